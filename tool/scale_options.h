// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SCALE_OPTIONS_H
#define MAPT_SCALE_OPTIONS_H

#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/Bbox_3.h>
#include <CLI/CLI.hpp>

#include <optional>
#include <vector>

namespace mapt {

/// the radii and the sizes of the collecting balls, as the user asks for them.
struct Scale_options
{
  std::vector<double> radii;
  std::optional<double> smallest, largest, step;
  std::optional<std::size_t> number;
  double sigma_ratio = 0.5;
  std::optional<double> sigma; // the same for all radii
};

void add_scale_options(CLI::App& app, Scale_options& options);

/// returns the scales in ascending order of their radii; what the user left open depends on the box
/// of the surface and on the voxel.
/// \throw Usage_error if the options contradict each other or a radius is smaller than the voxel.
std::vector<CGAL::Area_projection::Scale> choose_scales(const Scale_options& options,
                                                        const CGAL::Bbox_3& box, double voxel);

} // namespace mapt

#endif // MAPT_SCALE_OPTIONS_H
