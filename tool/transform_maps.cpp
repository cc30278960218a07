// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "transform_maps.h"

#include "errors.h"
#include "progress.h"
#include "text.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <functional>

namespace mapt {

namespace {

std::vector<AP::Nested_ball> nested_balls(const std::string& kernel)
{
  if(kernel == "epanechnikov")
    return AP::Epanechnikov_kernel_3().nested_balls();
  if(kernel == "gaussian")
    return AP::Gaussian_kernel_3().nested_balls();
  return AP::Ball_kernel_3().nested_balls();
}

// Tells of each scale on stderr, with --verbose.
struct Scale_teller : AP::Multiscale_default_visitor
{
  const Console* console;

  void scale_ends(std::size_t, const AP::Scale& scale, double) const
  {
    console->note("radius " + to_text(scale.radius) + " is done");
  }
};

// Calls `function(make_projector)` with what makes projectors by the method that was asked for.
template <class Function>
void with_method(const Transform_options& options, Function&& function)
{
  const auto balls = nested_balls(options.kernel);
  if(options.method == "exact")
    return function(
        [balls](const AP::Row_spans& part) { return AP::Exact_grid_projector(part, balls); });
  if(options.method == "paper")
    return function(
        [balls](const AP::Row_spans& part) { return AP::Paper_grid_projector(part, balls); });
  function(AP::Make_grid_projector{balls, options.sampling_ratio});
}

template <class Session>
Side_maps compute_side(Session& session, AP::Side side, const Transform_plan& plan,
                       const Transform_options& options, const Console& console)
{
  Side_maps maps{side, AP::Joint_map(plan.region, plan.scales), std::nullopt, {}, 1};
  if(options.is_compensated && *plan.coverage > 0)
    maps.factor = float(1 / *plan.coverage);
  if(options.kind != "jmapt")
    maps.of_scales.emplace(*plan.region, plan.scales.size());
  Progress_line line(console, side == AP::Side::INSIDE ? "inside" : "outside");
  const std::function<bool(double)> callback = [&line](double fraction) {
    line.show(fraction);
    return !Signal_watch::is_interrupted();
  };
  Scale_teller teller;
  teller.console = &console;
  const AP::Multiscale_summary& summary = session.project(
      plan.scales, side, maps, CGAL::parameters::callback(callback).visitor(std::ref(teller)));
  if(!summary.is_complete)
    throw Interruption();
  maps.areas_outside = summary.areas_outside;
  return maps;
}

} // namespace

std::vector<Side_maps> compute_maps(const std::shared_ptr<const Surface>& surface,
                                    const Transform_plan& plan, const Transform_options& options,
                                    const Console& console)
{
  const Thread_limit limit(plan.threads);
  std::vector<Side_maps> result;
  with_method(options, [&](auto make_projector) {
    AP::Map_session<Surface, CGAL::Parallel_if_available_tag, decltype(make_projector)> session(
        surface, plan.voxel, 0, make_projector);
    for(const AP::Side side : plan.sides) {
      session.set_region(side, plan.region);
      result.push_back(compute_side(session, side, plan, options, console));
    }
  });
  return result;
}

} // namespace mapt
