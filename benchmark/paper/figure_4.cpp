// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "normals_modes.h"
#include "shapes.h"

namespace Paper {

namespace {

AP::Scale scale_of(double radius)
{
  return {radius, 0.5 * radius};
}

/// the value at the centre of the sphere at its radius, and in the middle of a bump at that of the bump.
std::vector<Benchmarks::Row> compare_modes(const Bumps& bumps, int levels)
{
  const Soup smooth = icosphere(levels);
  const auto [bumpy, radius] = bumpy_sphere(bumps, levels);
  const Point_3 centre = CGAL::ORIGIN, bump = centre + radius * even_directions(bumps.number)[0];
  const AP::Scale scale_of_bump = scale_of(radius * bumps.width());
  const Benchmarks::Parameters parameters{{"faces", bumpy.triangles.size()},
                                          {"bumps", bumps.number},
                                          {"width", bumps.width()},
                                          {"amplitude", bumps.amplitude}};
  std::vector<Benchmarks::Row> rows;
  for(const std::string& mode : normals_modes()) {
    const double of_smooth = value_at(mode, smooth, centre, scale_of(1));
    const double of_bumpy = value_at(mode, bumpy, centre, scale_of(1));
    rows.push_back(row("figure 4", "bumpy sphere", mode, parameters,
                       {{"smooth sphere", of_smooth},
                        {"bumpy sphere", of_bumpy},
                        {"relative value", of_bumpy / of_smooth},
                        {"middle of a bump", value_at(mode, bumpy, bump, scale_of_bump)},
                        {"area", area(bumpy) / area(smooth)}}));
  }
  return rows;
}

} // namespace

void figure_4(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 4",
      "A sphere with bumps that approximates one of radius 1. At its centre the smooth sphere has "
      "the value 1 at R = 1; "
      "with the normals of its faces the bumps send most of the area elsewhere, and normals that "
      "are smoothed over more than a bump bring it back. In the middle of a bump that is half a "
      "ball the value at its own radius is about a half.");
  const int levels = options.pick(5, 7);
  std::vector<Benchmarks::Row> rows;
  for(std::size_t number : options.pick<std::vector<std::size_t>>({200}, {200, 1000}))
    for(double amplitude : options.pick<std::vector<double>>({0, 1}, {0, 0.1, 0.25, 0.5, 0.75, 1}))
      for(Benchmarks::Row& r : compare_modes({number, amplitude}, levels))
        rows.push_back(std::move(r));
  publish(rows, report);
}

} // namespace Paper
