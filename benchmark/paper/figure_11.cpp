// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "salient.h"
#include "salient_picture.h"

#include <algorithm>
#include <cmath>

namespace Paper {

namespace {

using Benchmarks::Row;

/// the strongest points of a clean surface that are looked for.
constexpr std::size_t number_sought = 20;

/// \brief which of the strongest points of the clean surface have a counterpart within `distance(point)` and
/// a quarter of the radius, or one step of it.
template <class Distance>
double found_fraction(const Salient_run& clean, const Salient_run& other, Distance distance)
{
  const std::size_t sought = std::min(clean.points.size(), number_sought);
  const auto is_found = [&](const Salient_point& p) {
    const double reach = distance(p);
    const double step = std::max(0.25 * p.scale, 1.01 * clean.reference_length);
    return std::any_of(other.points.begin(), other.points.end(), [&](const Salient_point& q) {
      return CGAL::squared_distance(p.position, q.position) <= reach * reach &&
             std::abs(p.scale - q.scale) <= step;
    });
  };
  return double(std::count_if(clean.points.begin(), clean.points.begin() + std::ptrdiff_t(sought),
                              is_found)) /
         double(sought);
}

Measures compare(const Salient_run& clean, const Salient_run& other)
{
  Measures measures{{"points", double(other.points.size())}};
  if(!clean.points.empty()) {
    const double two_voxels = 2 * clean.reference_length;
    measures.insert(
        measures.end(),
        {{"sought", double(std::min(clean.points.size(), number_sought))},
         {"within 2 voxels", found_fraction(clean, other, [=](const auto&) { return two_voxels; })},
         {"within R/2",
          found_fraction(clean, other, [](const Salient_point& p) { return 0.5 * p.scale; })}});
  }
  if(!other.points.empty())
    measures.emplace_back("strongest", other.points.front().intensity);
  measures.emplace_back("seconds", other.seconds);
  return measures;
}

} // namespace

void figure_11(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 11",
      "Salient points of scans: a mesh, and what is found again of its strongest twenty points "
      "where "
      "30 % of the faces are missing in thirty holes, and with noise of a tenth of the mean length "
      "of the edges as well. Found again is what has a radius like it within two voxels, or within "
      "R/2: along tubes nothing holds a maximum in its place. The reference length is that of the "
      "mesh as it is given; one that has holes of its own counts as clean.");
  std::vector<Row> rows;
  for(const Mesh& mesh : read_meshes(options, {"human_woman.obj", "hand.obj"})) {
    const Soup with_holes = holes(0.3).apply(mesh.soup, options.seed);
    const Soup scan = noise(0.1).apply(with_holes, options.seed);
    for(Salient_mode mode : salient_modes()) {
      mode.reference_length = options.pick(4, 1) * short_reference_length(mesh.soup);
      const Salient_run clean = find_salient_points(mesh.soup, mode);
      const auto add = [&](const std::string& damage, const Soup& soup, const Salient_run& run) {
        rows.push_back(row("figure 11", "points found again", mode.name,
                           {{"mesh", mesh.name}, {"damage", damage}}, compare(clean, run)));
        write_picture_of_points(options,
                                "figure_11_" + mesh.name + "_" + damage + "_" + mode.name + ".png",
                                soup, run.points);
      };
      add("none", mesh.soup, clean);
      add("holes", with_holes, find_salient_points(with_holes, mode));
      add("holes and noise", scan, find_salient_points(scan, mode));
    }
  }
  publish(rows, report);
}

} // namespace Paper
