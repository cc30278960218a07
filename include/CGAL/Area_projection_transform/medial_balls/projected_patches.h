// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_PROJECTED_PATCHES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_PROJECTED_PATCHES_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief counts the patches of a surface that are projected into a kernel: what the paper (section 4.2) takes to define the
/// medial axis.
///
/// The voters of `(x, R, σ)` are the points `p` with `|p - R n - x| ≤ σ`. Those that are farther apart than `2√(σR)`, the mean
/// of the diameters of kernel and ball, are of different patches; the count is the size of a set of such voters to which none
/// can be added, found greedily in the order of the points. As `σ` goes to 0, with `R` the distance of `x` from the surface, it becomes
///
/// - 1 where one point of the surface is the nearest: its voters are within `σ / (1 - κR)` of it, for the larger
///   curvature `κ`, which is less than `√(σR)` in the end;
/// - at least 2 where there are several, since whatever their distance is, it exceeds `2√(σR)` in the end.
///
/// So the full medial axis, with radii, is where the limit is greater than 1 *and* `R` is the distance; without that it is
/// the symmetry set. Connected parts of the surface would not do: the voters of the middle of a tube are one ring. The count
/// tells a wall (2, however small `σ` is) from a tube (it grows as `√(R/σ)`) and a sphere (as `R/σ`).
class Projected_patches
{
public:
  /// \param surfels the surface; its samples must be nearer to each other than the `σ` that is asked for
  /// \param side on which the places are that are asked about
  explicit Projected_patches(const Surfels& surfels, Side side = Side::INSIDE)
      : m_sign(side == Side::INSIDE ? 1 : -1)
  {
    for(std::size_t i = 0; i < surfels.size(); ++i) {
      m_positions.push_back(internal::to_eigen(surfels.positions[i]));
      m_normals.push_back(m_sign * internal::to_eigen(surfels.normals[i]));
    }
    m_cells = internal::Cell_list(m_positions, cell_size(surfels));
  }

  // The cells know where the points are.
  Projected_patches(const Projected_patches&) = delete;
  Projected_patches& operator=(const Projected_patches&) = delete;

  /// \brief returns the number of patches; 0 if there is no voter, as where `σ` is less than samples are apart.
  ///
  /// May be called concurrently.
  /// \throw std::invalid_argument if the radius or `σ` is not positive and finite
  std::size_t operator()(const Point_3& center, double radius, double sigma) const
  {
    internal::check_positive(radius, "radius");
    internal::check_positive(sigma, "sigma");
    const Vector x = internal::to_eigen(center);
    std::vector<std::size_t> voters;
    m_cells.for_each_in_ball(x, radius + sigma, [&](std::size_t i, double) {
      if((m_positions[i] - radius * m_normals[i] - x).squaredNorm() <= sigma * sigma)
        voters.push_back(i);
    });
    std::sort(voters.begin(), voters.end());
    return number_apart(voters, 4 * sigma * radius);
  }

private:
  using Vector = Eigen::Vector3d;

  static double cell_size(const Surfels& surfels)
  {
    double area = 0;
    for(const double a : surfels.areas)
      area += a;
    return area > 0 ? 5 * std::sqrt(area / double(surfels.size())) : 1;
  }

  std::size_t number_apart(const std::vector<std::size_t>& voters, double squared_distance) const
  {
    std::vector<Vector> patches;
    for(const std::size_t i : voters)
      if(std::all_of(patches.begin(), patches.end(), [&](const Vector& patch) {
           return (m_positions[i] - patch).squaredNorm() > squared_distance;
         }))
        patches.push_back(m_positions[i]);
    return patches.size();
  }

  double m_sign;
  std::vector<Vector> m_positions, m_normals;
  internal::Cell_list m_cells;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_PROJECTED_PATCHES_H
