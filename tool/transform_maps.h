// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_TRANSFORM_MAPS_H
#define MAPT_TRANSFORM_MAPS_H

#include "transform_plan.h"

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/sinks.h>

#include <optional>

namespace mapt {

/// the maps of one side of the surface.
struct Side_maps
{
  AP::Side side;
  AP::Joint_map joint;
  std::optional<AP::Scale_maps_sink> of_scales; // if asked for
  std::vector<double> areas_outside;            // of the grid, for each scale
  float factor = 1;                             // of all values

  void consume(std::size_t index, const AP::Scale& scale, std::size_t first_voxel,
               const float* values, std::size_t number)
  {
    std::vector<float> multiplied; // calls may be concurrent
    if(factor != 1) {
      multiplied.assign(values, values + number);
      for(float& value : multiplied)
        value *= factor;
      values = multiplied.data();
    }
    joint.consume(index, scale, first_voxel, values, number);
    if(of_scales)
      of_scales->consume(index, scale, first_voxel, values, number);
  }
};

/// computes the maps of the sides of the plan.
/// \throw Interruption if a signal came.
std::vector<Side_maps> compute_maps(const std::shared_ptr<const Surface>& surface,
                                    const Transform_plan& plan, const Transform_options& options,
                                    const Console& console);

} // namespace mapt

#endif // MAPT_TRANSFORM_MAPS_H
