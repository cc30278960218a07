// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SIDE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SIDE_H

#include <CGAL/Area_projection_transform/Kernel.h>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the side of the surface on which its parallel surfaces are taken.
///
/// Normals point outward; a surfel at `p` with unit normal `n` is projected to `p - R n` on the
/// inside and to `p + R n` on the outside. The sides are never added: each has its own map.
enum class Side { INSIDE, OUTSIDE };

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the factor of the outward normal that moves a surfel by `radius` to `side`.
inline double signed_distance(Side side, double radius)
{
  return side == Side::INSIDE ? -radius : radius;
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SIDE_H
