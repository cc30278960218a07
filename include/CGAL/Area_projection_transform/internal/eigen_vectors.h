// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EIGEN_VECTORS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EIGEN_VECTORS_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <Eigen/Core>

namespace CGAL {
namespace Area_projection {
namespace internal {

inline Eigen::Vector3d to_eigen(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

inline Eigen::Vector3d to_eigen(const Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EIGEN_VECTORS_H
