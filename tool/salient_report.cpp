// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_report.h"

#include "text.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_table = 20;

// null stands for what the library chooses.
Json or_null(const std::optional<double>& value)
{
  return value ? Json(*value) : Json();
}

Json counts_of(const Salient_points& found)
{
  Json counts;
  for(const AP::Salient_shape shape : {AP::Salient_shape::SPHERE, AP::Salient_shape::TUBE,
                                       AP::Salient_shape::CONE, AP::Salient_shape::OTHER})
    counts[AP::IO::to_text(shape)] =
        std::count_if(found.points.begin(), found.points.end(),
                      [shape](const AP::Salient_point& p) { return p.shape == shape; });
  return counts;
}

std::string counts_to_text(const Json& counts)
{
  std::string text;
  for(const auto& [type, count] : counts.items())
    if(count > 0)
      text +=
          (text.empty() ? "" : ", ") + counted(count, type, type == "other" ? type : type + "s");
  return text;
}

std::string right_aligned(const std::string& text, int width)
{
  return std::string(std::size_t(std::max(width - int(text.size()), 1)), ' ') + text;
}

// A number in a column, or a dash.
std::string column(double value, int width, const char* format)
{
  char text[48] = "-";
  if(!std::isnan(value))
    std::snprintf(text, sizeof text, format, value);
  return right_aligned(text, width);
}

// Far from the origin of their units, points need more digits than the size of the shape tells.
std::string columns_of_position(const AP::Point_3& p, double radius)
{
  std::string columns;
  for(const double value : {p.x(), p.y(), p.z()})
    columns += right_aligned(coordinate_to_text(value, radius), 12);
  return columns;
}

void show_strongest(const Salient_points& found, const Salient_options& options, Console& console)
{
  const std::size_t shown = std::min(found.points.size(), longest_table);
  console.line("");
  console.line(shown < found.points.size() ? "The strongest " + std::to_string(shown) + " of " +
                                                 std::to_string(found.points.size()) + ":"
                                           : "The strongest first:");
  const bool has_sides = options.side == "both";
  console.line(table_heading(options.is_fitted()) + std::string(has_sides ? "  side" : ""));
  for(std::size_t i = 0; i < shown; ++i)
    console.line(table_line(found.points[i], options.is_fitted()) +
                 (has_sides ? std::string("  ") + AP::IO::to_text(found.sides[i]) : ""));
  if(options.is_fitted())
    console.line("The radius is within ± of the true one with a probability of 95 %, if the "
                 "vertices scatter independently.");
  else
    console.line("The scale is raw: about two thirds of the radius of a sphere, 85 % of that of a "
                 "tube.");
}

} // namespace

std::string table_line(const AP::Salient_point& point, bool is_fitted)
{
  if(!is_fitted)
    return columns_of_position(point.position, point.scale) + column(point.scale, 12, "%.4g") +
           column(point.intensity, 11, "%.3f") + column(point.sphericity, 12, "%.2f");
  std::string type = AP::IO::to_text(point.shape);
  type.resize(6, ' ');
  return type + columns_of_position(point.position, point.radius) +
         column(point.radius, 12, "%.5g") +
         column((point.radius_high - point.radius_low) / 2, 10, "%.2g") +
         column(point.intensity, 11, "%.3f") + column(100 * point.observed_fraction, 10, "%.0f %%");
}

const char* table_heading(bool is_fitted)
{
  return is_fitted ? "type             x           y           z      radius        ±  intensity  "
                     "observed"
                   : "           x           y           z       scale  intensity  sphericity";
}

Json to_json(const Salient_points& found)
{
  Json points = Json::array();
  for(std::size_t i = 0; i < found.points.size(); ++i) {
    Json point;
    AP::IO::for_each_column(found.points[i], found.sides[i],
                            [&point](const char* name, const auto& value) { point[name] = value; });
    points.push_back(std::move(point));
  }
  return points;
}

void report_parameters(const Salient_options& options, Console& console)
{
  console.report["parameters"] = {{"mode", options.mode},
                                  {"side", options.side},
                                  {"threshold", options.used_threshold()},
                                  {"radius_min", or_null(options.smallest_radius)},
                                  {"radius_max", or_null(options.largest_radius)},
                                  {"types", options.types},
                                  {"tube_spacing", or_null(options.tube_spacing)},
                                  {"threads", number_of_threads(options.common.threads)}};
  console.row("method", options.mode + ", " + options.side + ", threshold " +
                            to_text(options.used_threshold()));
}

void report_points(const Salient_points& found, const Salient_options& options, Console& console)
{
  console.report["points"] = to_json(found);
  const Json counts = counts_of(found);
  console.report["counts"] = counts;
  if(found.points.empty()) {
    const double threshold = options.used_threshold();
    console.warn(
        options.mesh + ": nothing found: no point has " +
        (threshold > 0 ? "an intensity of " + to_text(threshold) : "a radius in the range") +
        (options.types.empty() ? "" : " and such a type") + "; " +
        (threshold > 0 ? "lower --threshold" : "widen --radius-min and --radius-max") +
        ", or look at the other side with --side");
    return;
  }
  console.row("found", counted(found.points.size(), "point", "points") +
                           (options.is_fitted() ? ": " + counts_to_text(counts) : ""));
  show_strongest(found, options, console);
}

} // namespace mapt
