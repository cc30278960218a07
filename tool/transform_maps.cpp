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

#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <functional>
#include <type_traits>

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

template <class Source>
AP::Multiscale_summary project(const AP::Constant_scale_space<Source>& surface,
                               const Transform_plan& plan, const Transform_options& options,
                               const Console& console, Side_maps& maps)
{
  Progress_line line(console, maps.side == AP::Side::INSIDE ? "inside" : "outside");
  const std::function<bool(double)> callback = [&line](double fraction) {
    line.show(fraction);
    return !Signal_watch::is_interrupted();
  };
  Scale_teller teller;
  teller.console = &console;
  const AP::Row_spans& region = *plan.region;
  const auto balls = nested_balls(options.kernel);
  const auto run = [&](auto make_projector) {
    return AP::project_scales<CGAL::Parallel_if_available_tag>(
        surface, region, plan.scales, maps.side, make_projector, maps,
        CGAL::parameters::callback(callback).visitor(std::ref(teller)));
  };
  if constexpr(std::is_same_v<Source, AP::Triangle_surface>)
    if(options.method == "exact")
      return run([&] { return AP::Exact_grid_projector(region, balls); });
  if(options.method == "paper")
    return run([&] { return AP::Paper_grid_projector(region, balls); });
  return run([&] { return AP::Grid_projector(region, balls, options.sampling_ratio); });
}

} // namespace

std::vector<Side_maps> compute_maps(const Surface& surface, const Transform_plan& plan,
                                    const Transform_options& options, const Console& console)
{
  const Thread_limit limit(plan.threads);
  std::vector<Side_maps> result;
  for(AP::Side side : plan.sides) {
    Side_maps maps{side, AP::Joint_map(plan.region, plan.scales), std::nullopt, {}};
    if(options.kind != "jmapt")
      maps.of_scales.emplace(*plan.region, plan.scales.size());
    const AP::Multiscale_summary summary = std::visit(
        [&](const auto& s) { return project(s, plan, options, console, maps); }, surface);
    if(!summary.is_complete)
      throw Interruption();
    maps.areas_outside = summary.areas_outside;
    result.push_back(std::move(maps));
  }
  return result;
}

} // namespace mapt
