// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_CROSSINGS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_CROSSINGS_H

#include <CGAL/Area_projection_transform/Grid_3.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Lattice_axis.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief where the lines of a grid along one axis go through a surface, and which way.
///
/// Lines are numbered `u + size_u * v`, where `u` and `v` run over the two other axes in cyclic order.
/// A line that meets an edge or a vertex goes where it would if it were moved by (ε, ε²): the triangles
/// around share out such lines, and each line goes through a closed surface as often inward as outward.
class Signed_crossings
{
public:
  struct Crossing
  {
    std::int32_t first_after; ///< the first lattice point of the line that is behind the crossing
    std::int32_t sign;        ///< +1 where the line enters the solid, -1 where it leaves
  };

  template <class ConcurrencyTag>
  Signed_crossings(ConcurrencyTag, const Triangle_surface& surface, const Grid_3& grid, int axis)
      : m_grid(grid), m_axis(axis), m_u(grid, (axis + 1) % 3), m_v(grid, (axis + 2) % 3)
  {
    constexpr std::size_t triangles_of_part = 1 << 14;
    std::vector<std::vector<Found>> found((surface.size() + triangles_of_part - 1) /
                                          triangles_of_part);
    for_each_index<ConcurrencyTag>(found.size(), [&](std::size_t part) {
      const std::size_t first = part * triangles_of_part;
      const std::size_t last = std::min(first + triangles_of_part, surface.size());
      for(std::size_t t = first; t < last; ++t)
        find_crossings(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2),
                       found[part]);
    });
    sort_into_lines(found);
  }

  std::size_t number_of_lines() const { return m_begin.size() - 1; }
  const Crossing* begin(std::size_t line) const { return m_crossings.data() + m_begin[line]; }
  const Crossing* end(std::size_t line) const { return m_crossings.data() + m_begin[line + 1]; }

private:
  struct Found
  {
    std::size_t line;
    Crossing crossing;
  };

  /// where a corner is seen along the lines.
  struct Flat_point
  {
    double u, v;
  };

  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

  /// \brief the number of lattice points of the line `v` that precede an edge, which passes the line
  /// upward. Exact: predicates decide where rounding might.
  int number_before_edge(const Flat_point& low, const Flat_point& high, double v) const
  {
    const double run = high.u - low.u;
    const double u = low.u + (v - low.v) / (high.v - low.v) * run;
    // Six roundings, each of half an epsilon or, in another rounding mode, a whole one.
    const double error =
        16 * std::numeric_limits<double>::epsilon() * (std::abs(low.u) + std::abs(run)) +
        std::numeric_limits<double>::min();
    const int i = m_u.guess(u);
    if((i == 0 || m_u[i - 1] < u - error) && (i == m_u.size() || m_u[i] > u + error))
      return i;
    const Exact::Point_2 a(low.u, low.v), b(high.u, high.v);
    return m_u.partition_point(i, [&](int index) {
      return CGAL::orientation(a, b, Exact::Point_2(m_u[index], v)) == CGAL::LEFT_TURN;
    });
  }

  void find_crossings(const Point_3& a, const Point_3& b, const Point_3& c,
                      std::vector<Found>& found) const
  {
    const auto flat = [this](const Point_3& p) { return Flat_point{p[m_u.axis()], p[m_v.axis()]}; };
    const std::array<Flat_point, 3> corners{flat(a), flat(b), flat(c)};
    const auto [low_u, high_u] = std::minmax({corners[0].u, corners[1].u, corners[2].u});
    const auto [low_v, high_v] = std::minmax({corners[0].v, corners[1].v, corners[2].v});
    const int first_v = m_v.number_below(low_v), last_v = m_v.number_below(high_v);
    if(first_v == last_v || m_u.number_below(low_u) == m_u.number_below(high_u))
      return;

    const Vector_3 normal = cross_product(b - a, c - a);
    for(int v = first_v; v < last_v; ++v) {
      int upward = 0, downward = 0; // lattice points that precede the edges of either kind
      for(int i = 0; i < 3; ++i) {
        const Flat_point &from = corners[std::size_t(i)], &to = corners[std::size_t(i + 1) % 3];
        if(from.v <= m_v[v] && m_v[v] < to.v)
          upward = number_before_edge(from, to, m_v[v]);
        else if(to.v <= m_v[v] && m_v[v] < from.v)
          downward = number_before_edge(to, from, m_v[v]);
      }
      // A triangle is on the left of its edges if its normal looks along the axis: there the line leaves.
      const std::int32_t sign = downward < upward ? -1 : 1;
      for(int u = std::min(upward, downward); u < std::max(upward, downward); ++u)
        found.push_back({std::size_t(u) + std::size_t(m_u.size()) * std::size_t(v),
                         {first_after({&a, &b, &c}, normal, m_u[u], m_v[v]), sign}});
    }
  }

  /// the first lattice point of a line behind the plane of a triangle, of which it is known that the line
  /// goes through it.
  std::int32_t first_after(const std::array<const Point_3*, 3>& corners, const Vector_3& normal,
                           double u, double v) const
  {
    const Point_3& a = *corners[0];
    const auto [low, high] = std::minmax({a[m_axis], (*corners[1])[m_axis], (*corners[2])[m_axis]});
    const double height = a[m_axis] - (normal[m_u.axis()] * (u - a[m_u.axis()]) +
                                       normal[m_v.axis()] * (v - a[m_v.axis()])) /
                                          normal[m_axis];
    // Rounding must not leave the triangle, nor make 0/0 of it.
    const double within = height >= low ? std::min(height, high) : low;
    const double after = std::ceil((within - m_grid.origin()[m_axis]) / m_grid.spacing());
    return std::int32_t(std::clamp(after, 0., double(m_grid.size()[std::size_t(m_axis)])));
  }

  void sort_into_lines(const std::vector<std::vector<Found>>& found)
  {
    m_begin.assign(std::size_t(m_u.size()) * std::size_t(m_v.size()) + 1, 0);
    for(const std::vector<Found>& part : found)
      for(const Found& f : part)
        ++m_begin[f.line];
    std::size_t sum = 0;
    for(std::size_t& begin : m_begin)
      begin = sum += begin; // the end of the line, which becomes its beginning as it is filled
    m_crossings.resize(sum);
    for(const std::vector<Found>& part : found)
      for(const Found& f : part)
        m_crossings[--m_begin[f.line]] = f.crossing;
    for(std::size_t line = 0; line < number_of_lines(); ++line)
      if(m_begin[line + 1] - m_begin[line] > 1)
        std::sort(m_crossings.data() + m_begin[line], m_crossings.data() + m_begin[line + 1],
                  [](const Crossing& a, const Crossing& b) {
                    return a.first_after != b.first_after ? a.first_after < b.first_after
                                                          : a.sign > b.sign;
                  });
  }

  const Grid_3& m_grid;
  int m_axis;
  Lattice_axis m_u, m_v;
  std::vector<std::size_t> m_begin;
  std::vector<Crossing> m_crossings;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_CROSSINGS_H
