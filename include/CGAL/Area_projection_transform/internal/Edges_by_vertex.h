// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EDGES_BY_VERTEX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EDGES_BY_VERTEX_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the point itself, for surfaces whose edges are told apart by the points that they name.
struct As_named
{
  std::uint32_t operator()(std::uint32_t point) const { return point; }
};

/// \brief the sides of the triangles of a surface, grouped by the edge that they lie on.
class Edges_by_vertex
{
public:
  /// a side of a triangle, of which the lower vertex is known.
  struct Side
  {
    std::uint32_t higher;
    std::uint32_t face;
    bool is_ascending; ///< from the lower vertex to the higher
  };

  /// \param place_of tells which points count as one
  template <class Place = As_named>
  explicit Edges_by_vertex(const Triangle_surface& surface, Place place_of = Place())
      : m_begin(surface.points.size() + 1, 0), m_sides(3 * surface.size())
  {
    for_each_side(surface, place_of, [this](std::size_t, std::uint32_t a, std::uint32_t b) {
      ++m_begin[std::min(a, b)];
    });
    std::size_t sum = 0;
    for(std::size_t& begin : m_begin)
      begin = sum += begin; // the end of the group, which becomes its beginning as it is filled
    for_each_side(surface, place_of, [this](std::size_t face, std::uint32_t a, std::uint32_t b) {
      m_sides[--m_begin[std::min(a, b)]] = {std::max(a, b), std::uint32_t(face), a < b};
    });
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v)
      std::sort(begin_of(v), begin_of(v + 1), [](const Side& a, const Side& b) {
        return a.higher < b.higher || (a.higher == b.higher && a.face < b.face);
      });
  }

  /// \brief calls `function(lower_vertex, begin, end)` with the sides on each edge, until it returns
  /// `false`; returns whether it never did.
  ///
  /// The sides of an edge are in the order of their faces, as the edges are in that of their vertices.
  template <class Function>
  bool all_edges(Function&& function) const
  {
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v) {
      const Side* const last = m_sides.data() + m_begin[v + 1];
      for(const Side* begin = m_sides.data() + m_begin[v]; begin != last;) {
        const Side* const end = std::find_if(
            begin, last, [begin](const Side& side) { return side.higher != begin->higher; });
        if(!function(std::uint32_t(v), begin, end))
          return false;
        begin = end;
      }
    }
    return true;
  }

private:
  template <class Place, class Function>
  static void for_each_side(const Triangle_surface& surface, const Place& place_of,
                            Function&& function)
  {
    for(std::size_t t = 0; t < surface.size(); ++t)
      for(int i = 0; i < 3; ++i)
        function(t, place_of(surface.triangles[t][i]), place_of(surface.triangles[t][(i + 1) % 3]));
  }

  std::vector<Side>::iterator begin_of(std::size_t vertex)
  {
    return m_sides.begin() + std::ptrdiff_t(m_begin[vertex]);
  }

  std::vector<std::size_t> m_begin;
  std::vector<Side> m_sides;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EDGES_BY_VERTEX_H
