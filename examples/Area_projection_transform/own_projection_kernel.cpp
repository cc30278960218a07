// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Can surface count less, the farther from the point it lands? Any kernel that falls from the middle to the rim can be
// written as balls within each other: here a cone, 1 - d/σ, on a grid around the axis of a tube.

#include <CGAL/area_projection_transform.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>
#include <memory>
#include <utility>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

// A model of ProjectionKernel_3. The balls have the radii 1/2n, 3/2n, … of σ and the same weight, so that their sum falls
// like the cone, in n steps.
struct Cone_kernel_3
{
  unsigned number_of_balls = 4;

  std::vector<AP::Nested_ball> nested_balls() const
  {
    std::vector<AP::Nested_ball> balls;
    for(unsigned i = 0; i < number_of_balls; ++i)
      balls.push_back({(i + 0.5) / number_of_balls, 1. / number_of_balls});
    return balls;
  }
};

int main()
{
  Mesh mesh; // a tube of radius 1 along the y-axis
  CGAL::make_regular_prism(200, mesh, Point(0, -5, 0), 10., 1., true);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);

  const auto value_on_axis = [&](const auto& kernel) {
    using Surface = AP::Constant_scale_space<AP::Triangle_surface>;
    AP::Map_session<Surface> session(Surface(AP::surface_from_mesh(mesh)), 0.1, 0,
                                     AP::Make_grid_projector{kernel.nested_balls()});
    const AP::Row_spans voxels(AP::Grid_3(CGAL::ORIGIN, 0.1, {1, 1, 1})); // one, in the middle
    session.set_region(AP::Side::INSIDE, std::make_shared<const AP::Row_spans>(voxels));
    return session.scale_map({1, 0.5}, AP::Side::INSIDE).front();
  };
  // On the axis, c times the mean of the kernel along a radius: 1 for the ball, 1/2 for the cone.
  std::cout << "ball: " << value_on_axis(AP::Ball_kernel_3()) << ", expected 0.5\n"
            << "cone: " << value_on_axis(Cone_kernel_3()) << ", expected 0.25\n";
}
