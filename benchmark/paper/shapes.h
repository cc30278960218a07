// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SHAPES_H
#define AREA_PROJECTION_PAPER_SHAPES_H

#include "damage.h"

#include <array>
#include <cstddef>
#include <vector>

namespace Paper {

/// a sphere of radius 1: an icosahedron of which each face is divided into four, `levels` times.
Soup icosphere(int levels);

/// a cylinder about the `z` axis with flat ends, its middle in the origin: all points lie on the round side,
/// in `rows + 1` circles, but for those in the middles of the ends.
Soup cylinder(double radius, double length, int sides, int rows);

/// both, side by side.
Soup joined(Soup a, const Soup& b);

/// directions that are spread evenly over the sphere, along a spiral: the nearest of `number` are about
/// 3.1/√number apart.
std::vector<Vector_3> even_directions(std::size_t number);

/// bumps on a sphere, as wide as half of what is between their centres, in the mean.
struct Bumps
{
  std::size_t number;
  /// the height of a bump in units of its width, both radii: 1 for half a ball, 0 for none.
  double amplitude;

  /// the radius of a bump, in units of that of the sphere.
  double width() const;
};

struct Bumpy_sphere
{
  Soup soup;
  double radius; ///< of the sphere on which the bumps stand
};

/// \brief a sphere with half an ellipsoid on each of `even_directions()`.
///
/// It has the volume of a ball of radius 1: that is the sphere that it approximates.
Bumpy_sphere bumpy_sphere(const Bumps& bumps, int levels);

/// \brief a box with a corner in the origin, whose sides are given in units of the spacing of its points.
///
/// It has many faces, so that normals which are interpolated differ from those of the faces near edges only.
Soup box(const std::array<int, 3>& sides, double spacing);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SHAPES_H
