// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt salient: centres of spheres and tubes.

#include "commands.h"
#include "cost.h"
#include "describe_input.h"
#include "file_elements.h"
#include "map_file.h"
#include "progress.h"
#include "salient_options.h"
#include "salient_picture.h"
#include "salient_points.h"
#include "salient_report.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>
#include <CGAL/Area_projection_transform/IO/salient_points_PLY.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <iostream>

namespace mapt {

namespace {

void write_table(std::ostream& stream, const Salient_points& found)
{
  AP::IO::Salient_points_CSV_writer table(stream);
  for(std::size_t i = 0; i < found.points.size(); ++i)
    table.write(found.points[i], found.sides[i]);
}

void write_voters(const Salient_points& found, const Surface& surface, const Input& input,
                  const Salient_options& options)
{
  write_labelled_elements(
      options.voters,
      std::visit(
          [&](const auto* source) { return AP::IO::salient_points_PLY(*source, found.points); },
          surface.source()),
      "mapt salient: salient_point is the row of the table, from 0, or -1", surface, input);
}

void write_files(const Salient_points& found, const Surface& surface, const Input& input,
                 const Salient_options& options, Console& console)
{
  auto& json = console.report["outputs"] = nlohmann::ordered_json::array();
  if(!options.voters.empty()) {
    write_voters(found, surface, input, options);
    json.push_back(options.voters);
  }
  if(!options.picture.empty()) {
    Signal_watch::check();
    write_salient_picture(options.picture, surface.source(), found.points, holes_of(input),
                          options.is_fitted() ? Salient_style::FITS : Salient_style::SCALES);
    json.push_back(options.picture);
  }
  if(!options.is_to_stdout()) {
    AP::IO::internal::Atomic_file file(options.output);
    write_table(file.stream(), found);
    file.commit();
    json.push_back(options.output);
  } else if(!console.is_json)
    write_table(std::cout, found);
}

void check_outputs(const Salient_options& options)
{
  mapt::check_outputs({{"--output", options.is_to_stdout() ? "" : options.output},
                       {"--voters", options.voters},
                       {"--picture", options.picture}},
                      {options.mesh});
}

} // namespace

bool run_salient(const std::vector<std::string>& arguments, Console& console)
{
  Salient_options options;
  if(!read_options(arguments, console, options))
    return false;
  check_outputs(options);
  if(options.is_to_stdout())
    console.give_stdout_away();

  Stopwatch watch;
  const Thread_limit limit(number_of_threads(options.common.threads));
  const Input input = read_described(options.mesh, options.common.reading, console);
  report_parameters(options, console);
  const double reading = watch.seconds();

  const Signal_watch signals;
  const auto surface = make_surface(input, Surface_options(), 1);
  const Salient_points found = find_points(*surface, options, console);
  const double computing = watch.seconds();

  write_files(found, *surface, input, options, console);
  report_cost({reading, computing, watch.seconds()}, console);
  for(const std::string file : console.report["outputs"])
    console.row("written", file);
  report_points(found, options, console);
  return true;
}

} // namespace mapt
