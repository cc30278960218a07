// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What it costs to see the surface at each radius.

#include "benchmark_projectors.h"

#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Mean_curvature_flow.h>
#include <CGAL/Area_projection_transform/scale_space/Smoothing_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/Polygon_mesh_processing/smooth_shape.h>

#include <cmath>
#include <utility>

namespace Benchmarks {

namespace {

/// the surfaces at all radii, without what projects them.
template <class Smoother>
Comparison::Work surfaces_of(const Job& job, const Smoother& smoother)
{
  return [&] {
    for(const AP::Scale& scale : job.scales)
      keep(smoother(scale.radius).total_area());
  };
}

/// all that it takes for a map: the surfaces, what projects them, and their projection.
template <class Smoother>
Comparison::Work map_of(const Job& job, const Smoother& smoother)
{
  return [&] {
    compute_joint_map(AP::Smoothing_scale_space(smoother, 1), job.region, job.scales,
                      grid_projector(job.region));
  };
}

/// what one would use otherwise: one implicit step for each radius, by a factorization.
void smooth_by_cgal(const Mesh& mesh, const Job& job)
{
  for(const AP::Scale& scale : job.scales) {
    Mesh copy = mesh;
    const double deviation = AP::Mean_curvature_flow::default_smoothing_ratio * scale.radius;
    CGAL::Polygon_mesh_processing::smooth_shape(copy, 0.5 * deviation * deviation);
    keep(copy.number_of_vertices());
  }
}

void compare_smoothers(Group& group, const Mesh& mesh, const std::string& name, int voxels)
{
  const AP::Triangle_surface source = AP::surface_from_mesh(mesh);
  const Surface surface(source);
  const Job job(surface, voxels);
  const AP::Averaged_normals averaged(source);
  const AP::Mean_curvature_flow flow(source);
  Comparison comparison = group.comparison("eight radii", {{"mesh", name},
                                                           {"vertices", mesh.number_of_vertices()},
                                                           {"faces", mesh.number_of_faces()},
                                                           {"voxels", voxels}});
  comparison.add("map, normals of faces", joint_map_of(job, grid_projector(job.region)));
  comparison.add("map, averaged normals", map_of(job, averaged));
  comparison.add("map, mean curvature flow", map_of(job, flow));
  comparison.add("Averaged_normals", surfaces_of(job, averaged));
  comparison.add("Mean_curvature_flow", surfaces_of(job, flow));
  if(mesh.number_of_vertices() <= group.pick<std::size_t>(1000, 20000, 200000))
    comparison.add("CGAL smooth_shape", [&] { smooth_by_cgal(mesh, job); });
  comparison.add("set-up: Constant_scale_space", [&] { keep(Surface(source).area(0)); });
  comparison.add("set-up: Averaged_normals",
                 [&] { keep(AP::Averaged_normals(source).source().size()); });
  comparison.add("set-up: Mean_curvature_flow",
                 [&] { keep(AP::Mean_curvature_flow(source).source().size()); });
  comparison.run();
}

void smoothing(Group& group)
{
  for(const std::string& file : group.options().meshes) {
    Mesh mesh = read_mesh(file);
    compare_smoothers(group, mesh, name_of_mesh(file), group.pick(16, 50, 50));
    if(group.options().effort == Effort::SMOKE)
      continue;
    refine(mesh, group.pick(0, 30000, 400000));
    compare_smoothers(group, mesh, name_of_mesh(file), group.pick(16, 50, 50));
  }
}

const Registered_group registered(
    "smoothing",
    "Normals that suit the radius, at eight radii R = 2, 3, …, 9 voxels. The maps are those of the "
    "interior, and the baseline is the map with the normals of the faces; with smoothed surfaces "
    "their time contains all but the set-up, which is needed once. Averaged_normals and "
    "Mean_curvature_flow are the smoothing alone. CGAL smooth_shape makes one implicit step of the "
    "time of the flow for each radius, on a copy of the mesh.",
    smoothing);

} // namespace

} // namespace Benchmarks
