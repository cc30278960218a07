// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The job of the paper's shape descriptor: eight scales inside of a mesh.

#include "benchmark_projectors.h"

#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/sinks.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>

namespace Benchmarks {

namespace {

using Maps = std::vector<std::vector<float>>;

template <class MakeProjector>
Maps maps(const Job& job, MakeProjector make_projector)
{
  AP::Scale_maps_sink sink(job.region, job.scales.size());
  AP::project_scales(job.surface, job.region, job.scales, AP::Side::INSIDE, make_projector, sink);
  return sink.maps();
}

double relative_error(const std::vector<float>& map, const std::vector<float>& exact)
{
  double difference = 0, norm = 0;
  for(std::size_t v = 0; v < map.size(); ++v) {
    difference += std::pow(double(map[v]) - exact[v], 2);
    norm += std::pow(double(exact[v]), 2);
  }
  return std::sqrt(difference / norm);
}

/// the root mean square of the error of each scale, relative to that of the map: mean and largest.
void add_errors(Row& row, const Maps& maps, const Maps& exact)
{
  double sum = 0, largest = 0;
  for(std::size_t k = 0; k < maps.size(); ++k) {
    const double error = relative_error(maps[k], exact[k]);
    sum += error;
    largest = std::max(largest, error);
  }
  row.measures.emplace_back("error", sum / double(maps.size()));
  row.measures.emplace_back("largest error", largest);
}

void add_grid_rows(Comparison& comparison, const Job& job, const Maps& exact)
{
  for(double ratio : {1., 0.6, 0.3, AP::default_sampling_ratio, 0.1}) {
    const auto projector = grid_projector(job.region, ratio);
    Row& row =
        comparison.add("Grid_projector", {{"sampling", ratio}}, joint_map_of(job, projector));
    add_errors(row, maps(job, projector), exact);
  }
}

/// the rows above use the best of the instruction sets, these the others.
void add_rows_of_instruction_sets(Comparison& comparison, const Job& job)
{
  for(auto set : AP::internal::available_instruction_sets())
    if(set != AP::internal::instruction_set())
      comparison.add(
          "Grid_projector",
          {{"sampling", AP::default_sampling_ratio}, {"instructions", AP::internal::name(set)}},
          with(set, joint_map_of(job, grid_projector(job.region))));
}

void compare_projectors(Group& group, const Mesh& mesh, const std::string& name, int voxels)
{
  const Surface surface(AP::surface_from_mesh(mesh));
  const Job job(surface, voxels);
  const AP::Row_spans box(job.region.grid());
  const Maps exact = maps(job, exact_projector(job.region));

  Comparison comparison = group.comparison("projectors", {{"mesh", name},
                                                          {"vertices", mesh.number_of_vertices()},
                                                          {"faces", mesh.number_of_faces()},
                                                          {"voxels", voxels},
                                                          {"scales", job.scales.size()}});
  Row& paper =
      comparison.add("Paper_grid_projector", joint_map_of(job, paper_projector(job.region)));
  add_errors(paper, maps(job, paper_projector(job.region)), exact);
  comparison.add("Paper_grid_projector, whole box",
                 [&] { compute_joint_map(surface, box, job.scales, paper_projector(box)); });
  add_grid_rows(comparison, job, exact);
  comparison.add("Exact_grid_projector", joint_map_of(job, exact_projector(job.region)));
  add_rows_of_instruction_sets(comparison, job);
  comparison.add("set-up: surface_from_mesh",
                 [&] { keep(Surface(AP::surface_from_mesh(mesh)).source().size()); });
  comparison.add("set-up: interior", [&] {
    keep(AP::interior(surface.source(), job.region.grid()).region.storage_size());
  });
  comparison.run();
}

void hapt(Group& group)
{
  for(const std::string& file : group.options().meshes) {
    Mesh mesh = read_mesh(file);
    compare_projectors(group, mesh, name_of_mesh(file), group.pick(16, 50, 50));
    if(group.options().effort == Effort::SMOKE)
      continue;
    // About as many vertices as the surface has voxels, as in scanned meshes.
    refine(mesh, group.pick(0, 30000, 170000));
    compare_projectors(group, mesh, name_of_mesh(file), group.pick(16, 100, 256));
  }
}

const Registered_group
    registered("hapt",
               "The job of the paper's shape descriptor: eight scales, R = 2, 3, …, 9 voxels and σ "
               "= R/2, inside of a "
               "mesh, into a joint map. The baseline is the paper's algorithm, restricted to the "
               "interior as the others "
               "are; the errors are those of the maps, as a root mean square relative to that of "
               "the exact map: the "
               "mean over the scales and the largest. Rows without an instruction set use the "
               "best. Set-up, which is "
               "needed once for all scales, is not in the times of the projectors.",
               hapt);

} // namespace

} // namespace Benchmarks
