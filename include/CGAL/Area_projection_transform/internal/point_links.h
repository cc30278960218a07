// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/internal/Heat_flow.h>
#include <CGAL/Area_projection_transform/internal/point_neighbours.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the flow of heat between neighbouring surfels.
///
/// Each surfel is linked with its nearest ones that face the same way, so that the two sides of a thin
/// sheet stay apart. Links are as strong as makes the second differences of the surfel and its
/// neighbours, on a plane, those of the Laplacian: `Σ w (u_j − u_i) = area Δu` for a quadratic `u`.
inline Heat_flow flow_between_elements(const Surfels& surfels)
{
  constexpr std::size_t number_of_neighbours = 8;
  Heat_flow::Links links(surfels.size());
  if(surfels.empty())
    return Heat_flow(surfels.areas, std::move(links));
  const Point_neighbours neighbours(surfels.positions);
  std::vector<Point_neighbours::Neighbour> found;
  for(std::size_t i = 0; i < surfels.size(); ++i) {
    neighbours.find(i, number_of_neighbours, found);
    double squared_distances = 0;
    for(const Point_neighbours::Neighbour& neighbour : found)
      if(surfels.normals[i] * surfels.normals[neighbour.index] > 0)
        squared_distances += neighbour.squared_distance;
    if(!(squared_distances > 0))
      continue;
    // Half from either end, as links go both ways.
    for(const Point_neighbours::Neighbour& neighbour : found)
      if(surfels.normals[i] * surfels.normals[neighbour.index] > 0)
        links.add(i, neighbour.index, 2 * surfels.areas[i] / squared_distances);
  }
  return Heat_flow(surfels.areas, std::move(links));
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H
