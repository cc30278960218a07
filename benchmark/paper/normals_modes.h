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

#include <sstream>
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

/// the name of a mode that smooths, with a ratio of its own instead of the default: "averaged 0.15".
inline std::string mode_with_ratio(const std::string& mode, double ratio)
{
  std::ostringstream text;
  text << mode << ' ' << ratio;
  return text.str();
}

/// \brief calls `function(const ScaleSpace&)` with the scale space of a mode, which may have a ratio, and
/// returns what it returns.
template <class Function>
auto with_scale_space(const std::string& mode, const Soup& soup, Function&& function)
{
  std::istringstream words(mode);
  std::string name;
  words >> name;
  const auto ratio_or = [&words](double ratio) {
    double given = 0;
    return words >> given ? given : ratio;
  };
  const auto surface = AP::surface_from_triangle_soup(
      soup.points, soup.triangles,
      AP::parameters::use_interpolated_normals(name == "interpolated"));
  if(name == "face" || name == "interpolated")
    return function(AP::Constant_scale_space(surface));
  if(name == "averaged")
    return function(AP::Smoothing_scale_space(
        AP::Averaged_normals(surface, ratio_or(AP::Averaged_normals<>::default_averaging_ratio))));
  if(name == "smoothed")
    return function(AP::Smoothing_scale_space(AP::Mean_curvature_flow(
        surface, ratio_or(AP::Mean_curvature_flow::default_smoothing_ratio))));
  throw std::invalid_argument("mode is " + mode + ": there are no such normals");
}

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_NORMALS_MODES_H
