// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_TRANSFORM_PLAN_H
#define MAPT_TRANSFORM_PLAN_H

#include "surface.h"
#include "transform_options.h"

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/forecast.h>

#include <memory>
#include <optional>

namespace mapt {

/// all that is settled before the computation begins.
struct Transform_plan
{
  double voxel;
  std::vector<AP::Scale> scales;
  std::vector<AP::Side> sides;
  std::string region_name;
  std::shared_ptr<const AP::Row_spans> region;
  std::optional<double> coverage; // of the interior
  std::size_t threads;
  AP::Forecast forecast;
};

/// chooses what the user left open, and makes sure that it fits into the memory before any of it is
/// taken.
/// \throw Usage_error if the options do not go with each other or with the input.
/// \throw Input_error if the grid is too large.
Transform_plan make_plan(const Input& input, const Surface& surface,
                         const Transform_options& options);

} // namespace mapt

#endif // MAPT_TRANSFORM_PLAN_H
