// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_COVARIANCE_3_H
#define CGAL_AREA_PROJECTION_TRANSFORM_COVARIANCE_3_H

#include <CGAL/Area_projection_transform/Kernel.h>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the covariance matrix of a distribution in space: how far it spreads, and where to.
///
/// In squared units of length. All zero for a single point.
struct Covariance_3
{
  double xx = 0; ///< the mean of `x²`, from the mean of `x`
  double xy = 0; ///< that of `x y`; so also the others
  double xz = 0; ///< \copybrief xy
  double yy = 0; ///< \copybrief xy
  double yz = 0; ///< \copybrief xy
  double zz = 0; ///< \copybrief xy

  /// the mean squared distance from the mean.
  double trace() const { return xx + yy + zz; }

  /// adds `weight` times the products of the components of `v` and `w`, made symmetric.
  void add(const Vector_3& v, const Vector_3& w, double weight)
  {
    xx += weight * v.x() * w.x();
    yy += weight * v.y() * w.y();
    zz += weight * v.z() * w.z();
    const double half = 0.5 * weight;
    xy += half * (v.x() * w.y() + v.y() * w.x());
    xz += half * (v.x() * w.z() + v.z() * w.x());
    yz += half * (v.y() * w.z() + v.z() * w.y());
  }

  friend Covariance_3 operator*(double s, const Covariance_3& c)
  {
    return {s * c.xx, s * c.xy, s * c.xz, s * c.yy, s * c.yz, s * c.zz};
  }

  friend Covariance_3 operator+(const Covariance_3& c, const Covariance_3& d)
  {
    return {c.xx + d.xx, c.xy + d.xy, c.xz + d.xz, c.yy + d.yy, c.yz + d.yz, c.zz + d.zz};
  }
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_COVARIANCE_3_H
