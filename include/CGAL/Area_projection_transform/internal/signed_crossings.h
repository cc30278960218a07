// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_CROSSINGS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_CROSSINGS_H

#include <CGAL/Area_projection_transform/Grid_3.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief where the lines of a grid along one axis go through a surface, and which way.
///
/// Lines are numbered `u + size_u * v`, where `u` and `v` run over the two other axes in cyclic order.
class Signed_crossings
{
public:
  struct Crossing
  {
    std::int32_t first_after; ///< the first lattice point of the line that is behind the crossing
    std::int32_t sign;        ///< +1 where the line enters the solid, -1 where it leaves
  };

  Signed_crossings(const Triangle_surface& surface, const Grid_3& grid, int axis)
      : m_axis(axis), m_u((axis + 1) % 3), m_v((axis + 2) % 3), m_grid(grid)
  {
    std::vector<Found> found;
    for(std::size_t t = 0; t < surface.size(); ++t)
      find_crossings(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2), found);
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

  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

  /// \brief the side of the edge `a b` on which `p` lies, as if `p` were moved by (ε, ε²).
  ///
  /// No point is on an edge then, and the triangles around an edge or a vertex share out the
  /// points on it: each line goes through a closed surface as often inward as outward.
  static bool is_left(const Exact::Point_2& a, const Exact::Point_2& b, const Exact::Point_2& p)
  {
    const CGAL::Orientation side = CGAL::orientation(a, b, p);
    if(side != CGAL::COLLINEAR)
      return side == CGAL::LEFT_TURN;
    return a.y() != b.y() ? b.y() < a.y() : a.x() < b.x();
  }

  void find_crossings(const Point_3& a, const Point_3& b, const Point_3& c,
                      std::vector<Found>& found) const
  {
    const auto flat = [this](const Point_3& p) { return Exact::Point_2(p[m_u], p[m_v]); };
    const Exact::Point_2 fa = flat(a), fb = flat(b), fc = flat(c);
    const CGAL::Orientation orientation = CGAL::orientation(fa, fb, fc);
    if(orientation == CGAL::COLLINEAR)
      return; // seen edge-on: no line goes through
    const bool is_positive = orientation == CGAL::LEFT_TURN;

    const auto [first_u, last_u] = lattice_range(m_u, a, b, c);
    const auto [first_v, last_v] = lattice_range(m_v, a, b, c);
    for(int v = first_v; v < last_v; ++v)
      for(int u = first_u; u < last_u; ++u) {
        const Exact::Point_2 p(coordinate(m_u, u), coordinate(m_v, v));
        if(is_left(fa, fb, p) == is_positive && is_left(fb, fc, p) == is_positive &&
           is_left(fc, fa, p) == is_positive) {
          const double height = height_above(a, b, c, p.x(), p.y());
          const double after = std::ceil((height - m_grid.origin()[m_axis]) / m_grid.spacing());
          const double clamped = std::clamp(after, 0., double(m_grid.size()[m_axis]));
          // An outward normal along the axis means that the line leaves.
          found.push_back({std::size_t(u) + std::size_t(m_grid.size()[m_u]) * std::size_t(v),
                           {std::int32_t(clamped), is_positive ? -1 : 1}});
        }
      }
  }

  double coordinate(int axis, int index) const
  {
    return m_grid.origin()[axis] + m_grid.spacing() * index;
  }

  std::pair<int, int> lattice_range(int axis, const Point_3& a, const Point_3& b,
                                    const Point_3& c) const
  {
    const double low = std::min({a[axis], b[axis], c[axis]});
    const double high = std::max({a[axis], b[axis], c[axis]});
    const double origin = m_grid.origin()[axis], spacing = m_grid.spacing();
    const double size = m_grid.size()[axis];
    // A point to spare on either side, since the quotients are rounded.
    return {int(std::clamp(std::ceil((low - origin) / spacing) - 1, 0., size)),
            int(std::clamp(std::floor((high - origin) / spacing) + 2, 0., size))};
  }

  /// the coordinate along the axis at which the plane of a triangle is met, within its range.
  double height_above(const Point_3& a, const Point_3& b, const Point_3& c, double u,
                      double v) const
  {
    const Vector_3 n = cross_product(b - a, c - a);
    const double height = a[m_axis] - (n[m_u] * (u - a[m_u]) + n[m_v] * (v - a[m_v])) / n[m_axis];
    const auto [low, high] = std::minmax({a[m_axis], b[m_axis], c[m_axis]});
    return height >= low ? std::min(height, high) : low; // also if rounding left 0/0
  }

  void sort_into_lines(const std::vector<Found>& found)
  {
    const std::size_t lines = std::size_t(m_grid.size()[m_u]) * std::size_t(m_grid.size()[m_v]);
    m_begin.assign(lines + 1, 0);
    for(const Found& f : found)
      ++m_begin[f.line + 1];
    for(std::size_t line = 0; line < lines; ++line)
      m_begin[line + 1] += m_begin[line];
    m_crossings.resize(found.size());
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for(const Found& f : found)
      m_crossings[next[f.line]++] = f.crossing;
    for(std::size_t line = 0; line < lines; ++line)
      std::sort(m_crossings.begin() + std::ptrdiff_t(m_begin[line]),
                m_crossings.begin() + std::ptrdiff_t(m_begin[line + 1]),
                [](const Crossing& a, const Crossing& b) {
                  return a.first_after != b.first_after ? a.first_after < b.first_after
                                                        : a.sign > b.sign;
                });
  }

  int m_axis, m_u, m_v;
  const Grid_3& m_grid;
  std::vector<std::size_t> m_begin;
  std::vector<Crossing> m_crossings;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_CROSSINGS_H
