// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_BEST_SCALE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_BEST_SCALE_H

#include <CGAL/Area_projection_transform/salient_points/Feature_surface.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// what the transform has at a point, over all radii.
struct Best_scale
{
  double radius;    ///< at which `APT / (4πR²)` is largest
  double intensity; ///< its value there
};

/// \brief returns the largest value of `APT / (4πR²)` at `x` over the radii from `smallest` to `largest`, for
/// `σ = ratio · R`: not at sampled radii, but over the continuum.
///
/// A patch at `u` from `x` with the normal `n` is projected into the ball if `(1 − c²) R² − 2 R u·n + u² ≤ 0`: an
/// interval of radii. Between the ends of these intervals the value falls, so it is largest where one begins.
/// Complexity: linear in the number of patches, and `O(m log m)` in that of the patches that vote.
inline Best_scale best_scale(const Feature_surface& surface, const Eigen::Vector3d& x, double ratio,
                             double smallest, double largest)
{
  struct Event
  {
    double radius, area;
  };
  std::vector<Event> begins, ends;
  const double a = 1 - ratio * ratio;
  const double reach = (1 + ratio) * largest, spacing = 0.3 * ratio * smallest;
  surface.for_each_patch_near(x, reach, spacing, [&](const Feature_surface::Patch& patch) {
    const Eigen::Vector3d u = patch.position - x;
    if(!(patch.area > 0))
      return;
    const double b = u.dot(patch.area_vector) / patch.area;
    const double discriminant = b * b - a * u.squaredNorm();
    if(!(b > 0) || !(discriminant >= 0))
      return;
    const double low = (b - std::sqrt(discriminant)) / a, high = (b + std::sqrt(discriminant)) / a;
    if(low > largest || high < smallest)
      return;
    begins.push_back({std::max(low, smallest), patch.area});
    ends.push_back({high, patch.area});
  });
  const auto by_radius = [](const Event& e, const Event& f) {
    return std::tie(e.radius, e.area) < std::tie(f.radius, f.area);
  };
  std::sort(begins.begin(), begins.end(), by_radius);
  std::sort(ends.begin(), ends.end(), by_radius);
  Best_scale best{smallest, 0};
  double area = 0;
  std::size_t end = 0;
  for(const Event& begin : begins) {
    for(; end < ends.size() && ends[end].radius < begin.radius; ++end)
      area -= ends[end].area;
    area += begin.area;
    const double value = area * Scale{begin.radius, 0}.normalization();
    if(value > best.intensity)
      best = {begin.radius, value};
  }
  return best;
}

/// the descriptors of a distribution with these variances along its principal axes, ascending.
inline Inertia_descriptors inertia_descriptors(const Eigen::Vector3d& variances)
{
  const Eigen::Vector3d d = variances.cwiseMax(0).cwiseSqrt();
  if(!(d[2] > 0))
    return {1, 0, 0};
  return {d[0] / d[2], (d[1] - d[0]) / d[2], (d[2] - d[1]) / d[2]};
}

/// \brief the descriptors of the map of one radius around `x`.
///
/// The map is the sum of a ball for each patch around its projection, so its inertia is that of the projections,
/// and that of a ball. Projections count up to two `σ` from `x`.
inline Inertia_descriptors inertia_at(const Feature_surface& surface, const Eigen::Vector3d& x,
                                      const Scale& scale)
{
  const double window = 2 * scale.sigma;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  const double reach = scale.radius + window;
  surface.for_each_patch_near(
      x, reach, 0.5 * scale.sigma, [&](const Feature_surface::Patch& patch) {
        if(!(patch.area > 0))
          return;
        const Eigen::Vector3d u =
            patch.position - (scale.radius / patch.area) * patch.area_vector - x;
        if(!(u.squaredNorm() < window * window))
          return;
        moments += patch.area * u * u.transpose();
        sum += patch.area * u;
        total += patch.area;
      });
  if(!(total > 0))
    return {1, 0, 0};
  const Eigen::Vector3d mean = sum / total;
  Eigen::Matrix3d covariance = moments / total - mean * mean.transpose();
  covariance.diagonal().array() += scale.sigma * scale.sigma / 5;
  return inertia_descriptors(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly)
          .eigenvalues());
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_BEST_SCALE_H
