// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MESH_TRIANGULATION_H
#define MAPT_MESH_TRIANGULATION_H

#include "input_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mapt {

using Triangle = std::array<std::uint32_t, 3>;

struct Triangulation
{
  std::vector<Triangle> triangles;         // of three different vertices each
  std::vector<std::uint32_t> source_faces; // the face of the file of each triangle
  std::size_t polygons = 0;                // faces with more than 3 corners
};

/// cuts every face into triangles that have its orientation.
///
/// A planar simple polygon is covered exactly, convex or not. A polygon that is not planar is
/// judged by its shadow along its normal, and one that intersects itself becomes a fan.
Triangulation triangulate(const std::vector<Point_3>& points, const Polygons& polygons);

} // namespace mapt

#endif // MAPT_MESH_TRIANGULATION_H
