// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What does a value of the transform mean? It is a fraction of a sphere: the table shows what simple
// shapes read at their centre, beside the closed form.

#include <CGAL/area_projection_transform.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

Mesh sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for(const Mesh::Vertex_index v : mesh.vertices()) { // back to the sphere
    const auto radial = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + radial / std::sqrt(radial.squared_length());
  }
  return mesh;
}

Mesh cylinder()
{
  Mesh mesh;
  CGAL::make_regular_prism(200, mesh, Point(0, -5, 0), 10., 1., true);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

void print(const std::string& shape, const Mesh& mesh, double radius, double expected)
{
  const AP::Scale scale{radius, radius / 2};
  const double area =
      AP::area_projection_transform(mesh, Point(0, 0, 0), scale.radius, scale.sigma);
  std::cout << std::setw(10) << shape << std::setw(8) << radius << std::setw(12)
            << area * scale.normalization() << std::setw(12) << expected << '\n';
}

int main()
{
  std::cout << "     shape       R        MAPT    expected\n" << std::fixed << std::setprecision(4);
  for(const double radius : {0.8, 1., 1.5}) { // seen at their radius, and beside it
    const double t = 1 / radius;
    print("sphere", sphere(), radius, t * t);
    print("cylinder", cylinder(), radius, t * std::sqrt(0.25 - (t - 1) * (t - 1)));
  }
}
