# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the package of BUILD to a fresh PREFIX, which may then hold no file that could be CGAL's.

file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --config ${CONFIG}
                COMMAND_ERROR_IS_FATAL ANY)

file(GLOB installed RELATIVE ${PREFIX}/include ${PREFIX}/include/* ${PREFIX}/include/CGAL/*)
list(REMOVE_ITEM installed CGAL CGAL/Area_projection_transform CGAL/area_projection_transform.h)
if(installed)
  message(FATAL_ERROR "installed below include, but not ours: ${installed}")
endif()
