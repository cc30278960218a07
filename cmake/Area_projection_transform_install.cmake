# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the library so that find_package(Area_projection_transform) works. Only files of our own
# names go below include/CGAL, so that the package can share a prefix with CGAL.

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Area_projection_transform)

install(TARGETS Area_projection_transform EXPORT Area_projection_transformTargets)
install(
  EXPORT Area_projection_transformTargets
  NAMESPACE Area_projection_transform::
  DESTINATION ${package_dir})

install(FILES ${PROJECT_SOURCE_DIR}/include/CGAL/area_projection_transform.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/CGAL)
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/include/CGAL/Area_projection_transform
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/CGAL
  FILES_MATCHING
  PATTERN "*.h")

if(TARGET CGAL::TBB_support)
  set(is_tbb_linked TRUE)
else()
  set(is_tbb_linked FALSE)
endif()
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/Area_projection_transformConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Area_projection_transformConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/Area_projection_transformConfigVersion.cmake
  COMPATIBILITY SameMinorVersion # until 1.0 a minor version may change the interface
  ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/Area_projection_transformConfig.cmake
              ${PROJECT_BINARY_DIR}/Area_projection_transformConfigVersion.cmake
        DESTINATION ${package_dir})
