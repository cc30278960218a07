// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SCALE_AXIS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SCALE_AXIS_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the balls among which larger ones are sought, the largest first, as arrays.
struct Larger_balls
{
  std::array<std::vector<double>, 3> centers;
  std::vector<double> radii;

  explicit Larger_balls(const std::vector<Medial_ball>& balls)
  {
    constexpr std::size_t most = 20000;
    std::vector<const Medial_ball*> order;
    const std::size_t stride = 1 + balls.size() / (most + 1);
    for(std::size_t i = 0; i < balls.size(); i += stride)
      order.push_back(&balls[i]);
    std::stable_sort(order.begin(), order.end(), [](const Medial_ball* a, const Medial_ball* b) {
      return a->radius > b->radius;
    });
    for(const Medial_ball* ball : order) {
      for(int axis = 0; axis < 3; ++axis)
        centers[std::size_t(axis)].push_back(ball->center[axis]);
      radii.push_back(ball->radius);
    }
  }

  /// \brief the smallest factor at which a ball is within one that is larger.
  ///
  /// The ball `(c, r)`, `s` times as large, is within `(c', r')` that is, too, if `|c - c'| <= s (r' - r)`.
  double factor(const Medial_ball& ball) const
  {
    const auto larger = std::partition_point(radii.begin(), radii.end(),
                                             [&ball](double r) { return r > ball.radius; });
    const double x = ball.center.x(), y = ball.center.y(), z = ball.center.z();
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t j = 0; j < std::size_t(larger - radii.begin()); ++j) {
      const double dx = centers[0][j] - x, dy = centers[1][j] - y, dz = centers[2][j] - z;
      const double growth = radii[j] - ball.radius;
      least = std::min(least, (dx * dx + dy * dy + dz * dz) / (growth * growth));
    }
    return std::sqrt(least);
  }
};

/// \brief finds `Medial_ball::scale_axis` for all balls.
///
/// A ball counts as swallowed if one other ball covers it, not if several do together, as the scale axis transform
/// (Giesen et al. 2009) has it. Of many balls every second, third, … is looked at.
template <class ConcurrencyTag>
void set_scale_axis(std::vector<Medial_ball>& balls)
{
  const Larger_balls larger(balls);
  for_each_index<ConcurrencyTag>(
      balls.size(), [&](std::size_t i) { balls[i].scale_axis = larger.factor(balls[i]); });
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SCALE_AXIS_H
