// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How the times grow with faces, voxels, radii and threads, on one shape.

#include "benchmark_projectors.h"

#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>

namespace Benchmarks {

namespace {

Surface surface_of(const Soup& soup)
{
  return Surface(AP::surface_from_triangle_soup(soup.points, soup.triangles));
}

/// the additions of the paper's algorithm: a ball of voxels at each voxel.
double additions_of_paper(const Job& job)
{
  double additions = 0;
  for(const AP::Scale& scale : job.scales)
    additions +=
        double(job.region.storage_size()) * size_of_ball(scale.sigma / job.region.grid().spacing());
  return additions;
}

/// how often the exact projector cuts a triangle with a ball, about: each triangle reaches a ball of
/// voxels, but at least one, and more if it is larger than a voxel.
double cuts_of_exact(const Job& job)
{
  const AP::Triangle_surface& source = job.surface.source();
  const double area = source.total_area() / std::pow(job.region.grid().spacing(), 2);
  double cuts = 0;
  for(const AP::Scale& scale : job.scales) {
    const double ball = size_of_ball(scale.sigma / job.region.grid().spacing());
    cuts += double(source.size()) * std::max(1., ball) + area * std::sqrt(ball);
  }
  return cuts;
}

/// The slow ones are left out where they take longer than some 15 seconds (full) or one (quick): additions
/// are counted, and a cut is about a thousand. Without the paper's, the default is its own baseline.
void add_projectors(Group& group, Comparison& comparison, const Job& job)
{
  const double most = group.pick(1e7, 3e9, 1e11);
  if(additions_of_paper(job) <= most)
    comparison.add("Paper_grid_projector", joint_map_of(job, paper_projector(job.region)));
  comparison.add("Grid_projector", joint_map_of(job, grid_projector(job.region)));
  if(1000 * cuts_of_exact(job) <= most)
    comparison.add("Exact_grid_projector", joint_map_of(job, exact_projector(job.region)));
}

void grow_faces(Group& group)
{
  const int voxels = group.pick(32, 128, 128);
  const std::size_t most =
      group.pick(std::size_t(1000), std::size_t(100000), std::size_t(10000000));
  for(std::size_t faces = 1000; faces <= most; faces *= 10) {
    const Soup soup = rippled_torus(faces);
    const Surface surface = surface_of(soup);
    const Job job(surface, voxels);
    Comparison comparison =
        group.comparison("faces", {{"faces", soup.triangles.size()}, {"voxels", voxels}});
    add_projectors(group, comparison, job);
    comparison.add("set-up: surface_from_triangle_soup",
                   [&] { keep(surface_of(soup).source().size()); });
    comparison.add("set-up: interior", [&] {
      keep(AP::interior(surface.source(), job.region.grid()).region.storage_size());
    });
    comparison.run();
  }
}

void grow_voxels(Group& group, const Surface& surface)
{
  for(int voxels = 32; voxels <= group.pick(32, 128, 1024); voxels *= 2) {
    const Job job(surface, voxels);
    Comparison comparison =
        group.comparison("voxels", {{"faces", surface.source().size()}, {"voxels", voxels}});
    add_projectors(group, comparison, job);
    comparison.run();
  }
}

void grow_radii(Group& group, const Surface& surface)
{
  const int voxels = group.pick(32, 128, 128);
  Job job(surface, voxels);
  for(int radius = 1; radius <= group.pick(4, 64, 64); radius *= 2) {
    job.scales = AP::proportional_scales({radius * job.region.grid().spacing()});
    Comparison comparison = group.comparison("radii", {{"faces", surface.source().size()},
                                                       {"voxels", voxels},
                                                       {"radius", radius},
                                                       {"sigma", 0.5 * radius}});
    add_projectors(group, comparison, job);
    comparison.run();
  }
}

#ifdef CGAL_LINKED_WITH_TBB
/// 1, 2, 4, … and all.
std::vector<int> numbers_of_threads()
{
  const int all = tbb::this_task_arena::max_concurrency();
  std::vector<int> numbers;
  for(int threads = 1; threads < all; threads *= 2)
    numbers.push_back(threads);
  numbers.push_back(all);
  return numbers;
}

void grow_threads(Group& group, const Surface& surface)
{
  const int voxels = group.pick(32, 128, 256);
  Job job(surface, voxels);
  job.scales = descriptor_scales(job.region.grid(), 16);
  Comparison comparison = group.comparison(
      "threads",
      {{"faces", surface.source().size()}, {"voxels", voxels}, {"scales", job.scales.size()}},
      Comparison::Clock::WALL);
  for(int threads : numbers_of_threads())
    comparison.add("Grid_projector", {{"threads", threads}}, [&job, threads] {
      tbb::task_arena(threads).execute([&job] {
        compute_joint_map<CGAL::Parallel_tag>(job.surface, job.region, job.scales,
                                              grid_projector(job.region));
      });
    });
  comparison.run();
}
#endif

void growth(Group& group)
{
  grow_faces(group);
  const Surface surface = surface_of(rippled_torus(group.pick(1000, 100000, 100000)));
  grow_voxels(group, surface);
  grow_radii(group, surface);
#ifdef CGAL_LINKED_WITH_TBB
  grow_threads(group, surface);
#endif
}

const Registered_group registered("growth",
                                  "How the times grow, on a torus with ripples: with the number of "
                                  "its faces, with the voxels along its "
                                  "longest side (eight scales, R = 2, …, 9 voxels, as above), with "
                                  "the radius (in voxels; one scale), and "
                                  "with the number of threads (sixteen scales; the ratios are of "
                                  "wall times). The baseline is the paper's "
                                  "algorithm; where that or the exact one would take too long, "
                                  "they are left out, and the default is its "
                                  "own baseline.",
                                  growth);

} // namespace

} // namespace Benchmarks
