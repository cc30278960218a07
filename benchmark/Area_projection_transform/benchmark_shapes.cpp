// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "benchmark_shapes.h"

#include <CGAL/Area_projection_transform/regions.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace Benchmarks {

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error(file + ": cannot be read as a mesh of triangles");
  return mesh;
}

std::string name_of_mesh(const std::string& file)
{
  return std::filesystem::path(file).stem().string();
}

void refine(Mesh& mesh, std::size_t vertices)
{
  while(mesh.number_of_vertices() < vertices)
    CGAL::Subdivision_method_3::Loop_subdivision(mesh);
}

Soup rippled_torus(std::size_t faces)
{
  constexpr double two_pi = 2 * 3.14159265358979323846;
  // Three times as many around the axis as around the tube makes the triangles about equilateral.
  const std::size_t n = std::max(std::size_t(3), std::size_t(std::sqrt(double(faces) / 6)));
  const std::size_t m = 3 * n;
  Soup soup;
  soup.points.reserve(n * m);
  soup.triangles.reserve(2 * n * m);
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double u = two_pi * double(i) / double(m), v = two_pi * double(j) / double(n);
      const double tube = 0.14 + 0.01 * std::cos(9 * u) * std::cos(3 * v);
      const double distance = 0.35 + tube * std::cos(v);
      soup.points.emplace_back(distance * std::cos(u), distance * std::sin(u), tube * std::sin(v));
      const std::size_t a = i * n + j, b = (i + 1) % m * n + j;
      const std::size_t c = (i + 1) % m * n + (j + 1) % n, d = i * n + (j + 1) % n;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

AP::Grid_3 grid_of(const Surface& surface, int voxels)
{
  const CGAL::Bbox_3 b = surface.bbox();
  return AP::grid_around(b, std::max({b.x_span(), b.y_span(), b.z_span()}) / voxels);
}

std::vector<AP::Scale> descriptor_scales(const AP::Grid_3& grid, std::size_t number)
{
  const double s = grid.spacing();
  return AP::proportional_scales(AP::uniform_radii(2 * s, s, number));
}

Job::Job(const Surface& s, int voxels)
    : surface(s)
    , region(AP::interior(s.source(), grid_of(s, voxels)).region)
    , scales(descriptor_scales(region.grid()))
{}

} // namespace Benchmarks
