// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What does a skeleton keep of a shape, and what a medial axis? Reads a triangle mesh (argument 1; a flat ring if there is
// none), compares medial axes, centrelines and CGAL's skeleton of it, and writes the axis that is weighted by the
// transform to medial_axis.ply.

#include <CGAL/Area_projection_transform/IO/medial_balls_PLY.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <vector>

namespace AP = CGAL::Area_projection;

// A ring of radius 3 whose section is an ellipse, 2 wide and 0.5 high.
AP::Triangle_surface flat_ring()
{
  const unsigned n = 120, m = 40;
  std::vector<AP::Point_3> points;
  std::vector<std::array<unsigned, 3>> triangles;
  for(unsigned i = 0; i < n; ++i)
    for(unsigned j = 0; j < m; ++j) {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / m, r = 3 + std::cos(b);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 0.25 * std::sin(b));
      const auto at = [&](unsigned k, unsigned l) { return (i + k) % n * m + (j + l) % m; };
      triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  return AP::surface_from_triangle_soup(points, triangles);
}

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if(argc > 1 && !CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " is not a mesh that can be read\n";
    return 1;
  }
  const AP::Triangle_surface surface = argc > 1 ? AP::surface_from_mesh(mesh) : flat_ring();

  const AP::Medial_axes compared = AP::medial_axes(surface);
  for(const auto& [name, reason] : compared.left_out)
    std::cout << "no " << name << ": " << reason << "\n";
  if(compared.axes.empty()) {
    std::cerr << argv[1] << " has no face with an area\n";
    return 1;
  }
  const AP::Medial_judge judge(surface, compared.axes.front(), compared.tolerance);
  for(const AP::Medial_representation& axis : compared.axes)
    std::printf("%-14s %6zu balls cover %5.1f %% of the surface; %ld loops\n", axis.name.c_str(),
                axis.size(), 100 * judge.measure(axis).coverage, axis.topology->loops);

  const auto balls = AP::medial_balls(surface);
  const auto kept = AP::select_by_weight(balls, AP::Medial_weight::IMPORTANCE, 0.3);
  const double growth = AP::crack_width(surface.total_area(), balls.size());
  AP::IO::write_PLY("medial_axis.ply",
                    AP::IO::medial_balls_PLY(balls, kept, AP::medial_complex(balls, kept, growth)));
}
