// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_AXIS_DISTANCES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_AXIS_DISTANCES_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Surface_distance.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief what is told of many numbers: all are NaN if there are none.
struct Spread_of_values
{
  /// what stands for a number that is not known.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  double mean = unknown;        ///< in the units of the numbers, as the others
  double median = unknown;      ///< half of the numbers are smaller
  double quantile_95 = unknown; ///< 95 % of the numbers are smaller
  double largest = unknown;     ///< of all
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief summarises numbers; those that are NaN are left out.
inline Spread_of_values spread_of(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
               values.end());
  if(values.empty())
    return {};
  std::sort(values.begin(), values.end());
  const auto quantile = [&values](double part) {
    return values[std::size_t(std::ceil(part * double(values.size() - 1)))];
  };
  const double sum = std::accumulate(values.begin(), values.end(), 0.);
  return {sum / double(values.size()), quantile(0.5), quantile(0.95), values.back()};
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief summarises numbers that count by their weights, which are not negative; those that are NaN are left out.
inline Spread_of_values spread_of(const std::vector<double>& values,
                                  const std::vector<double>& weights)
{
  std::vector<std::size_t> order;
  double total = 0, sum = 0;
  for(std::size_t i = 0; i < values.size(); ++i)
    if(!std::isnan(values[i]) && weights[i] > 0) {
      order.push_back(i);
      total += weights[i];
      sum += weights[i] * values[i];
    }
  if(order.empty())
    return {};
  std::sort(order.begin(), order.end(),
            [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  Spread_of_values result{sum / total, values[order.back()], values[order.back()],
                          values[order.back()]};
  double below = 0;
  for(const std::size_t i : order) {
    const double up_to = below + weights[i];
    for(const auto& [part, quantile] :
        {std::pair(0.5, &result.median), {0.95, &result.quantile_95}})
      if(below < part * total && part * total <= up_to)
        *quantile = values[i];
    below = up_to;
  }
  return result;
}

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief calls `sample(corners, weights)` for places between the balls, on edges and triangles, so that none of these is farther
/// from one, or from a centre, than about the spacing.
template <class Sample>
void for_each_place_between(const Medial_representation& axis, double spacing, Sample&& sample)
{
  check_positive(spacing, "spacing");
  for(const auto& [from, to] : axis.edges) {
    const double length = std::sqrt(squared_distance(axis.centers[from], axis.centers[to]));
    const double pieces = std::ceil(length / spacing);
    for(double i = 1; i < pieces; ++i)
      sample(std::array{from, to, to}, std::array{1 - i / pieces, i / pieces, 0.});
  }
  for(const auto& corners : axis.triangles) {
    const auto add = [&](const Triangle_piece& piece) {
      if(piece.fraction < 1) // a small triangle is represented by its corners
        sample(corners, piece.centroid());
    };
    for_each_piece(whole_triangle(axis.centers[corners[0]], axis.centers[corners[1]],
                                  axis.centers[corners[2]]),
                   largest_variance(spacing), add);
  }
}

inline Point_3 place_between(const Medial_representation& axis,
                             const std::array<std::uint32_t, 3>& corners,
                             const std::array<double, 3>& weights)
{
  const Point_3 &a = axis.centers[corners[0]], &b = axis.centers[corners[1]],
                &c = axis.centers[corners[2]];
  return a + weights[1] * (b - a) + weights[2] * (c - a);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns points all over a representation: the centres, and points on edges and triangles, so that no place of
/// these is farther from one than about the spacing.
/// \throw std::invalid_argument if the spacing is not positive and finite
inline std::vector<Point_3> axis_samples(const Medial_representation& axis, double spacing)
{
  std::vector<Point_3> samples = axis.centers;
  internal::for_each_place_between(axis, spacing, [&](const auto& corners, const auto& weights) {
    samples.push_back(internal::place_between(axis, corners, weights));
  });
  return samples;
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns a representation with balls all over its edges and triangles, of radii between those at the corners: cones and
/// slabs, as a medial mesh is understood.
///
/// Neighbours are about the spacing apart, so that between balls of radius `r` they leave dents of `spacing² / 8r`. The
/// topology is not known.
/// \throw std::invalid_argument if the spacing is not positive and finite
inline Medial_representation interpolated_balls(const Medial_representation& axis, double spacing)
{
  Medial_representation result;
  result.name = axis.name;
  result.centers = axis.centers;
  result.radii = axis.radii;
  internal::for_each_place_between(axis, spacing, [&](const auto& corners, const auto& weights) {
    result.centers.push_back(internal::place_between(axis, corners, weights));
    double radius = 0;
    for(std::size_t i = 0; i < 3; ++i)
      radius += weights[i] * axis.radii[corners[i]];
    result.radii.push_back(radius);
  });
  return result;
}

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class ConcurrencyTag>
Spread_of_values distances_from(const std::vector<Point_3>& points, const Nearest_point& nearest)
{
  std::vector<double> distances(points.size());
  for_each_index<ConcurrencyTag>(points.size(),
                                 [&](std::size_t i) { distances[i] = nearest(points[i]); });
  return spread_of(std::move(distances));
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns how far points are from the nearest ones of others; the largest is the one-sided Hausdorff distance.
///
/// Infinite if there are none to be near to.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Spread_of_values distances_from(const std::vector<Point_3>& points,
                                const std::vector<Point_3>& others)
{
  return internal::distances_from<ConcurrencyTag>(points, internal::Nearest_point(others));
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief how far two representations are from each other.
///
/// An axis with sheets and a skeleton without are far apart one way, and near the other: one number for both would hide
/// that.
struct Axis_distances
{
  Spread_of_values there; ///< from each place of the first to the nearest of the second
  Spread_of_values back;  ///< from each place of the second to the nearest of the first

  /// the two-sided Hausdorff distance.
  double hausdorff() const { return std::max(there.largest, back.largest); }
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief compares where two representations are.
///
/// Each sample counts alike, so that means depend on how a representation is sampled where it has more balls than the
/// spacing asks for; largest distances are right up to the spacing.
/// \throw std::invalid_argument if the spacing is not positive and finite
template <class ConcurrencyTag = CGAL::Sequential_tag>
Axis_distances axis_distances(const Medial_representation& first,
                              const Medial_representation& second, double spacing)
{
  const std::vector<Point_3> a = axis_samples(first, spacing), b = axis_samples(second, spacing);
  return {distances_from<ConcurrencyTag>(a, b), distances_from<ConcurrencyTag>(b, a)};
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_AXIS_DISTANCES_H
