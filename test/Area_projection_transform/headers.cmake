# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Every public header compiles by itself, and twice in a row, and all of them link into one program,
# which fails if a header forgets to make a function inline.
#
# With -DAREA_PROJECTION_TRANSFORM_NEWER_CGAL=<include folder> the same is done again, and the tests
# of the library are repeated, with the CGAL headers of that folder (tests of the label newer-cgal).

set(include_dir ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${include_dir} ${include_dir}/CGAL/*.h)
list(FILTER headers EXCLUDE REGEX /internal/)

set(header_sources ${CMAKE_CURRENT_BINARY_DIR}/headers/main.cpp)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/headers/main.cpp CONTENT "int main() {}\n")
foreach(header IN LISTS headers)
  string(REPLACE "/" "." source ${header})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${source}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
  list(APPEND header_sources ${source})
endforeach()

add_executable(test_headers ${header_sources})
target_link_libraries(test_headers PRIVATE Area_projection_transform::Area_projection_transform)
target_compile_options(test_headers PRIVATE -O0) # nothing runs
area_projection_transform_add_warnings(test_headers)
add_test(NAME headers.compile_alone_and_link COMMAND test_headers)

set(AREA_PROJECTION_TRANSFORM_NEWER_CGAL "" CACHE PATH
    "Include folder of another CGAL, whose headers the tests are repeated with")
if(NOT AREA_PROJECTION_TRANSFORM_NEWER_CGAL)
  return()
endif()

# Adds a test that builds `target` with the other CGAL and runs it; not part of the normal build.
function(add_test_with_newer_cgal target)
  area_projection_transform_add_warnings(${target})
  target_link_libraries(${target} PRIVATE Area_projection_transform::Area_projection_transform)
  target_include_directories(${target} SYSTEM BEFORE
                             PRIVATE ${AREA_PROJECTION_TRANSFORM_NEWER_CGAL})
  set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  add_test(NAME newer_cgal.build_${target} COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}
                                                   --config $<CONFIG> --target ${target})
  add_test(NAME newer_cgal.${target} COMMAND ${target})
  # One build at a time in a build folder.
  set_tests_properties(newer_cgal.build_${target}
                       PROPERTIES LABELS newer-cgal FIXTURES_SETUP ${target} RUN_SERIAL TRUE)
  set_tests_properties(newer_cgal.${target} PROPERTIES LABELS newer-cgal FIXTURES_REQUIRED ${target})
endfunction()

# The proof that the other headers were taken: their version, read from the folder and by the compiler.
file(STRINGS ${AREA_PROJECTION_TRANSFORM_NEWER_CGAL}/CGAL/version.h version_line
     REGEX "^#define CGAL_VERSION_NR [0-9]+")
string(REGEX MATCH "[0-9]+$" version_number "${version_line}")
set(version_source ${CMAKE_CURRENT_BINARY_DIR}/headers/newer_cgal_version.cpp)
file(CONFIGURE OUTPUT ${version_source} @ONLY CONTENT "#include <CGAL/version.h>
static_assert(CGAL_VERSION_NR == @version_number@, \"the wrong CGAL was included\");\n")

add_executable(test_headers_newer_cgal ${header_sources} ${version_source})
target_compile_options(test_headers_newer_cgal PRIVATE -O0)
add_test_with_newer_cgal(test_headers_newer_cgal)
if(TARGET test_library)
  get_target_property(sources test_library SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  add_executable(test_library_newer_cgal ${sources} ${version_source})
  get_target_property(definitions test_library COMPILE_DEFINITIONS)
  target_compile_definitions(test_library_newer_cgal PRIVATE ${definitions})
  target_link_libraries(test_library_newer_cgal PRIVATE GTest::gtest_main)
  target_include_directories(test_library_newer_cgal PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_precompile_headers(test_library_newer_cgal PRIVATE pch.h)
  add_test_with_newer_cgal(test_library_newer_cgal)
endif()
