// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "transform_plan.h"

#include "errors.h"
#include "text.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/default_scales.h>
#include <CGAL/Area_projection_transform/regions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mapt {

namespace {

// The grid in numbers that cannot overflow, before there is one.
struct Frame
{
  std::array<double, 3> size;

  Frame(const CGAL::Bbox_3& box, double voxel, double margin)
  {
    for(int axis = 0; axis < 3; ++axis)
      size[axis] = std::ceil((box.max(axis) - box.min(axis) + 2 * margin) / voxel) + 1;
  }
  double rows() const { return size[1] * size[2]; }
  double voxels() const { return size[0] * rows(); }
  double padded_voxels(double padding) const
  {
    return (size[0] + 2 * padding) * (size[1] + 2 * padding) * (size[2] + 2 * padding);
  }
};

void check_memory(const Frame& frame, double bytes, const Transform_options& options)
{
  if(bytes <= options.common.max_memory)
    return;
  std::string dimensions;
  for(double size : frame.size)
    dimensions += (dimensions.empty() ? "" : " x ") + to_text(size, 9);
  throw Input_error(options.mesh + ": " + dimensions + " voxels need " + bytes_to_text(bytes) +
                    "; " + options.coarser_grid + " or raise --max-memory (" +
                    bytes_to_text(options.common.max_memory) + ")");
}

// What it takes to find the region, and the region itself. Along each axis the lines of the grid go
// through the surface once for every two of its voxels, in the mean of all directions.
double bytes_of_region(const Frame& frame, const Transform_plan& plan, const Input& input,
                       double area, std::size_t threads)
{
  const double rows = 60 * frame.rows();
  if(plan.region_name == "band")
    return rows + 60 * double(std::max(input.triangles.size(), input.points.size()));
  if(plan.region_name == "all")
    return rows;
  const double crossings = area / (2 * plan.voxel * plan.voxel);
  if(input.report.is_closed && input.report.is_consistently_oriented)
    return rows + 24 * crossings;
  const auto& size = frame.size;
  const double lines = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  return rows + 8 * lines + 40 * crossings + double(threads) * 18 * size[0] * size[1];
}

std::string choose_region(const Input& input, const Transform_options& options)
{
  if(input.is_point_set && options.region == "interior")
    throw Usage_error("--region interior: " + options.mesh +
                      " has points only, of which the interior is not known; use band or all");
  if(!options.region.empty())
    return options.region;
  return options.side == "inside" && !input.is_point_set ? "interior" : "all";
}

void check_for_points(const Input& input, const Transform_options& options)
{
  if(!input.is_point_set)
    return;
  if(options.method == "exact")
    throw Usage_error("--method exact: " + options.mesh +
                      " has points only, and exact areas need faces; use grid");
}

AP::Row_spans find_region(const AP::Grid_3& grid, const Surface& surface, double reach,
                          Transform_plan& plan)
{
  using Tag = CGAL::Parallel_if_available_tag;
  if(plan.region_name == "band")
    return std::visit([&](const auto* source) { return AP::band<Tag>(*source, grid, reach); },
                      surface.source());
  if(plan.region_name == "all")
    return AP::Row_spans(grid);
  AP::Interior interior =
      AP::interior<Tag>(*std::get<const AP::Triangle_surface*>(surface.source()), grid);
  plan.coverage = interior.coverage;
  return std::move(interior.region);
}

// Counts, beside the joint map of one side, the map of the other and those of the radii; the whole grid that the
// algorithm of the paper works on; and the program itself with its libraries and threads, as measured.
AP::Forecast forecast(const Frame& frame, const Transform_plan& plan, const Surface& surface,
                      const Transform_options& options)
{
  const double sides = double(plan.sides.size());
  const double maps = options.kind == "jmapt" ? 0 : double(plan.scales.size());
  const double joint_map = 5. / 4.; // in maps of floats
  const double stored = double(plan.region->storage_size());
  constexpr double bytes_of_program = 1e7;
  AP::Forecast result =
      AP::forecast_joint_map(stored, frame.rows(), double(surface.number_of_elements()),
                             surface.total_area(), plan.voxel, plan.scales, options.sampling_ratio,
                             double(plan.threads), sides * maps + (sides - 1) * joint_map);
  if(options.method == "paper") {
    result.bytes -= 4 * stored * double(std::min(plan.threads, plan.scales.size()));
    for(std::size_t t = 0; t < plan.threads; ++t) {
      const std::size_t k = plan.scales.size() - 1 - t % plan.scales.size();
      result.bytes += 4 * frame.padded_voxels(plan.scales[k].sigma / plan.voxel);
    }
  }
  result.writes *= sides;
  result.bytes += bytes_of_program + bytes_per_element(options.surface, plan.threads) *
                                         double(surface.number_of_elements());
  return result;
}

} // namespace

Transform_plan make_plan(const Input& input, const Surface& surface,
                         const Transform_options& options)
{
  check_for_points(input, options);
  const CGAL::Bbox_3& box = input.report.bounding_box;
  Transform_plan plan{};
  plan.voxel = options.voxel.value_or(AP::default_voxel_size(box));
  plan.scales = choose_scales(options.scales, box, plan.voxel);
  plan.sides =
      options.side == "both"
          ? std::vector<AP::Side>{AP::Side::INSIDE, AP::Side::OUTSIDE}
          : std::vector<AP::Side>{options.side == "inside" ? AP::Side::INSIDE : AP::Side::OUTSIDE};
  plan.region_name = choose_region(input, options);

  const double largest = plan.scales.back().radius;
  const double reach = largest + plan.scales.back().sigma;
  const double margin = options.margin.value_or(options.side == "inside" ? 0. : largest);
  const Frame frame(box, plan.voxel, margin);
  plan.threads = number_of_threads(options.common.threads);
  const double area = surface.total_area();
  check_memory(frame, bytes_of_region(frame, plan, input, area, plan.threads), options);
  if(plan.region_name == "all")
    check_memory(frame, 9 * frame.voxels(), options);
  for(const AP::Scale& scale : plan.scales)
    if(scale.sigma > 1000 * plan.voxel)
      throw Usage_error("sigma is " + to_text(scale.sigma, 9) +
                        ": more than 1000 voxels; raise --voxel, or lower --sigma");
  const Thread_limit limit(plan.threads);
  plan.region = std::make_shared<const AP::Row_spans>(
      find_region(AP::grid_around(box, plan.voxel, margin), surface, reach, plan));

  if(options.is_compensated && !plan.coverage)
    throw Usage_error("--compensate needs --region interior: only from inside is it known how much "
                      "of the surface is there");

  // Fewer threads hold fewer maps: better slow than not at all.
  do
    plan.forecast = forecast(frame, plan, surface, options);
  while(plan.forecast.bytes > options.common.max_memory && plan.threads-- > 1);
  check_memory(frame, plan.forecast.bytes, options);
  return plan;
}

} // namespace mapt
