// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt retrieve: how well descriptors tell classes of shapes apart, and which shapes are alike.

#include "commands.h"
#include "cost.h"
#include "errors.h"
#include "input.h"
#include "map_file.h"
#include "progress.h"
#include "retrieve_files.h"
#include "retrieve_options.h"
#include "retrieve_report.h"
#include "text.h"
#include "threads.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

namespace mapt {

namespace {

using Tag = CGAL::Parallel_if_available_tag;

AP::Histogram_distance distance_of(const AP::Descriptor_table& table,
                                   const Retrieve_options& options)
{
  constexpr std::size_t bins_of_the_paper = 12;
  const std::size_t block =
      options.has_blocks() ? options.bins.value_or(bins_of_the_paper) : table.dimension();
  if(table.dimension() % block != 0)
    throw Usage_error("--distance " + options.distance + ": rows of " +
                      counted(table.dimension(), "number", "numbers") +
                      " are not made of blocks of " + std::to_string(block) + ": give --bins");
  return AP::Histogram_distance(options.distance_kind(), table.dimension(), block);
}

// A shape is named by its whole name, that without folders, or that without extension, too.
std::size_t find_shape(const std::string& query, const std::vector<std::string>& names)
{
  std::vector<std::size_t> found, similar;
  for(std::size_t i = 0; i < names.size(); ++i) {
    const std::filesystem::path path(names[i]);
    if(names[i] == query)
      found.push_back(i);
    else if(path.filename() == query || path.stem() == query)
      similar.push_back(i);
  }
  if(found.empty())
    found = std::move(similar);
  if(found.empty()) {
    const std::string nearest = nearest_word(query, names);
    throw Usage_error("--query " + query + ": is not in the table" +
                      (nearest.empty() ? "" : ": did you mean " + nearest + "?"));
  }
  if(found.size() > 1)
    throw Usage_error("--query " + query + ": is the name of " + std::to_string(found.size()) +
                      " rows, such as " + names[found[0]] + " and " + names[found[1]] +
                      ": give the whole name, and each row its own");
  return found[0];
}

std::vector<std::size_t> find_queries(const AP::IO::Named_descriptors& shapes,
                                      const Retrieve_options& options)
{
  std::vector<std::size_t> queries;
  for(const std::string& query : options.queries)
    queries.push_back(find_shape(query, shapes.names));
  return queries;
}

void answer_query(std::size_t query, const AP::IO::Named_descriptors& shapes,
                  const AP::Histogram_distance& distance, const AP::Class_labels& labels,
                  const Retrieve_options& options, Console& console)
{
  std::vector<AP::Neighbor> nearest = nearest_by_scan(shapes.table, distance, shapes.table[query],
                                                      options.number_of_neighbours + 1);
  const auto itself = std::find_if(nearest.begin(), nearest.end(),
                                   [&](const AP::Neighbor& n) { return n.index == query; });
  nearest.erase(itself == nearest.end() ? itself - 1 : itself); // many others may be equal to it
  report_neighbours(shapes.names[query], nearest, shapes.names, labels, console);
}

void check_memory(std::size_t shapes, const Retrieve_options& options)
{
  const double bytes = 4. * double(shapes) * double(shapes);
  if(bytes > options.common.max_memory)
    throw Usage_error("--distances: those of " + std::to_string(shapes) + " shapes need " +
                      bytes_to_text(bytes) + ": raise --max-memory, or leave them out");
}

AP::Class_labels labels_of(const AP::IO::Named_descriptors& shapes, const Retrieve_options& options,
                           Console& console)
{
  if(options.labels.empty())
    return {};
  AP::Class_labels labels = read_labels(options.labels, shapes.names);
  std::size_t unlabelled = 0;
  for(std::size_t i = 0; i < labels.size(); ++i)
    unlabelled += labels[i] == AP::Class_labels::none ? 1 : 0;
  if(unlabelled == labels.size())
    throw Input_error(options.labels + ": has none of the shapes of " + options.table +
                      ", such as " + shapes.names[0] +
                      ": shapes must be named as in the table, or without folder and extension");
  if(unlabelled > 0)
    console.warn(options.labels + ": has no class for " +
                 counted(unlabelled, "shape: it is found by others, and is wrong then",
                         "shapes: they are found by others, and are wrong then"));
  return labels;
}

AP::Retrieval_evaluation evaluate(const AP::Relevant_ranks& ranks, const AP::Class_labels& labels,
                                  const Retrieve_options& options)
{
  try {
    return evaluate_retrieval(ranks, labels, options.smallest_class);
  } catch(const std::invalid_argument& error) {
    throw Input_error(options.labels + ": " + error.what() + "; see --smallest-class");
  }
}

void check_outputs(const Retrieve_options& options)
{
  std::vector<std::string> inputs{options.table};
  if(!options.labels.empty())
    inputs.push_back(options.labels);
  mapt::check_outputs(
      {{"--distances", options.distances}, {"--precision-recall", options.precision_recall}},
      inputs);
}

void write_files(const AP::IO::Named_descriptors& shapes,
                 const std::optional<AP::Distance_matrix>& distances,
                 const AP::Relevant_ranks& ranks, const AP::Class_labels& labels,
                 const Retrieve_options& options, Console& console)
{
  // Before, nothing is lost if a signal ends the program.
  const Signal_watch signals;
  auto& outputs = console.report["outputs"] = nlohmann::ordered_json::array();
  if(distances) {
    write_distances(options.distances, shapes.names, *distances);
    outputs.push_back(options.distances);
  }
  if(!options.precision_recall.empty()) {
    Signal_watch::check();
    write_precision_recall(options.precision_recall, ranks, labels, options.smallest_class);
    outputs.push_back(options.precision_recall);
  }
}

void report_parameters(const AP::IO::Named_descriptors& shapes,
                       const AP::Histogram_distance& distance, const Retrieve_options& options,
                       Console& console)
{
  console.report["parameters"] = {{"distance", options.distance},
                                  {"block_size", distance.block_size()},
                                  {"smallest_class", options.smallest_class},
                                  {"threads", number_of_threads(options.common.threads)}};
  console.report["shapes"] = shapes.names.size();
  console.report["dimension"] = shapes.table.dimension();
  console.row("table", options.table + ": " + counted(shapes.names.size(), "shape", "shapes") +
                           " with " + counted(shapes.table.dimension(), "number", "numbers"));
  console.row("distance",
              options.distance + (options.has_blocks()
                                      ? ", in blocks of " + std::to_string(distance.block_size())
                                      : ""));
}

} // namespace

bool run_retrieve(const std::vector<std::string>& arguments, Console& console)
{
  Retrieve_options options;
  if(!read_options(arguments, console, options))
    return false;
  check_outputs(options);

  Stopwatch watch;
  const Thread_limit limit(number_of_threads(options.common.threads));
  const AP::IO::Named_descriptors shapes = read_descriptors(options.table);
  const AP::Class_labels labels = labels_of(shapes, options, console);
  const AP::Histogram_distance distance = distance_of(shapes.table, options);
  const std::vector<std::size_t> queries = find_queries(shapes, options);
  report_parameters(shapes, distance, options, console);
  const double reading = watch.seconds();

  std::optional<AP::Distance_matrix> distances;
  if(!options.distances.empty()) {
    check_memory(shapes.names.size(), options);
    distances = AP::distance_matrix<Tag>(shapes.table, distance);
  }
  AP::Relevant_ranks ranks;
  if(labels.size() > 0) {
    ranks = distances ? AP::relevant_ranks<Tag>(*distances, labels)
                      : AP::relevant_ranks<Tag>(shapes.table, distance, labels);
    report_scores(evaluate(ranks, labels, options), console);
  }
  for(const std::size_t query : queries)
    answer_query(query, shapes, distance, labels, options, console);
  const double computing = watch.seconds();

  write_files(shapes, distances, ranks, labels, options, console);
  console.line("");
  report_cost({reading, computing, watch.seconds()}, console);
  for(const std::string file : console.report["outputs"])
    console.row("written", file);
  return true;
}

} // namespace mapt
