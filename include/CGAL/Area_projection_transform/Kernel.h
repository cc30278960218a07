// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_KERNEL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_KERNEL_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// the kernel of everything the package stores. Meshes, point sets and query points may come from
/// any other kernel (a model of `AreaProjectionTraits_3`); they are converted once, on entry.
using Kernel = CGAL::Simple_cartesian<double>;

/// \ingroup PkgAreaProjectionTransformGround
/// the points of `Kernel`.
using Point_3 = Kernel::Point_3;

/// \ingroup PkgAreaProjectionTransformGround
/// the vectors of `Kernel`.
using Vector_3 = Kernel::Vector_3;

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class AnyPoint>
Point_3 to_point(const AnyPoint& p)
{
  return Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

template <class AnyVector>
Vector_3 to_vector(const AnyVector& v)
{
  return Vector_3(CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z()));
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_KERNEL_H
