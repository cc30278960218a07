# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Finds a package, or says who needs it and what to do about it.
#
#   area_projection_transform_require(ZLIB FOR "the library" DEBIAN zlib1g-dev)
#   area_projection_transform_require(GTest FOR "the tests" DEBIAN libgtest-dev OPTION BUILD_TESTS)
#
# The arguments before FOR go to find_package(). OPTION names the option that does without.
#
# A macro, so that what a package sets (as CGAL does with CMAKE_MODULE_PATH) reaches the caller.
macro(area_projection_transform_require package)
  cmake_parse_arguments(_apt_require "" "FOR;DEBIAN;OPTION" "" ${ARGN})
  find_package(${package} ${_apt_require_UNPARSED_ARGUMENTS} QUIET)
  if(NOT ${package}_FOUND)
    set(_apt_require_remedy "Install it (Debian and Ubuntu: ${_apt_require_DEBIAN}, or run "
                            "scripts/install-dependencies)")
    if(_apt_require_OPTION)
      list(APPEND _apt_require_remedy
           " or do without: -DAREA_PROJECTION_TRANSFORM_${_apt_require_OPTION}=OFF")
    endif()
    string(JOIN " " _apt_require_wanted ${package} ${_apt_require_UNPARSED_ARGUMENTS})
    message(FATAL_ERROR "${_apt_require_wanted} was not found; ${_apt_require_FOR} cannot be built "
                        "without it. " ${_apt_require_remedy} ".")
  endif()
endmacro()

# Strict warnings for a target of ours; never for the users of the library.
function(area_projection_transform_add_warnings target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(
      ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
                        $<$<BOOL:${AREA_PROJECTION_TRANSFORM_WERROR}>:-Werror>)
  endif()
endfunction()
