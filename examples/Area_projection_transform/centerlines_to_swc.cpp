// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where do the tubes of this run, and how thick are they? Reads a triangle mesh (argument 1; a helix that has lost half
// of its faces if there is none) and writes its centrelines to centerlines.swc, for programs that show neurons and
// vessels, and to centerlines.vtp for ParaView.

#include <CGAL/Area_projection_transform/IO/centerlines_SWC.h>
#include <CGAL/Area_projection_transform/IO/centerlines_VTP.h>
#include <CGAL/Area_projection_transform/centerlines.h>

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

// A tube of radius 1 around a helix of radius 4, open at its ends, without half of its faces.
Mesh helix()
{
  const int columns = 24, rows = 200;
  Mesh mesh;
  CGAL::make_grid(
      rows, columns, mesh,
      [&](int i, int j) {
        const double a = 4 * CGAL_PI * i / rows, b = 2 * CGAL_PI * j / columns, pitch = 0.7;
        const double c = std::cos(a), s = std::sin(a), n = std::hypot(4, pitch);
        // Across the helix: towards its axis, and along the binormal.
        const double inward = std::cos(b), along = std::sin(b) / n;
        return Point((4 - inward) * c + along * pitch * s, (4 - inward) * s - along * pitch * c,
                     pitch * a + along * 4);
      },
      true);
  CGAL::Random random(1);
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
    mesh = helix();
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " is not a mesh that can be read\n";
    return 1;
  }
  const AP::Centerline_graph graph = AP::centerlines<CGAL::Parallel_if_available_tag>(mesh);

  std::cout.precision(4);
  for(const AP::Centerline_branch& branch : AP::branches(graph))
    std::cout << "from " << graph[branch.from()].point << " to " << graph[branch.to()].point
              << ": length " << branch.length << ", mean radius " << branch.mean_radius << ", "
              << branch.voters.size() << " faces around it\n";
  AP::IO::write_centerlines_SWC("centerlines.swc", graph);
  AP::IO::write_centerlines_VTP("centerlines.vtp", graph);
}
