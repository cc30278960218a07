// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt lines: centrelines of tubes.

#include "commands.h"
#include "cost.h"
#include "describe_input.h"
#include "file_elements.h"
#include "find_lines.h"
#include "lines_options.h"
#include "lines_output.h"
#include "lines_picture.h"
#include "lines_report.h"
#include "map_file.h"
#include "progress.h"
#include "surface.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/IO/centerlines_PLY.h>

namespace mapt {

namespace {

void write_files(const AP::Centerline_graph& graph, const Surface& surface, const Input& input,
                 const Lines_options& options, Console& console)
{
  auto& json = console.report["outputs"] = nlohmann::ordered_json::array();
  if(!options.segments.empty()) {
    write_labelled_elements(
        options.segments,
        std::visit([&](const auto* source) { return AP::IO::centerlines_PLY(*source, graph); },
                   surface.source()),
        "mapt lines: branch is the number of the branch, from 0, or -1", surface, input);
    json.push_back(options.segments);
  }
  if(!options.picture.empty()) {
    Signal_watch::check();
    write_lines_picture(options.picture, surface.source(), graph, holes_of(input));
    json.push_back(options.picture);
  }
  for(const std::string& output : options.outputs) {
    Signal_watch::check();
    write_lines(output, graph);
    json.push_back(output);
  }
}

void check_outputs(const Lines_options& options)
{
  std::vector<Named_output> outputs{{"--segments", options.segments},
                                    {"--picture", options.picture}};
  for(const std::string& output : options.outputs)
    outputs.push_back({"--output", output});
  mapt::check_outputs(outputs, {options.mesh});
}

} // namespace

bool run_lines(const std::vector<std::string>& arguments, Console& console)
{
  Lines_options options;
  if(!read_options(arguments, console, options))
    return false;
  check_outputs(options);

  Stopwatch watch;
  const Thread_limit limit(number_of_threads(options.common.threads));
  const Input input = read_described(options.mesh, options.common.reading, console);
  report_parameters(options, console);
  const double reading = watch.seconds();

  const auto surface = make_surface(input, Surface_options(), 1);
  const Signal_watch signals;
  const AP::Centerline_graph graph = find_lines(*surface, options.lines, console);
  const double computing = watch.seconds();

  write_files(graph, *surface, input, options, console);
  report_cost({reading, computing, watch.seconds()}, console);
  for(const std::string file : console.report["outputs"])
    console.row("written", file);
  report_lines(graph, options, console);
  return true;
}

} // namespace mapt
