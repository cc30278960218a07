// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "medial_comparison.h"

#include "medial_reconstruction.h"
#include "text.h"
#include "with_progress.h"

#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;
using Tag = CGAL::Parallel_if_available_tag;

struct Comparison
{
  AP::Medial_axes axes;
  std::vector<AP::Medial_measures> measures; // of each axis
  std::vector<std::optional<double>>
      thickness; // of each: the ranks of its diameters against CGAL's
  std::vector<std::vector<AP::Spread_of_values>> distances; // from each to each
  std::optional<AP::Betti_numbers> shape;
  double diagonal = 0;
};

// Rays of the shape diameter function go inside.
std::vector<std::optional<double>> thickness_of(const AP::Medial_axes& axes,
                                                const AP::Triangle_surface& surface,
                                                const Medial_options& options)
{
  std::vector<std::optional<double>> result(axes.axes.size());
  if(options.computation.side == AP::Side::OUTSIDE)
    return result;
  const std::vector<double> diameters = AP::shape_diameters(surface);
  for(std::size_t i = 0; i < result.size(); ++i) {
    const double correlation = AP::shape_diameter_correlation(axes.axes[i], surface, diameters);
    if(!std::isnan(correlation))
      result[i] = correlation;
  }
  return result;
}

std::vector<std::optional<double>> thickness_of(const AP::Medial_axes& axes, const AP::Surfels&,
                                                const Medial_options&)
{
  return std::vector<std::optional<double>>(axes.axes.size());
}

template <class Source>
Comparison compare(const Source& source, const Medial_result& found, const Medial_options& options,
                   const Console& console)
{
  AP::Medial_axes_options choices;
  choices.balls = options.computation;
  choices.lines.side = options.computation.side;
  choices.coverage = options.coverage.value_or(choices.coverage);
  choices.number = options.balls;
  choices.tolerance = options.tolerance;
  choices.seed = options.seed;
  Comparison result;
  result.axes = with_progress("medial axes", console, [&](const auto& np) {
    return AP::medial_axes<Tag>(source, found.balls, found.seconds, choices, np);
  });
  result.shape = AP::shape_topology(source);
  result.diagonal = AP::internal::diagonal_of(source.bbox());
  if(result.axes.axes.empty())
    return result;
  const AP::Medial_judge<Source> judge(source, result.axes.axes.front(), result.axes.tolerance,
                                       options.seed);
  for(const AP::Medial_representation& axis : result.axes.axes) {
    Signal_watch::check();
    result.measures.push_back(judge.template measure<Tag>(axis));
  }
  Signal_watch::check();
  result.thickness = thickness_of(result.axes, source, options);
  Signal_watch::check();
  result.distances = AP::axis_distance_matrix<Tag>(
      result.axes.axes, std::max(result.axes.tolerance, 0.001 * result.diagonal));
  return result;
}

Json or_null(const std::optional<AP::Betti_numbers>& topology)
{
  return topology ? mapt::to_json(*topology) : Json();
}

Json to_json(const AP::Ball_volume& volume)
{
  const auto estimate = [](const std::optional<AP::Estimated_volume>& v) {
    return v ? Json{{"value", v->value}, {"error", v->error}} : Json();
  };
  const std::optional<double> overlap = volume.overlap();
  return {{"balls", estimate(volume.balls)},
          {"solid", estimate(volume.solid)},
          {"common", estimate(volume.common)},
          {"overlap", overlap ? Json(*overlap) : Json()}};
}

Json distances_to_json(const Comparison& comparison, std::size_t i)
{
  Json result = Json::object();
  for(std::size_t j = 0; j < comparison.axes.axes.size(); ++j) {
    if(i == j)
      continue;
    const AP::Axis_distances distances{comparison.distances[i][j], comparison.distances[j][i]};
    result[comparison.axes.axes[j].name] = {{"hausdorff", distances.hausdorff()},
                                            {"there", mapt::to_json(distances.there)},
                                            {"back", mapt::to_json(distances.back)}};
  }
  return result;
}

Json axis_to_json(const Comparison& comparison, std::size_t i)
{
  const AP::Medial_representation& axis = comparison.axes.axes[i];
  const AP::Medial_measures& measures = comparison.measures[i];
  return {{"name", axis.name},
          {"balls", axis.size()},
          {"edges", axis.edges.size()},
          {"faces", axis.triangles.size()},
          {"topology", or_null(axis.topology)},
          {"coverage", measures.coverage},
          {"volume", to_json(measures.volume)},
          {"reconstruction", mapt::to_json(measures.reconstruction)},
          {"radius_error", mapt::to_json(measures.radius_error)},
          {"off_centre", mapt::to_json(measures.off_centre)},
          {"shape_diameter_correlation",
           comparison.thickness[i] ? Json(*comparison.thickness[i]) : Json()},
          {"distances", distances_to_json(comparison, i)},
          {"seconds", axis.seconds}};
}

Json to_json(const Comparison& comparison, const Medial_options& options)
{
  Json result{{"file", options.mesh},
              {"tolerance", comparison.axes.tolerance},
              {"diagonal", comparison.diagonal},
              {"shape", or_null(comparison.shape)},
              {"representations", Json::array()},
              {"left_out", Json::array()}};
  for(std::size_t i = 0; i < comparison.axes.axes.size(); ++i)
    result["representations"].push_back(axis_to_json(comparison, i));
  for(const auto& [name, reason] : comparison.axes.left_out)
    result["left_out"].push_back({{"name", name}, {"reason", reason}});
  return result;
}

// A number that may be unknown.
std::string cell_of_table(const std::optional<double>& value)
{
  char text[32] = "        -";
  if(value && !std::isnan(*value))
    std::snprintf(text, sizeof text, " %8.2f", *value);
  return text;
}

std::string row_of_table(const Comparison& comparison, std::size_t i)
{
  const AP::Medial_representation& axis = comparison.axes.axes[i];
  const AP::Medial_measures& m = comparison.measures[i];
  const double percent = 100 / comparison.diagonal;
  const auto& protrusion = m.reconstruction.protrusion;
  const std::optional<double> overlap = m.volume.overlap();
  char text[64];
  std::snprintf(text, sizeof text, "%-13s%7zu %6ld %5ld", axis.name.c_str(), axis.size(),
                axis.topology->components, axis.topology->loops);
  std::string row = text;
  for(const std::optional<double>& value :
      {std::optional(100 * m.coverage), overlap ? std::optional(100 * *overlap) : std::nullopt,
       std::optional(percent * m.reconstruction.missing.mean),
       std::optional(percent * m.reconstruction.missing.largest),
       protrusion ? std::optional(percent * protrusion->largest) : std::nullopt,
       std::optional(100 * m.radius_error.quantile_95),
       std::optional(100 * m.off_centre.quantile_95), comparison.thickness[i],
       std::optional(percent * comparison.distances[i][0].largest),
       std::optional(percent * comparison.distances[0][i].largest), std::optional(axis.seconds)})
    row += cell_of_table(value);
  return row;
}

std::vector<std::string> table_of(const Comparison& comparison)
{
  std::vector<std::string> lines{
      "axis           balls pieces loops   covers    fills    lacks  at most   sticks   radius    "
      "aside      SDF    there     back  seconds"};
  for(std::size_t i = 0; i < comparison.axes.axes.size(); ++i)
    lines.push_back(row_of_table(comparison, i));
  if(comparison.shape)
    lines.push_back("The shape has " +
                    counted(std::size_t(comparison.shape->components), "piece", "pieces") +
                    " and " + counted(std::size_t(comparison.shape->loops), "loop", "loops") + ".");
  for(const std::string& line :
      {"covers          the part of the surface within " + to_text(comparison.axes.tolerance) +
           " of the balls, in %",
       std::string("fills           the common volume of balls and shape, in % of that of either"),
       std::string("lacks, at most  how far the surface is from the balls, mean and largest, in % "
                   "of the diagonal"),
       std::string("sticks          how far the balls stick out of it at most, in the same"),
       std::string("radius          the error of the radius, in %; 5 % have more"),
       std::string("aside           from the middle, 0, to the surface, 100; 5 % have more"),
       std::string("SDF             the correlation of the ranks of its diameters with those of "
                   "CGAL's shape diameter function"),
       std::string(
           "there, back     the largest distance to and from the unpruned axis, in % of the "
           "diagonal")})
    lines.push_back(line);
  return lines;
}

} // namespace

Axis_comparison compare_axes(const Surface& surface, const Medial_result& found,
                             const Medial_options& options, const Console& console)
{
  const Comparison comparison =
      std::visit([&](const auto* source) { return compare(*source, found, options, console); },
                 surface.source());
  Axis_comparison result{to_json(comparison, options), table_of(comparison), {}};
  for(const auto& [name, reason] : comparison.axes.left_out)
    result.left_out.push_back(name + " is left out of the comparison: " + reason);
  return result;
}

void write_comparison(const std::string& file, const Axis_comparison& comparison)
{
  AP::IO::internal::Atomic_file output(file);
  // File names need not be UTF-8; what is not becomes a replacement character.
  output.stream() << comparison.json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  output.commit();
}

void show_comparison(const Axis_comparison& comparison, const Medial_options& options,
                     Console& console)
{
  console.line("");
  for(const std::string& line : comparison.table)
    console.line(line);
  for(const std::string& text : comparison.left_out)
    console.warn(options.mesh + ": " + text);
}

} // namespace mapt
