// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_INNER_BALLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_INNER_BALLS_H

#include <CGAL/Area_projection_transform/centerlines/Sample_levels.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

struct Inner_ball
{
  Eigen::Vector3d center;
  double radius;
};

/// \brief the largest ball that touches the surface from inside at a sample and has no other surface in it.
///
/// Samples that are seen from the centre within 41 degrees of the first do not count: between those are the noise
/// and the coarseness of the surface.
inline std::optional<Inner_ball> inner_ball(const Sample_levels& levels,
                                            const Eigen::Vector3d& position,
                                            const Eigen::Vector3d& normal, double smallest_radius,
                                            double largest_radius)
{
  constexpr double least_sine = 0.35; // of half of the angle
  for(double reach = smallest_radius; reach < 2 * largest_radius; reach *= 1.5) {
    const Sample_levels::Level& level = levels.at(reach);
    double radius = reach;
    level.cells.for_each_in_ball(position - reach * normal, reach, [&](std::size_t i, double) {
      const Eigen::Vector3d chord = position - level.positions[i];
      const double squared = chord.squaredNorm(), along = chord.dot(normal);
      if(along > least_sine * std::sqrt(squared))
        radius = std::min(radius, squared / (2 * along));
    });
    if(radius < reach)
      return Inner_ball{position - radius * normal, radius};
  }
  return std::nullopt;
}

/// \brief inner balls of some thousands of samples, spread over the surface, in the order of the samples.
template <class ConcurrencyTag>
std::vector<Inner_ball> inner_balls(const Sample_levels& levels, const Line_samples& samples)
{
  const Sample_levels::Level& level = levels.with_at_most(3000);
  std::vector<std::optional<Inner_ball>> found(level.positions.size());
  for_each_index<ConcurrencyTag>(found.size(), [&](std::size_t i) {
    if(level.areas[i] > 0)
      found[i] = inner_ball(levels, level.positions[i], level.normals[i], samples.smallest_radius(),
                            samples.largest_radius());
  });
  std::vector<Inner_ball> balls;
  for(const std::optional<Inner_ball>& ball : found)
    if(ball)
      balls.push_back(*ball);
  return balls;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_INNER_BALLS_H
