// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_VTP_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_VTP_H

#include <CGAL/Area_projection_transform/IO/Poly_data.h>
#include <CGAL/Area_projection_transform/internal/vtk_poly_data_reader.h>

#include <string>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a `.vtp` file: a polygon soup, or points with normals.
///
/// Reads ascii, binary and appended data, raw or in base64, plain or compressed with zlib, as
/// written by VTK and ParaView. Triangle strips become triangles; several pieces become one.
/// Indices are checked; coordinates and the degeneracy of polygons are not.
/// \param file_name the file
/// \throw std::runtime_error if the file cannot be read or is damaged; its text names the file, the
/// array and the defect.
inline Poly_data read_VTP(const std::string& file_name)
{
  return internal::Vtk_poly_data_reader(file_name).read();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_VTP_H
