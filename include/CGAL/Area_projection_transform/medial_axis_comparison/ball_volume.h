// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_BALL_VOLUME_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_BALL_VOLUME_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/is_closed.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief a volume, and the standard error of its estimate.
struct Estimated_volume
{
  double value = 0; ///< in cubed units of the surface
  double error = 0; ///< one standard deviation, in the same
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief how much of a solid a union of balls fills.
struct Ball_volume
{
  Estimated_volume balls; ///< the volume of the union
  std::optional<Estimated_volume>
      solid; ///< that of the solid; nothing if the surface is not closed, or so far from 0 that rounding hides it
  std::optional<Estimated_volume>
      common; ///< of the part of the balls that is in the solid; the same

  /// the common part over all that is in either: 1 if they are the same.
  std::optional<double> overlap() const
  {
    if(!common)
      return std::nullopt;
    return common->value / (balls.value + solid->value - common->value);
  }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// disjoint intervals of a line, ascending.
using Intervals = std::vector<std::pair<double, double>>;

inline void merge(Intervals& intervals)
{
  std::sort(intervals.begin(), intervals.end());
  std::size_t last = 0;
  for(std::size_t i = 1; i < intervals.size(); ++i)
    if(intervals[i].first <= intervals[last].second)
      intervals[last].second = std::max(intervals[last].second, intervals[i].second);
    else
      intervals[++last] = intervals[i];
  if(!intervals.empty())
    intervals.resize(last + 1);
}

inline double length_of(const Intervals& intervals)
{
  double sum = 0;
  for(const auto& [low, high] : intervals)
    sum += high - low;
  return sum;
}

inline double common_length(const Intervals& a, const Intervals& b)
{
  double sum = 0;
  for(auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    sum += std::max(0., std::min(i->second, j->second) - std::max(i->first, j->first));
    ++(i->second < j->second ? i : j);
  }
  return sum;
}

/// what lines parallel to the `z` axis meet.
class Line_scene
{
public:
  Line_scene(const Medial_representation& balls, const Triangle_surface* solid)
      : m_balls(balls), m_solid(solid)
  {}

  Bbox_3 bbox() const
  {
    Bbox_3 box = m_solid ? m_solid->bbox() : Bbox_3();
    for(std::size_t i = 0; i < m_balls.size(); ++i)
      if(m_balls.radii[i] > 0)
        box += Kernel::Sphere_3(m_balls.centers[i], m_balls.radii[i] * m_balls.radii[i]).bbox();
    return box;
  }

  /// those balls and triangles that lines from `low` to `high` in `y` can meet.
  struct Row
  {
    std::vector<std::size_t> balls, triangles;
  };

  Row row(double low, double high) const
  {
    Row row;
    for(std::size_t i = 0; i < m_balls.size(); ++i)
      if(m_balls.centers[i].y() + m_balls.radii[i] > low &&
         m_balls.centers[i].y() - m_balls.radii[i] < high)
        row.balls.push_back(i);
    for(std::size_t t = 0; m_solid && t < m_solid->size(); ++t) {
      const auto [least, most] = std::minmax(
          {m_solid->corner(t, 0).y(), m_solid->corner(t, 1).y(), m_solid->corner(t, 2).y()});
      if(most >= low && least <= high)
        row.triangles.push_back(t);
    }
    return row;
  }

  Intervals in_balls(const Row& row, double x, double y) const
  {
    Intervals intervals;
    for(const std::size_t i : row.balls) {
      const Point_3& c = m_balls.centers[i];
      const double dx = c.x() - x, dy = c.y() - y;
      const double squared = m_balls.radii[i] * m_balls.radii[i] - dx * dx - dy * dy;
      if(squared > 0)
        intervals.emplace_back(c.z() - std::sqrt(squared), c.z() + std::sqrt(squared));
    }
    merge(intervals);
    return intervals;
  }

  /// nothing if the line goes through an edge.
  std::optional<Intervals> in_solid(const Row& row, double x, double y) const
  {
    std::vector<std::pair<double, int>> crossings;
    for(const std::size_t t : row.triangles)
      if(!add_crossing(t, x, y, crossings))
        return std::nullopt;
    std::sort(crossings.begin(), crossings.end());
    Intervals intervals;
    int winding = 0;
    for(const auto& [z, sign] : crossings) {
      const bool was_inside = winding > 0;
      winding += sign;
      const bool is_inside = winding > 0;
      if(is_inside && !was_inside)
        intervals.emplace_back(z, z);
      else if(was_inside && !is_inside)
        intervals.back().second = z;
    }
    if(winding != 0)
      return std::nullopt;
    return intervals;
  }

private:
  /// \brief twice the area of the triangle of an edge and a place, seen along `z`.
  ///
  /// The two triangles at an edge get the same number but for the sign, whatever is rounded.
  static double side_of(const Point_3& a, const Point_3& b, double x, double y)
  {
    const auto of_ascending = [&](const Point_3& p, const Point_3& q) {
      return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
    };
    return a < b ? of_ascending(a, b) : -of_ascending(b, a);
  }

  /// returns whether the line goes through no edge of the triangle.
  bool add_crossing(std::size_t t, double x, double y,
                    std::vector<std::pair<double, int>>& crossings) const
  {
    const Point_3 &a = m_solid->corner(t, 0), &b = m_solid->corner(t, 1),
                  &c = m_solid->corner(t, 2);
    const double u = side_of(b, c, x, y), v = side_of(c, a, x, y), w = side_of(a, b, x, y);
    const bool is_above = u > 0 && v > 0 && w > 0, is_below = u < 0 && v < 0 && w < 0;
    if(is_above || is_below) // seen from above it turns left where the solid ends
      crossings.emplace_back((u * a.z() + v * b.z() + w * c.z()) / (u + v + w), is_above ? -1 : 1);
    const bool is_on_edge = !is_above && !is_below && u + v + w != 0 &&
                            (std::min({u, v, w}) >= 0 || std::max({u, v, w}) <= 0);
    return !is_on_edge;
  }

  const Medial_representation& m_balls;
  const Triangle_surface* m_solid;
};

/// the sums of values over pairs of lines, and of the squared differences of the two.
struct Sums_of_pairs
{
  std::array<double, 3> values{}, squares{};

  void add(const std::array<double, 3>& first, const std::array<double, 3>& second)
  {
    for(std::size_t i = 0; i < 3; ++i) {
      values[i] += 0.5 * (first[i] + second[i]);
      squares[i] += 0.25 * (first[i] - second[i]) * (first[i] - second[i]);
    }
  }
};

/// \brief the lengths, on a line by chance in a cell, of the balls, of the solid, and of what is common.
///
/// Those that need the solid are not numbers if all lines go through edges, which are where coordinates are too large to tell
/// places between them.
inline std::array<double, 3> lengths_on_a_line(const Line_scene& scene, const Line_scene::Row& row,
                                               double low_x, double low_y, double width,
                                               double height, std::mt19937_64& random)
{
  constexpr int attempts = 8;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto uniform = [&random] { return double(random() >> 11) * 0x1p-53; };
  for(int attempt = 1;; ++attempt) {
    const double x = low_x + width * uniform(), y = low_y + height * uniform();
    const std::optional<Intervals> solid = scene.in_solid(row, x, y);
    if(!solid && attempt < attempts)
      continue;
    const Intervals balls = scene.in_balls(row, x, y);
    if(!solid)
      return {length_of(balls), unknown, unknown};
    return {length_of(balls), length_of(*solid), common_length(balls, *solid)};
  }
}

template <class ConcurrencyTag>
Ball_volume ball_volume(const Medial_representation& axis, const Triangle_surface* solid,
                        std::size_t rows, std::uint64_t seed)
{
  constexpr std::size_t most = 1 << 16;
  if(rows < 1 || rows > most)
    throw std::invalid_argument("rows is " + std::to_string(rows) + ": must be from 1 to " +
                                std::to_string(most));
  Ball_volume result;
  const Line_scene scene(axis, solid);
  const Bbox_3 box = scene.bbox();
  const double width = (box.xmax() - box.xmin()) / double(rows),
               height = (box.ymax() - box.ymin()) / double(rows);
  std::vector<Sums_of_pairs> sums(rows);
  if(width > 0 && height > 0)
    for_each_index<ConcurrencyTag>(rows, [&](std::size_t j) {
      std::mt19937_64 random(seed * 1000003 +
                             j); // one for each row, so that they can be shared out
      const double y = box.ymin() + double(j) * height;
      const Line_scene::Row row = scene.row(y, y + height);
      for(std::size_t i = 0; i < rows; ++i) {
        const double x = box.xmin() + double(i) * width;
        const auto first = lengths_on_a_line(scene, row, x, y, width, height, random);
        sums[j].add(first, lengths_on_a_line(scene, row, x, y, width, height, random));
      }
    });
  std::array<Estimated_volume, 3> volumes;
  for(const Sums_of_pairs& sum : sums)
    for(std::size_t i = 0; i < 3; ++i) {
      volumes[i].value += width * height * sum.values[i];
      volumes[i].error += width * height * width * height * sum.squares[i];
    }
  for(Estimated_volume& volume : volumes)
    volume.error = std::sqrt(volume.error);
  result.balls = volumes[0];
  if(solid && std::isfinite(volumes[1].value)) {
    result.solid = volumes[1];
    result.common = volumes[2];
  }
  return result;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief measures the union of the balls of a representation, and what of it is in the solid that a surface bounds.
///
/// Lines parallel to the `z` axis are cut exactly; two of them, by chance, go through each of `rows` × `rows` cells, and the
/// difference between the two tells the error. With 64 rows it is about a thousandth of the volume.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result does not depend on it, to the last bit
/// \param axis the balls
/// \param surface if it is not closed, only the balls are measured
/// \param seed another seed, other lines; the same on every platform
/// \param rows of cells along each of two axes, from 1 to 65 536
/// \throw std::invalid_argument if `rows` is not in its range
///
/// Complexity: `rows²` times the number of balls and triangles that a line of a row can meet
template <class ConcurrencyTag = CGAL::Sequential_tag>
Ball_volume ball_volume(const Medial_representation& axis, const Triangle_surface& surface,
                        std::uint64_t seed = 0, std::size_t rows = 64)
{
  const bool is_solid = !surface.empty() && internal::is_closed(surface);
  return internal::ball_volume<ConcurrencyTag>(axis, is_solid ? &surface : nullptr, rows, seed);
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief measures the union of the balls of a representation alone.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Ball_volume ball_volume(const Medial_representation& axis, const Surfels&, std::uint64_t seed = 0,
                        std::size_t rows = 64)
{
  return internal::ball_volume<ConcurrencyTag>(axis, nullptr, rows, seed);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_BALL_VOLUME_H
