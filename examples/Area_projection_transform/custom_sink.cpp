// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What else can be made of the maps than their maximum? Anything that takes values as they come: here a
// histogram for each scale, without keeping a map of any.

#include <CGAL/area_projection_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace AP = CGAL::Area_projection;

// A model of MultiscaleSink. A scale is handed over by one thread at a time, so histograms that are
// kept by scale need no lock.
class Histograms
{
public:
  explicit Histograms(std::size_t number_of_scales) : m_counts(number_of_scales) {}

  void consume(std::size_t scale_index, const AP::Scale&, std::size_t /* first_voxel */,
               const float* values, std::size_t number)
  {
    for(std::size_t i = 0; i < number; ++i)
      ++m_counts[scale_index][std::min<std::size_t>(std::size_t(values[i] * 10), 11)];
  }

  const std::array<std::size_t, 12>& counts(std::size_t scale) const { return m_counts[scale]; }

private:
  std::vector<std::array<std::size_t, 12>> m_counts;
};

int main()
{
  Mesh mesh; // a round pebble
  CGAL::make_icosahedron(mesh, CGAL::Simple_cartesian<double>::Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));

  const AP::Constant_scale_space surface(AP::surface_from_mesh(mesh));
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.05);
  const AP::Row_spans region = AP::interior(surface.source(), grid).region;
  const std::vector<AP::Scale> scales = AP::proportional_scales(AP::uniform_radii(0.2, 0.2, 5));

  Histograms histograms(scales.size());
  AP::project_scales<CGAL::Parallel_if_available_tag>(
      surface, region, scales, AP::Side::INSIDE, [&] { return AP::Grid_projector(region); },
      histograms);

  std::cout << region.number_of_voxels() << " voxels; how many have 0-0.1, 0.1-0.2, ..., 1.1-\n";
  for(std::size_t s = 0; s < scales.size(); ++s) {
    std::cout << "R = " << scales[s].radius << ':';
    for(const std::size_t count : histograms.counts(s))
      std::cout << std::setw(6) << count;
    std::cout << '\n';
  }
}
