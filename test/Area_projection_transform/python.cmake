# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The command mapt, and the files it writes, seen by the readers of others: each test_*.py is a test (mapt_test.py is what they share)
# that finds the command in the environment variable MAPT and the meshes in MAPT_DATA.

file(GLOB scripts CONFIGURE_DEPENDS test_*.py)
if(NOT scripts)
  return()
endif()
if(NOT TARGET mapt)
  message(STATUS "The tests of the command mapt are left out: it is not built")
  return()
endif()

# The system's Python first: it is the one that Debian's VTK belongs to.
find_program(Python3_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(Python3_EXECUTABLE python3 REQUIRED)
execute_process(COMMAND ${Python3_EXECUTABLE} -c "import numpy, vtkmodules" RESULT_VARIABLE result
                ERROR_VARIABLE reason)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The tests need the modules numpy and vtk of ${Python3_EXECUTABLE}:\n${reason}"
                      "Install them (Debian and Ubuntu: python3-numpy python3-vtk9, or run "
                      "scripts/install-dependencies), name another Python by -DPython3_EXECUTABLE, "
                      "or do without: -DAREA_PROJECTION_TRANSFORM_BUILD_TESTS=OFF.")
endif()

foreach(script IN LISTS scripts)
  cmake_path(GET script STEM name)
  set(scratch ${CMAKE_CURRENT_BINARY_DIR}/scratch/${name})
  file(MAKE_DIRECTORY ${scratch})
  add_test(NAME mapt.${name} COMMAND ${Python3_EXECUTABLE} -B ${script} WORKING_DIRECTORY ${scratch})
  set_tests_properties(
    mapt.${name} PROPERTIES ENVIRONMENT
                            "MAPT=$<TARGET_FILE:mapt>;MAPT_DATA=${PROJECT_SOURCE_DIR}/data")
endforeach()
