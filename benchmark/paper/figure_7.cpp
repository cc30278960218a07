// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "damage_tables.h"
#include "figures.h"

namespace Paper {

void figure_7(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 7",
      "Holes where a scanner does not see, and the noise of its measurements. A mesh that "
      "has holes of its own counts as clean, and gets more of them.");
  const std::vector<std::size_t> three_scales{0, 3, 7}; // R = 2, 5 and 9 voxels
  const Damage scan{"scan", 0.3, [](const Soup& soup, std::uint64_t seed) {
                      return add_noise(holes(0.3).apply(soup, seed), 0.1, seed);
                    }};
  for(Mesh& mesh : read_meshes(options, {"human_woman.obj"})) {
    Subject subject(std::move(mesh), options.voxels, descriptor_radii());
    compare_damages("figure 7", options, subject, {scan}, three_scales, report);
  }
}

} // namespace Paper
