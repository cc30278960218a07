// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints checksums of the joint maps of two meshes by each of the projectors, computed by as many
// threads as the only argument says. The output may depend on nothing but the library.

#include "shapes.h"

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace {

namespace AP = CGAL::Area_projection;

template <class Function>
void with_threads(int number, Function function)
{
#ifdef CGAL_LINKED_WITH_TBB
  // More threads than cores are allowed, so that the test is the same on every machine.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(number));
  tbb::task_arena(number).execute(function);
#else
  static_cast<void>(number);
  function();
#endif
}

/// the checksum of Fowler, Noll and Vo.
template <class T>
std::uint64_t checksum(const std::vector<T>& values)
{
  std::uint64_t sum = 14695981039346656037u;
  for(const T& value : values) {
    std::array<unsigned char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    for(const unsigned char byte : bytes)
      sum = (sum ^ byte) * 1099511628211u;
  }
  return sum;
}

template <class Projector>
void print(const std::string& name, const shapes::Soup& soup, int threads)
{
  const auto surface = shapes::scale_space_of(soup);
  const CGAL::Bbox_3 box = surface.bbox();
  const double voxel = std::max({box.x_span(), box.y_span(), box.z_span()}) / 40;
  const AP::Grid_3 grid = AP::grid_around(box, voxel);
  const auto region =
      std::make_shared<const AP::Row_spans>(AP::interior(surface.source(), grid).region);
  const auto scales = AP::proportional_scales(AP::uniform_radii(2 * voxel, voxel, 6));
  AP::Joint_map map(region, scales);
  with_threads(threads, [&] {
    AP::project_scales<CGAL::Parallel_if_available_tag>(
        surface, *region, scales, AP::Side::INSIDE, [&] { return Projector(*region); }, map);
  });
  std::cout << name << ": " << map.values().size() << " voxels, JMAPT " << std::hex
            << checksum(map.values()) << ", SMAPT " << checksum(map.scale_indices()) << std::dec
            << '\n';
}

} // namespace

int main(int argc, char* argv[])
{
  const int threads = argc == 2 ? std::atoi(argv[1]) : 0;
  if(threads < 1) {
    std::cerr << "usage: print_map_checksum <number of threads>\n";
    return EXIT_FAILURE;
  }
  for(const auto& [name, soup] : {std::make_pair("hand", shapes::bundled_mesh("hand.obj")),
                                  std::make_pair("blob", shapes::blob(5, 1))}) {
    print<AP::Grid_projector>(std::string(name) + ", grid", soup, threads);
    print<AP::Exact_grid_projector>(std::string(name) + ", exact", soup, threads);
    print<AP::Paper_grid_projector>(std::string(name) + ", paper", soup, threads);
  }
}
