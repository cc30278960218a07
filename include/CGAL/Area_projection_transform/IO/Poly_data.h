// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_POLY_DATA_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_POLY_DATA_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief a polygon soup that was read from a file, or a set of points if it has no polygons.
struct Poly_data
{
  std::vector<Point_3> points;                    ///< the points, used or not
  std::vector<std::vector<std::size_t>> polygons; ///< indices of points, less than their number
  std::vector<Vector_3> normals;                  ///< one of each point, or none at all
  std::size_t number_of_vertex_cells = 0;         ///< cells that are points
  std::size_t number_of_line_cells = 0;           ///< cells that are lines; not read
};

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_POLY_DATA_H
