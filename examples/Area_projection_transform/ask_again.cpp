// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What if the radius were a little larger? A session pays for the surface and for its inside once; then
// every question costs its own projection only, as a slider needs it. Reads a triangle mesh (argument 1;
// a knobbly ball if there is none).

#include <CGAL/area_projection_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace AP = CGAL::Area_projection;
using Surface = AP::Constant_scale_space<AP::Triangle_surface>;

Mesh knobbly_ball()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(5));
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double r = 1 + 0.1 * std::sin(9 * p.x()) * std::sin(9 * p.y()) * std::sin(9 * p.z());
    mesh.point(v) = Point(r * p.x(), r * p.y(), r * p.z());
  }
  return mesh;
}

// Tells how long it took to answer, and the largest value found.
template <class Question>
void ask(const std::string& text, Question question)
{
  const auto start = std::chrono::steady_clock::now();
  const float largest = question();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  std::cout << std::setw(42) << std::left << text << std::right << std::setw(9) << std::fixed
            << std::setprecision(1) << time.count() << " ms, largest value " << std::setprecision(3)
            << largest << '\n';
}

float largest(const std::vector<float>& values)
{
  return *std::max_element(values.begin(), values.end());
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc < 2)
    mesh = knobbly_ball();
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " is not a mesh that can be read\n";
    return 1;
  }

  Surface surface(AP::surface_from_mesh(mesh));
  const CGAL::Bbox_3 box = surface.bbox();
  const double voxel = AP::default_voxel_size(box);
  std::vector<double> radii = AP::default_radii(box, voxel);
  AP::Map_session<Surface, CGAL::Parallel_if_available_tag> session(std::move(surface), voxel,
                                                                    radii.back());
  session.keep_maps(true);

  const auto joint = [&](double c, AP::Side side) {
    return largest(session.joint_map(AP::proportional_scales(radii, c), side).values());
  };
  const auto one = [&](double radius, double c) {
    return largest(session.scale_map({radius, c * radius}, AP::Side::INSIDE));
  };
  const double radius = radii[radii.size() / 2];
  ask("the first radius, with the inside", [&] { return one(radius, 0.5); });
  ask("a radius that is 5 % larger", [&] { return one(1.05 * radius, 0.5); });
  ask("a narrower ball, c = 0.3", [&] { return one(radius, 0.3); });
  ask("the joint map of " + std::to_string(radii.size()) + " radii",
      [&] { return joint(0.5, AP::Side::INSIDE); });
  radii[radii.size() / 2] *= 1.05;
  ask("the joint map with one radius changed", [&] { return joint(0.5, AP::Side::INSIDE); });
  ask("the joint map with c = 0.4", [&] { return joint(0.4, AP::Side::INSIDE); });
  ask("the joint map of the outside", [&] { return joint(0.4, AP::Side::OUTSIDE); });
}
