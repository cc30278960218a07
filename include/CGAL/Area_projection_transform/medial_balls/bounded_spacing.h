// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_BOUNDED_SPACING_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_BOUNDED_SPACING_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief about how many samples a surface has at a spacing, good to a factor of two.
///
/// Needles are halved along both of their long edges: they take more pieces than their area tells.
inline double number_of_samples(const Triangle_surface& surface, double spacing)
{
  double sum = 0;
  for(std::size_t t = 0; t < surface.size(); ++t) {
    double longest = 0;
    for(int i = 0; i < 3; ++i)
      longest =
          std::max(longest, squared_distance(surface.corner(t, i), surface.corner(t, (i + 1) % 3)));
    sum += 1 + (2 * surface.areas[t] + 0.05 * longest) / (spacing * spacing);
  }
  return sum;
}

/// the spacing, or a larger one at which a surface has about so many samples at most.
inline double bounded_spacing(const Triangle_surface& surface, double spacing, double most)
{
  while(std::isnormal(spacing) && number_of_samples(surface, spacing) > most)
    spacing *= 1.3;
  return spacing;
}

/// points are as many as they are.
inline double bounded_spacing(const Surfels&, double spacing, double)
{
  return spacing;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_BOUNDED_SPACING_H
