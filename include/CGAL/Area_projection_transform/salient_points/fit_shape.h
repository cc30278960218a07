// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FIT_SHAPE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FIT_SHAPE_H

#include <CGAL/Area_projection_transform/salient_points/Shape.h>
#include <CGAL/Area_projection_transform/salient_points/Vote_level.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// what is still to be had of a level: claimed clusters belong to shapes that were found before.
struct Free_clusters
{
  const Vote_level* level;
  const std::vector<char>* claimed_clusters;
  const std::vector<char>* claimed_points;

  bool is_free(std::size_t i) const { return !(*claimed_clusters)[i]; }
  bool is_point_free(std::size_t i) const { return !(*claimed_points)[i]; }

  /// calls `function(i, place)` for the free clusters near a shape.
  template <class Function>
  void for_each_near(const Shape& shape, double band, double margin, Function&& function) const
  {
    const Shape_bound bound(shape, band, margin);
    level->for_each_in_ball(bound.center(), bound.reach(), [&](std::size_t i, double) {
      if(!is_free(i) || !bound.may_hold(level->position(i)))
        return;
      const Shape::Place place = shape.place(level->position(i));
      if(shape.is_along(place.along, margin))
        function(i, place);
    });
  }
};

/// the limits of the alternating fits.
struct Fit_limits
{
  static constexpr std::size_t least_points = 8;
  static constexpr double least_cosine = 0.6; ///< between the normals of shape and surface
  static constexpr int most_rounds = 10;
};

/// \brief calls `function(i, place)` for the points that a shape may be fitted to: those in a band around it whose
/// normals agree.
template <class Function>
void for_each_fitting_point(const Free_clusters& clusters, const Shape& shape, double band,
                            Function&& function)
{
  const Vote_level& level = *clusters.level;
  const Shape_bound bound(shape, band);
  level.for_each_point_in_ball(bound.center(), bound.reach(), [&](std::size_t i, double) {
    if(!clusters.is_point_free(i) || !bound.may_hold(level.point(i)))
      return;
    const Shape::Place place = shape.place(level.point(i));
    if(std::abs(place.residual) < band && shape.is_along(place.along, 0) &&
       level.point_normal(i).dot(place.normal) > Fit_limits::least_cosine)
      function(i, place);
  });
}

inline void collect_points(const Free_clusters& clusters, const Shape& shape, double band,
                           std::vector<Eigen::Vector3d>& points, std::vector<double>& residuals)
{
  points.clear();
  residuals.clear();
  for_each_fitting_point(clusters, shape, band, [&](std::size_t i, const Shape::Place& place) {
    points.push_back(clusters.level->point(i));
    residuals.push_back(place.residual);
  });
}

/// \brief the band around a shape in a round of its fit, from wide to the deviation of the points.
inline double band_of_round(int round, double radius, double deviation)
{
  if(round == 0)
    return 0.3 * radius;
  return std::min(std::max(5 * deviation, (round < 3 ? 0.12 : 0.01) * radius), 0.25 * radius);
}

/// \brief splits the deviation of residuals, which come in the order of their places, into noise and misfit.
///
/// Neighbours differ by the noise of both, and what they share is misfit (von Neumann's ratio).
inline double misfit_of(const std::vector<double>& residuals, double deviation)
{
  std::vector<double> differences;
  for(std::size_t i = 1; i < residuals.size(); ++i)
    differences.push_back(residuals[i] - residuals[i - 1]);
  const double noise = robust_deviation(differences) / std::sqrt(2.);
  return std::sqrt(std::max(deviation * deviation - noise * noise, 0.));
}

/// moves a shape by a step of its fit; returns how far, in units of the radius.
inline double move_shape(Shape& shape, const std::vector<Eigen::Vector3d>& points, double deviation,
                         const Tube::Freedom& freedom)
{
  if(shape.is_sphere()) {
    Sphere& sphere = std::get<Sphere>(shape.model);
    const auto equations = sphere.equations(points, deviation);
    const Sphere::Equations::Row step =
        equations.step(Sphere::Equations::Row::Constant(1e-9)); // lone caps leave a direction open
    sphere.move(step);
    return step.norm() / sphere.radius;
  }
  if(!shape.is_tube()) {
    Ellipsoid& ellipsoid = std::get<Ellipsoid>(shape.model);
    const Ellipsoid::Equations::Row step =
        ellipsoid.equations(points, deviation).step(Ellipsoid::Equations::Row::Constant(1e-6));
    ellipsoid.move(step);
    return step.norm() / ellipsoid.radius();
  }
  Tube& tube = std::get<Tube>(shape.model);
  Tube::Equations::Row ridge;
  ridge << 1e-9, 1e-9, 1e-6, 1e-6, 1e-9, freedom.slope ? 1e-4 : 1, freedom.curvature ? 1e-4 : 1,
      freedom.curvature ? 1e-4 : 1;
  const Tube::Equations::Row step = tube.equations(points, deviation, freedom).step(ridge);
  tube.move(step);
  return step.norm() / tube.radius;
}

/// \brief fits a shape to the points around it, choosing points and moving the shape in turn.
/// \return whether it came to rest at a shape of a similar size
inline bool fit_shape(const Free_clusters& clusters, Shape& shape, const Tube::Freedom& freedom,
                      int first_round = 0)
{
  const double start = shape.radius();
  std::vector<Eigen::Vector3d> points;
  std::vector<double> residuals;
  for(int round = first_round; round < first_round + Fit_limits::most_rounds; ++round) {
    const double radius = shape.radius();
    collect_points(clusters, shape, band_of_round(round, radius, shape.deviation), points,
                   residuals);
    if(points.size() < Fit_limits::least_points)
      return false;
    shape.deviation = std::max(robust_deviation(residuals), 1e-9 * radius);
    shape.misfit = misfit_of(residuals, shape.deviation);
    const double step = move_shape(shape, points, shape.deviation, freedom);
    if(!(shape.radius() > 0.4 * start) || !(shape.radius() < 2.5 * start))
      return false;
    if(round >= 4 && step < 1e-4)
      break;
  }
  return true;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FIT_SHAPE_H
