# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The same bits with and without TBB, and for any number of threads: print_map_checksum.cpp, compiled
# both ways, prints the same for each number of threads, its only argument.

if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/print_map_checksum.cpp)
  return()
endif()

add_executable(print_map_checksum_tbb print_map_checksum.cpp)
target_link_libraries(print_map_checksum_tbb
                      PRIVATE Area_projection_transform::Area_projection_transform)

# The library again, without the one dependency.
get_target_property(libraries Area_projection_transform INTERFACE_LINK_LIBRARIES)
list(REMOVE_ITEM libraries CGAL::TBB_support)
add_executable(print_map_checksum_sequential print_map_checksum.cpp)
target_compile_features(print_map_checksum_sequential PRIVATE cxx_std_17)
target_include_directories(
  print_map_checksum_sequential
  PRIVATE $<TARGET_PROPERTY:Area_projection_transform,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_options(
  print_map_checksum_sequential
  PRIVATE $<TARGET_PROPERTY:Area_projection_transform,INTERFACE_COMPILE_OPTIONS>)
target_link_libraries(print_map_checksum_sequential PRIVATE ${libraries})

foreach(program IN ITEMS print_map_checksum_tbb print_map_checksum_sequential)
  target_compile_definitions(${program}
                             PRIVATE AREA_PROJECTION_TRANSFORM_DATA="${PROJECT_SOURCE_DIR}/data")
  area_projection_transform_add_warnings(${program})
endforeach()

add_test(
  NAME same_bits.threads_and_tbb
  COMMAND
    ${CMAKE_COMMAND}
    "-DPROGRAMS=$<TARGET_FILE:print_map_checksum_tbb>;$<TARGET_FILE:print_map_checksum_sequential>"
    "-DTHREADS=1;2;3" -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_checksums.cmake)
