// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SUPPORT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SUPPORT_H

#include <CGAL/Area_projection_transform/salient_points/fit_shape.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// what the surface says for and against a shape.
struct Support
{
  double area = 0;        ///< of the surface that lies on the shape
  double area_within = 0; ///< of the surface deep inside of it that does not face the centre
  /// the eigenvalues of the mean of `n nᵀ` over the normals of the shape there, ascending: 1/3 each for spheres
  /// and hemispheres, (0, 1/2, 1/2) for tubes and half tubes, (0, 0, 1) for a plane.
  Eigen::Vector3d spread = Eigen::Vector3d::Zero();
  /// \brief how much the normals turn from place to place, in units of what they turn on the shape: 0 on
  /// planes, however well they touch it, 1 on the shape.
  double turning = 0;
  /// \brief the angle between the normals of the surface, not averaged, and those of the shape (root mean square,
  /// in radians): what tells a rounded corner from a sharp one, of which there are few points.
  double normal_error = 0;
  /// of the pairs of near clusters between which the shape turns, those that lie in one plane: with noise, none.
  double flat_fraction = 0;
  double point_spacing = 0; ///< of the points on the shape, their median
  /// the area on the far side of the plane through the centre that has most on the other one.
  double far_area = 0;
  std::size_t clusters = 0;
  /// of the points that could belong to the shape, as near as they are and as their normals are, those that do.
  double explained = 0;
};

/// the full area of a shape.
inline double full_area(const Shape& shape)
{
  constexpr double pi = 3.14159265358979323846;
  const double r = shape.radius();
  if(shape.is_sphere())
    return 4 * pi * r * r;
  if(!shape.is_tube()) { // Thomsen's formula, to 1 %
    const Eigen::Vector3d a = shape.ellipsoid().axes().lengths.array().pow(1.6075);
    return 4 * pi * std::pow((a[0] * a[1] + a[0] * a[2] + a[1] * a[2]) / 3, 1 / 1.6075);
  }
  return 2 * pi * shape.tube().radius_at(0.5 * (shape.first + shape.last)) * shape.length();
}

/// the part of the area of a shape that is there, at most 1.
inline double observed_fraction(const Shape& shape, const Support& support)
{
  return std::min(support.area / full_area(shape), 1.);
}

namespace support {

constexpr double deep = 0.6; // what counts as deep inside, in units of the radius
constexpr double pair_distance =
    0.6; // of clusters whose normals are compared, in units of the radius
constexpr double least_cosine = 0.5;

struct Member
{
  std::size_t cluster;
  Eigen::Vector3d model;   // the normal of the shape there
  Eigen::Vector3d surface; // that of the surface, across the axis of a tube
};

/// \brief the regression of the normals of the surface on those of the shape, over pairs of near clusters, in the
/// direction in which it is least.
///
/// Directions into which the shape does not turn do not count, such as the axis of a tube.
inline double turning(const Vote_level& level, double radius, const std::vector<Member>& members,
                      double& flat_fraction)
{
  constexpr double flat = 1e-3, turned = 0.1; // differences of normals
  const double reach = pair_distance * radius;
  double all = 0, flats = 0;
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero(), squares = Eigen::Matrix3d::Zero();
  for(std::size_t a = 0; a < members.size(); ++a)
    for(std::size_t b = a + 1; b < members.size(); ++b) {
      const std::size_t i = members[a].cluster, j = members[b].cluster;
      if((level.position(i) - level.position(j)).squaredNorm() > reach * reach)
        continue;
      const Eigen::Vector3d turn = members[a].model - members[b].model;
      const double weight = std::min(level.area(i), level.area(j));
      products += weight * (members[a].surface - members[b].surface) * turn.transpose();
      squares += weight * turn * turn.transpose();
      if(turn.squaredNorm() > turned * turned) {
        all += 1;
        flats += (level.own_normal(i) - level.own_normal(j)).squaredNorm() < flat * flat ? 1 : 0;
      }
    }
  flat_fraction = all > 0 ? flats / all : 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(squares);
  double least = std::numeric_limits<double>::max();
  for(int k = 0; k < 3; ++k) {
    const Eigen::Vector3d direction = eigen.eigenvectors().col(k);
    if(eigen.eigenvalues()[k] > 0.05 * eigen.eigenvalues()[2])
      least = std::min(least, direction.dot(products * direction) / eigen.eigenvalues()[k]);
  }
  return least;
}

} // namespace support

/// \brief measures the part of the points around a shape, with normals like its own, that lies on it; and how
/// dense they are.
inline void measure_points(const Free_clusters& clusters, const Shape& shape, Support& support)
{
  constexpr double around = 0.25; // in units of the radius
  const double tolerance = std::max(4 * shape.deviation, 0.02 * shape.radius());
  const double band = std::max(around * shape.radius(), tolerance);
  const Vote_level& level = *clusters.level;
  std::vector<double> spacings;
  std::size_t number = 0;
  for_each_fitting_point(clusters, shape, band, [&](std::size_t i, const Shape::Place& place) {
    ++number;
    if(std::abs(place.residual) < tolerance)
      spacings.push_back(level.point_spacing(i));
  });
  support.explained = number > 0 ? double(spacings.size()) / double(number) : 0;
  support.point_spacing = median(spacings);
}

/// measures the support of a shape within `tolerance` of it.
inline Support measure_support(const Free_clusters& clusters, const Shape& shape, double tolerance)
{
  const Vote_level& level = *clusters.level;
  const double radius = shape.radius();
  Support result;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::vector<support::Member> members;
  clusters.for_each_near(shape, tolerance, 0, [&](std::size_t i, const Shape::Place& place) {
    const Eigen::Vector3d& n = level.normal(i);
    const double cosine = n.dot(place.normal);
    if(place.residual < -(1 - support::deep) * radius) {
      if(cosine > -0.3)
        result.area_within += level.area(i);
      return;
    }
    if(!(std::abs(place.residual) < tolerance) || !(cosine > support::least_cosine))
      return;
    const double area = level.area(i) * cosine;
    result.area += area;
    // Where faces point to all sides, or are turned over, the sum of them says little: it is short.
    result.normal_error += area * level.own_normal(i).cross(place.normal).squaredNorm();
    spread += area * place.normal * place.normal.transpose();
    mean += area * place.normal;
    ++result.clusters;
    members.push_back({i, place.normal, n - n.dot(place.axis) * place.axis});
  });
  if(!(result.area > 0))
    return result;
  result.spread =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread / result.area, Eigen::EigenvaluesOnly)
          .eigenvalues();
  for(const support::Member& member : members)
    if(member.model.dot(mean) < 0)
      result.far_area += level.area(member.cluster);
  result.normal_error = std::sqrt(result.normal_error / result.area);
  result.turning = support::turning(level, radius, members, result.flat_fraction);
  measure_points(clusters, shape, result);
  return result;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SUPPORT_H
