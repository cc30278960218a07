// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_KERNEL_3_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_KERNEL_3_H

#include <CGAL/Area_projection_transform/internal/to_text.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief one of the nested balls that make up a projection kernel.
struct Nested_ball
{
  double relative_radius; ///< in units of `σ`, in (0, 1]
  double weight;          ///< what a surfel within this ball adds, as a fraction of its area
};

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the kernel of the paper: everything within `σ` counts fully.
/// \cgalModels `ProjectionKernel_3`
struct Ball_kernel_3
{
  /// one ball, of the radius `σ`, with the weight 1.
  std::vector<Nested_ball> nested_balls() const { return {{1., 1.}}; }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_kernel(const std::vector<Nested_ball>& kernel)
{
  double sum = 0;
  for(const Nested_ball& ball : kernel) {
    if(!(ball.relative_radius > 0 && ball.relative_radius <= 1))
      throw std::invalid_argument("kernel has a ball of relative radius " +
                                  internal::to_text(ball.relative_radius) + ": must be in (0, 1]");
    if(!(ball.weight > 0))
      throw std::invalid_argument("kernel has a ball of weight " + internal::to_text(ball.weight) +
                                  ": must be positive");
    sum += ball.weight;
  }
  if(!(sum <= 1 + 1e-9))
    throw std::invalid_argument("kernel has weights that sum to " + internal::to_text(sum) +
                                ": must be at most 1");
}

/// the area that a kernel collects, from those that `evaluate(x, sigma)` finds in balls.
template <class Evaluator, class Point>
double sum_over_balls(const Evaluator& evaluate, const Point& x, double sigma,
                      const std::vector<Nested_ball>& kernel)
{
  double sum = 0;
  for(const Nested_ball& ball : kernel)
    sum += ball.weight * evaluate(x, sigma * ball.relative_radius);
  return sum;
}

/// splits a profile that falls from 1 at the centre to 0 at `σ` into `number` nested balls: ball
/// `j` reaches to where the profile has fallen to the middle of its step.
template <class RadiusOfValue>
std::vector<Nested_ball> nested_balls_of_profile(unsigned number, RadiusOfValue radius_of_value)
{
  if(number == 0)
    throw std::invalid_argument("number_of_balls is 0: must be at least 1");
  std::vector<Nested_ball> balls;
  for(unsigned j = 0; j < number; ++j)
    balls.push_back({radius_of_value((j + 0.5) / number), 1. / number});
  return balls;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the kernel `1 - (d/σ)²`, as a mixture of nested balls.
/// \cgalModels `ProjectionKernel_3`
struct Epanechnikov_kernel_3
{
  unsigned number_of_balls = 8; ///< the mixture is within `1/(2 number_of_balls)` of the profile

  /// \throw std::invalid_argument if there is no ball.
  std::vector<Nested_ball> nested_balls() const
  {
    return internal::nested_balls_of_profile(number_of_balls,
                                             [](double value) { return std::sqrt(1 - value); });
  }
};

/// \ingroup PkgAreaProjectionTransformGround
/// \brief a Gaussian of standard deviation `σ/cutoff`, cut off at `σ` and lowered and stretched to
/// run from 1 to 0, as a mixture of nested balls.
/// \cgalModels `ProjectionKernel_3`
struct Gaussian_kernel_3
{
  double cutoff = 3;            ///< where the Gaussian is cut, in standard deviations
  unsigned number_of_balls = 8; ///< the mixture is within `1/(2 number_of_balls)` of the profile

  /// \throw std::invalid_argument if `cutoff` is not positive or there is no ball.
  std::vector<Nested_ball> nested_balls() const
  {
    if(!(cutoff > 0))
      throw std::invalid_argument("cutoff is " + internal::to_text(cutoff) + ": must be positive");
    const double floor = std::exp(-0.5 * cutoff * cutoff);
    return internal::nested_balls_of_profile(number_of_balls, [&](double value) {
      return std::sqrt(-2 * std::log(floor + value * (1 - floor))) / cutoff;
    });
  }
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_KERNEL_3_H
