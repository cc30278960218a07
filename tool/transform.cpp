// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt transform: from a mesh to its maps.

#include "commands.h"
#include "cost.h"
#include "describe_input.h"
#include "local_maxima.h"
#include "map_file.h"
#include "picture.h"
#include "progress.h"
#include "text.h"
#include "threads.h"
#include "transform_output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

std::vector<double> radii_of(const Transform_plan& plan)
{
  std::vector<double> radii;
  for(const AP::Scale& scale : plan.scales)
    radii.push_back(scale.radius);
  return radii;
}

std::vector<double> sigmas_of(const Transform_plan& plan)
{
  std::vector<double> sigmas;
  for(const AP::Scale& scale : plan.scales)
    sigmas.push_back(scale.sigma);
  return sigmas;
}

void report_parameters(const Transform_plan& plan, const Transform_options& options,
                       Console& console)
{
  Json& json = console.report["parameters"];
  json["kind"] = options.kind;
  json["radii"] = radii_of(plan);
  json["sigma"] = sigmas_of(plan);
  if(!options.scales.sigma)
    json["sigma_ratio"] = options.scales.sigma_ratio;
  json["voxel"] = plan.voxel;
  json["side"] = options.side;
  json["region"] = plan.region_name;
  json["normals"] = options.surface.normals;
  if(const auto ratio = options.surface.used_smoothing_ratio())
    json["smoothing_ratio"] = *ratio;
  json["is_compensated"] = options.is_compensated;
  json["method"] = options.method;
  json["kernel"] = options.kernel;
  json["sampling_ratio"] = options.sampling_ratio;
  json["threads"] = plan.threads;
  json["max_memory"] = options.common.max_memory;
}

void report_plan(const Transform_plan& plan, const Transform_options& options, Console& console)
{
  report_parameters(plan, options, console);
  const AP::Grid_3& grid = plan.region->grid();
  const auto& size = grid.size();
  console.report["grid"] = {{"size", size},
                            {"origin", {grid.origin().x(), grid.origin().y(), grid.origin().z()}},
                            {"spacing", grid.spacing()},
                            {"voxels", grid.number_of_voxels()},
                            {"region_voxels", plan.region->number_of_voxels()},
                            {"stored_voxels", plan.region->storage_size()}};
  if(plan.coverage)
    console.report["coverage"] = *plan.coverage;
  console.report["forecast"] = {{"voxels", plan.forecast.voxels},
                                {"bytes", plan.forecast.bytes},
                                {"writes", plan.forecast.writes}};

  console.row("grid", std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                          std::to_string(size[2]) + " voxels of " + to_text(plan.voxel));
  console.row("region", plan.region_name + ": " +
                            counted(plan.region->number_of_voxels(), "voxel", "voxels"));
  if(plan.coverage && *plan.coverage < 0.9995 && *plan.coverage > 0)
    console.row("coverage", to_text(100 * *plan.coverage, 3) +
                                " % of the surface is there, seen from inside" +
                                (options.is_compensated ? ": values are divided by it" : ""));
  console.row("radii", list_to_text(radii_of(plan)));
  console.row("sigma", options.scales.sigma
                           ? to_text(*options.scales.sigma)
                           : to_text(options.scales.sigma_ratio) +
                                 " of the radius: " + list_to_text(sigmas_of(plan)));
  console.row("side", options.side + ", " + options.surface.normals + " normals");
  console.row("method", options.method + ", " + options.kernel + ", " +
                            counted(plan.threads, "thread", "threads"));
  console.row("forecast", bytes_to_text(plan.forecast.bytes) + ", " +
                              to_text(plan.forecast.writes, 2) + " additions");
}

void warn_of_plan(const Transform_plan& plan, const Transform_options& options, Console& console)
{
  const double smallest = plan.scales.front().sigma;
  if(smallest < plan.voxel)
    console.warn("the smallest collecting ball has a radius of " + to_text(smallest) +
                 ", less than a voxel: its map is coarse; lower --voxel");
  if(plan.region->number_of_voxels() == 0)
    console.warn(options.mesh + ": no voxel is in the region, '" + plan.region_name +
                 "'; for an open surface use --region band or all");
}

void report_area_outside(const std::vector<Side_maps>& maps, double area, Console& console)
{
  double largest = 0;
  for(const Side_maps& side : maps) {
    std::vector<double> percent;
    for(double outside : side.areas_outside)
      percent.push_back(100 * outside / area);
    largest = std::max(largest, *std::max_element(percent.begin(), percent.end()));
    console.report["area_outside_percent"][side.side == AP::Side::INSIDE ? "inside" : "outside"] =
        percent;
  }
  if(largest > 0)
    console.row("lost", to_text(largest, 2) +
                            " % of the area at most, at one radius, falls outside of the grid");
}

void report_maxima(const Side_maps& maps, const Transform_options& options, Console& console)
{
  constexpr std::size_t number = 10;
  const bool is_inside = maps.side == AP::Side::INSIDE;
  const std::vector<Local_maximum> maxima = strongest_local_maxima(maps.joint, number);
  Json& json = console.report[is_inside ? "maxima" : "maxima_outside"];
  json = Json::array();
  for(const Local_maximum& m : maxima)
    json.push_back({{"x", m.position.x()},
                    {"y", m.position.y()},
                    {"z", m.position.z()},
                    {"radius", m.radius},
                    {"value", m.value}});
  console.line("");
  if(maxima.empty()) {
    console.line("Nothing found: the joint map is zero " +
                 std::string(is_inside ? "inside" : "outside") + " at these radii.");
    return;
  }
  console.line("The strongest local maxima of the joint map, " +
               std::string(is_inside ? "inside:" : "outside:"));
  console.line("           x           y           z      radius   value");
  for(const Local_maximum& m : maxima) {
    char line[128];
    std::snprintf(line, sizeof line, "%12.5g%12.5g%12.5g%12.4g%8.3f", m.position.x(),
                  m.position.y(), m.position.z(), m.radius, m.value);
    console.line(line);
  }
  const double c = options.scales.sigma_ratio;
  if(!options.scales.sigma && maps.joint.scales().size() > 1)
    console.line("The radius is that of the map: a sphere is strongest at " +
                 to_text(1 / (1 + c), 2) + " of its own radius, a tube at " +
                 to_text(4 / (3 + std::sqrt(1 + 8 * c * c)), 2) + ".");
}

void report_outside_as_maxima(Console& console)
{
  if(!console.report.contains("maxima"))
    console.report["maxima"] = console.report["maxima_outside"];
}

void write_files(const std::vector<Side_maps>& maps, const Surface& surface,
                 const Transform_plan& plan, const Transform_options& options, Console& console)
{
  Json& outputs = console.report["outputs"];
  outputs = Json::array();
  if(!options.output.empty()) {
    write_maps(maps, plan, options);
    outputs.push_back(options.output);
  }
  if(!options.picture.empty()) {
    write_picture(options.picture, maps.front().joint, surface.source());
    outputs.push_back(options.picture);
  }
}

} // namespace

bool run_transform(const std::vector<std::string>& arguments, Console& console)
{
  Transform_options options;
  if(!read_options(arguments, console, options))
    return false;
  for(const std::string& file : {options.output, options.picture})
    if(!file.empty())
      check_writable(file);

  Stopwatch watch;
  const Thread_limit limit(number_of_threads(options.common.threads));
  const Input input = read_described(options.mesh, options.common.reading, console);
  const double reading = watch.seconds();

  const Signal_watch signals;
  const auto surface =
      make_surface(input, options.surface, number_of_threads(options.common.threads));
  const Transform_plan plan = make_plan(input, *surface, options);
  report_plan(plan, options, console);
  warn_of_plan(plan, options, console);
  const std::vector<Side_maps> maps = compute_maps(surface, plan, options, console);
  const double computing = watch.seconds();
  Signal_watch::check();
  write_files(maps, *surface, plan, options, console);
  const double writing = watch.seconds();

  report_cost({reading, computing, writing}, console);
  report_area_outside(maps, surface->total_area(), console);
  for(const std::string file : console.report["outputs"])
    console.row("written", file);
  if(console.report["outputs"].empty())
    console.row("written", "nothing: name a file with -o or --picture");
  for(const Side_maps& side : maps)
    report_maxima(side, options, console);
  report_outside_as_maxima(console);
  return true;
}

} // namespace mapt
