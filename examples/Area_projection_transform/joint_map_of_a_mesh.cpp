// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where are the round parts of a mesh, and how thick are they? Reads a triangle mesh (argument 1; a
// dumbbell if there is none) and writes its joint map, which ParaView shows, to joint_map.vti.

#include <CGAL/area_projection_transform.h>
#include <CGAL/Area_projection_transform/IO/VTI.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

// A sphere of radius 1 and one of 0.6, three apart, and a bar of radius 0.25 between them.
Mesh dumbbell()
{
  const int columns = 60, rows = 150;
  const auto radius = [](double x) {
    const auto ball = [x](double center, double r) {
      return std::sqrt(std::max(r * r - (x - center) * (x - center), 0.));
    };
    return std::max({ball(0, 1), ball(3, 0.6), x > 0 && x < 3 ? 0.25 : 0.});
  };
  Mesh mesh;
  CGAL::make_grid(
      columns, rows, mesh,
      [&](int i, int j) {
        const double phi = 2 * CGAL_PI * i / columns, x = -1 + 4.6 * j / rows;
        return Point(x, radius(x) * std::cos(phi), radius(x) * std::sin(phi));
      },
      true);
  return mesh;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc < 2)
    mesh = dumbbell();
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " is not a mesh that can be read\n";
    return 1;
  }

  const AP::Joint_map map =
      AP::joint_area_projection_transform<CGAL::Parallel_if_available_tag>(mesh);

  const AP::Grid_3& grid = map.grid();
  float largest = 0;
  std::array<int, 3> where{};
  for(int k = 0; k < grid.size()[2]; ++k)
    for(int j = 0; j < grid.size()[1]; ++j)
      for(int i = 0; i < grid.size()[0]; ++i)
        if(map.value(i, j, k) > largest) {
          largest = map.value(i, j, k);
          where = {i, j, k};
        }
  std::cout << "The largest value, " << largest << ", is at "
            << grid.point(where[0], where[1], where[2])
            << ", at the scale R = " << map.radius(where[0], where[1], where[2]) << ".\n";

  const auto rows = std::size_t(grid.size()[1]);
  AP::IO::Grid_image image(grid);
  image.add_array<float>("JMAPT", [&](std::size_t row, float* values) {
    for(int i = 0; i < grid.size()[0]; ++i)
      values[i] = map.value(i, int(row % rows), int(row / rows));
  });
  image.add_array<float>("SMAPT", [&](std::size_t row, float* values) {
    for(int i = 0; i < grid.size()[0]; ++i)
      values[i] = float(map.radius(i, int(row % rows), int(row / rows)));
  });
  AP::IO::write_VTI("joint_map.vti", image);
  std::cout << "joint_map.vti holds " << grid.number_of_voxels() << " voxels.\n";
}
