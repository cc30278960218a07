// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_summary.h"

#include "local_maxima.h"
#include "salient_report.h"
#include "text.h"

#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>

#include <algorithm>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_table = 8;

std::vector<double> radii_of(const Report_results& results)
{
  std::vector<double> radii;
  for(const AP::Scale& scale : results.plan.scales)
    radii.push_back(scale.radius);
  return radii;
}

void report_maps(const Report_results& results, Console& console)
{
  const std::vector<Local_maximum> maxima = strongest_local_maxima(results.maps.joint, 1);
  Json& json = console.report["joint_map"];
  json["largest"] = maxima.empty() ? 0. : maxima[0].value;
  if(maxima.empty()) {
    console.row("maps", "zero at all radii");
    return;
  }
  const auto& [position, radius, value] = maxima[0];
  const auto coordinate = [r = radius](double x) { return coordinate_to_text(x, r); };
  json["at"] = {position.x(), position.y(), position.z()};
  json["radius"] = radius;
  console.row("maps", "largest value " + to_text(value, 3) + " at (" + coordinate(position.x()) +
                          ", " + coordinate(position.y()) + ", " + coordinate(position.z()) +
                          "), radius " + to_text(radius));
}

void report_lines(const AP::Centerline_graph& lines, Console& console)
{
  double length = 0;
  for(const AP::Centerline_branch& branch : AP::branches(lines))
    length += branch.length;
  console.report["lines"] = {{"branches", AP::branches(lines).size()}, {"length", length}};
  console.row("lines", counted(AP::branches(lines).size(), "branch", "branches") + ", " +
                           to_text(length) + " long together");
}

void report_medial(const Shown_balls& medial, Console& console)
{
  double largest = 0;
  for(const AP::Medial_ball& ball : medial.balls)
    largest = std::max(largest, ball.refitted_radius);
  console.report["medial"] = {
      {"balls", medial.found}, {"shown", medial.balls.size()}, {"largest_radius", largest}};
  console.row("balls", counted(medial.found, "medial ball", "medial balls") +
                           ", the largest of radius " + to_text(largest));
}

void report_descriptor(const Report_results& results, Console& console)
{
  if(!results.descriptor) {
    console.report["descriptor"] = {{"missing", results.no_descriptor}};
    console.row("hapt", "none: " + results.no_descriptor);
    return;
  }
  console.report["descriptor"] = {{"reference_length", results.descriptor->reference_length},
                                  {"coverage", results.descriptor->coverage},
                                  {"values", results.descriptor->values}};
  console.row("hapt", counted(results.descriptor->values.size(), "number", "numbers") +
                          ", reference length " + to_text(results.descriptor->reference_length));
}

void report_salient(const Salient_points& found, Console& console)
{
  console.report["salient"] = to_json(found);
  const std::size_t shown = std::min(found.points.size(), longest_table);
  console.row("salient",
              counted(found.points.size(), "point", "points") +
                  (shown < found.points.size() ? ", the strongest " + std::to_string(shown) + ":"
                   : shown > 0                 ? ":"
                                               : ""));
  if(shown > 0)
    console.line(table_heading(true));
  for(std::size_t i = 0; i < shown; ++i)
    console.line(table_line(found.points[i], true));
}

} // namespace

void report_parameters(const Report_results& results, const Report_options& options,
                       Console& console)
{
  const AP::Grid_3& grid = results.plan.region->grid();
  Json& json = console.report["parameters"];
  json["side"] = options.side;
  json["radii"] = radii_of(results);
  if(options.scales.sigma)
    json["sigma"] = *options.scales.sigma;
  else
    json["sigma_ratio"] = options.scales.sigma_ratio;
  json["resolution"] = options.resolution;
  json["voxel"] = results.plan.voxel;
  json["region"] = results.plan.region_name;
  json["left_out"] = options.left_out;
  json["threads"] = results.plan.threads;
  console.report["grid"] = {{"size", grid.size()},
                            {"origin", {grid.origin().x(), grid.origin().y(), grid.origin().z()}},
                            {"spacing", grid.spacing()},
                            {"region_voxels", results.plan.region->number_of_voxels()}};
  if(results.plan.coverage)
    console.report["coverage"] = *results.plan.coverage;
  Json& steps = console.report["steps"];
  for(const auto& [name, seconds] : results.seconds)
    steps[name] = seconds;

  const auto& size = grid.size();
  console.row("grid", std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                          std::to_string(size[2]) + " voxels of " + to_text(grid.spacing()) + ", " +
                          results.plan.region_name);
  console.row("radii", list_to_text(radii_of(results)));
}

void report_results(const Report_results& results, const Report_options& options, Console& console)
{
  std::string times;
  for(const auto& [name, seconds] : results.seconds)
    times += (times.empty() ? "" : ", ") + name + " " +
             to_text(std::round(1000 * seconds) / 1000, 2) + " s";
  console.row("steps", times);
  report_maps(results, console);
  if(results.lines)
    report_lines(*results.lines, console);
  if(results.medial)
    report_medial(*results.medial, console);
  if(options.has("descriptor"))
    report_descriptor(results, console);
  if(results.salient)
    report_salient(*results.salient, console);
}

void report_page(const Page_summary& page, const Input& input, const Report_options& options,
                 Console& console)
{
  console.report["outputs"].push_back(options.output);
  console.report["page"] = {{"bytes", page.bytes}, {"faces", page.faces}};
  console.row("written",
              options.output + ", " + bytes_to_text(double(page.bytes)) + ": open it in a browser");
  if(page.faces < input.triangles.size())
    console.row("", "the page draws " + std::to_string(page.faces) + " of " +
                        std::to_string(input.triangles.size()) + " faces: see --most-faces");
}

} // namespace mapt
