// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_ASSIGN_VOTERS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_ASSIGN_VOTERS_H

#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>
#include <CGAL/Area_projection_transform/salient_points/Shape_detector.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief how far the centre of a patch may be from a shape that it belongs to: noise, and as far as the middle of
/// a face is inside of a round surface that has its corners.
inline double voter_tolerance(const Shape& shape, double area)
{
  constexpr double coarsest = 0.12; // an octagon
  const double radius = shape.radius();
  return std::max(5 * shape.deviation, 0.03 * radius) +
         std::min(0.3 * area / radius, coarsest * radius);
}

/// \brief gives each patch to the shape that it lies on, the first one if there are several.
///
/// Patches that face away from a shape do not support it, though they may lie on it.
inline void assign_voters(const Feature_surface& surface, const std::vector<std::uint32_t>& sources,
                          const std::vector<Found_shape>& shapes,
                          std::vector<Salient_point>& points)
{
  constexpr double least_cosine = 0.3;
  const std::vector<Feature_surface::Patch>& patches = surface.patches();
  std::vector<Eigen::Vector3d> centers;
  centers.reserve(patches.size());
  for(const Feature_surface::Patch& patch : patches)
    centers.push_back(patch.position);
  const Cell_list cells(centers, 3 * surface.resolution());
  std::vector<char> is_taken(patches.size(), 0);
  for(std::size_t k = 0; k < shapes.size(); ++k) {
    const Shape& shape = shapes[k].shape;
    const double margin = 0.1 * shape.radius();
    const double reach = shape.reach() + std::max(5 * shape.deviation, 0.15 * shape.radius());
    cells.for_each_in_ball(shape.center(), reach, [&](std::size_t i, double) {
      const Shape::Place place = shape.place(centers[i]);
      if(is_taken[i] || !shape.is_along(place.along, margin) ||
         !(std::abs(place.residual) < voter_tolerance(shape, patches[i].area)) ||
         !(patches[i].area_vector.dot(place.normal) > least_cosine * patches[i].area))
        return;
      is_taken[i] = 1;
      points[k].voters.push_back(sources[i]);
    });
    std::sort(points[k].voters.begin(), points[k].voters.end());
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_ASSIGN_VOTERS_H
