// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_DEFAULT_SCALES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_DEFAULT_SCALES_H

#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief returns the spacing of the grid when the user has none in mind: 1/128 of the longest side
/// of the bounding box of the surface.
/// \param box the bounding box of the surface
inline double default_voxel_size(const Bbox_3& box)
{
  return std::max({box.x_span(), box.y_span(), box.z_span()}) / 128;
}

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief returns radii that cover everything which fits into a box.
///
/// The smallest radius has `σ` of one and a half voxels; the largest is half the shortest side of the
/// box, since no ball inside the surface can be larger. They form a geometric series with steps of
/// at most `1 + sigma_ratio/2`, so that the ranges `R ± σ` of neighbours overlap by more than half:
/// every sphere and cylinder of a radius in between is seen by a scale near it.
/// \param box the bounding box of the surface
/// \param voxel_size the spacing of the grid, in the units of the surface, positive
/// \param sigma_ratio the ratio `σ/R`, in (0, 1)
/// \throw std::invalid_argument if `voxel_size` is not positive or `sigma_ratio` not in (0, 1).
inline std::vector<double> default_radii(const Bbox_3& box, double voxel_size,
                                         double sigma_ratio = 0.5)
{
  internal::check_positive(voxel_size, "voxel_size");
  internal::check_sigma_ratio(sigma_ratio);
  const double smallest = 1.5 * voxel_size / sigma_ratio;
  const double largest =
      std::max(smallest, std::min({box.x_span(), box.y_span(), box.z_span()}) / 2);
  const double steps = std::ceil(std::log(largest / smallest) / std::log(1 + sigma_ratio / 2));
  return geometric_radii(smallest, largest, std::size_t(steps) + 1);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_DEFAULT_SCALES_H
