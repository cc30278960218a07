// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_AABB_TRAITS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_AABB_TRAITS_H

#include <CGAL/version.h>

// CGAL 6.0 renamed the traits of trees of boxes, and warns of the old name.
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

namespace CGAL {
namespace Area_projection {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <class GeomTraits, class Primitive>
using Aabb_traits = CGAL::AABB_traits_3<GeomTraits, Primitive>;
#else
template <class GeomTraits, class Primitive>
using Aabb_traits = CGAL::AABB_traits<GeomTraits, Primitive>;
#endif

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_AABB_TRAITS_H
