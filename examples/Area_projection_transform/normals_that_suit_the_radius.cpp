// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Is this rough thing a ball? At a radius far larger than its bumps, the normals of its faces point
// everywhere, and what is projected along them scatters. Averaged over a neighbourhood that grows with the
// radius, or on a surface that is smoothed as the radius grows, they point where those of a ball do.

#include <CGAL/area_projection_transform.h>

#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Mean_curvature_flow.h>
#include <CGAL/Area_projection_transform/scale_space/Smoothing_scale_space.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

Mesh rough_ball()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(5));
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double length = std::sqrt((p - CGAL::ORIGIN).squared_length());
    const double r =
        1 + 0.04 * (std::sin(25 * p.x()) + std::sin(25 * p.y()) + std::sin(25 * p.z()));
    mesh.point(v) = CGAL::ORIGIN + r / length * (p - CGAL::ORIGIN);
  }
  return mesh;
}

// The value at the centre, where a ball of radius 1 has 1.
template <class ScaleSpace>
double value_at_centre(const ScaleSpace& surface)
{
  const AP::Scale scale{1., 0.5};
  const AP::Exact_evaluator evaluate(surface, scale.radius, AP::Side::INSIDE);
  return scale.normalization() * evaluate(Point(0, 0, 0), scale.sigma);
}

int main()
{
  const AP::Triangle_surface ball = AP::surface_from_mesh(rough_ball());
  const double plain = value_at_centre(AP::Constant_scale_space(ball));
  const double averaged = value_at_centre(AP::Smoothing_scale_space(AP::Averaged_normals(ball)));
  const double smoothed = value_at_centre(AP::Smoothing_scale_space(AP::Mean_curvature_flow(ball)));
  std::cout << "normals of the faces " << plain << ", averaged " << averaged
            << ", of the smoothed surface " << smoothed << "; a ball has 1\n";
  return plain < 0.5 && std::abs(averaged - 1) < 0.1 && std::abs(smoothed - 1) < 0.05 ? 0 : 1;
}
