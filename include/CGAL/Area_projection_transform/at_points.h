// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_AT_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_AT_POINTS_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief a place and a scale at which the transform is asked for.
struct Query
{
  Point_3 point; ///< where
  Scale scale;   ///< the radius and `σ`, in the units of the surface
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief asks an evaluator for each query: `result(q, evaluator)`, in parallel for the queries of the same radius.
///
/// The evaluators are made one after the other.
template <class ConcurrencyTag, class MakeEvaluator, class Result>
void evaluate_by_radius(const std::vector<Query>& queries, MakeEvaluator&& make_evaluator,
                        Result&& result)
{
  for(std::size_t q = 0; q < queries.size(); ++q) {
    check_positive(queries[q].scale.radius, "radius of query " + std::to_string(q));
    check_positive(queries[q].scale.sigma, "sigma of query " + std::to_string(q));
  }
  std::vector<std::size_t> order(queries.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Scale &s = queries[a].scale, &t = queries[b].scale;
    return s.radius != t.radius ? s.radius < t.radius : s.sigma < t.sigma;
  });
  for(auto begin = order.begin(); begin != order.end();) {
    const Scale scale = queries[*begin].scale;
    const auto end = std::find_if(
        begin, order.end(), [&](std::size_t q) { return queries[q].scale.radius != scale.radius; });
    const auto evaluator = make_evaluator(scale);
    for_each_index<ConcurrencyTag>(std::size_t(end - begin), [&](std::size_t i) {
      result(begin[std::ptrdiff_t(i)], evaluator);
    });
    begin = end;
  }
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief evaluates the transform at many places and scales.
///
/// Queries of the same radius share one evaluator; the evaluators are made one after the other, and
/// the queries of each run in parallel. The result does not depend on the number of threads.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \tparam MakeEvaluator a function that takes a `Scale`, that of the smallest `σ` of its radius,
/// and returns a model of `ProjectionEvaluator`
///
/// \param queries the places and scales, in any order
/// \param make_evaluator makes the evaluator of a radius
/// \param kernel the balls of a model of `ProjectionKernel_3`
/// \return for each query, the area that is projected into its ball
/// \throw std::invalid_argument if a radius or a `σ` is not positive
template <class ConcurrencyTag = CGAL::Sequential_tag, class MakeEvaluator>
std::vector<double>
evaluate_at_points(const std::vector<Query>& queries, MakeEvaluator&& make_evaluator,
                   const std::vector<Nested_ball>& kernel = Ball_kernel_3().nested_balls())
{
  std::vector<double> areas(queries.size(), 0.);
  internal::evaluate_by_radius<ConcurrencyTag>(
      queries, make_evaluator, [&](std::size_t q, const auto& evaluator) {
        areas[q] = evaluator(queries[q].point, queries[q].scale.sigma, kernel);
      });
  return areas;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_AT_POINTS_H
