// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_BALLS_AT_H
#define AREA_PROJECTION_TRANSFORM_TEST_BALLS_AT_H

#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>

#include <vector>

namespace shapes {

/// balls that nothing joins.
inline CGAL::Area_projection::Medial_representation
balls_at(const std::vector<CGAL::Area_projection::Point_3>& centers,
         const std::vector<double>& radii)
{
  CGAL::Area_projection::Medial_representation result;
  result.centers = centers;
  result.radii = radii;
  return result;
}

} // namespace shapes

#endif // AREA_PROJECTION_TRANSFORM_TEST_BALLS_AT_H
