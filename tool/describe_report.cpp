// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_report.h"

#include "errors.h"
#include "text.h"
#include "threads.h"

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

// The seconds of all threads, for a mesh in the mean of those that were described now.
void report_cost_of_mesh(const Describe_queue& queue, Console& console)
{
  double reading = 0, computing = 0;
  std::size_t number = 0;
  for(std::size_t i = 0; i < queue.size(); ++i)
    if(!queue.is_resumed(i) && queue.results()[i].failure.empty()) {
      reading += queue.results()[i].reading;
      computing += queue.results()[i].computing;
      ++number;
    }
  if(number == 0)
    return;
  console.report["seconds_of_mesh"] = {{"read", reading / double(number)},
                                       {"compute", computing / double(number)}};
  console.row("mesh", to_text(1e3 * reading / double(number), 3) + " ms to read, " +
                          to_text(1e3 * computing / double(number), 3) +
                          " ms to compute, in the mean");
}

void warn_of_remarks(const Describe_queue& queue, Console& console)
{
  Json& remarks = console.report["remarks"] = Json::array();
  for(std::size_t i = 0; i < queue.size(); ++i)
    if(const Description& d = queue.results()[i]; d.failure.empty() && !d.remark.empty())
      remarks.push_back({{"file", queue.file(i)}, {"remark", d.remark}});
  if(!remarks.empty())
    console.warn(counted(remarks.size(), "mesh is", "meshes are") +
                 " odd in some way: see --verbose, --json or mapt info");
}

Json rows_of(const Describe_queue& queue)
{
  Json rows = Json::array();
  for(std::size_t i = 0; i < queue.size(); ++i)
    if(queue.results()[i].failure.empty())
      rows.push_back({{"file", queue.file(i)}, {"values", queue.results()[i].values}});
  return rows;
}

Json failures_of(const Describe_queue& queue)
{
  Json failures = Json::array();
  for(std::size_t i = 0; i < queue.size(); ++i)
    if(const std::string& failure = queue.results()[i].failure; !failure.empty())
      failures.push_back({{"file", queue.file(i)}, {"error", failure}});
  return failures;
}

} // namespace

void report_parameters(const Describe_options& options, std::size_t ranks, Console& console)
{
  Json& parameters = console.report["parameters"] = choices_of(options);
  parameters["dimension"] = options.dimension();
  parameters["block_size"] = options.block_size();
  parameters["threads"] = ranks > 1 ? 1 : number_of_threads(options.common.threads);
  parameters["ranks"] = ranks;
  console.row("method", options.kind + ", normals: " +
                            (options.subdivide ? "subdivided" : options.surface.normals) + ", " +
                            std::to_string(options.dimension()) + " numbers in blocks of " +
                            std::to_string(options.block_size()));
}

void report_descriptions(const Describe_queue& queue, const Describe_options& options,
                         Console& console)
{
  const Json failures = failures_of(queue);
  const std::size_t described = queue.size() - failures.size();
  console.report["counts"] = {{"files", queue.size()},
                              {"described", described},
                              {"resumed", queue.number_resumed()},
                              {"failed", failures.size()}};
  console.report["failures"] = failures;
  if(options.is_to_stdout() && console.is_json)
    console.report["descriptors"] = rows_of(queue);
  report_cost_of_mesh(queue, console);
  console.row("described",
              std::to_string(described) + " of " + counted(queue.size(), "mesh", "meshes") +
                  (queue.number_resumed() > 0
                       ? ", " + std::to_string(queue.number_resumed()) + " of them by a former run"
                       : ""));
  warn_of_remarks(queue, console);
  if(failures.empty())
    return;
  const std::string summary = std::to_string(failures.size()) + " of " +
                              counted(queue.size(), "file", "files") +
                              " could not be described, see above: " +
                              (described > 0 ? "the table has the others" : "nothing was written");
  console.complain(summary);
  console.report["error"] = summary;
  console.exit_code = UNUSABLE_INPUT;
}

} // namespace mapt
