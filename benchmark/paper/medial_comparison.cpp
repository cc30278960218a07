// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What medial axes, skeletons and centrelines of meshes are worth, and what they take.

#include "figures.h"
#include "medial_stability.h"
#include "peak_growth.h"
#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_axis_comparison.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Paper {

namespace {

namespace AP = CGAL::Area_projection;
using AP::Medial_representation;
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
    const auto& outside = m.reconstruction.protrusion;
    const double protrusion = outside ? outside->largest : std::nan("");
    rows.push_back(row("medial", "axes", axis.name, {{"mesh", mesh.name}, {"coverage", 0.9}},
                       finite({{"balls", double(axis.size())},
                               {"covers", m.coverage},
                               {"fills", m.volume.overlap().value_or(std::nan(""))},
                               {"pieces", double(axis.topology->components)},
                               {"loops", double(axis.topology->loops)},
                               {"lacks %", 100 * m.reconstruction.missing.mean / diagonal},
                               {"sticks %", 100 * protrusion / diagonal},
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

/// what it takes to find medial balls in two ways, centrelines and the skeleton, each in a process of its own.
void compare_memory(const Mesh& mesh, Benchmarks::Report& report)
{
  const AP::Triangle_surface surface = surface_of(mesh.soup);
  AP::Medial_ball_options polar;
  polar.method = AP::Medial_ball_method::POLAR;
  const std::pair<const char*, std::function<void()>> works[] = {
      {"touching balls", [&] { AP::medial_balls(surface); }},
      {"polar balls", [&] { AP::medial_balls(surface, polar); }},
      {"centerlines", [&] { AP::centerlines(surface); }},
      {"skeleton", [&] {
         if(AP::skeleton_obstacle(surface).empty())
           AP::mean_curvature_skeleton(surface);
       }}};
  std::vector<Row> rows;
  for(const auto& [name, work] : works)
    rows.push_back(row("medial", "memory", name,
                       {{"mesh", mesh.name}, {"faces", mesh.soup.triangles.size()}},
                       {{"peak MB", peak_growth(work) / 1e6}}));
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
      "in % of the diagonal; lacks and sticks: how far the surface is from the balls, in the mean, "
      "and how far they stick out of it at most, in the same. Stability: how far each axis moves, "
      "both ways, when the surface changes, in the mean of the seeds and in the worst case; each "
      "covers 90 % before and after.");
  const std::vector<Mesh> meshes =
      options.is_quick ? std::vector<Mesh>{{"cylinder", cylinder(1, 6, 24, 24)}}
                       : read_meshes(options, {"hand.obj", "human_woman.obj", "scorpion_low.obj"});
  for(const Mesh& mesh : meshes) {
    compare_axes(mesh, options, report);
    compare_selections(mesh, options, report);
    compare_memory(mesh, report);
  }
  medial_stability(meshes, options, report);
}

} // namespace Paper
