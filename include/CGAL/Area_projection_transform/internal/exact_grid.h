// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_GRID_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_GRID_H

#include <CGAL/Area_projection_transform/internal/Exact_accumulator.h>
#include <CGAL/Area_projection_transform/internal/Fixed_point.h>
#include <CGAL/Area_projection_transform/internal/Flat_triangle.h>

#include <cmath>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a triangle in the coordinates of a lattice, and what it counts.
struct Voting_triangle
{
  Flat_triangle shape;
  double quanta; ///< of all of it
  double dither; ///< see `Fixed_point::rounded()`

  /// triangle `t` of a surface, moved by `distance` along its normal of projection.
  Voting_triangle(const Triangle_surface& surface, std::size_t t, double distance,
                  const Grid_3& lattice, const Fixed_point& fixed)
      : shape(projected_triangle(surface, t, distance, lattice))
      , quanta(fixed.quanta(surface.areas[t]))
      , dither(Fixed_point::uniform(shape.centroid()))
  {}
};

/// the balls around the voxels: their radius, in voxels, and what quanta in them are multiplied by.
struct Weighted_ball
{
  double radius, weight;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#define CGAL_AREA_PROJECTION_KERNEL <CGAL/Area_projection_transform/internal/exact_grid_impl.h>
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief adds the parts of triangles within the balls around the voxels.
///
/// The same bits for every instruction set. Of a triangle of the longest edge `a` and the least height
/// `h`, a part errs by less than `1e-6 min(a, σ) σ`, and by less than 1e-4 of the triangle.
inline void add_to_grid(const Voting_triangle* begin, const Voting_triangle* end,
                        const Weighted_ball& ball, const Exact_target& target)
{
  CGAL_AREA_PROJECTION_DISPATCHED(add_triangles, begin, end, ball, target);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_GRID_H
