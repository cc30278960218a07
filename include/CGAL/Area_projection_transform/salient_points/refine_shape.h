// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_REFINE_SHAPE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_REFINE_SHAPE_H

#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>
#include <CGAL/Area_projection_transform/salient_points/fit_shape.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a radius, and how far it can be trusted.
struct Radius_estimate
{
  double radius;
  double low, high; ///< hold it with a probability of 95 %
};

/// which points of a surface a shape may be fitted to: those of the input, or those between them, too.
struct Fit_range
{
  std::size_t end; ///< the first that is not
  double margin;   ///< how far from the ends of a tube they must be; negative: how far beyond
};

/// all points of a range near a shape that their normals do not forbid.
inline std::vector<Eigen::Vector3d> points_on(const Feature_surface::Points& points,
                                              const Cell_list& cells, const Shape& shape,
                                              double band, const Fit_range& range)
{
  constexpr double least_cosine = 0.4; // normals of single points are noisy
  std::vector<Eigen::Vector3d> found;
  const Shape_bound bound(shape, band, std::max(-range.margin, 0.));
  cells.for_each_in_ball(bound.center(), bound.reach(), [&](std::size_t v, double) {
    if(v >= range.end || !bound.may_hold(points.positions[v]))
      return;
    const Shape::Place place = shape.place(points.positions[v]);
    if(std::abs(place.residual) < band && shape.is_along(place.along, -range.margin) &&
       points.normals[v].dot(place.normal) > least_cosine)
      found.push_back(points.positions[v]);
  });
  return found;
}

/// \brief the points that tell most of a shape.
///
/// Not those at the very ends of tubes: noise would take points of flat caps for points of the tube. Where there are
/// no others, the ends; and only then points between those of the input, which share the errors of these.
inline std::vector<Eigen::Vector3d> best_points_on(const Feature_surface::Points& points,
                                                   const Cell_list& cells, const Shape& shape,
                                                   double band)
{
  constexpr std::size_t enough = 20;
  const double inner = std::min(2 * shape.deviation, 0.2 * shape.length());
  const double outer = -3 * shape.deviation - 0.02 * shape.radius();
  for(const Fit_range& range : {Fit_range{points.number_of_independent, inner},
                                Fit_range{points.number_of_independent, outer}}) {
    std::vector<Eigen::Vector3d> found = points_on(points, cells, shape, band, range);
    if(found.size() >= enough)
      return found;
  }
  return points_on(points, cells, shape, band, {points.positions.size(), inner});
}

/// \brief the standard deviations from the mean that hold 95 % of Student's distribution, to 1 % from five
/// degrees of freedom on.
inline double student_quantile(double degrees_of_freedom)
{
  return 1.96 + 2.4 / std::max(degrees_of_freedom - 1, 1.);
}

/// the mean square of the residuals that are no outliers.
inline double mean_square(const Shape& shape, const std::vector<Eigen::Vector3d>& points)
{
  const Tukey tukey(shape.deviation);
  double sum = 0, number = 0;
  for(const Eigen::Vector3d& p : points) {
    const double residual = shape.place(p).residual;
    if(tukey.weight(residual) > 0) {
      sum += residual * residual;
      number += 1;
    }
  }
  return number > 0 ? sum / number : 0;
}

/// \brief fits a shape to all points on it, and tells how well its radius is known.
///
/// Independent displacements of standard deviation `s` in all directions move points away from a sphere of radius
/// `r` by `s²/r` in the mean, and from a cylinder by half of that: the radius is corrected for it.
inline Radius_estimate refine_shape(const Feature_surface::Points& points, const Cell_list& cells,
                                    Shape& shape)
{
  constexpr int most_rounds = 12;
  constexpr std::size_t spare = 8; // points more than parameters
  Tube::Freedom freedom;
  if(shape.is_tube())
    freedom = {shape.tube().slope != 0, shape.tube().curvature.squaredNorm() > 0};
  std::vector<Eigen::Vector3d> chosen;
  for(int round = 0; round < most_rounds; ++round) {
    const double radius = shape.radius();
    chosen = best_points_on(points, cells, shape,
                            std::clamp(6 * shape.deviation, 1e-5 * radius, 0.25 * radius));
    if(chosen.size() < Fit_limits::least_points)
      break;
    if(shape.is_tube() && chosen.size() < std::size_t(freedom.number()) + spare) {
      freedom = {};
      std::get<Tube>(shape.model).slope = 0;
      std::get<Tube>(shape.model).curvature.setZero();
    }
    std::vector<double> residuals;
    for(const Eigen::Vector3d& p : chosen)
      residuals.push_back(shape.place(p).residual);
    shape.deviation = std::max(robust_deviation(residuals), 1e-9 * radius);
    if(move_shape(shape, chosen, shape.deviation, freedom) < 1e-9)
      break;
  }
  const double r = shape.radius(), s = shape.deviation;
  if(!shape.is_sphere() && !shape.is_tube())
    return {r, Salient_point::unknown, Salient_point::unknown};
  double variance = 0, degrees = 1, correction = mean_square(shape, chosen) / r;
  if(shape.is_sphere()) {
    variance = shape.sphere().equations(chosen, s).covariance({0, 1, 2, 3})(3, 3);
    degrees = double(chosen.size()) - 4;
  } else {
    variance = shape.tube()
                   .equations(chosen, s, freedom)
                   .covariance(freedom.free_parameters())(Tube::RADIUS, Tube::RADIUS);
    degrees = double(chosen.size()) - freedom.number();
    correction /= 2;
  }
  const double half = student_quantile(degrees) * std::sqrt(std::max(variance, 0.)) + 1e-6 * r;
  return {r - correction, r - correction - half, r - correction + half};
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_REFINE_SHAPE_H
