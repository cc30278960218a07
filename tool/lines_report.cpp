// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lines_report.h"

#include "text.h"
#include "threads.h"

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_table = 20;

// null stands for what the library chooses.
Json or_null(const std::optional<double>& value)
{
  return value ? Json(*value) : Json();
}

std::size_t place_of(const std::vector<std::size_t>& nodes, std::size_t vertex)
{
  return std::size_t(std::lower_bound(nodes.begin(), nodes.end(), vertex) - nodes.begin());
}

Json to_json(const AP::Centerline_branch& branch, const std::vector<std::size_t>& nodes)
{
  return {{"from", place_of(nodes, branch.from())}, {"to", place_of(nodes, branch.to())},
          {"points", branch.vertices.size()},       {"length", branch.length},
          {"mean_radius", branch.mean_radius},      {"score", branch.score},
          {"voters", branch.voters.size()}};
}

std::size_t number_of_pieces(const AP::Centerline_graph& graph)
{
  std::vector<std::size_t> component(num_vertices(graph));
  return std::size_t(boost::connected_components(graph, component.data()));
}

// The longest first.
std::vector<std::size_t> order_of_branches(const std::vector<AP::Centerline_branch>& branches)
{
  std::vector<std::size_t> order(branches.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return branches[a].length > branches[b].length;
  });
  return order;
}

const char* kind_of_end(const AP::Centerline_graph& graph, const AP::Centerline_branch& branch,
                        std::size_t end)
{
  if(branch.is_closed())
    return "closed";
  return degree(end, graph) > 1 ? "branch" : "end";
}

void show_longest(const AP::Centerline_graph& graph, Console& console)
{
  const auto& branches = AP::branches(graph);
  const std::size_t shown = std::min(branches.size(), longest_table);
  console.line("");
  console.line(shown < branches.size() ? "The longest " + std::to_string(shown) + " of " +
                                             std::to_string(branches.size()) + ":"
                                       : "The longest first:");
  console.line("branch      length mean radius  from     to       score");
  const std::vector<std::size_t> order = order_of_branches(branches);
  for(std::size_t i = 0; i < shown; ++i) {
    const AP::Centerline_branch& branch = branches[order[i]];
    char text[120];
    std::snprintf(text, sizeof text, "%6zu %11.5g %11.5g  %-8s %-8s %5.2f", order[i], branch.length,
                  branch.mean_radius, kind_of_end(graph, branch, branch.from()),
                  kind_of_end(graph, branch, branch.to()), branch.score);
    console.line(text);
  }
  console.line("The score is the part of a branch where a tube fits, times how much of its "
               "circumference is there.");
}

} // namespace

void report_parameters(const Lines_options& options, Console& console)
{
  const AP::Centerline_options& lines = options.lines;
  console.report["parameters"] = {{"side", options.side},
                                  {"radius_min", or_null(lines.smallest_radius)},
                                  {"radius_max", or_null(lines.largest_radius)},
                                  {"least_length", lines.least_length},
                                  {"spacing", lines.vertex_spacing},
                                  {"join", lines.do_join},
                                  {"extend", lines.do_extend},
                                  {"threads", number_of_threads(options.common.threads)}};
}

void report_lines(const AP::Centerline_graph& graph, const Lines_options& options, Console& console)
{
  const std::vector<std::size_t> nodes = AP::nodes(graph);
  const auto& branches = AP::branches(graph);
  Json& json = console.report["lines"];
  const bool is_turned_over = graph[boost::graph_bundle].is_turned_over;
  json = {{"pieces", number_of_pieces(graph)},
          {"is_turned_over", is_turned_over},
          {"branches", Json::array()},
          {"nodes", Json::array()}};
  if(is_turned_over)
    console.warn(options.mesh + ": the faces look inward, seen as a whole: lines were sought as if "
                                "they looked outward");
  for(const AP::Centerline_branch& branch : branches)
    json["branches"].push_back(to_json(branch, nodes));
  for(const std::size_t node : nodes) {
    const AP::Point_3& p = graph[node].point;
    json["nodes"].push_back({p.x(), p.y(), p.z()});
  }
  if(branches.empty()) {
    console.warn(options.mesh + ": no tube found; look at the other side with --side, or for other "
                                "radii with --radius-min and --radius-max");
    return;
  }
  console.row("found", counted(branches.size(), "branch", "branches") + ", " +
                           counted(nodes.size(), "node", "nodes") + ", " +
                           counted(number_of_pieces(graph), "piece", "pieces"));
  show_longest(graph, console);
}

} // namespace mapt
