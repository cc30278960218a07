// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which shapes are alike? Describes triangle meshes (the arguments; rods, bars and balls of any size and place if there are
// none) by the histograms of their maps, and tells for each which other one is nearest.

#include <CGAL/Area_projection_transform/retrieval.h>
#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;

// A prism of some sides: round with many of them, a bar with four.
Mesh prism(int sides, double radius, double length)
{
  Mesh mesh;
  CGAL::make_regular_prism(sides, mesh, Point(1, 2, 3), length, radius, true);
  return mesh;
}

Mesh ball(double radius)
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(-5, 0, 0), radius);
  return mesh;
}

std::vector<std::pair<std::string, Mesh>> some_shapes()
{
  return {{"rod", prism(40, 1, 9)},    {"long bar", prism(4, 1, 9)},
          {"ball", ball(3)},           {"large rod", prism(30, 50, 480)},
          {"bar", prism(4, 0.1, 0.8)}, {"small ball", ball(0.02)}};
}

int main(int argc, char* argv[])
{
  std::vector<std::pair<std::string, Mesh>> shapes;
  for(int i = 1; i < argc; ++i) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh)) {
      std::cerr << argv[i] << " is not a mesh that can be read\n";
      return 1;
    }
    shapes.emplace_back(argv[i], mesh);
  }
  if(shapes.empty())
    shapes = some_shapes();

  AP::Descriptor_table table(96, 12);
  for(const auto& [name, mesh] : shapes)
    table.push_back(AP::shape_descriptor<CGAL::Parallel_if_available_tag>(mesh).values);
  const AP::Metric_index index(table, AP::Histogram_distance(AP::Distance_kind::JEFFREY, 96, 12));
  for(std::size_t i = 0; i < shapes.size(); ++i)
    for(const AP::Neighbor& neighbor : index.nearest(table[i], 2))
      if(neighbor.index != i) // the other one is the shape itself
        std::cout << shapes[i].first << " is most like " << shapes[neighbor.index].first
                  << ": at a distance of " << neighbor.distance << "\n";
}
