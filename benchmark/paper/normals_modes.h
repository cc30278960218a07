// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_NORMALS_MODES_H
#define AREA_PROJECTION_PAPER_NORMALS_MODES_H

#include "damage.h"

#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scale_space/Mean_curvature_flow.h>
#include <CGAL/Area_projection_transform/scale_space/Smoothing_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace Paper {

namespace AP = CGAL::Area_projection;

// The ways to get normals from a surface, in the order in which they are shown. This file is the only place
// that knows them.

inline const std::vector<std::string>& normals_modes()
{
  static const std::vector<std::string> names{"face", "interpolated", "averaged", "smoothed"};
  return names;
}

/// calls `function(const ScaleSpace&)` with the scale space of a mode and returns what it returns.
template <class Function>
auto with_scale_space(const std::string& mode, const Soup& soup, Function&& function)
{
  const auto surface = AP::surface_from_triangle_soup(
      soup.points, soup.triangles,
      AP::parameters::use_interpolated_normals(mode == "interpolated"));
  if(mode == "face" || mode == "interpolated")
    return function(AP::Constant_scale_space(surface));
  if(mode == "averaged")
    return function(AP::Smoothing_scale_space(AP::Averaged_normals(surface)));
  if(mode == "smoothed")
    return function(AP::Smoothing_scale_space(AP::Mean_curvature_flow(surface)));
  throw std::invalid_argument("mode is " + mode + ": there are no such normals");
}

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_NORMALS_MODES_H
