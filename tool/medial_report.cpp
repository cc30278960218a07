// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "medial_report.h"

#include "text.h"
#include "threads.h"

#include <algorithm>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json();
}

std::string percent(double part)
{
  return to_text(100 * part, 3) + " %";
}

double largest_radius(const Medial_result& result)
{
  double largest = 0;
  for(const std::size_t i : result.kept)
    largest = std::max(largest, result.balls[i].radius);
  return largest;
}

std::string to_text(const AP::Betti_numbers& topology)
{
  std::string text = counted(std::size_t(topology.components), "piece", "pieces") + ", " +
                     counted(std::size_t(topology.loops), "loop", "loops");
  if(topology.cavities > 0)
    text += ", " + counted(std::size_t(topology.cavities), "cavity", "cavities");
  return text;
}

// How the selected balls are connected, beside the shape.
void report_connections(const Medial_result& result, Console& console)
{
  const AP::Medial_complex& complex = result.complex;
  Json& json = console.report["medial"];
  json["edges"] = complex.edges.size();
  json["faces"] = complex.triangles.size();
  json["growth"] = result.growth;
  json["topology"] = to_json(complex.topology);
  json["shape"] = result.shape ? to_json(*result.shape) : Json();
  std::string text = to_text(complex.topology);
  if(result.shape)
    text += *result.shape == complex.topology ? ", as the shape"
                                              : "; the shape has " + to_text(*result.shape);
  console.row("connected", text + " (" + counted(complex.edges.size(), "edge", "edges") + ", " +
                               counted(complex.triangles.size(), "face", "faces") + ")");
}

} // namespace

nlohmann::ordered_json to_json(const AP::Betti_numbers& topology)
{
  return {{"components", topology.components},
          {"loops", topology.loops},
          {"cavities", topology.cavities},
          {"euler_number", topology.euler_number()}};
}

void report_parameters(const Medial_options& options, Console& console)
{
  const AP::Medial_ball_options& computation = options.computation;
  console.report["parameters"] = {{"method", options.method},
                                  {"side", options.side},
                                  {"weight", options.weight},
                                  {"prune", or_null(options.prune)},
                                  {"balls", or_null(options.balls)},
                                  {"select", options.select},
                                  {"seed", options.seed},
                                  {"spacing", or_null(computation.spacing)},
                                  {"stop_angle", computation.stop_angle},
                                  {"crease_angle", computation.crease_angle},
                                  {"sigma_ratio", computation.sigma_ratio},
                                  {"compensate", computation.compensate},
                                  {"threads", number_of_threads(options.common.threads)}};
}

void report_balls(const Medial_result& result, const Medial_options& options, Console& console)
{
  console.report["medial"] = {{"balls", result.balls.size()},
                              {"kept", result.kept.size()},
                              {"tolerance", result.tolerance},
                              {"covered_by_all", result.covered_by_all},
                              {"covered_by_kept", result.covered_by_kept},
                              {"largest_radius", largest_radius(result)}};
  if(result.balls.empty()) {
    console.warn(options.mesh + ": no ball found; look at the other side with --side, or at the "
                                "orientation of the faces with mapt info");
    return;
  }
  console.row("balls", counted(result.balls.size(), "ball", "balls") + ", which cover " +
                           percent(result.covered_by_all) + " of the surface up to " +
                           to_text(result.tolerance));
  if(options.is_selecting())
    console.row("kept", counted(result.kept.size(), "ball", "balls") + ", which cover " +
                            percent(result.covered_by_kept));
  if(result.kept.empty())
    console.warn("no ball has the weight that --prune asks for: ask for less");
  else
    console.row("largest", "radius " + to_text(largest_radius(result)));
  report_connections(result, console);
}

} // namespace mapt
