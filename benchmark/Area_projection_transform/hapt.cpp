// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The job of the paper's shape descriptor: eight scales inside of a mesh.

#include "baselines/direct_projectors.h"
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

template <class Convolution>
void add_direct_row(Comparison& comparison, const std::string& name, const Job& job,
                    const Maps& exact)
{
  const auto projector = [&job] {
    return baselines::Direct_paper_projector<Convolution>(job.region);
  };
  Row& row = comparison.add(name, joint_map_of(job, projector));
  add_errors(row, maps(job, projector), exact);
}

/// the additions of the paper's algorithm: a ball of voxels at each voxel of the grid.
double additions_of_paper(const Job& job)
{
  const AP::Grid_3& grid = job.region.grid();
  double additions = 0;
  for(const AP::Scale& scale : job.scales)
    additions += size_of_ball(scale.sigma / grid.spacing()) * double(grid.number_of_voxels());
  return additions;
}

/// The direct ones are left out where they take longer than about a minute (full) or two seconds (quick).
void add_paper_rows(Group& group, Comparison& comparison, const Job& job, const Maps& exact)
{
  const double most = group.pick(3e8, 5e9, 1.5e11);
  if(slowness_of_literal * additions_of_paper(job) <= most)
    add_direct_row<baselines::Literal_convolution>(comparison, "literal paper algorithm", job,
                                                   exact);
  if(additions_of_paper(job) <= most)
    add_direct_row<baselines::Tuned_convolution>(comparison, "tuned paper algorithm", job, exact);
  const auto folded = paper_projector(job.region);
  Row& row = comparison.add("Paper_grid_projector", joint_map_of(job, folded));
  add_errors(row, maps(job, folded), exact);
}

void add_grid_rows(Comparison& comparison, const Job& job, const Maps& exact)
{
  for(double ratio : {1., 0.6, AP::Grid_projector::default_sampling_ratio}) {
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
      comparison.add("Grid_projector",
                     {{"sampling", AP::Grid_projector::default_sampling_ratio},
                      {"instructions", AP::internal::name(set)}},
                     with(set, joint_map_of(job, grid_projector(job.region))));
}

/// what all methods have to do before they vote, sampled as the paper does.
void project_surface(const Job& job)
{
  std::size_t number = 0;
  for(const AP::Scale& scale : job.scales)
    job.surface.project(scale.radius, AP::Side::INSIDE, job.region.grid().spacing(),
                        [&](const AP::Projected_surfels& batch) { number += batch.size(); });
  keep(number);
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
  add_paper_rows(group, comparison, job, exact);
  comparison.add("Paper_grid_projector, whole box",
                 [&] { compute_joint_map(surface, box, job.scales, paper_projector(box)); });
  add_grid_rows(comparison, job, exact);
  comparison.add("Exact_grid_projector", joint_map_of(job, exact_projector(job.region)));
  add_rows_of_instruction_sets(comparison, job);
  comparison.add("projection alone", [&] { project_surface(job); });
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

const Registered_group registered(
    "hapt",
    "The job of the paper's shape descriptor: eight scales, R = 2, 3, …, 9 voxels and σ = "
    "R/2, inside of a mesh, into a joint map. The baseline is the paper's algorithm as "
    "one reads it, on the whole grid, unless that would take too long; tuned, it is the "
    "same without tests. Paper_grid_projector has the same result, found faster, and in "
    "the interior only, as the others have. The errors are those of the maps, as a root "
    "mean square relative to that of the exact map: the mean over the scales and the "
    "largest. Rows without an instruction set use the best. Set-up, which is needed once "
    "for all scales, is not in the times of the projectors.",
    hapt);

} // namespace

} // namespace Benchmarks
