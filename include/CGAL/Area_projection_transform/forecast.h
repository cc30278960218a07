// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_FORECAST_H
#define CGAL_AREA_PROJECTION_TRANSFORM_FORECAST_H

#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief what a computation will take, before it is begun.
struct Forecast
{
  double voxels; ///< with storage
  double bytes;  ///< at the peak, for the maps and the surface
  double writes; ///< additions to the maps, the unit of work
};

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief forecasts a joint map by `Grid_projector`.
///
/// \param voxels the number of voxels with storage
/// \param rows the number of rows of the grid
/// \param faces the number of faces, or of points
/// \param area the area of the surface
/// \param voxel_size the spacing of the grid
/// \param scales the scales
/// \param sampling_ratio the spacing of the surfels in units of `σ`
/// \param threads the number of threads; several share a scale if there are fewer scales
/// \param maps the number of maps of floats that are kept beside the joint map
///
/// The work is an estimate, good to a factor of two or three: surfels that land close together are
/// merged, and halved triangles are smaller than the spacing allows.
inline Forecast forecast_joint_map(double voxels, double rows, double faces, double area,
                                   double voxel_size, const std::vector<Scale>& scales,
                                   double sampling_ratio, double threads, double maps)
{
  const double pi = 3.14159265358979323846;
  Forecast forecast{voxels, 0, 0};
  for(const Scale& scale : scales) {
    const double spacing = sampling_ratio * scale.sigma;
    const double surfels = std::max(area / (spacing * spacing), 0.5 * faces);
    forecast.writes += 2 * surfels * pi * (scale.sigma / voxel_size) * (scale.sigma / voxel_size);
  }
  const double region = 40 * rows;    // hulls and runs
  const double surface = 450 * faces; // triangles, tree, and room to build it
  const double at_a_time = std::min(threads, double(scales.size()));
  double working = 4 * voxels * at_a_time + 80 * rows * threads; // sums, spare places, hulls
  if(at_a_time < threads)
    working += region * threads; // of the parts of the region
  forecast.bytes = (5 + 4 * maps) * voxels + working + region + surface;
  return forecast;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_FORECAST_H
