// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "damage_tables.h"
#include "figures.h"

namespace Paper {

void figure_1(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 1", "Half of the faces removed at random, and noise of a fifth of the mean length of "
                  "the edges, against the clean surface, over its interior.");
  const std::vector<std::size_t> two_scales{1, 5}; // R = 3 and 7 voxels
  for(Mesh& mesh : read_meshes(options, {"scorpion_low.obj", "hand.obj", "human_woman.obj"})) {
    Subject subject(std::move(mesh), options.voxels, descriptor_radii());
    compare_damages("figure 1", options, subject, {removed_faces(0.5), noise(0.2)}, two_scales,
                    report);
  }
}

} // namespace Paper
