// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_SAMPLED_EVALUATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_SAMPLED_EVALUATOR_H

#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/Weighted_point_tree.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the transform of sampled surfels at arbitrary points, for one radius and any `σ`.
///
/// Finds the same surfels as `Kd_tree_evaluator`, in a fraction of its time: a tree knows the area of each
/// subtree, so that only surfels near the rim of the ball are looked at. Works for point sets, and for any
/// other weighted points.
///
/// The rim belongs to the ball: a surfel counts if its squared distance, as computed in double, is at most
/// `σ²`. No exception is made to that, while the search of \cgal may take in a surfel that is farther by a
/// rounding.
///
/// Areas are rounded to a multiple of about `2^-61` of their total, and then summed without error: the result
/// has the same bits for any order of the surfels, any number of threads and any instruction set.
/// Queries are `const` and may run concurrently.
///
/// \cgalModels `ProjectionEvaluator`
class Sampled_evaluator
{
public:
  /// \tparam ScaleSpace a model of `SurfelScaleSpace`
  /// \tparam ConcurrencyTag says how the tree is built: `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  /// `CGAL::Parallel_if_available_tag`
  /// \param surface is read by the constructor only
  /// \param radius the distance of projection, positive, in the units of the surface
  /// \param side the side on which the surface is projected
  /// \param spacing the spacing of the surfels; see `default_sampling_ratio`
  /// \param tag an instance of `ConcurrencyTag`
  /// \throw std::invalid_argument if `radius` or `spacing` is not positive.
  ///
  /// Complexity: `O(n log n)` for `n` surfels.
  template <class ScaleSpace, class ConcurrencyTag = Sequential_tag>
  Sampled_evaluator(const ScaleSpace& surface, double radius, Side side, double spacing,
                    ConcurrencyTag tag = {})
      : Sampled_evaluator(projected(surface, radius, side, spacing), tag)
  {}

  /// \brief sums the areas of these, whatever they stand for.
  /// \throw std::invalid_argument if a coordinate is not finite or an area not finite or negative.
  template <class ConcurrencyTag = Sequential_tag>
  explicit Sampled_evaluator(Projected_surfels points, ConcurrencyTag tag = {})
      : m_number(checked_number(points))
      , m_quantum(points.areas)
      , m_tree(release(std::move(points), m_quantum), tag)
  {}

  /// \brief returns the area that is projected into the ball of radius `sigma` around `x`.
  ///
  /// Complexity: in general, proportional to the length of the line in which the rim of the ball cuts the
  /// parallel surface, measured in units of the spacing.
  template <class Point>
  double operator()(const Point& x, double sigma) const
  {
    return m_quantum.weight(m_tree.sum(internal::ball_around(x, sigma)));
  }

  /// the same for another kernel.
  template <class Point>
  double operator()(const Point& x, double sigma, const std::vector<Nested_ball>& kernel) const
  {
    return internal::sum_over_balls(*this, x, sigma, kernel);
  }

  /// how many samples of the surface are searched.
  std::size_t number_of_surfels() const { return m_number; }

private:
  template <class ScaleSpace>
  static Projected_surfels projected(const ScaleSpace& surface, double radius, Side side,
                                     double spacing)
  {
    internal::check_positive(radius, "radius");
    internal::check_positive(spacing, "spacing");
    Projected_surfels all;
    surface.project(radius, side, spacing, [&all](const Projected_surfels& batch) {
      all.positions.insert(all.positions.end(), batch.positions.begin(), batch.positions.end());
      all.areas.insert(all.areas.end(), batch.areas.begin(), batch.areas.end());
    });
    return all;
  }

  static std::size_t checked_number(const Projected_surfels& points)
  {
    CGAL_precondition(points.positions.size() == points.areas.size());
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Point_3& p = points.positions[i];
      if(!(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())))
        throw std::invalid_argument("positions[" + std::to_string(i) + "] is not finite");
      if(!(std::isfinite(points.areas[i]) && points.areas[i] >= 0))
        throw std::invalid_argument("areas[" + std::to_string(i) + "] is " +
                                    internal::to_text(points.areas[i]) +
                                    ": must be finite and not negative");
    }
    return points.size();
  }

  /// frees the memory of the points before the tree asks for its own.
  static std::vector<internal::Weighted_point> release(Projected_surfels&& points,
                                                       const internal::Weight_quantum& quantum)
  {
    const Projected_surfels last_use = std::move(points);
    return internal::weighted_points(last_use, quantum);
  }

  std::size_t m_number;
  internal::Weight_quantum m_quantum;
  internal::Weighted_point_tree m_tree;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_SAMPLED_EVALUATOR_H
