# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs an example, which must succeed and print what mathematics says.
#
#   cmake -DEXAMPLE=<program> -DOUTCOME=<regular expression> -P check_outcome.cmake

execute_process(COMMAND ${EXAMPLE} RESULT_VARIABLE result OUTPUT_VARIABLE output)
message("${output}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The example failed: ${result}")
endif()
if(NOT output MATCHES "${OUTCOME}")
  message(FATAL_ERROR "This was expected in the output, but is not there: ${OUTCOME}")
endif()
