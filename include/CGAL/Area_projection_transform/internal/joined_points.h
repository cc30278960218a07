// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_JOINED_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_JOINED_POINTS_H

#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief returns for each point the one that stands for it: itself, or, on the rim of a gap, the first
/// rim point at the same position.
///
/// So the triangles of a soup find each other, and a closed surface that touches itself is not joined.
/// Positions must be equal to the last bit. Complexity: `O(n log n)`.
inline std::vector<std::uint32_t> joined_points(const Triangle_surface& surface)
{
  std::vector<bool> is_on_rim(surface.points.size(), false);
  Edges_by_vertex(surface).all_edges(
      [&is_on_rim](std::uint32_t lower, const auto* begin, const auto* end) {
        if(end - begin == 1)
          is_on_rim[lower] = is_on_rim[begin->higher] = true;
        return true;
      });
  std::vector<std::uint32_t> rim, places(surface.points.size());
  std::iota(places.begin(), places.end(), 0u);
  std::copy_if(places.begin(), places.end(), std::back_inserter(rim),
               [&is_on_rim](std::uint32_t i) { return is_on_rim[i]; });
  const std::vector<Point_3>& points = surface.points;
  std::sort(rim.begin(), rim.end(), [&points](std::uint32_t i, std::uint32_t j) {
    return std::tie(points[i], i) < std::tie(points[j], j);
  });
  for(std::size_t k = 1; k < rim.size(); ++k)
    if(points[rim[k]] == points[rim[k - 1]])
      places[rim[k]] = places[rim[k - 1]];
  return places;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_JOINED_POINTS_H
