# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The parts of the command mapt that are libraries.

if(NOT TARGET mapt_input)
  message(STATUS "The tests of its parts are left out: the command mapt is not built")
  return()
endif()

add_executable(test_tool tool/test_drawing.cpp tool/test_input.cpp)
target_compile_definitions(test_tool PRIVATE MAPT_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}/data")
target_link_libraries(test_tool PRIVATE mapt_input mapt_results GTest::gtest_main)
area_projection_transform_add_warnings(test_tool)
gtest_discover_tests(test_tool DISCOVERY_TIMEOUT 60)
