// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VERTEX_LINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VERTEX_LINKS_H

#include <CGAL/Area_projection_transform/internal/Heat_flow.h>
#include <CGAL/Area_projection_transform/internal/triangle_measures.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the flow of heat from vertex to vertex: linear finite elements with lumped masses.
///
/// A triangle links two of its corners with half of the cotangent of the angle at the third (Pinkall
/// and Polthier 1993), which is bounded in needles.
/// \param places the point that stands for each point
inline Heat_flow flow_between_vertices(const Triangle_surface& surface,
                                       const std::vector<std::uint32_t>& places)
{
  constexpr double least_sine = 1e-3;
  const std::vector<double> areas = geometric_areas(surface);
  std::vector<double> areas_of_vertices(surface.points.size(), 0.);
  Heat_flow::Links links(surface.points.size());
  for(std::size_t t = 0; t < surface.size(); ++t) {
    const auto& triangle = surface.triangles[t];
    double longest = 0;
    for(int i = 0; i < 3; ++i)
      longest =
          std::max(longest, squared_distance(surface.corner(t, i), surface.corner(t, (i + 1) % 3)));
    if(!(longest > 0))
      continue; // all at one point
    // The same for all corners, which keeps the energy of the triangle positive.
    const double doubled_area = std::max(2 * areas[t], least_sine * longest);
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Vector_3 u = surface.corner(t, j) - surface.corner(t, i);
      const Vector_3 v = surface.corner(t, k) - surface.corner(t, i);
      links.add(places[triangle[j]], places[triangle[k]], 0.5 * (u * v) / doubled_area);
      areas_of_vertices[places[triangle[i]]] += areas[t] / 3;
    }
  }
  return Heat_flow(areas_of_vertices, std::move(links));
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VERTEX_LINKS_H
