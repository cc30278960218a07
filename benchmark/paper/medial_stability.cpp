// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is left of medial axes, skeletons and centrelines when the surface changes, but hardly its shape.

#include "medial_stability.h"

#include "remeshing.h"

#include <CGAL/Area_projection_transform/internal/diagonal_of.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Paper {

namespace {

namespace AP = CGAL::Area_projection;
using AP::Medial_representation;
using Benchmarks::Row;
using Tag = CGAL::Parallel_if_available_tag;

/// something that changes a surface but hardly its shape, and what undoes it for points.
struct Change
{
  const char* name;
  double stop_angle; ///< for the balls, before and after
  int seeds;
  std::function<Soup(const Soup&, std::uint64_t seed)> apply;
  std::function<Point_3(const Point_3&)> undo = [](const Point_3& p) { return p; };
};

Change noise(const char* name, double amount)
{
  // Displaced within balls of that many edges, about.
  return {name, 45, 3, [amount](const Soup& soup, std::uint64_t seed) {
            return add_noise(soup, amount / std::sqrt(5.), seed);
          }};
}

Change removal(const char* name, double part)
{
  return {name, 20, 3, [part](const Soup& soup, std::uint64_t seed) {
            return remove_random_faces(soup, part, seed);
          }};
}

std::vector<Change> changes(const Options& options)
{
  const Change rotation{"turned", 20, 1,
                        [](Soup soup, std::uint64_t) {
                          for(Point_3& p : soup.points)
                            p = turned(p);
                          return soup;
                        },
                        [](const Point_3& p) { return turned(p, true); }};
  if(options.is_quick)
    return {rotation};
  return {noise("noise 0.1", 0.1),
          noise("noise 0.3", 0.3),
          removal("30 % of the faces", 0.3),
          removal("half of the faces", 0.5),
          {"a hole of 5 %", 20, 3,
           [](const Soup& soup, std::uint64_t seed) { return remove_holes(soup, 0.05, 1, seed); }},
          {"remeshed", 20, 1,
           [](const Soup& soup, std::uint64_t) {
             return remeshed(soup, 0.8 * mean_edge_length(soup));
           }},
          rotation};
}

AP::Medial_axes axes_of(const Soup& soup, double stop_angle, double tolerance,
                        const Options& options)
{
  AP::Medial_axes_options choices;
  choices.balls.stop_angle = stop_angle;
  choices.seed = options.seed;
  choices.tolerance = tolerance;
  return AP::medial_axes<Tag>(AP::surface_from_triangle_soup(soup.points, soup.triangles), choices);
}

/// how far an axis moved, in % of the diagonal of the shape.
struct Movement
{
  double hausdorff, quantile_95, mean;
};

/// by the change and the axis.
using Movements = std::map<std::pair<std::string, std::string>, std::vector<Movement>>;

/// adds how far each axis moves by a change, each pruned to the same coverage before and after.
void add_movements(const Soup& soup, const Change& change, std::uint64_t seed,
                   const AP::Medial_axes& before, const Options& options, Movements& movements)
{
  const double percent = 0.5 / before.tolerance; // the tolerance is 0.5 % of the diagonal
  AP::Medial_axes after =
      axes_of(change.apply(soup, seed), change.stop_angle, before.tolerance, options);
  for(Medial_representation& axis : after.axes) {
    const auto same = std::find_if(before.axes.begin(), before.axes.end(),
                                   [&axis](const auto& other) { return other.name == axis.name; });
    if(same == before.axes.end())
      continue;
    std::transform(axis.centers.begin(), axis.centers.end(), axis.centers.begin(), change.undo);
    const AP::Axis_distances moved = AP::axis_distances<Tag>(*same, axis, before.tolerance);
    movements[{change.name, axis.name}].push_back(
        {percent * moved.hausdorff(),
         percent * std::max(moved.there.quantile_95, moved.back.quantile_95),
         percent * 0.5 * (moved.there.mean + moved.back.mean)});
  }
}

void publish_movements(const std::string& mesh, const Movements& movements,
                       Benchmarks::Report& report)
{
  std::vector<Row> rows;
  for(const auto& [key, all] : movements) {
    Movement sum{0, 0, 0};
    double worst = 0;
    for(const Movement& m : all) {
      sum = {sum.hausdorff + m.hausdorff, sum.quantile_95 + m.quantile_95, sum.mean + m.mean};
      worst = std::max(worst, m.hausdorff);
    }
    const double number = double(all.size());
    rows.push_back(row("medial", "stability", key.second,
                       {{"mesh", mesh}, {"change", key.first}, {"cases", all.size()}},
                       {{"Hausdorff %", sum.hausdorff / number},
                        {"worst %", worst},
                        {"95 %", sum.quantile_95 / number},
                        {"mean %", sum.mean / number}}));
  }
  publish(rows, report);
}

} // namespace

void medial_stability(const std::vector<Mesh>& meshes, const Options& options,
                      Benchmarks::Report& report)
{
  Movements of_all;
  for(const Mesh& mesh : meshes) {
    const double tolerance =
        0.005 * AP::internal::diagonal_of(
                    AP::surface_from_triangle_soup(mesh.soup.points, mesh.soup.triangles).bbox());
    Movements of_mesh;
    std::map<double, AP::Medial_axes> before; // by the stop angle
    for(const Change& change : changes(options)) {
      AP::Medial_axes& axes = before[change.stop_angle];
      if(axes.axes.empty())
        axes = axes_of(mesh.soup, change.stop_angle, tolerance, options);
      for(int i = 0; i < change.seeds; ++i)
        add_movements(mesh.soup, change, options.seed + std::uint64_t(i), axes, options, of_mesh);
    }
    publish_movements(mesh.name, of_mesh, report);
    for(const auto& [key, all] : of_mesh)
      of_all[key].insert(of_all[key].end(), all.begin(), all.end());
  }
  if(meshes.size() > 1)
    publish_movements("all", of_all, report);
}

} // namespace Paper
