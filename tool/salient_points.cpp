// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_points.h"

#include "errors.h"
#include "with_progress.h"

#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>
#include <CGAL/Area_projection_transform/salient_points.h>
#include <CGAL/Area_projection_transform/salient_points/paper_salient_points.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace mapt {

namespace {

using Tag = CGAL::Parallel_if_available_tag;
using Points = std::vector<AP::Salient_point>;

/// what is done, for the progress line.
std::string task_of(AP::Side side)
{
  return std::string("salient points, ") + AP::IO::to_text(side);
}

Points fitted_points(const Surface& surface, AP::Side side, const Salient_options& options,
                     const Console& console)
{
  AP::Salient_point_options choices;
  choices.side = side;
  choices.smallest_radius = options.smallest_radius;
  choices.largest_radius = options.largest_radius;
  choices.threshold = options.used_threshold();
  choices.tube_spacing = options.tube_spacing;
  return with_progress(task_of(side), console, [&](const auto& np) {
    return std::visit(
        [&](const auto* source) { return AP::salient_points<Tag>(*source, choices, np); },
        surface.source());
  });
}

Points maxima(const Surface& surface, AP::Side side, const Salient_options& options,
              const Console& console)
{
  AP::Paper_salient_options choices;
  choices.side = side;
  choices.reference_length = options.smallest_radius;
  choices.largest_radius = options.largest_radius;
  choices.threshold = options.used_threshold();
  choices.use_joint_map = options.mode == "joint";
  return with_progress(task_of(side), console, [&](const auto& np) {
    return std::visit(
        [&](const auto* source) { return AP::paper_salient_points<Tag>(*source, choices, np); },
        surface.source());
  });
}

// The library names its own parameters, which are the options by other words.
Points points_of_side(const Surface& surface, AP::Side side, const Salient_options& options,
                      const Console& console)
{
  try {
    return options.is_fitted() ? fitted_points(surface, side, options, console)
                               : maxima(surface, side, options, console);
  } catch(const std::invalid_argument& error) {
    throw Usage_error("--mode " + options.mode + ": " + error.what() +
                      "; see --radius-min and --radius-max");
  }
}

bool is_wanted(const AP::Salient_point& point, const std::vector<std::string>& types)
{
  return types.empty() ||
         std::find(types.begin(), types.end(), AP::IO::to_text(point.shape)) != types.end();
}

// The strongest first; of equal ones, those inside.
void sort(Salient_points& found)
{
  std::vector<std::size_t> order(found.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return found.points[a].intensity > found.points[b].intensity;
  });
  Salient_points sorted;
  for(const std::size_t i : order) {
    sorted.points.push_back(std::move(found.points[i]));
    sorted.sides.push_back(found.sides[i]);
  }
  found = std::move(sorted);
}

} // namespace

Salient_points find_points(const Surface& surface, const Salient_options& options,
                           const Console& console)
{
  Salient_points found;
  for(const AP::Side side : {AP::Side::INSIDE, AP::Side::OUTSIDE}) {
    if(options.side != "both" && options.side != AP::IO::to_text(side))
      continue;
    for(AP::Salient_point& point : points_of_side(surface, side, options, console))
      if(is_wanted(point, options.types)) {
        found.points.push_back(std::move(point));
        found.sides.push_back(side);
      }
  }
  if(options.side == "both")
    sort(found);
  return found;
}

} // namespace mapt
