// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/internal/Heat_flow.h>
#include <CGAL/Area_projection_transform/internal/Oriented_places.h>
#include <CGAL/Area_projection_transform/internal/point_neighbours.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the flow of heat between neighbouring surfels.
///
/// Copies of a surfel are one cell. Each cell is linked with the nearest ones that face the same
/// way, so that the two sides of a thin sheet stay apart. Links are as strong as makes the second
/// differences of the cell and its neighbours, on a plane, those of the Laplacian: `Σ w (u_j − u_i)
/// = area Δu` for a quadratic `u`.
inline Heat_flow flow_between_elements(const Surfels& surfels)
{
  constexpr std::size_t number_of_neighbours = 8;
  constexpr double largest = 1e3; // within heaps: they need not be coupled better
  Oriented_places places(surfels.positions, surfels.normals);
  const std::size_t number = places.positions.size();
  std::vector<double> areas(number, 0.);
  for(std::size_t i = 0; i < surfels.size(); ++i)
    areas[places.index_of[i]] += surfels.areas[i];
  Heat_flow::Links links(number);
  if(surfels.empty())
    return Heat_flow(areas, std::move(links));
  const Point_neighbours neighbours(places.positions);
  std::vector<Point_neighbours::Neighbour> found;
  for(std::size_t i = 0; i < number; ++i) {
    neighbours.find(i, number_of_neighbours, found);
    double squared_distances = 0;
    for(const Point_neighbours::Neighbour& neighbour : found)
      if(places.normals[i] * places.normals[neighbour.index] > 0)
        squared_distances += neighbour.squared_distance;
    if(!(squared_distances > 0))
      continue;
    // Half from either end, as links go both ways.
    const double conductance = std::min(2 * areas[i] / squared_distances, largest);
    for(const Point_neighbours::Neighbour& neighbour : found)
      if(places.normals[i] * places.normals[neighbour.index] > 0)
        links.add(i, neighbour.index, conductance);
  }
  return Heat_flow(areas, std::move(links), std::move(places.index_of));
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H
