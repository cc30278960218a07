// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What medial axes, skeletons and centrelines of meshes are worth, and what is left of them when the surface changes.

#include "figures.h"
#include "remeshing.h"
#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_axis_comparison.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace Paper {

namespace {

namespace AP = CGAL::Area_projection;
using AP::Medial_representation;
using Benchmarks::Parameters;
using Benchmarks::Row;
using Tag = CGAL::Parallel_if_available_tag;

AP::Triangle_surface surface_of(const Soup& soup)
{
  return AP::surface_from_triangle_soup(soup.points, soup.triangles);
}

double diagonal_of(const Soup& soup)
{
  return AP::internal::diagonal_of(surface_of(soup).bbox());
}

Measures finite(const Measures& measures)
{
  Measures known;
  for(const auto& measure : measures)
    if(std::isfinite(measure.second))
      known.push_back(measure);
  return known;
}

/// all that is measured of each axis of a mesh, at the coverage that most programs would prune to.
void compare_axes(const Mesh& mesh, const Options& options, Benchmarks::Report& report)
{
  const AP::Triangle_surface surface = surface_of(mesh.soup);
  const double diagonal = diagonal_of(mesh.soup);
  AP::Medial_axes_options choices;
  choices.seed = options.seed;
  const AP::Medial_axes axes = AP::medial_axes<Tag>(surface, choices);
  const AP::Medial_judge<AP::Triangle_surface> judge(surface, axes.axes.front(), axes.tolerance);
  const auto distances = AP::axis_distance_matrix<Tag>(axes.axes, axes.tolerance);
  std::vector<Row> rows;
  for(std::size_t i = 0; i < axes.axes.size(); ++i) {
    const Medial_representation& axis = axes.axes[i];
    const AP::Medial_measures m = judge.measure<Tag>(axis);
    rows.push_back(row("medial", "axes", axis.name, {{"mesh", mesh.name}, {"coverage", 0.9}},
                       finite({{"balls", double(axis.size())},
                               {"covers", m.coverage},
                               {"fills", m.volume.overlap().value_or(std::nan(""))},
                               {"pieces", double(axis.topology->components)},
                               {"loops", double(axis.topology->loops)},
                               {"radius error", m.radius_error.quantile_95},
                               {"aside", m.off_centre.quantile_95},
                               {"there %", 100 * distances[i][0].largest / diagonal},
                               {"back %", 100 * distances[0][i].largest / diagonal},
                               {"back mean %", 100 * distances[0][i].mean / diagonal},
                               {"ms", 1000 * axis.seconds}})));
  }
  publish(rows, report);
}

/// how much of the surface equal numbers of balls cover.
void compare_selections(const Mesh& mesh, const Options& options, Benchmarks::Report& report)
{
  const AP::Triangle_surface surface = surface_of(mesh.soup);
  for(const std::size_t number : {std::size_t(50), std::size_t(200)}) {
    AP::Medial_axes_options choices;
    choices.number = number;
    choices.do_skeleton = false;
    choices.seed = options.seed;
    const AP::Medial_axes axes = AP::medial_axes<Tag>(surface, choices);
    std::vector<Row> rows;
    for(const Medial_representation& axis : axes.axes)
      if(axis.name != "unpruned" && axis.name != "centerlines" && axis.name != "mapt_refitted")
        rows.push_back(row("medial", "equal numbers", axis.name,
                           {{"mesh", mesh.name}, {"most balls", number}},
                           {{"balls", double(axis.size())},
                            {"covers", AP::covered_part(axis, surface, axes.tolerance)},
                            {"pieces", double(axis.topology->components)},
                            {"loops", double(axis.topology->loops)}}));
    publish(rows, report);
  }
}

/// something that changes a surface but hardly its shape, and what undoes it for points.
struct Change
{
  const char* name;
  double stop_angle; ///< for the balls, before and after
  std::function<Soup(const Soup&, std::uint64_t seed)> apply;
  std::function<Point_3(const Point_3&)> undo = [](const Point_3& p) { return p; };
};

std::vector<Change> changes(const Options& options)
{
  // Displaced within balls of that many edges, about.
  const auto noisy = [](double amount) {
    return [amount](const Soup& soup, std::uint64_t seed) {
      return add_noise(soup, amount / std::sqrt(5.), seed);
    };
  };
  std::vector<Change> all{
      {"noise 0.1", 45, noisy(0.1)},
      {"noise 0.3", 45, noisy(0.3)},
      {"half of the faces", 20,
       [](const Soup& soup, std::uint64_t seed) { return remove_random_faces(soup, 0.5, seed); }},
      {"remeshed", 20,
       [](const Soup& soup, std::uint64_t) {
         return remeshed(soup, 0.8 * mean_edge_length(soup));
       }},
      {"turned", 20,
       [](Soup soup, std::uint64_t) {
         for(Point_3& p : soup.points)
           p = turned(p);
         return soup;
       },
       [](const Point_3& p) { return turned(p, true); }}};
  if(options.is_quick)
    all.erase(all.begin(), all.end() - 1);
  return all;
}

AP::Medial_axes axes_of(const Soup& soup, double stop_angle, double tolerance,
                        const Options& options)
{
  AP::Medial_axes_options choices;
  choices.balls.stop_angle = stop_angle;
  choices.seed = options.seed;
  choices.tolerance = tolerance;
  return AP::medial_axes<Tag>(surface_of(soup), choices);
}

/// how far axes move when the surface changes, each pruned to the same coverage before and after.
void compare_stability(const Mesh& mesh, const Change& change, const AP::Medial_axes& before,
                       const Options& options, Benchmarks::Report& report)
{
  const double diagonal = diagonal_of(mesh.soup);
  AP::Medial_axes after =
      axes_of(change.apply(mesh.soup, options.seed), change.stop_angle, before.tolerance, options);
  std::vector<Row> rows;
  for(Medial_representation& axis : after.axes) {
    const auto same = std::find_if(before.axes.begin(), before.axes.end(),
                                   [&axis](const auto& other) { return other.name == axis.name; });
    if(same == before.axes.end())
      continue;
    std::transform(axis.centers.begin(), axis.centers.end(), axis.centers.begin(), change.undo);
    const AP::Axis_distances moved = AP::axis_distances<Tag>(*same, axis, before.tolerance);
    rows.push_back(row(
        "medial", "stability", axis.name, {{"mesh", mesh.name}, {"change", change.name}},
        finite(
            {{"Hausdorff %", 100 * moved.hausdorff() / diagonal},
             {"95 %", 100 * std::max(moved.there.quantile_95, moved.back.quantile_95) / diagonal},
             {"mean %", 50 * (moved.there.mean + moved.back.mean) / diagonal},
             {"pieces", double(axis.topology->components)},
             {"loops", double(axis.topology->loops)}})));
  }
  publish(rows, report);
}

} // namespace

void medial_comparison(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "medial",
      "Medial axes of meshes beside CGAL's skeleton by mean curvature flow. Covers: the part "
      "of the area within 0.005 of the diagonal of the balls; fills: the common volume of "
      "balls and shape over that of either; radius error and aside: 95th percentiles of |r - "
      "d| / r and of a / (a + d), where d is the distance from the surface and a that from "
      "the unpruned axis; there and back: the largest distance to and from the unpruned axis, "
      "in % of the diagonal. Stability: how far each axis moves, both ways, when the surface "
      "changes; each covers 90 % before and after.");
  const std::vector<Mesh> meshes =
      options.is_quick ? std::vector<Mesh>{{"cylinder", cylinder(1, 6, 24, 24)}}
                       : read_meshes(options, {"hand.obj", "human_woman.obj", "scorpion_low.obj"});
  for(const Mesh& mesh : meshes) {
    compare_axes(mesh, options, report);
    compare_selections(mesh, options, report);
    std::map<double, AP::Medial_axes> before; // by the stop angle
    for(const Change& change : changes(options)) {
      AP::Medial_axes& axes = before[change.stop_angle];
      if(axes.axes.empty())
        axes = axes_of(mesh.soup, change.stop_angle, 0.005 * diagonal_of(mesh.soup), options);
      compare_stability(mesh, change, axes, options, report);
    }
  }
}

} // namespace Paper
