// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_DISTANCES_FROM_BALLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_DISTANCES_FROM_BALLS_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief halves places until those that are left have few balls to be nearest to, or are few themselves.
class Ball_distances
{
public:
  struct Part
  {
    std::size_t begin, end;           ///< of the order of places
    std::vector<std::uint32_t> balls; ///< of which each of these places is nearest to one
  };

  Ball_distances(const std::vector<Point_3>& places, const Medial_representation& balls)
      : m_places(places), m_balls(balls), m_order(places.size())
  {
    std::iota(m_order.begin(), m_order.end(), std::uint32_t(0));
  }

  Part whole() const
  {
    Part all{0, m_places.size(), {}};
    for(std::size_t i = 0; i < m_balls.size(); ++i)
      if(m_balls.radii[i] > 0)
        all.balls.push_back(std::uint32_t(i));
    return all;
  }

  /// calls `function(Part)` for parts of no more than so many places, in a fixed order.
  template <class Function>
  void for_each_part(const Part& part, std::size_t places, Function&& function)
  {
    if(part.end - part.begin <= places || part.balls.size() <= 1) {
      function(part);
      return;
    }
    const std::size_t middle = halve(part);
    for(Part half : {Part{part.begin, middle, {}}, Part{middle, part.end, {}}}) {
      keep_balls(part.balls, half);
      for_each_part(half, places, function);
    }
  }

  void measure(const Part& part, std::vector<double>& distances) const
  {
    for(std::size_t k = part.begin; k < part.end; ++k) {
      double& distance = distances[m_order[k]];
      for(const std::uint32_t i : part.balls)
        distance = std::min(distance, distance_from(i, m_places[m_order[k]]));
    }
  }

private:
  double distance_from(std::uint32_t ball, const Point_3& place) const
  {
    return std::sqrt(squared_distance(m_balls.centers[ball], place)) - m_balls.radii[ball];
  }

  Bbox_3 bbox(const Part& part) const
  {
    Bbox_3 box;
    for(std::size_t k = part.begin; k < part.end; ++k)
      box += m_places[m_order[k]].bbox();
    return box;
  }

  /// sorts the places of a part to both sides of its longest extent; returns where the second half begins.
  std::size_t halve(const Part& part)
  {
    const Bbox_3 box = bbox(part);
    int longest = 0;
    for(int axis = 1; axis < 3; ++axis)
      if(box.max(axis) - box.min(axis) > box.max(longest) - box.min(longest))
        longest = axis;
    const std::size_t middle = part.begin + (part.end - part.begin) / 2;
    const auto at = [this](std::size_t i) { return m_order.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(part.begin), at(middle), at(part.end),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double x = m_places[a][longest], y = m_places[b][longest];
                       return x != y ? x < y : a < b;
                     });
    return middle;
  }

  /// \brief fills in the balls that a place of a part may be nearest to, as seen from its middle.
  ///
  /// Within ρ of there, the distances from two balls whose centres are `a` and `b` away and `d` apart change against each other
  /// by no more than 2ρ, nor than 2ρd / (a + b - 2ρ), since the directions to both are that near to each other.
  void keep_balls(const std::vector<std::uint32_t>& candidates, Part& part) const
  {
    const Bbox_3 box = bbox(part);
    const Point_3 low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
    const Point_3 center = midpoint(low, high);
    const double reach = 0.5 * std::sqrt(squared_distance(low, high));
    const auto nearer = [&](std::uint32_t a, std::uint32_t b) {
      return distance_from(a, center) < distance_from(b, center);
    };
    const std::uint32_t best = *std::min_element(candidates.begin(), candidates.end(), nearer);
    const double least = distance_from(best, center);
    for(const std::uint32_t i : candidates) {
      const double distance = distance_from(i, center);
      const double apart = std::sqrt(squared_distance(m_balls.centers[i], m_balls.centers[best]));
      const double both = distance + m_balls.radii[i] + least + m_balls.radii[best] - 2 * reach;
      const double change = 2 * reach * (both > apart ? apart / both : 1);
      if(distance - least <= change * (1 + 1e-9))
        part.balls.push_back(i);
    }
  }

  const std::vector<Point_3>& m_places;
  const Medial_representation& m_balls;
  std::vector<std::uint32_t> m_order;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns how far places are from the nearest of the balls of a representation; negative inside.
///
/// Outside, that is the distance from their union. Inside, one ball alone tells how deep it is, and the union may be deeper.
/// Infinite if there are no balls.
///
/// Complexity: `O(n log n)` for balls along an axis and places on a surface.
template <class ConcurrencyTag = CGAL::Sequential_tag>
std::vector<double> distances_from_balls(const std::vector<Point_3>& places,
                                         const Medial_representation& axis)
{
  std::vector<double> distances(places.size(), std::numeric_limits<double>::infinity());
  internal::Ball_distances search(places, axis);
  using Part = internal::Ball_distances::Part;
  std::vector<Part> parts;
  search.for_each_part(search.whole(), 4096, [&parts](const Part& p) { parts.push_back(p); });
  internal::for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t i) {
    search.for_each_part(parts[i], 8, [&](const Part& part) { search.measure(part, distances); });
  });
  return distances;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_DISTANCES_FROM_BALLS_H
