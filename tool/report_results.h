// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_REPORT_RESULTS_H
#define MAPT_REPORT_RESULTS_H

#include "report_options.h"
#include "salient_points.h"
#include "transform_maps.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mapt {

/// what a page shows of the medial balls: the most important ones, the most important first.
struct Shown_balls
{
  std::vector<AP::Medial_ball> balls;
  std::size_t found = 0;
};

/// all that is found in a surface. Parts that were left out are empty.
struct Report_results
{
  Transform_plan plan;
  Side_maps maps;
  std::optional<Salient_points> salient;
  std::optional<AP::Centerline_graph> lines;
  std::optional<Shown_balls> medial;
  std::optional<AP::Shape_descriptor> descriptor;
  std::string no_descriptor;                           // why there is none
  std::vector<std::pair<std::string, double>> seconds; // of each step
};

/// \throw Usage_error, Input_error if the options do not suit the surface
/// \throw Interruption
Report_results compute_report(const Input& input, const Report_options& options, Console& console);

} // namespace mapt

#endif // MAPT_REPORT_RESULTS_H
