// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_CENTERLINE_SHAPES_H
#define AREA_PROJECTION_PAPER_CENTERLINE_SHAPES_H

#include "damage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace Paper {

/// an axis that is known: a fine polyline with the radius at each point, linear in between.
struct True_line
{
  std::vector<Point_3> points;
  std::vector<double> radii;
  bool is_closed = false; ///< the last point is followed by the first
  /// how far it is from each end, straight on, to the surface: the radius for a round cap.
  std::array<double, 2> beyond = {{0, 0}};
};

/// a surface of tubes, and their axes.
struct Centerline_shape
{
  std::string name;
  Soup soup;
  std::vector<True_line> lines; ///< those that meet have a point in common
  std::size_t leaves = 0;       ///< free ends
  std::size_t components = 1;
  std::size_t cycles = 0;
  bool is_closed = true; ///< the surface
  bool is_hard = false;  ///< of the second list of the shapes
};

/// \name Shapes
/// of tubes, of radius 1 where nothing else is said, with round caps.
/// @{

/// straight, with flat caps, open, bent, helix, torus, knot, tapering, Y, two that touch along a line, two that are merged along
/// a strip, a body and an arm that is fused with it.
std::vector<Centerline_shape> centerline_shapes();

/// strong cones, tubes that cross each other, networks with loops, tubes of 10 sides, elliptic sections 1 : 2, radii that change
/// in steps.
std::vector<Centerline_shape> hard_centerline_shapes();
/// @}

/// \brief displaces each vertex by a vector of uniform probability in a ball, whose radius is `ratio` times the mean
/// length of the edges there.
Soup add_local_noise(const Soup& soup, double ratio, std::uint64_t seed);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_CENTERLINE_SHAPES_H
