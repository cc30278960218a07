// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt describe: rows of numbers for meshes, by which shapes are compared.

#include "commands.h"
#include "cost.h"
#include "describe_queue.h"
#include "describe_ranks.h"
#include "describe_report.h"
#include "errors.h"
#include "file_list.h"
#include "map_file.h"

#include <CGAL/Area_projection_transform/IO/shape_descriptors_CSV.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <algorithm>
#include <iostream>
#include <optional>

namespace mapt {

namespace {

void write_table(std::ostream& stream, const Describe_queue& queue, std::size_t dimension)
{
  AP::IO::write_shape_descriptors_CSV_header(stream, dimension);
  for(std::size_t i = 0; i < queue.size(); ++i)
    if(queue.results()[i].failure.empty())
      AP::IO::write_shape_descriptor_CSV_row(stream, queue.file(i), queue.results()[i].values);
}

void write_table(const Describe_queue& queue, const Describe_options& options, Console& console)
{
  console.report["outputs"] = nlohmann::ordered_json::array();
  const auto& results = queue.results();
  if(std::all_of(results.begin(), results.end(),
                 [](const Description& d) { return !d.failure.empty(); }))
    return; // a table without a row is of no use
  if(!options.is_to_stdout()) {
    AP::IO::internal::Atomic_file file(options.output);
    write_table(file.stream(), queue, options.dimension());
    file.commit();
    console.report["outputs"].push_back(options.output);
  } else if(!console.is_json)
    write_table(std::cout, queue, options.dimension());
}

void check_all_done(const Describe_queue& queue, const std::optional<Describe_journal>& journal)
{
  if(queue.number_finished() == queue.size())
    return;
  if(!journal)
    throw Interruption();
  throw Interruption("interrupted: " + std::to_string(queue.number_finished()) + " of " +
                     std::to_string(queue.size()) +
                     " meshes are done; the same command goes on "
                     "from there, thanks to " +
                     journal->name());
}

} // namespace

bool run_describe(const std::vector<std::string>& arguments, Console& console)
{
  const Signal_watch signals;
  Describe_ranks ranks;
  if(!ranks.is_first()) {
    ranks.serve(arguments);
    return false;
  }
  Describe_options options;
  if(!read_options(arguments, console, options))
    return false;
  if(ranks.number() > 1 && options.common.threads > 1)
    throw Usage_error("--threads " + std::to_string(options.common.threads) +
                      ": each process of MPI works in one thread: start more of them instead");
  if(options.is_to_stdout())
    console.give_stdout_away();
  else
    check_output("--output", options.output, {options.list});

  Stopwatch watch;
  std::vector<std::string> files = list_files(options.meshes, options.list);
  std::optional<Describe_journal> journal;
  if(options.has_journal())
    journal.emplace(options.output + ".partial", options);
  Describe_queue queue(std::move(files), journal ? &*journal : nullptr, console);
  report_parameters(options, ranks.number(), console);
  const double listing = watch.seconds();

  ranks.describe_all(queue, options);
  check_all_done(queue, journal);
  const double computing = watch.seconds();

  write_table(queue, options, console);
  if(journal)
    journal->remove();
  report_cost({listing, computing, watch.seconds()}, console);
  for(const std::string file : console.report["outputs"])
    console.row("written", file);
  report_descriptions(queue, options, console);
  return true;
}

} // namespace mapt
