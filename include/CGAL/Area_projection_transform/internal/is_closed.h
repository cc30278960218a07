// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IS_CLOSED_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IS_CLOSED_H

#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// whether the triangles form a closed, consistently oriented surface: every edge is passed as often
/// one way as the other. Then its winding number is the same along every ray from a point.
inline bool is_closed(const Triangle_surface& surface)
{
  using Side = Edges_by_vertex::Side;
  return Edges_by_vertex(surface).all_edges(
      [](std::uint32_t lower, const Side* begin, const Side* end) {
        if(begin->higher == lower)
          return true; // an edge from a vertex to itself goes both ways
        std::ptrdiff_t surplus = 0;
        for(const Side* side = begin; side != end; ++side)
          surplus += side->is_ascending ? 1 : -1;
        return surplus == 0;
      });
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IS_CLOSED_H
