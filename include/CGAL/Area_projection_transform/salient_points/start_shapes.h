// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_START_SHAPES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_START_SHAPES_H

#include <CGAL/Area_projection_transform/salient_points/fit_shape.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the clusters whose projections meet at a place.
struct Voters
{
  std::vector<std::size_t> clusters;
  double claimed_fraction = 0; ///< of the votes
  Eigen::Vector3d spread =
      Eigen::Vector3d::Zero(); ///< eigenvalues of the mean of `n nᵀ`, ascending
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX(); ///< the eigenvector of the smallest
};

inline Voters find_voters(const Free_clusters& clusters, const Eigen::Vector3d& x)
{
  const Vote_level& level = *clusters.level;
  Voters voters;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double free = 0, claimed = 0;
  level.for_each_in_ball(x, level.radius() + level.sigma(), [&](std::size_t i, double) {
    const double vote = level.vote(i, x);
    if(!(vote > 0))
      return;
    if(!clusters.is_free(i)) {
      claimed += vote;
      return;
    }
    free += vote;
    spread += vote * level.normal(i) * level.normal(i).transpose();
    voters.clusters.push_back(i);
  });
  voters.claimed_fraction = free + claimed > 0 ? claimed / (free + claimed) : 1;
  if(free > 0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread / free);
    voters.spread = eigen.eigenvalues();
    voters.axis = eigen.eigenvectors().col(0);
  }
  return voters;
}

/// moves a place to the weighted mean of the projections around it, until it rests (mean shift).
inline Eigen::Vector3d meeting_place(const Free_clusters& clusters, Eigen::Vector3d x)
{
  const Vote_level& level = *clusters.level;
  constexpr int most_steps = 5;
  for(int step = 0; step < most_steps; ++step) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    level.for_each_in_ball(x, level.radius() + level.sigma(), [&](std::size_t i, double) {
      const Eigen::Vector3d q = level.projection(i);
      if(!clusters.is_free(i) || !((q - x).squaredNorm() < level.sigma() * level.sigma()))
        return;
      sum += level.area(i) * q;
      total += level.area(i);
    });
    if(!(total > 0))
      break;
    const Eigen::Vector3d next = sum / total;
    const bool rests = (next - x).norm() < 0.02 * level.radius();
    x = next;
    if(rests)
      break;
  }
  return x;
}

/// \brief the radius and the centre for which the normals of voters meet best, `min Σ A |p − r n − x|²`,
/// across `axis` if it is not null.
struct Meeting
{
  double radius;
  Eigen::Vector3d center;
};

inline std::optional<Meeting> meeting_of_normals(const Vote_level& level,
                                                 const std::vector<std::size_t>& voters,
                                                 const Eigen::Vector3d& axis)
{
  using Vector = Eigen::Vector3d;
  Vector mean_p = Vector::Zero(), mean_n = Vector::Zero();
  double total = 0;
  const auto across = [&axis](const Vector& v) { return Vector(v - v.dot(axis) * axis); };
  for(std::size_t i : voters) {
    mean_p += level.area(i) * level.position(i);
    mean_n += level.area(i) * across(level.normal(i));
    total += level.area(i);
  }
  if(!(total > 0))
    return std::nullopt;
  mean_p /= total;
  mean_n /= total;
  double products = 0, squares = 0;
  for(std::size_t i : voters) {
    const Vector n = across(level.normal(i)) - mean_n;
    products += level.area(i) * n.dot(across(level.position(i) - mean_p));
    squares += level.area(i) * n.squaredNorm();
  }
  const double radius = squares > 0 ? products / squares : 0;
  if(!(radius > 0.3 * level.radius()) || !(radius < 2.5 * level.radius()))
    return std::nullopt;
  return Meeting{radius, mean_p - radius * mean_n};
}

inline std::optional<Shape> start_sphere(const Vote_level& level, const Voters& voters)
{
  const auto meeting =
      meeting_of_normals(level, voters.clusters, Eigen::Vector3d(Eigen::Vector3d::Zero()));
  if(!meeting)
    return std::nullopt;
  Shape shape;
  shape.model = Sphere{meeting->center, meeting->radius};
  shape.deviation = 0.1 * meeting->radius;
  return shape;
}

/// \param half_length in units of the radius
inline std::optional<Shape> start_tube(const Vote_level& level, const Voters& voters,
                                       double half_length)
{
  const auto meeting = meeting_of_normals(level, voters.clusters, voters.axis);
  if(!meeting)
    return std::nullopt;
  Shape shape;
  Tube tube;
  tube.center = meeting->center;
  tube.axis = voters.axis;
  tube.radius = meeting->radius;
  shape.model = tube;
  shape.last = half_length * meeting->radius;
  shape.first = -shape.last;
  shape.deviation = 0.1 * meeting->radius;
  return shape;
}

/// the ellipsoid of the points around a place that face away from it.
inline std::optional<Shape> start_ellipsoid(const Free_clusters& clusters, const Eigen::Vector3d& x)
{
  constexpr double reach = 2; // in units of the radius of the level
  constexpr double least_cosine = 0.2, largest_ratio = 3.5;
  const Vote_level& level = *clusters.level;
  std::vector<Eigen::Vector3d> points, normals;
  level.for_each_point_in_ball(x, reach * level.radius(), [&](std::size_t i, double squared) {
    const Eigen::Vector3d &p = level.point(i), &n = level.point_normal(i);
    if(clusters.is_point_free(i) && n.dot(p - x) > least_cosine * std::sqrt(squared)) {
      points.push_back(p);
      normals.push_back(n);
    }
  });
  if(points.size() < 3 * Fit_limits::least_points)
    return std::nullopt;
  const std::optional<Ellipsoid> ellipsoid =
      ellipsoid_with_normals(points, normals, x, level.radius());
  if(!ellipsoid)
    return std::nullopt;
  const Eigen::Vector3d lengths = ellipsoid->axes().lengths;
  if(!(lengths[2] < largest_ratio * lengths[0]) || !(lengths[2] < 4 * level.radius()))
    return std::nullopt;
  Shape shape;
  shape.model = *ellipsoid;
  shape.deviation = 0.1 * ellipsoid->radius();
  return shape;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_START_SHAPES_H
