// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_TUBES_H
#define AREA_PROJECTION_TRANSFORM_TEST_TUBES_H

// Tubes of which the centrelines are known, and what of a graph of centrelines can be counted.

#include "shapes.h"

#include <CGAL/Area_projection_transform/centerlines.h>

#include <boost/graph/connected_components.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace shapes {

/// an open tube around the z axis from 0 to `length`, all of its points on it; `radius(z)` and an elliptic section whose
/// semi-axes are `aspect` times as long along x and that much shorter along y.
template <class Radius>
Soup tube(double length, Radius radius, int sides = 32, int rows = 60, double aspect = 1)
{
  return welded(lattice_patch(sides, rows, [=](int i, int j) {
    const double a = 2 * pi * (i % sides) / sides, z = length * j / rows, r = radius(z);
    return Point_3(aspect * r * std::cos(a), r / aspect * std::sin(a), z);
  }));
}

inline Soup round_tube(double length, double radius = 1)
{
  return tube(length, [=](double) { return radius; });
}

/// three tubes that come from the same place, at an angle to each other, without what of each is inside another.
inline Soup three_tubes(double angle = 2 * pi / 3)
{
  Soup all;
  for(int k = 0; k < 3; ++k)
    all = joined(all, moved(round_tube(8), [=](const Point_3& p) {
                   const double a = angle * k, c = std::cos(a), s = std::sin(a);
                   return Point_3(c * p.z() - s * p.x(), s * p.z() + c * p.x(), p.y());
                 }));
  return without_faces(all, [=](const Point_3& c) {
    int inside = 0;
    for(int k = 0; k < 3; ++k) {
      const double a = angle * k, along = std::cos(a) * c.x() + std::sin(a) * c.y();
      const double across = std::cos(a) * c.y() - std::sin(a) * c.x();
      inside += along > 0 && std::hypot(across, c.z()) < 0.98 ? 1 : 0;
    }
    return inside > 0;
  });
}

inline AP::Centerline_graph lines_of(const Soup& soup, const AP::Centerline_options& options = {})
{
  return AP::centerlines(surface_of(soup), options);
}

inline std::size_t number_of_leaves(const AP::Centerline_graph& graph)
{
  std::size_t leaves = 0;
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    leaves += degree(v, graph) == 1 ? 1 : 0;
  return leaves;
}

inline std::size_t number_of_parts(const AP::Centerline_graph& graph)
{
  std::vector<int> part(num_vertices(graph));
  return part.empty() ? 0 : std::size_t(boost::connected_components(graph, part.data()));
}

} // namespace shapes

#endif // AREA_PROJECTION_TRANSFORM_TEST_TUBES_H
