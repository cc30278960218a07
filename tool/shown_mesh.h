// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SHOWN_MESH_H
#define MAPT_SHOWN_MESH_H

#include "input.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mapt {

/// a mesh for the eye: no more than some faces, of points that are used.
struct Shown_mesh
{
  std::vector<Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double joined_within = 0; // points of a cube of that side became one; 0: none did
};

/// the mesh itself if it has no more than `most_faces`; otherwise its points are joined in cubes, as
/// small as will do. Points without faces are thinned out.
Shown_mesh shown_mesh(const Input& input, std::size_t most_faces);

} // namespace mapt

#endif // MAPT_SHOWN_MESH_H
