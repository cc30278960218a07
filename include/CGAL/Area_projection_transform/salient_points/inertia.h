// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_INERTIA_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_INERTIA_H

#include <CGAL/Area_projection_transform/Covariance_3.h>
#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief the radius of the ball around a maximum in which the inertia of the map is taken, in voxels.
///
/// It is twice the `σ` of the scale, since the spot that a sphere leaves in the map ends there at the
/// scale at which it is strongest, but at least three voxels: less is not enough to tell shapes apart.
/// \param sigma of the scale, in voxels
inline double inertia_radius(double sigma)
{
  return std::max(2 * sigma, 3.);
}

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief returns the covariance of the voxels in a ball, weighted by the values of a map, about their
/// centre of mass: in squared voxels; zero if there are no values.
///
/// \param region the voxels
/// \param map values, not negative, at the places that `region.index()` gives
/// \param centre the voxel in the centre of the ball
/// \param radius in voxels
inline Covariance_3 map_covariance(const Row_spans& region, const std::vector<float>& map,
                                   const std::array<int, 3>& centre, double radius)
{
  double mass = 0;
  Vector_3 first(0, 0, 0);
  Covariance_3 second;
  const int reach = int(radius);
  for(int k = -reach; k <= reach; ++k)
    for(int j = -reach; j <= reach; ++j) {
      const double rest = radius * radius - j * j - k * k;
      if(rest < 0)
        continue;
      const int half = int(std::sqrt(rest));
      for(int i = -half; i <= half; ++i) {
        const std::size_t place = region.index(centre[0] + i, centre[1] + j, centre[2] + k);
        if(place == region.storage_size() || !(map[place] > 0))
          continue;
        const double weight = map[place];
        const Vector_3 v(i, j, k);
        mass += weight;
        first = first + weight * v;
        second.add(v, v, weight);
      }
    }
  if(!(mass > 0))
    return Covariance_3();
  Covariance_3 covariance = (1 / mass) * second;
  covariance.add(first / mass, first / mass, -1);
  return covariance;
}

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief returns blobness, flatness and vesselness of a distribution; NaN if it has no extent.
///
/// They sum to 1. The smallest extent over the largest, the sphericity, is the blobness.
/// \param covariance the covariance matrix of the map around the point
inline Inertia_descriptors inertia_descriptors(const Covariance_3& covariance)
{
  Eigen::Matrix3d matrix;
  matrix << covariance.xx, covariance.xy, covariance.xz, //
      covariance.xy, covariance.yy, covariance.yz,       //
      covariance.xz, covariance.yz, covariance.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix, Eigen::EigenvaluesOnly);
  // Ascending; those that are zero may come out a little below.
  const auto extent = [&](int i) { return std::sqrt(std::max(solver.eigenvalues()[i], 0.)); };
  const double a = extent(2), b = extent(1), c = extent(0);
  if(!(a > 0))
    return {Salient_point::unknown, Salient_point::unknown, Salient_point::unknown};
  return {c / a, (b - c) / a, (a - b) / a};
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_INERTIA_H
