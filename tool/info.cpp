// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt info: what is in a mesh or a map.

#include "command_line.h"
#include "commands.h"
#include "describe_input.h"
#include "errors.h"
#include "map_file.h"
#include "text.h"
#include "transform_plan.h"

#include <CGAL/Area_projection_transform/projection/Grid_projector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

// With the digits that tell it from a point which is 1/1000 of `length` away.
std::string point_to_text(double x, double y, double z, double length)
{
  return "(" + coordinate_to_text(x, length) + ", " + coordinate_to_text(y, length) + ", " +
         coordinate_to_text(z, length) + ")";
}

// -- meshes ---------------------------------------------------------------------------------------

void show_shape(const Input& input, Console& console)
{
  const Mesh_report& report = input.report;
  const CGAL::Bbox_3& box = report.bounding_box;
  const double length = std::max({box.x_span(), box.y_span(), box.z_span()});
  console.row("box", point_to_text(box.xmin(), box.ymin(), box.zmin(), length) + " to " +
                         point_to_text(box.xmax(), box.ymax(), box.zmax(), length));
  if(report.area > 0)
    console.row("area", to_text(report.area, 6));
  if(input.is_point_set)
    return;
  if(report.signed_volume)
    console.row("volume", to_text(*report.signed_volume, 6));
  if(report.genus)
    console.row("genus", std::to_string(*report.genus));
  console.row("faces", report.is_consistently_oriented
                           ? "all agree about the outside"
                           : counted(report.inconsistent_edges, "edge", "edges") +
                                 " between faces that disagree about the outside");
  console.row("parts", std::to_string(report.components));
}

// What `mapt transform` would take if it were called with nothing but this file.
void show_forecast(const Input& input, Console& console)
{
  Transform_options options;
  options.mesh = input.file;
  options.sampling_ratio = AP::Grid_projector::default_sampling_ratio;
  options.common.max_memory = std::numeric_limits<double>::infinity();
  const Transform_plan plan = make_plan(input, *make_surface(input, options.surface, 1), options);
  const auto& size = plan.region->grid().size();
  Json radii = Json::array();
  for(const AP::Scale& scale : plan.scales)
    radii.push_back(scale.radius);
  console.report["forecast"] = {{"voxel", plan.voxel},
                                {"size", size},
                                {"region", plan.region_name},
                                {"region_voxels", plan.region->number_of_voxels()},
                                {"radii", radii},
                                {"bytes", plan.forecast.bytes},
                                {"writes", plan.forecast.writes}};
  if(plan.coverage)
    console.report["coverage"] = *plan.coverage;
  console.row("transform",
              std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                  std::to_string(size[2]) + " voxels of " + to_text(plan.voxel) + ", " +
                  std::to_string(plan.region->number_of_voxels()) + " of them " +
                  (plan.region_name == "interior" ? "inside" : "to compute") + "; " +
                  counted(plan.scales.size(), "radius", "radii") + " from " +
                  to_text(plan.scales.front().radius) + " to " +
                  to_text(plan.scales.back().radius) + "; " + bytes_to_text(plan.forecast.bytes) +
                  ", " + to_text(plan.forecast.writes, 2) + " additions");
}

void show_operations(const Input& input, Console& console)
{
  const Mesh_report& report = input.report;
  std::string transform = "transform: any method";
  std::string evaluate = "evaluate: exact, samples or kd-tree";
  std::string normals = "--normals: face, interpolated, averaged or smoothed";
  if(input.is_point_set) {
    transform = "transform: grid or paper, in all voxels, since points have no interior";
    evaluate = "evaluate: samples or kd-tree, since points have no faces";
    normals = "--normals: face (those of the points) or averaged";
  } else if(!report.is_closed)
    transform += "; the interior is what most of six directions see as inside, and --compensate "
                 "divides by what they see";
  if(!report.is_consistently_oriented && !input.is_point_set)
    transform +=
        "; faces that look the wrong way project to the wrong side: --orient, or --side both";
  if(report.are_duplicates_joined)
    normals += "; neighbours are found by the positions of vertices";
  console.row("use", transform);
  console.row("", evaluate);
  console.row("", normals);
  console.report["operations"] = {transform, evaluate, normals};
}

void show_mesh(const std::string& file, const Reading_options& reading, Console& console)
{
  const Input input = read_input(file, reading);
  console.report["type"] = input.is_point_set ? "points" : "mesh";
  console.report.update(to_json(input.report));
  console.row("mesh", file + ": " + summary(input));
  show_shape(input, console);
  warn_of(input, console);
  show_forecast(input, console);
  show_operations(input, console);
}

// -- maps -----------------------------------------------------------------------------------------

struct Range
{
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  std::size_t not_finite = 0;
};

Range range_of(const AP::IO::Typed_values& values)
{
  Range range;
  std::visit(
      [&range](const auto& list) {
        for(const auto element : list) {
          const double value = double(element);
          if(!std::isfinite(value)) {
            ++range.not_finite;
            continue;
          }
          range.smallest = std::min(range.smallest, value);
          range.largest = std::max(range.largest, value);
        }
      },
      values);
  return range;
}

void show_array(const AP::IO::Stored_image::Array& array, Console& console)
{
  const Range range = range_of(array.values);
  const bool has_values = range.smallest <= range.largest;
  console.report["arrays"].push_back({{"name", array.name},
                                      {"components", array.components},
                                      {"min", has_values ? Json(range.smallest) : Json(nullptr)},
                                      {"max", has_values ? Json(range.largest) : Json(nullptr)},
                                      {"not_finite", range.not_finite}});
  console.row("array", array.name + ": " +
                           (has_values ? to_text(range.smallest) + " to " + to_text(range.largest)
                                       : std::string("no finite value")));
  if(range.not_finite > 0)
    console.warn("array " + array.name + ": " +
                 counted(range.not_finite, "value is", "values are") + " not finite");
}

void show_map(const std::string& file, Console& console)
{
  const AP::IO::Stored_image image = read_map(file);
  const AP::Grid_3& grid = image.grid;
  const auto& size = grid.size();
  console.report["type"] = "map";
  console.report["grid"] = {{"size", size},
                            {"origin", {grid.origin().x(), grid.origin().y(), grid.origin().z()}},
                            {"spacing", grid.spacing()},
                            {"voxels", grid.number_of_voxels()}};
  console.row("map", file + ": " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
                         " x " + std::to_string(size[2]) + " voxels of " + to_text(grid.spacing()));
  console.row("origin", point_to_text(grid.origin().x(), grid.origin().y(), grid.origin().z(),
                                      grid.spacing()) +
                            ", the centre of the first voxel");
  console.report["arrays"] = Json::array();
  for(const AP::IO::Stored_image::Array& array : image.arrays)
    show_array(array, console);
  console.report["metadata"] = Json::object();
  for(const AP::IO::Metadata_entry& entry : image.metadata) {
    const auto* text = std::get_if<std::string>(&entry.value);
    const auto* numbers = std::get_if<std::vector<double>>(&entry.value);
    console.report["metadata"][entry.name] = text ? Json(*text) : Json(*numbers);
    console.row(entry.name, text ? *text : list_to_text(*numbers));
  }
}

} // namespace

bool run_info(const std::vector<std::string>& arguments, Console& console)
{
  std::string file;
  Reading_options reading;
  Command_line app("mapt info",
                   "Tells what is in a file and what is wrong with it: of a mesh the counts, the "
                   "measures and what a transform would take; of a map its grid, ranges and "
                   "parameters.");
  app.add_option("FILE", file, "a mesh, points with normals, or a map (.vti .nrrd)")
      ->required()
      ->type_name("");
  add_normals_option(app, reading);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  console.report["file"] = file;
  const std::string extension = extension_of(file);
  const bool is_map = extension == ".vti" || extension == ".nrrd";
  if(is_map && reading.estimate_normals)
    throw Usage_error("--estimate-normals: " + file + " is a map, not points: leave it out");
  if(is_map)
    show_map(file, console);
  else
    show_mesh(file, reading, console);
  return true;
}

} // namespace mapt
