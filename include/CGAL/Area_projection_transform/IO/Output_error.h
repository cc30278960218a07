// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_OUTPUT_ERROR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_OUTPUT_ERROR_H

#include <stdexcept>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief tells that a file could not be written: its text names the file and the cause.
///
/// Readers throw a plain `std::runtime_error`, so that a program can tell the two apart.
class Output_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_OUTPUT_ERROR_H
