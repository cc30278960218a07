// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_EVALUATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_EVALUATOR_H

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/Exact_tree.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the exact transform of a triangulated surface at arbitrary points, for one radius.
///
/// Each flat triangle, moved by `R`, contributes the area of its intersection with a disk, in closed
/// form. A tree of boxes skips triangles out of reach and adds whole subtrees that the ball holds.
/// The only errors are those of rounding, and the bits are the same on every processor. Queries are
/// `const` and may run concurrently.
///
/// \cgalModels `ProjectionEvaluator`
class Exact_evaluator
{
public:
  /// \tparam ScaleSpace a model of `TriangleScaleSpace`
  /// \param surface is read by the constructor only
  /// \param radius the distance of projection, positive, in the units of the surface
  /// \param side the side on which the surface is projected
  /// \throw std::invalid_argument if the radius is not positive or normals are interpolated.
  ///
  /// Complexity: `O(n log n)` for `n` triangles; 220 bytes for each.
  template <class ScaleSpace>
  Exact_evaluator(const ScaleSpace& surface, double radius, Side side)
  {
    internal::check_positive(radius, "radius");
    const auto kept = surface.triangles(radius);
    const Triangle_surface& triangles = *kept;
    internal::check_flat(triangles);
    m_tree =
        internal::Exact_tree_builder(triangles, internal::signed_distance(side, radius)).build();
  }

  /// \brief returns the area that is projected into the ball of radius `sigma` around `x`.
  ///
  /// Complexity: proportional to the number of triangles that meet the rim of the ball.
  template <class Point>
  double operator()(const Point& x, double sigma) const
  {
    return internal::area_within_ball(m_tree, internal::to_point(x), sigma);
  }

  /// the same for another kernel.
  template <class Point>
  double operator()(const Point& x, double sigma, const std::vector<Nested_ball>& kernel) const
  {
    return internal::sum_over_balls(*this, x, sigma, kernel);
  }

private:
  internal::Exact_tree m_tree;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_EVALUATOR_H
