// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PATCH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PATCH_H

#include <CGAL/Area_projection_transform/Covariance_3.h>
#include <CGAL/Area_projection_transform/Grid_3.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a projected piece of surface as the balls of radius `r` around voxels see it; in voxels.
///
/// The share of the piece that lies in the ball around a voxel goes from 1 to 0 where its distance
/// from the mean passes `r`, over a ramp that depends on how far the piece spreads in that direction:
/// a cubic `3 t² - 2 t³` over `sqrt(20)` standard deviations, since the distribution with the density
/// `6 t (1 - t)` has the variance `1/20`. See patches_impl.h.
struct Patch
{
  std::int32_t i, j, k;         ///< the voxel nearest to the mean
  float x, y, z;                ///< the mean relative to that voxel, each in [-1/2, 1/2]
  float reach;                  ///< the share is zero at all voxels farther from the mean
  float full;                   ///< and one at all voxels closer to it; may be negative
  float xx, xy, xz, yy, yz, zz; ///< `5/(2 b²)` times the covariance, where `b = r² - trace`
  float quarter;                ///< `1/(4 b)`
  float least_q;                ///< for the direction in which a piece does not spread
  float amount;                 ///< what a voxel gets that holds all of it
};

/// \brief the balls of a given radius around the voxels of a grid.
class Patch_maker
{
public:
  /// \param radius in voxels
  Patch_maker(const Grid_3& grid, double radius)
      : m_origin(grid.origin())
      , m_voxels_per_unit(1 / grid.spacing())
      , m_size(grid.size())
      , m_radius(radius)
  {}

  /// where the mean of a piece lies between the voxels.
  std::array<double, 3> place(const Point_3& mean) const
  {
    std::array<double, 3> c;
    for(int axis = 0; axis < 3; ++axis)
      c[axis] = (mean[axis] - m_origin[axis]) * m_voxels_per_unit;
    return c;
  }

  bool is_outside(const std::array<double, 3>& place) const { return !is_within(place, 0.5); }

  /// \brief sets all of `patch` but its amount.
  ///
  /// A piece that spreads farther than the ball, as rounding makes it when it is moved by 10^16 times its size, is taken for
  /// a point at its mean.
  ///
  /// \return whether the piece reaches any voxel
  bool make(const std::array<double, 3>& place, const Covariance_3& covariance, Patch& patch) const
  {
    const Covariance_3 c = (m_voxels_per_unit * m_voxels_per_unit) * covariance;
    const double b = m_radius * m_radius - c.trace();
    if(!(b > 0))
      return make(place, Covariance_3(), patch);
    const double ramp = std::sqrt(20 * largest_eigenvalue(c));
    const double half_ramp = 0.505 * ramp; // a little more, for the approximations of the kernel
    const double reach = m_radius + half_ramp;
    if(!is_within(place, reach))
      return false;
    patch.i = std::int32_t(std::floor(place[0] + 0.5));
    patch.j = std::int32_t(std::floor(place[1] + 0.5));
    patch.k = std::int32_t(std::floor(place[2] + 0.5));
    patch.x = float(place[0] - patch.i);
    patch.y = float(place[1] - patch.j);
    patch.z = float(place[2] - patch.k);
    patch.reach = float(reach);
    patch.full = float(std::sqrt(b) - half_ramp);
    const double scale = 2.5 / (b * b);
    patch.xx = float(scale * c.xx);
    patch.xy = float(scale * c.xy);
    patch.xz = float(scale * c.xz);
    patch.yy = float(scale * c.yy);
    patch.yz = float(scale * c.yz);
    patch.zz = float(scale * c.zz);
    patch.quarter = float(0.25 / b);
    // Keeps roots away from rounding errors; widens the ramp by a thousandth of that across.
    patch.least_q = float(1e-10 + 1e-6 * scale * c.trace() * m_radius * m_radius);
    return true;
  }

private:
  bool is_within(const std::array<double, 3>& place, double distance) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(!(place[axis] >= -distance && place[axis] <= m_size[axis] - 1 + distance))
        return false;
    return true;
  }

  /// a bound: the fourth root of the trace of the fourth power. At most 3^(1/4) of the eigenvalue.
  static double largest_eigenvalue(const Covariance_3& c)
  {
    const double xx = c.xx * c.xx + c.xy * c.xy + c.xz * c.xz;
    const double yy = c.xy * c.xy + c.yy * c.yy + c.yz * c.yz;
    const double zz = c.xz * c.xz + c.yz * c.yz + c.zz * c.zz;
    const double xy = c.xx * c.xy + c.xy * c.yy + c.xz * c.yz;
    const double xz = c.xx * c.xz + c.xy * c.yz + c.xz * c.zz;
    const double yz = c.xy * c.xz + c.yy * c.yz + c.yz * c.zz;
    return std::sqrt(std::sqrt(xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)));
  }

  Point_3 m_origin;
  double m_voxels_per_unit;
  std::array<int, 3> m_size;
  double m_radius;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PATCH_H
