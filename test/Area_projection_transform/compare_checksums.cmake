# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Fails unless each of PROGRAMS prints the same for each of THREADS.

foreach(program IN LISTS PROGRAMS)
  foreach(threads IN LISTS THREADS)
    execute_process(COMMAND ${program} ${threads} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
    cmake_path(GET program FILENAME name)
    message(STATUS "${name} with ${threads} threads:\n${output}")
    if(output STREQUAL "")
      message(FATAL_ERROR "${name} printed nothing")
    elseif(NOT DEFINED expected)
      set(expected "${output}")
    elseif(NOT output STREQUAL expected)
      message(FATAL_ERROR "${name} with ${threads} threads differs from the first run")
    endif()
  endforeach()
endforeach()
