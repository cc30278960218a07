// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_VALUES_AT_VOXELS_H
#define AREA_PROJECTION_TRANSFORM_TEST_VALUES_AT_VOXELS_H

#include "shapes.h"

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>

#include <vector>

namespace shapes {

/// the values of an evaluator at the centres of the voxels of interest, at their places.
template <class Evaluator>
std::vector<double> values_at_voxels(const Evaluator& evaluator,
                                     const CGAL::Area_projection::Row_spans& region, double sigma,
                                     const std::vector<CGAL::Area_projection::Nested_ball>& kernel)
{
  std::vector<double> values(region.storage_size());
  for_each_voxel(region, [&](const CGAL::Area_projection::Point_3& x, std::size_t place) {
    values[place] = evaluator(x, sigma, kernel);
  });
  return values;
}

} // namespace shapes

#endif // AREA_PROJECTION_TRANSFORM_TEST_VALUES_AT_VOXELS_H
