// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_JUDGE_SHAPE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_JUDGE_SHAPE_H

#include <CGAL/Area_projection_transform/salient_points/fit_tube.h>
#include <CGAL/Area_projection_transform/salient_points/support.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief what a shape must be like to be believed. Fractions of the radius, unless said otherwise.
struct Shape_limits
{
  double deviation = 0.25; ///< of the points
  /// of the points, noise apart: of spheres, which ellipsoids are not; of tubes; and of those that are round.
  double misfit_of_sphere = 0.06, misfit = 0.08, misfit_of_round_tube = 0.13;
  double least_turning = 0.76, most_turning = 1.3;
  /// the angle between the normals of faces and those of the shape, in radians: of coarse faces, and what noise adds,
  /// which turns faces by so much for a deviation of an edge.
  double normal_error = 0.32, normal_error_of_noise = 1.9;
  double least_observed = 0.08;    ///< of the area of the shape
  double observed_for_noise = 1.5; ///< more of it, per deviation
  double least_explained = 0.5;    ///< of the points around
  double most_within = 0.3;        ///< of surface inside, per surface on the shape
  double sphere_spread = 0.06;     ///< the least spread of the normals of a sphere
  double bend = 0.5;               ///< the radius of a tube over that of its bend
  double tube_spread = 0.15;       ///< the second least, of a tube
  std::size_t least_clusters = 10;
};

/// how far from a shape its surface may be: noise, and how far the clusters of a round surface are inside.
inline double support_tolerance(const Shape& shape)
{
  return std::max(5 * shape.deviation, 0.06 * shape.radius());
}

/// whether points are as near to a shape as they should be.
inline bool is_close_fit(const Shape& shape, const Shape_limits& limits)
{
  const double misfit = shape.is_tube() ? limits.misfit_of_round_tube : limits.misfit_of_sphere;
  return shape.deviation < limits.deviation * shape.radius() &&
         shape.misfit < misfit * shape.radius();
}

/// \brief whether the misfit of a tube is forgiven: limbs are no cylinders, but long, round, and all around.
inline bool is_round_enough(const Shape& shape, const Support& support, const Shape_limits& limits)
{
  constexpr double least_observed = 0.6, least_turning = 0.84, least_length = 4;
  return shape.misfit < limits.misfit * shape.radius() ||
         (shape.is_tube() && shape.length() > least_length * shape.radius() &&
          observed_fraction(shape, support) > least_observed && support.turning > least_turning);
}

/// the largest angle between normals; noise counts where there is any, which turns faces out of a common plane.
inline double largest_normal_error(const Shape& shape, const Support& support,
                                   const Shape_limits& limits)
{
  constexpr double most_flat = 0.1;
  return support.flat_fraction > most_flat
             ? limits.normal_error
             : limits.normal_error +
                   limits.normal_error_of_noise * shape.deviation / support.point_spacing;
}

/// whether a tube is hardly a tube.
inline bool is_too_bent(const Shape& shape, const Shape_limits& limits)
{
  return shape.is_tube() && shape.tube().curvature.norm() * shape.radius() > limits.bend;
}

inline bool is_supported(const Shape& shape, const Support& support, const Shape_limits& limits)
{
  const double least_observed =
      limits.least_observed + limits.observed_for_noise * shape.deviation / shape.radius();
  return support.clusters >= limits.least_clusters && !is_too_bent(shape, limits) &&
         is_round_enough(shape, support, limits) && (!shape.is_tube() || is_thick_enough(shape)) &&
         support.area > least_observed * full_area(shape) &&
         support.area_within < limits.most_within * support.area &&
         support.normal_error < largest_normal_error(shape, support, limits) &&
         support.explained > limits.least_explained && support.turning > limits.least_turning &&
         support.turning < limits.most_turning &&
         (shape.is_tube() ? support.spread[1] > limits.tube_spread
                          : support.spread[0] > limits.sphere_spread);
}

/// \brief an ellipsoid, which bends to much, must explain more of the surface, and better.
inline bool is_supported_ellipsoid(const Shape& shape, const Support& support)
{
  constexpr double least_observed = 0.3, least_explained = 0.7, most_misfit = 0.05;
  constexpr double least_spread = 0.1;
  return observed_fraction(shape, support) > least_observed &&
         support.explained > least_explained && support.spread[0] > least_spread &&
         shape.misfit < most_misfit * shape.radius();
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_JUDGE_SHAPE_H
