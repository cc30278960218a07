// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far to smooth: what it gains under noise, and what it costs on a clean surface.

#include "figures.h"
#include "normals_modes.h"

namespace Paper {

namespace {

// Noise against the clean map of the same mode, and the clean map against that of the normals of faces.
Measures measure(const std::string& mode, Subject& subject, const Soup& noisy)
{
  const Maps& face = subject.maps("face");
  const Maps& clean = subject.maps(mode);
  const Maps other = compute_maps(mode, noisy, subject.region(), subject.scales());
  const auto differ = [&](const std::vector<float>& a, const std::vector<float>& b) {
    return compare(*subject.region(), a, b);
  };
  const Map_difference by_noise = differ(clean.joint.values(), other.joint.values());
  const Map_difference by_smoothing = differ(face.joint.values(), clean.joint.values());
  return {{"noise: joint correlation", by_noise.correlation},
          {"noise: joint error", by_noise.relative_rms},
          {"noise: largest R error", differ(clean.scales.back(), other.scales.back()).relative_rms},
          {"smoothing: joint correlation", by_smoothing.correlation},
          {"smoothing: joint error", by_smoothing.relative_rms}};
}

} // namespace

void smoothing_ratios(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "ratios",
      "How far normals are averaged or surfaces smoothed, in units of the radius: what becomes of "
      "the "
      "map by noise of a fifth of the mean length of the edges, and what by the smoothing itself, "
      "against the normals of faces on the clean surface. Means over the meshes.");
  constexpr double amount = 0.2;
  std::vector<Subject> subjects;
  std::vector<Soup> noisy;
  for(Mesh& mesh : read_meshes(options, {"hand.obj", "human_woman.obj", "scorpion_low.obj"})) {
    noisy.push_back(add_noise(mesh.soup, amount, options.seed));
    subjects.emplace_back(std::move(mesh), options.voxels, descriptor_radii());
  }
  std::vector<Benchmarks::Row> rows;
  const auto add = [&](const std::string& name, double ratio, const std::string& mode) {
    std::vector<Measures> measures;
    for(std::size_t s = 0; s < subjects.size(); ++s)
      measures.push_back(measure(mode, subjects[s], noisy[s]));
    rows.push_back(row("ratios", "noise and smoothing", name, {{"ratio", ratio}}, mean(measures)));
  };
  add("face", 0, "face");
  for(const std::string name : {"averaged", "smoothed"})
    for(double ratio :
        options.pick<std::vector<double>>({0.25}, {0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5}))
      add(name, ratio, mode_with_ratio(name, ratio));
  publish(rows, report);
}

} // namespace Paper
