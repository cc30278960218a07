// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TRIANGLE_MEASURES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TRIANGLE_MEASURES_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the normal of a triangle, by its corners, of the length of twice its area.
inline Vector_3 doubled_area_vector(const Triangle_surface& surface, std::size_t t)
{
  return cross_product(surface.corner(t, 1) - surface.corner(t, 0),
                       surface.corner(t, 2) - surface.corner(t, 0));
}

/// the area that each triangle has by its corners, whatever it votes with.
inline std::vector<double> geometric_areas(const Triangle_surface& surface)
{
  std::vector<double> areas(surface.size());
  for(std::size_t t = 0; t < areas.size(); ++t)
    areas[t] = 0.5 * std::sqrt(doubled_area_vector(surface, t).squared_length());
  return areas;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TRIANGLE_MEASURES_H
