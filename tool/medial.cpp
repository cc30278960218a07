// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt medial: medial balls, weighted by the transform.

#include "commands.h"
#include "cost.h"
#include "describe_input.h"
#include "file_elements.h"
#include "find_balls.h"
#include "map_file.h"
#include "medial_comparison.h"
#include "medial_options.h"
#include "medial_picture.h"
#include "medial_reconstruction.h"
#include "medial_report.h"
#include "write_mesh.h"
#include "progress.h"
#include "surface.h"
#include "text.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/IO/medial_balls_PLY.h>
#include <CGAL/Area_projection_transform/internal/diagonal_of.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_topology.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_samples.h>
#include <CGAL/Area_projection_transform/medial_balls/select_balls.h>
#include <CGAL/Area_projection_transform/medial_balls/select_connecting.h>
#include <CGAL/Area_projection_transform/medial_complex.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace mapt {

namespace {

// Those that cover the most and those that join them, no more than so many.
template <class Source>
std::vector<std::size_t> select_connected(const std::vector<AP::Medial_ball>& balls,
                                          const Source& source, double tolerance, double growth,
                                          std::size_t number)
{
  std::vector<std::size_t> covering = AP::select_covering(balls, source, tolerance, number);
  std::vector<std::size_t> all = AP::select_connecting(balls, covering, growth);
  while(all.size() > number) { // one alone has nothing to join
    Signal_watch::check();
    covering.resize(covering.size() - std::min(covering.size() - 1, all.size() - number));
    all = AP::select_connecting(balls, covering, growth);
  }
  return all;
}

// Of the balls that are not pruned, those that --select asks for.
template <class Source>
std::vector<std::size_t> selected(const Medial_result& result, const Source& source,
                                  const Medial_options& options)
{
  const AP::Medial_weight weight = options.used_weight();
  const std::vector<std::size_t> candidates = AP::select_by_weight(
      result.balls, weight, options.prune.value_or(-std::numeric_limits<double>::infinity()));
  std::vector<AP::Medial_ball> balls;
  for(const std::size_t i : candidates)
    balls.push_back(result.balls[i]);
  const std::size_t number = options.balls.value_or(balls.size());
  std::vector<std::size_t> kept;
  if(options.select == "covering")
    kept = AP::select_covering(balls, source, result.tolerance, number);
  else if(options.select == "connected")
    kept = select_connected(balls, source, result.tolerance,
                            AP::crack_width(source.total_area(), result.balls.size()), number);
  else if(options.select == "random")
    kept = AP::select_random(balls, number, options.seed);
  else if(options.balls)
    kept = AP::select_strongest(balls, weight, number);
  else
    return candidates;
  for(std::size_t& i : kept)
    i = candidates[i];
  return kept;
}

template <class Source>
void connect_balls(Medial_result& result, const Source& source, const Medial_options& options)
{
  result.tolerance = options.tolerance.value_or(0.005 * AP::internal::diagonal_of(source.bbox()));
  if(!(result.tolerance > 0)) // of a surface without extent
    return;
  result.kept = selected(result, source, options);
  std::vector<std::size_t> all;
  for(std::size_t i = 0; i < result.balls.size(); ++i)
    all.push_back(i);
  result.covered_by_all = AP::covered_part(result.balls, all, source, result.tolerance);
  result.covered_by_kept = AP::covered_part(result.balls, result.kept, source, result.tolerance);
  result.growth = AP::crack_width(source.total_area(), result.balls.size());
  result.complex = AP::medial_complex(result.balls, result.kept, result.growth);
  result.shape = AP::shape_topology(source);
}

void write_files(const Medial_result& result, const Axis_comparison& comparison,
                 const Reconstruction& reconstruction, const Surface& surface, const Input& input,
                 const Medial_options& options, Console& console)
{
  auto& json = console.report["outputs"] = nlohmann::ordered_json::array();
  if(!options.picture.empty()) {
    Signal_watch::check();
    write_medial_picture(options.picture, surface.source(), result.balls, result.kept,
                         holes_of(input));
    json.push_back(options.picture);
  }
  if(!options.output.empty()) {
    Signal_watch::check();
    AP::IO::PLY_options format;
    format.comments = {"mapt medial: balls of " + options.mesh};
    AP::IO::write_PLY(options.output,
                      AP::IO::medial_balls_PLY(result.balls, result.kept, result.complex,
                                               options.do_write_kept_only),
                      format);
    json.push_back(options.output);
  }
  if(!options.reconstruct.empty()) {
    Signal_watch::check();
    write_mesh(options.reconstruct, reconstruction.mesh);
    json.push_back(options.reconstruct);
  }
  if(!options.compare.empty()) {
    Signal_watch::check();
    write_comparison(options.compare, comparison);
    json.push_back(options.compare);
  }
}

// As measured, with what connects the balls: polar ones are cells of a triangulation, and axes are compared as copies.
void check_memory(const Input& input, const Surface& surface, const Medial_options& options)
{
  const bool is_more = options.method == "polar" || !options.compare.empty();
  const double bytes_of_ball = is_more ? 2400 : 1300;
  const double balls = std::visit(
      [&](const auto* source) {
        return AP::internal::forecast_medial_balls(*source, options.computation);
      },
      surface.source());
  const double bytes = bytes_of_ball * balls;
  if(bytes <= options.common.max_memory)
    return;
  const char* const remedy = input.is_point_set            ? "give fewer points"
                             : options.computation.spacing ? "raise --spacing"
                                                           : "simplify the mesh";
  throw Input_error(options.mesh + ": about " + to_text(balls, 3) + " balls need " +
                    bytes_to_text(bytes) + "; " + remedy + " or raise --max-memory (" +
                    bytes_to_text(options.common.max_memory) + ")");
}

} // namespace

bool run_medial(const std::vector<std::string>& arguments, Console& console)
{
  Medial_options options;
  if(!read_options(arguments, console, options))
    return false;
  check_outputs({{"--output", options.output},
                 {"--picture", options.picture},
                 {"--reconstruct", options.reconstruct},
                 {"--compare", options.compare}},
                {options.mesh});

  Stopwatch watch;
  const Thread_limit limit(number_of_threads(options.common.threads));
  const Input input = read_described(options.mesh, options.common.reading, console);
  report_parameters(options, console);
  const double reading = watch.seconds();

  const auto surface = make_surface(input, Surface_options(), 1);
  check_memory(input, *surface, options);
  const Signal_watch signals;
  Stopwatch of_balls;
  Medial_result result;
  result.balls = find_balls(*surface, options.computation, console);
  result.seconds = of_balls.seconds();
  std::visit([&](const auto* source) { connect_balls(result, *source, options); },
             surface->source());
  Signal_watch::check();
  Reconstruction reconstruction;
  if(!options.reconstruct.empty())
    reconstruction = reconstruct(result, *surface, options);
  Signal_watch::check();
  Axis_comparison comparison;
  if(!options.compare.empty())
    comparison = compare_axes(*surface, result, options, console);
  Signal_watch::check();
  const double computing = watch.seconds();

  write_files(result, comparison, reconstruction, *surface, input, options, console);
  report_cost({reading, computing, watch.seconds()}, console);
  for(const std::string file : console.report["outputs"])
    console.row("written", file);
  report_balls(result, options, console);
  if(!options.reconstruct.empty())
    report_reconstruction(reconstruction, console);
  if(!options.compare.empty())
    show_comparison(comparison, options, console);
  return true;
}

} // namespace mapt
