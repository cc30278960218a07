// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_TRANSFORM_H
#define AREA_PROJECTION_PAPER_TRANSFORM_H

#include "damage.h"

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <memory>
#include <string>
#include <vector>

namespace Paper {

namespace AP = CGAL::Area_projection;

/// the maps of a surface over a region.
struct Maps
{
  AP::Joint_map joint;
  std::vector<std::vector<float>> scales; ///< at the places that `Row_spans::index()` gives
};

/// \param mode one of `normals_modes()`
Maps compute_maps(const std::string& mode, const Soup& soup,
                  std::shared_ptr<const AP::Row_spans> region,
                  const std::vector<AP::Scale>& scales);

/// the normalised transform at a point.
double value_at(const std::string& mode, const Soup& soup, const Point_3& point,
                const AP::Scale& scale);

/// a lattice around a surface with `voxels` voxels along its longest side.
AP::Grid_3 grid_of(const Soup& soup, int voxels);

/// the voxels inside of a surface, and the fraction of it that they see (see `AP::Interior`).
struct Inside
{
  std::shared_ptr<const AP::Row_spans> region;
  double coverage;
};

Inside inside(const Soup& soup, const AP::Grid_3& grid);

/// \brief writes a picture of one scale of maps as a PNG, before the silhouette of a surface.
/// \throw Output_error if it cannot be written.
void write_picture_of_scale(const std::string& file, const Maps& maps, std::size_t scale,
                            const Soup& silhouette);

/// the same for the joint map.
void write_picture_of_joint_map(const std::string& file, const Maps& maps, const Soup& silhouette);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_TRANSFORM_H
