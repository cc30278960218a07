// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// My points are not where the mesh has them, nor of a type of CGAL: must I copy? No: a property map computes them when they
// are read. Here the vertices of a unit sphere are swollen to a radius of 2 on the way, in single precision.

#include <CGAL/area_projection_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

// Three numbers are enough: a model of the point of AreaProjectionTraits_3.
struct Float_point
{
  float coordinates[3];

  float x() const { return coordinates[0]; }
  float y() const { return coordinates[1]; }
  float z() const { return coordinates[2]; }
};

// A model of ReadablePropertyMap: the point of a vertex, on the sphere of some radius.
struct Swollen_point_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = Float_point;
  using reference = Float_point;
  using category = boost::readable_property_map_tag;

  const Mesh* mesh;
  double radius;

  friend Float_point get(const Swollen_point_map& map, Mesh::Vertex_index v)
  {
    const auto radial = map.mesh->point(v) - CGAL::ORIGIN;
    const double factor = map.radius / std::sqrt(radial.squared_length());
    return {{float(factor * radial.x()), float(factor * radial.y()), float(factor * radial.z())}};
  }
};

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));

  const auto points = CGAL::parameters::vertex_point_map(Swollen_point_map{&mesh, 2.});
  const AP::Scale scale{2, 1};
  const Float_point center{{0, 0, 0}};
  const double area =
      AP::area_projection_transform(mesh, center, scale.radius, scale.sigma, points);
  std::cout << "MAPT at the centre, at R = 2: " << area * scale.normalization()
            << ", of a sphere 1\n";
}
