// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "centerline_score.h"
#include "figures.h"
#include "skeleton_peer.h"

#include <CGAL/Area_projection_transform/centerlines.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Paper {

namespace {

const std::string group = "lines";

/// finds lines; nothing if it cannot be asked.
struct Method
{
  const char* name;
  std::optional<AP::Centerline_graph> (*find)(const Soup& soup);
};

const Method methods[] = {
    {"area projection",
     [](const Soup& soup) -> std::optional<AP::Centerline_graph> {
       return AP::centerlines<CGAL::Parallel_if_available_tag>(
           AP::surface_from_triangle_soup(soup.points, soup.triangles));
     }},
    {"mean curvature flow", skeleton_lines},
};

struct Line_damage
{
  const char* name;
  Soup (*apply)(const Soup& soup, std::uint64_t seed);
};

const Line_damage damages[] = {
    {"clean", [](const Soup& soup, std::uint64_t) { return soup; }},
    {"perturbed",
     [](const Soup& soup, std::uint64_t seed) {
       return remove_random_faces(add_local_noise(soup, 0.2, seed), 0.5, seed + 1);
     }},
};

Measures measures_of(const Centerline_score& score, const Centerline_shape& shape, double seconds)
{
  Measures measures{
      {"body error", score.body},          {"all error", score.all},
      {"furthest", score.furthest},        {"coverage", score.coverage},
      {"radius error", score.radius},      {"spurious", double(score.spurious(shape))},
      {"free ends", double(score.leaves)}, {"parts", double(score.components)},
      {"loops", double(score.cycles)},     {"ms", 1000 * seconds}};
  Measures known;
  for(const auto& measure : measures)
    if(std::isfinite(measure.second))
      known.push_back(measure);
  return known;
}

void compare(const Centerline_shape& shape, const Line_damage& damage, const Options& options,
             Benchmarks::Report& report)
{
  const Soup soup = damage.apply(shape.soup, options.seed);
  std::vector<Benchmarks::Row> rows;
  for(const Method& method : methods) {
    const auto start = std::chrono::steady_clock::now();
    const std::optional<AP::Centerline_graph> lines = method.find(soup);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    Measures measures{{"cannot: open", 1}};
    if(lines)
      measures = measures_of(score(shape, *lines), shape, time.count());
    rows.push_back(row(group, damage.name, method.name,
                       {{"shape", shape.name}, {"faces", soup.triangles.size()}}, measures));
  }
  publish(rows, report);
}

} // namespace

void centerline_comparison(const Options& options, Benchmarks::Report& report)
{
  report.add_group(group, "Centrelines of tubes whose axes are known; lengths are in units of the "
                          "radius. Body: mean distance "
                          "from the axis beside it; all: with the way through round caps to the "
                          "surface. Coverage: the part of "
                          "the axis with a line within a fifth of the radius. Perturbed: half of "
                          "the faces removed, vertices "
                          "moved within a fifth of the edges there. Beside it CGAL's skeleton by "
                          "mean curvature flow, with its "
                          "defaults, where that can be asked: of closed surfaces.");
  std::vector<Centerline_shape> shapes = centerline_shapes();
  for(Centerline_shape& shape : hard_centerline_shapes())
    shapes.push_back(std::move(shape));
  if(options.is_quick)
    shapes.resize(2);
  for(const Line_damage& damage : damages)
    for(const Centerline_shape& shape : shapes)
      compare(shape, damage, options, report);
}

} // namespace Paper
