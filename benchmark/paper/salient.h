// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SALIENT_H
#define AREA_PROJECTION_PAPER_SALIENT_H

#include "damage.h"
#include "experiment.h"

#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <optional>
#include <string>
#include <vector>

namespace Paper {

namespace AP = CGAL::Area_projection;
using AP::Salient_point;

/// how the paper's salient points are found, where it can be read in more than one way.
struct Salient_mode
{
  std::string name;
  bool use_joint_map = false;
  std::optional<double> reference_length; ///< default: that of the library
  double smoothing = 1;                   ///< in voxels
};

/// maxima in four dimensions, and of the joint map.
const std::vector<Salient_mode>& salient_modes();

struct Salient_run
{
  std::vector<Salient_point> points; ///< the strongest first
  double reference_length;           ///< the size of a voxel, too
  double seconds;                    ///< on the wall
};

Salient_run find_salient_points(const Soup& soup, const Salient_mode& mode);

/// position, scale, intensity and inertia.
Measures describe(const Salient_point& point);

/// \name The reference length of the paper, in its two readings
/// @{
double short_reference_length(const Soup& soup); ///< √A / 80π, that of the library
double long_reference_length(const Soup& soup);  ///< √(A / 80π)
/// @}

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SALIENT_H
