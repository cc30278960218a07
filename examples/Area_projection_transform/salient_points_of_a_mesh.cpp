// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which balls and tubes is this made of? Reads a triangle mesh (argument 1; a lollipop that has lost half of its
// faces if there is none) and writes a copy, of which the faces show what they belong to, to salient_points.ply.

#include <CGAL/Area_projection_transform/IO/PLY.h>
#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>
#include <CGAL/Area_projection_transform/IO/salient_points_PLY.h>
#include <CGAL/Area_projection_transform/salient_points.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <iostream>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

// A ball of radius 1 on a stick of radius 0.4: half of the faces, at random, and vertices with noise.
Mesh lollipop()
{
  CGAL::Random random(1);
  const int columns = 60, rows = 150;
  Mesh mesh;
  CGAL::make_grid(
      columns, rows, mesh,
      [&](int i, int j) {
        const double phi = 2 * CGAL_PI * i / columns, x = -1 + 5. * j / rows;
        const double r = x > 0.9 ? 0.4 : std::sqrt(1 - x * x);
        const double noisy_r = r + random.uniform_real(-0.01, 0.01);
        return Point(x, noisy_r * std::cos(phi), noisy_r * std::sin(phi));
      },
      true);
  const std::vector<Mesh::Face_index> faces(mesh.faces_begin(), mesh.faces_end());
  for(const Mesh::Face_index f : faces)
    if(random.get_bool())
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  return mesh;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc < 2)
    mesh = lollipop();
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " is not a mesh that can be read\n";
    return 1;
  }
  const AP::Triangle_surface surface = AP::surface_from_mesh(mesh);
  const std::vector<AP::Salient_point> points =
      AP::salient_points<CGAL::Parallel_if_available_tag>(surface);

  std::cout.precision(4);
  for(const AP::Salient_point& p : points)
    std::cout << AP::IO::to_text(p.shape) << " at " << p.position << ", radius " << p.radius << " ("
              << p.radius_low << " to " << p.radius_high << "), "
              << std::round(100 * p.observed_fraction) << " % of it in " << p.voters.size()
              << " faces\n";
  AP::IO::write_PLY("salient_points.ply", AP::IO::salient_points_PLY(surface, points));
}
