// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_TOUCHING_BALL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_TOUCHING_BALL_H

#include <CGAL/Area_projection_transform/medial_balls/Thinned_samples.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL {
namespace Area_projection {
namespace internal {

struct Touching_ball
{
  Eigen::Vector3d center;
  double radius;
  std::uint32_t contact; ///< the sample that stops it
};

/// \brief the largest ball that touches the surface at a sample and has no other sample in it, but for those that it
/// sees within a small angle of the first.
///
/// A ball that touches at `p` and passes through `q` has the radius `|p - q|² / (2 n·(p - q))` and sees the two under the
/// angle `2 asin(n·(p - q) / |p - q|)`, so that the smallest one over all `q` that count is found in one pass. The
/// shrinking ball, of which this is the fixed point, needs a nearest neighbour for each of its steps, and in the middle
/// of a sphere all neighbours are the nearest.
///
/// \param start where to begin the search, any length
/// \param largest no larger radius is looked for
/// \param least_sine of half of the angle
inline std::optional<Touching_ball> touching_ball(const Thinned_samples& samples,
                                                  const Eigen::Vector3d& position,
                                                  const Eigen::Vector3d& normal, double start,
                                                  double largest, double least_sine)
{
  // What lies between samples so far apart, in units of the radius, sticks into the ball by 1/800 of it.
  constexpr double spacing = 0.1;
  for(double reach = std::min(start, largest);; reach = std::min(1.5 * reach, largest)) {
    const Thinned_samples::Level& level = samples.at(spacing * reach);
    Touching_ball ball{{}, reach, 0};
    bool is_stopped = false;
    level.cells.for_each_in_ball(position - reach * normal, reach, [&](std::size_t i, double) {
      const Eigen::Vector3d chord = position - level.positions[i];
      const double squared = chord.squaredNorm(), along = chord.dot(normal);
      if(!(along > least_sine * std::sqrt(squared)))
        return;
      const double radius = squared / (2 * along);
      if(radius < ball.radius || (radius == ball.radius && level.indices[i] < ball.contact)) {
        ball.radius = radius;
        ball.contact = level.indices[i];
        is_stopped = true;
      }
    });
    if(is_stopped && ball.radius > 0) {
      ball.center = position - ball.radius * normal;
      return ball;
    }
    if(!(reach < largest))
      return std::nullopt;
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_TOUCHING_BALL_H
