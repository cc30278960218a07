// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DIAGONAL_OF_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DIAGONAL_OF_H

#include <CGAL/Bbox_3.h>

#include <cmath>

namespace CGAL {
namespace Area_projection {
namespace internal {

inline double diagonal_of(const Bbox_3& box)
{
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DIAGONAL_OF_H
