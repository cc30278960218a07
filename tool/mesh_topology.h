// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MESH_TOPOLOGY_H
#define MAPT_MESH_TOPOLOGY_H

#include "input_file.h"
#include "mesh_triangulation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mapt {

/// how the triangles of a soup hang together.
///
/// Found by sorting, so that any soup has an answer: O(n log n) for n triangles.
struct Mesh_topology
{
  std::size_t unused_vertices = 0; // points of no triangle

  std::size_t boundary_edges = 0;     // of one triangle
  std::size_t nonmanifold_edges = 0;  // of three triangles or more
  std::size_t inconsistent_edges = 0; // of an even number, not half of them each way round
  std::size_t holes = 0;              // connected pieces of the boundary edges

  std::vector<std::uint32_t> component; // triangle -> piece connected through edges, from 0
  struct Component
  {
    // every edge has two triangles, or is passed equally often both ways
    bool is_closed = true;
    bool is_consistently_oriented = true;
    double volume = 0; // signed; of an open piece with its holes closed by cones
    double area = 0;
    double hole_area = 0; // of those cones
    CGAL::Bbox_3 box;
  };
  std::vector<Component> components;
  long long euler_characteristic = 0; // sum over the components
};

/// returns for each point the index of the first point at its position.
std::vector<std::uint32_t> join_equal_points(const std::vector<Point_3>& points);

/// \pre `joined` names for each point the one that stands for it: itself, or another at the same
/// position. The vertices of a triangle have three positions.
Mesh_topology analyse(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& joined,
                      const std::vector<Triangle>& triangles);

/// returns the edges of one triangle each, from vertex to vertex as the triangle runs.
/// \pre as for `analyse()`
std::vector<std::array<std::uint32_t, 2>> boundary_edges(const std::vector<std::uint32_t>& joined,
                                                         const std::vector<Triangle>& triangles);

} // namespace mapt

#endif // MAPT_MESH_TOPOLOGY_H
