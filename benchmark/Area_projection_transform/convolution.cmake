# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Convolution with balls, against the paper's direct algorithm and, if it is installed, FFTW.

add_executable(benchmark_convolution convolution.cpp)
target_link_libraries(benchmark_convolution
                      PRIVATE Area_projection_transform::Area_projection_transform)
area_projection_transform_add_warnings(benchmark_convolution)

find_path(FFTW3_INCLUDE_DIR fftw3.h)
find_library(FFTW3F_LIBRARY fftw3f)
find_library(FFTW3F_THREADS_LIBRARY fftw3f_threads)
find_package(Threads QUIET)
mark_as_advanced(FFTW3_INCLUDE_DIR FFTW3F_LIBRARY FFTW3F_THREADS_LIBRARY)
if(FFTW3_INCLUDE_DIR AND FFTW3F_LIBRARY)
  target_include_directories(benchmark_convolution SYSTEM PRIVATE ${FFTW3_INCLUDE_DIR})
  target_compile_definitions(benchmark_convolution PRIVATE AREA_PROJECTION_TRANSFORM_FFTW)
  if(FFTW3F_THREADS_LIBRARY AND TARGET Threads::Threads)
    target_compile_definitions(benchmark_convolution PRIVATE AREA_PROJECTION_TRANSFORM_FFTW_THREADS)
    target_link_libraries(benchmark_convolution PRIVATE ${FFTW3F_THREADS_LIBRARY} Threads::Threads)
  endif()
  target_link_libraries(benchmark_convolution PRIVATE ${FFTW3F_LIBRARY})
else()
  message(STATUS "FFTW was not found (Debian: libfftw3-dev): benchmark_convolution does without")
endif()
