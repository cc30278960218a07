// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_BENCHMARK_SHAPES_H
#define AREA_PROJECTION_BENCHMARK_SHAPES_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Benchmarks {

namespace AP = CGAL::Area_projection;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface = AP::Constant_scale_space<AP::Triangle_surface>;

/// \throw std::runtime_error if the file cannot be read as a mesh of triangles.
Mesh read_mesh(const std::string& file);

/// the name of a file without folder and extension.
std::string name_of_mesh(const std::string& file);

/// subdivides (Loop) until the mesh has at least a number of vertices.
void refine(Mesh& mesh, std::size_t vertices);

struct Soup
{
  std::vector<AP::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// \brief a closed torus with ripples on it, of about a number of faces: the shape is always the same.
///
/// Its longest side is about 1, its tube about 0.3 thick.
Soup rippled_torus(std::size_t faces);

/// the grid around a surface that has `voxels` voxels along the longest side.
AP::Grid_3 grid_of(const Surface& surface, int voxels);

/// the scales of the paper's descriptor: R = 2 s, 3 s, … for voxels of size s, and sigma = R / 2.
std::vector<AP::Scale> descriptor_scales(const AP::Grid_3& grid, std::size_t number = 8);

/// a surface and the voxels inside of it.
struct Job
{
  const Surface& surface;
  AP::Row_spans region;
  std::vector<AP::Scale> scales;

  Job(const Surface& s, int voxels);
};

} // namespace Benchmarks

#endif // AREA_PROJECTION_BENCHMARK_SHAPES_H
