// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is the transform at these places? An evaluator holds the surface for one radius and answers for any point and
// any σ: here along a line through a sphere that is seen at a smaller radius than its own, so that it lands on a sphere of
// 0.2, of which the ball of radius σ takes in a cap.

#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

Mesh unit_sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(5));
  for(const Mesh::Vertex_index v : mesh.vertices()) { // back to the sphere
    const auto radial = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + radial / std::sqrt(radial.squared_length());
  }
  return mesh;
}

// The part of a sphere of radius `r` that lies within `sigma` of a point at the distance `d` from its centre.
double part_within(double sigma, double d, double r)
{
  return d == 0 ? double(r <= sigma)
                : std::clamp((sigma * sigma - (d - r) * (d - r)) / (4 * d * r), 0., 1.);
}

int main()
{
  const AP::Constant_scale_space surface(AP::surface_from_mesh(unit_sphere()));
  const AP::Scale scale{0.8, 0.25};
  const AP::Exact_evaluator exact(surface, scale.radius, AP::Side::INSIDE);
  const AP::Sampled_evaluator sampled(surface, scale.radius, AP::Side::INSIDE,
                                      AP::default_sampling_ratio * scale.sigma);

  std::cout << "distance    exact  sampled  closed form\n" << std::fixed << std::setprecision(4);
  double largest_error = 0;
  for(const double d : {0., 0.04, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    const double expected = part_within(scale.sigma, d, 0.2) / (scale.radius * scale.radius);
    const double value = exact(Point(d, 0, 0), scale.sigma) * scale.normalization();
    std::cout << std::setw(8) << d << std::setw(9) << value << std::setw(9)
              << sampled(Point(d, 0, 0), scale.sigma) * scale.normalization() << std::setw(13)
              << expected << '\n';
    largest_error = std::max(largest_error, std::abs(value - expected));
  }
  std::cout << "largest error of the exact value, for a mesh in place of a sphere: "
            << largest_error << '\n';
}
