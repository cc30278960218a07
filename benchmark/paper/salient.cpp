// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient.h"

#include <CGAL/Area_projection_transform/salient_points/paper_salient_points.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <chrono>
#include <cmath>

namespace Paper {

const std::vector<Salient_mode>& salient_modes()
{
  static const std::vector<Salient_mode> modes{{"4D", false, {}, 1}, {"joint", true, {}, 1}};
  return modes;
}

Salient_run find_salient_points(const Soup& soup, const Salient_mode& mode)
{
  AP::Paper_salient_options options;
  options.reference_length = mode.reference_length.value_or(short_reference_length(soup));
  options.use_joint_map = mode.use_joint_map;
  options.smoothing = mode.smoothing;
  const auto surface = AP::surface_from_triangle_soup(soup.points, soup.triangles);
  const auto start = std::chrono::steady_clock::now();
  auto points = AP::paper_salient_points<CGAL::Parallel_if_available_tag>(surface, options);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {std::move(points), *options.reference_length, time.count()};
}

Measures describe(const Salient_point& p)
{
  return {{"x", p.position.x()},
          {"y", p.position.y()},
          {"z", p.position.z()},
          {"R", p.scale},
          {"intensity", p.intensity},
          {"sphericity", p.sphericity},
          {"blobness", p.inertia.blobness},
          {"flatness", p.inertia.flatness},
          {"vesselness", p.inertia.vesselness}};
}

double short_reference_length(const Soup& soup)
{
  return AP::paper_reference_length(area(soup));
}

double long_reference_length(const Soup& soup)
{
  return std::sqrt(area(soup) / (80 * 3.14159265358979323846));
}

} // namespace Paper
