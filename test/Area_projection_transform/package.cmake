# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# A stranger's project can use the package: installed, and as a subdirectory.

set(consumer_options -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                     -DCGAL_DIR=${CGAL_DIR}
                     -DAREA_PROJECTION_TRANSFORM_WITH_TBB=${AREA_PROJECTION_TRANSFORM_WITH_TBB})
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)

add_test(NAME package.installs COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR}
                                       -DPREFIX=${prefix} -DCONFIG=$<CONFIG> -P
                                       ${CMAKE_CURRENT_SOURCE_DIR}/install_package.cmake)
add_test(
  NAME package.is_found_when_installed
  COMMAND
    ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer
    ${CMAKE_CURRENT_BINARY_DIR}/consumer_of_installed --build-generator ${CMAKE_GENERATOR}
    --build-options ${consumer_options} -DCMAKE_PREFIX_PATH=${prefix} --test-command consumer)
add_test(
  NAME package.works_as_subdirectory
  COMMAND
    ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer
    ${CMAKE_CURRENT_BINARY_DIR}/consumer_of_source --build-generator ${CMAKE_GENERATOR}
    --build-options ${consumer_options} -DPACKAGE_SOURCE=${PROJECT_SOURCE_DIR} --test-command
    consumer)
set_tests_properties(package.installs PROPERTIES FIXTURES_SETUP installed_package)
set_tests_properties(package.is_found_when_installed PROPERTIES FIXTURES_REQUIRED installed_package)
