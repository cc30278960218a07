// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/area_projection_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

// At the centre of a cube, at the distance of half an edge, the six faces land in one ball: six times
// the sixteenth that a plane reads.
int main()
{
  Mesh cube;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(2, 0, 0), Point(2, 2, 0), Point(0, 2, 0),
                        Point(0, 2, 2), Point(0, 0, 2), Point(2, 0, 2), Point(2, 2, 2), cube);
  for(const Mesh::Halfedge_index h : cube.halfedges())
    if(cube.degree(cube.face(h)) == 4)
      CGAL::Euler::split_face(h, cube.next(cube.next(h)), cube);

  const double at_center = AP::area_projection_transform(cube, Point(1, 1, 1), 1., 0.5);
  const double mapt = at_center * AP::Scale{1., 0.5}.normalization();
  const AP::Joint_map map = AP::joint_area_projection_transform(
      cube,
      AP::parameters::combine(AP::parameters::voxel_size(0.125), AP::parameters::radii({0.5, 1.})));
  const float largest = *std::max_element(map.values().begin(), map.values().end());

  std::cout << "MAPT at the centre of a cube: " << mapt << "; largest JMAPT: " << largest << '\n';
  return std::abs(mapt - 6. / 16) < 1e-12 && largest > 0.3 && largest < 1 ? 0 : 1;
}
