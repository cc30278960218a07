// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "transform.h"

#include "normals_modes.h"
#include "picture.h"

#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/sinks.h>

#include <algorithm>
#include <memory>

namespace Paper {

namespace {

using Concurrency = CGAL::Parallel_if_available_tag;

AP::Triangle_surface surface_of(const Soup& soup)
{
  return AP::surface_from_triangle_soup(soup.points, soup.triangles);
}

void write_picture(const std::string& file, const AP::Joint_map& map, const Soup& silhouette)
{
  const AP::Triangle_surface surface = surface_of(silhouette);
  mapt::write_picture(file, map, &surface);
}

} // namespace

Maps compute_maps(const std::string& mode, const Soup& soup,
                  std::shared_ptr<const AP::Row_spans> region, const std::vector<AP::Scale>& scales)
{
  AP::Joint_map joint(region, scales);
  AP::Scale_maps_sink each(*region, scales.size());
  AP::Sink_pair sinks(joint, each);
  with_scale_space(mode, soup, [&](const auto& space) {
    AP::project_scales<Concurrency>(
        space, *region, scales, AP::Side::INSIDE,
        [](const AP::Row_spans& part) { return AP::Grid_projector(part); }, sinks);
  });
  return {std::move(joint), each.maps()};
}

double value_at(const std::string& mode, const Soup& soup, const Point_3& point,
                const AP::Scale& scale)
{
  return with_scale_space(mode, soup, [&](const auto& space) {
    const double spacing = AP::default_sampling_ratio * scale.sigma;
    const AP::Sampled_evaluator evaluator(space, scale.radius, AP::Side::INSIDE, spacing);
    return scale.normalization() * evaluator(point, scale.sigma);
  });
}

AP::Grid_3 grid_of(const Soup& soup, int voxels)
{
  const CGAL::Bbox_3 b = surface_of(soup).bbox();
  return AP::grid_around(b, std::max({b.x_span(), b.y_span(), b.z_span()}) / voxels);
}

Inside inside(const Soup& soup, const AP::Grid_3& grid)
{
  AP::Interior interior = AP::interior<Concurrency>(surface_of(soup), grid);
  return {std::make_shared<const AP::Row_spans>(std::move(interior.region)), interior.coverage};
}

void write_picture_of_scale(const std::string& file, const Maps& maps, std::size_t scale,
                            const Soup& silhouette)
{
  const AP::Scale& s = maps.joint.scales()[scale];
  const std::shared_ptr<const AP::Row_spans> region(std::shared_ptr<void>(), &maps.joint.region());
  AP::Joint_map map(region, {s});
  map.consume(0, s, 0, maps.scales[scale].data(), maps.scales[scale].size());
  write_picture(file, map, silhouette);
}

void write_picture_of_joint_map(const std::string& file, const Maps& maps, const Soup& silhouette)
{
  write_picture(file, maps.joint, silhouette);
}

} // namespace Paper
