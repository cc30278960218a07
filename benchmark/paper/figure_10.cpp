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

/// so many points of a model are listed.
constexpr std::size_t number_listed = 12;

Measures summarise(const Salient_run& run)
{
  Measures measures{{"s", run.reference_length}, {"points", double(run.points.size())}};
  if(!run.points.empty()) {
    std::vector<double> radii, sphericities;
    for(const Salient_point& p : run.points) {
      radii.push_back(p.scale / run.reference_length);
      if(!std::isnan(p.sphericity))
        sphericities.push_back(p.sphericity);
    }
    std::sort(radii.begin(), radii.end());
    const auto count = [&](auto predicate) {
      return double(std::count_if(sphericities.begin(), sphericities.end(), predicate));
    };
    measures.insert(measures.end(),
                    {{"smallest R/s", radii.front()},
                     {"median R/s", radii[radii.size() / 2]},
                     {"largest R/s", radii.back()},
                     {"strongest", run.points.front().intensity},
                     {"sphericity > 0.8", count([](double s) { return s > 0.8; })},
                     {"sphericity < 0.6", count([](double s) { return s < 0.6; })}});
  }
  measures.emplace_back("seconds", run.seconds);
  return measures;
}

} // namespace

void figure_10(const Options& options, Benchmarks::Report& report)
{
  report.add_group("figure 10",
                   "The salient points of animals and people, maxima in four dimensions and of the "
                   "joint map, and the strongest of them one by one. Lengths are in units of the "
                   "mesh, R/s in steps of the radius.");
  std::vector<Row> models;
  std::vector<std::vector<Row>> lists;
  for(const Mesh& mesh : read_meshes(options, {"hand.obj", "human_woman.obj", "scorpion_low.obj"}))
    for(Salient_mode mode : salient_modes()) {
      // In large voxels it takes less than a second.
      mode.reference_length = options.pick(4, 1) * short_reference_length(mesh.soup);
      const Salient_run run = find_salient_points(mesh.soup, mode);
      const Benchmarks::Parameters parameters{{"mesh", mesh.name},
                                              {"faces", mesh.soup.triangles.size()}};
      models.push_back(row("figure 10", "models", mode.name, parameters, summarise(run)));
      write_picture_of_points(options, "figure_10_" + mesh.name + "_" + mode.name + ".png",
                              mesh.soup, run.points);
      std::vector<Row> list;
      for(std::size_t i = 0; i < std::min(run.points.size(), number_listed); ++i)
        list.push_back(row("figure 10", "strongest points", mode.name + " " + std::to_string(i + 1),
                           parameters, describe(run.points[i])));
      if(!list.empty())
        lists.push_back(std::move(list));
    }
  publish(models, report);
  for(const std::vector<Row>& list : lists)
    publish(list, report);
}

} // namespace Paper
