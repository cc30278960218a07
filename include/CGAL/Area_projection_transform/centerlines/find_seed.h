// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIND_SEED_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIND_SEED_H

#include <CGAL/Area_projection_transform/centerlines/Canal.h>
#include <CGAL/Area_projection_transform/centerlines/Sample_levels.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a place where a tube may be, and what speaks for it.
struct Line_seed
{
  Canal canal;
  double score = 0;
};

/// \brief the surface that meets at a place when it is moved by a radius along its normals.
struct Seed_votes
{
  double value = 0; ///< MAPT with the kernel of Epanechnikov
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();

  Seed_votes(const Sample_levels& levels, const Eigen::Vector3d& place, double radius)
  {
    constexpr double sigma_ratio = 0.3, coarseness = 1.5, pi = 3.14159265358979323846;
    const Sample_levels::Level& level = levels.at(coarseness * radius);
    const double sigma = sigma_ratio * radius;
    // No more than that of a flat face, however large, is near one place.
    const double most_of_face = pi * sigma * sigma;
    level.cells.for_each_in_ball(place, radius + sigma, [&](std::size_t i, double) {
      const Eigen::Vector3d& n = level.normals[i];
      const double offset = (level.positions[i] - radius * n - place).squaredNorm();
      const double weight = std::min(level.areas[i], most_of_face) * (1 - offset / (sigma * sigma));
      if(!(weight > 0))
        return;
      value += weight;
      normals.noalias() += weight * n * n.transpose();
    });
    value /= 4 * pi * radius * radius;
  }
};

/// \brief the best place under a sample, on the ray against its normal: where most of the surface meets (paper, section
/// 3), and the direction to which it is parallel there.
inline Line_seed find_seed(const Sample_levels& levels, const Line_samples& samples,
                           std::size_t index)
{
  constexpr double ratio = 1.2, of_blobs = 0.2;
  const Line_samples::Sample& sample = samples[index];
  double best_radius = 0, best = 0;
  for(double r = samples.smallest_radius(); r <= samples.largest_radius() * ratio; r *= ratio) {
    const double value = Seed_votes(levels, sample.position - r * sample.normal, r).value;
    if(value > best) {
      best = value;
      best_radius = r;
    }
  }
  Line_seed seed;
  if(!(best > 0))
    return seed;
  Tube& tube = seed.canal.tube;
  tube.radius = best_radius;
  tube.center = sample.position - best_radius * sample.normal;
  const Seed_votes votes(levels, tube.center, best_radius);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(votes.normals);
  const Eigen::Vector3d& l = eigen.eigenvalues();
  tube.axis = eigen.eigenvectors().col(0);
  seed.score = best * (of_blobs + (l[1] - l[0]) / l[2]);
  return seed;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIND_SEED_H
