// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_results.h"

#include "cost.h"
#include "find_balls.h"
#include "find_lines.h"
#include "progress.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/medial_balls/select_balls.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>

#include <algorithm>
#include <stdexcept>

namespace mapt {

namespace {

using Tag = CGAL::Parallel_if_available_tag;

AP::Side side_of(const Report_options& options)
{
  return options.side == "inside" ? AP::Side::INSIDE : AP::Side::OUTSIDE;
}

Transform_options transform_options(const Input& input, const Report_options& options)
{
  const CGAL::Bbox_3& box = input.report.bounding_box;
  Transform_options transform;
  transform.mesh = options.mesh;
  transform.kind = "mapt"; // the map of each radius, and their joint map
  transform.side = options.side;
  transform.sampling_ratio = AP::Grid_projector::default_sampling_ratio;
  transform.coarser_grid = "lower --resolution";
  transform.voxel =
      std::max({box.x_span(), box.y_span(), box.z_span()}) / double(options.resolution);
  transform.scales = options.scales;
  transform.common = options.common;
  return transform;
}

// A surface that encloses nothing is looked at from all over the grid.
Transform_plan plan_maps(const Input& input, const Surface& surface, Transform_options& transform,
                         Console& console)
{
  Transform_plan plan = make_plan(input, surface, transform);
  if(plan.region->number_of_voxels() > 0)
    return plan;
  console.warn(transform.mesh + ": no voxel is inside: the maps cover all of the bounding box");
  transform.region = "all";
  return make_plan(input, surface, transform);
}

Salient_points find_salient(const Surface& surface, const Report_options& options,
                            const Console& console)
{
  Salient_options salient;
  salient.mesh = options.mesh;
  salient.side = options.side;
  return find_points(surface, salient, console);
}

AP::Centerline_graph find_lines(const Surface& surface, const Report_options& options,
                                const Console& console)
{
  AP::Centerline_options lines;
  lines.side = side_of(options);
  return find_lines(surface, lines, console);
}

// A page has room for a few thousand balls, and nobody sees those that almost coincide.
Shown_balls find_shown_balls(const Surface& surface, const Report_options& options,
                             const Console& console)
{
  constexpr std::size_t most = 3000;
  constexpr double apart = 0.3; // of the radius
  AP::Medial_ball_options choices;
  choices.side = side_of(options);
  const std::vector<AP::Medial_ball> all = find_balls(surface, choices, console);
  Shown_balls shown;
  shown.found = all.size();
  for(const std::size_t i : AP::select_strongest(all, AP::Medial_weight::IMPORTANCE, most, apart))
    shown.balls.push_back(all[i]);
  return shown;
}

void describe(const Input& input, Report_results& results)
{
  if(input.is_point_set) {
    results.no_descriptor = "a descriptor needs faces";
    return;
  }
  try {
    results.descriptor =
        AP::shape_descriptor<Tag>(AP::surface_from_triangle_soup(input.points, input.triangles));
  } catch(const std::invalid_argument& error) {
    results.no_descriptor = error.what();
  }
}

// Does one step after the other, tells which, and measures how long each takes.
class Steps
{
public:
  Steps(const Console& console, std::size_t number)
      : m_progress(console, "report"), m_number(double(number))
  {}

  template <class Work>
  auto operator()(const std::string& name, const Work& work)
  {
    Signal_watch::check();
    m_progress.hide();
    m_progress.show(double(m_seconds.size()) / m_number, name);
    Stopwatch watch;
    auto result = work();
    m_seconds.emplace_back(name, watch.seconds());
    return result;
  }

  const std::vector<std::pair<std::string, double>>& seconds() const { return m_seconds; }

private:
  Progress_line m_progress;
  double m_number;
  std::vector<std::pair<std::string, double>> m_seconds;
};

} // namespace

Report_results compute_report(const Input& input, const Report_options& options, Console& console)
{
  const auto surface =
      make_surface(input, Surface_options(), number_of_threads(options.common.threads));
  Transform_options transform = transform_options(input, options);
  Transform_plan plan = plan_maps(input, *surface, transform, console);

  Steps steps(console, 5 - options.left_out.size());
  std::vector<Side_maps> maps =
      steps("maps", [&] { return compute_maps(surface, plan, transform, console); });
  Report_results results{std::move(plan), std::move(maps.front()), {}, {}, {}, {}, {}, {}};
  if(options.has("salient"))
    results.salient =
        steps("salient points", [&] { return find_salient(*surface, options, console); });
  if(options.has("lines"))
    results.lines = steps("centrelines", [&] { return find_lines(*surface, options, console); });
  if(options.has("medial"))
    results.medial =
        steps("medial balls", [&] { return find_shown_balls(*surface, options, console); });
  if(options.has("descriptor"))
    steps("descriptor", [&] {
      describe(input, results);
      return true;
    });
  results.seconds = steps.seconds();
  return results;
}

} // namespace mapt
