// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "transform_output.h"

#include "map_file.h"
#include "progress.h"

#include <algorithm>
#include <filesystem>

namespace mapt {

namespace {

using AP::IO::Grid_image;

// Adds an array that is `of_voxel(index)` in the region and 0 outside of it.
template <class OfVoxel>
void add_array(Grid_image& image, const std::string& name, const AP::Row_spans& region,
               OfVoxel of_voxel)
{
  image.add_array<float>(name, [&region, of_voxel](std::size_t row, float* values) {
    Signal_watch::check();
    const AP::Row_spans::Hull& hull = region.hull(row);
    std::fill(values, values + region.grid().size()[0], 0.f);
    for(std::int32_t i = hull.first; i < hull.last; ++i)
      values[i] = of_voxel(hull.offset + std::size_t(i - hull.first));
  });
}

void add_joint_map(Grid_image& image, const AP::Joint_map& map, const std::string& suffix)
{
  add_array(image, "JMAPT" + suffix, map.region(),
            [&map](std::size_t voxel) { return map.values()[voxel]; });
  add_array(image, "SMAPT" + suffix, map.region(), [&map](std::size_t voxel) {
    return float(map.radius_of_index(map.scale_indices()[voxel]));
  });
}

void add_maps_of_scales(Grid_image& image, const Side_maps& maps, const std::string& kind,
                        const std::string& suffix)
{
  for(std::size_t k = 0; k < maps.of_scales->maps().size(); ++k) {
    const std::vector<float>& map = maps.of_scales->maps()[k];
    const double factor = kind == "apt" ? 1 / maps.joint.scales()[k].normalization() : 1.;
    add_array(image, (kind == "apt" ? "APT_" : "MAPT_") + std::to_string(k) + suffix,
              maps.joint.region(),
              [&map, factor](std::size_t voxel) { return float(map[voxel] * factor); });
  }
}

void add_parameters(Grid_image& image, const Transform_plan& plan, const Transform_options& options)
{
  std::vector<double> radii, sigmas;
  for(const AP::Scale& scale : plan.scales) {
    radii.push_back(scale.radius);
    sigmas.push_back(scale.sigma);
  }
  image.add_metadata("radii", radii);
  image.add_metadata("sigma", sigmas);
  if(!options.scales.sigma)
    image.add_metadata("sigma_ratio", options.scales.sigma_ratio);
  image.add_metadata("side", options.side);
  image.add_metadata("normals", options.surface.normals);
  if(const auto ratio = options.surface.used_smoothing_ratio())
    image.add_metadata("smoothing_ratio", *ratio);
  if(options.is_compensated)
    image.add_metadata("divided_by_coverage", *plan.coverage);
  image.add_metadata("method", options.method);
  image.add_metadata("kernel", options.kernel);
  image.add_metadata("region", plan.region_name);
  image.add_metadata("sampling_ratio", options.sampling_ratio);
  image.add_metadata("source", std::filesystem::path(options.mesh).filename().string());
  image.add_metadata("version", MAPT_VERSION);
}

} // namespace

void write_maps(const std::vector<Side_maps>& maps, const Transform_plan& plan,
                const Transform_options& options)
{
  Grid_image image(plan.region->grid());
  for(std::size_t s = 0; s < maps.size(); ++s) {
    const std::string suffix = s == 0 ? "" : "_outside";
    if(options.kind == "jmapt")
      add_joint_map(image, maps[s].joint, suffix);
    else
      add_maps_of_scales(image, maps[s], options.kind, suffix);
  }
  add_parameters(image, plan, options);
  write_map(options.output, image, options.is_compressed);
}

} // namespace mapt
