// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the row spans and the stream of maps save: each row in a process of its own.

#include "benchmark_projectors.h"

#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/sinks.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

namespace Benchmarks {

namespace {

void keep_all_maps(const Surface& surface, const AP::Row_spans& region,
                   const std::vector<AP::Scale>& scales)
{
  AP::Scale_maps_sink sink(region, scales.size());
  AP::project_scales(surface, region, scales, AP::Side::INSIDE, grid_projector(region), sink);
  keep(sink.maps().data());
}

/// The regions are found within the work: they take time and memory, too.
void compare_storage(Group& group, const std::string& file)
{
  const int voxels = group.pick(32, 128, 512);
  const Surface surface(AP::surface_from_mesh(read_mesh(file)));
  const AP::Grid_3 grid = grid_of(surface, voxels);
  const std::vector<AP::Scale> scales = descriptor_scales(grid);
  const auto interior = [&] { return AP::interior(surface.source(), grid).region; };

  Comparison comparison = group.comparison("joint map", {{"mesh", name_of_mesh(file)},
                                                         {"faces", surface.source().size()},
                                                         {"voxels", voxels},
                                                         {"scales", scales.size()}});
  comparison.add(
      "maps of all scales, whole box", {},
      [&] { keep_all_maps(surface, AP::Row_spans(grid), scales); }, Comparison::Place::CHILD);
  comparison.add(
      "maps of all scales, interior", {}, [&] { keep_all_maps(surface, interior(), scales); },
      Comparison::Place::CHILD);
  comparison.add(
      "joint map, whole box", {},
      [&] {
        const AP::Row_spans box(grid);
        compute_joint_map(surface, box, scales, grid_projector(box));
      },
      Comparison::Place::CHILD);
  comparison.add(
      "joint map, interior", {},
      [&] {
        const AP::Row_spans region = interior();
        compute_joint_map(surface, region, scales, grid_projector(region));
      },
      Comparison::Place::CHILD);
  comparison.run();
}

void memory(Group& group)
{
  for(const std::string& file : group.options().meshes)
    compare_storage(group, file);
}

const Registered_group registered(
    "memory",
    "What the joint map and the region save: peak of resident memory (beyond mesh and program) and "
    "time of "
    "eight scales with the default projector in one thread, each row in a process of its own, the "
    "search of "
    "the interior included. The baseline keeps the dense maps of all scales over the bounding box.",
    memory);

} // namespace

} // namespace Benchmarks
