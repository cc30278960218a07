// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IS_CLOSED_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IS_CLOSED_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the directed edges of a surface, grouped by the lower of their vertices.
class Edges_by_vertex
{
public:
  struct Edge
  {
    std::uint32_t higher;
    bool is_ascending; ///< from the lower vertex to the higher
  };

  explicit Edges_by_vertex(const Triangle_surface& surface)
      : m_begin(surface.points.size() + 1, 0), m_edges(3 * surface.size())
  {
    for_each_edge(surface, [this](std::uint32_t a, std::uint32_t b) { ++m_begin[std::min(a, b)]; });
    std::size_t sum = 0;
    for(std::size_t& begin : m_begin)
      begin = sum += begin; // the end of the group, which becomes its beginning as it is filled
    for_each_edge(surface, [this](std::uint32_t a, std::uint32_t b) {
      m_edges[--m_begin[std::min(a, b)]] = {std::max(a, b), a < b};
    });
  }

  /// whether every edge is passed as often one way as the other.
  bool are_balanced()
  {
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v) {
      const auto begin = m_edges.begin() + std::ptrdiff_t(m_begin[v]);
      const auto end = m_edges.begin() + std::ptrdiff_t(m_begin[v + 1]);
      std::sort(begin, end, [](const Edge& a, const Edge& b) { return a.higher < b.higher; });
      std::ptrdiff_t surplus = 0;
      for(auto edge = begin; edge != end; ++edge) {
        if(edge->higher != v) // an edge from a vertex to itself goes both ways
          surplus += edge->is_ascending ? 1 : -1;
        if(surplus != 0 && (edge + 1 == end || edge[1].higher != edge->higher))
          return false;
      }
    }
    return true;
  }

private:
  template <class Function>
  static void for_each_edge(const Triangle_surface& surface, Function&& function)
  {
    for(const Triangle_surface::Triangle& triangle : surface.triangles)
      for(int i = 0; i < 3; ++i)
        function(triangle[i], triangle[(i + 1) % 3]);
  }

  std::vector<std::size_t> m_begin;
  std::vector<Edge> m_edges;
};

/// whether the triangles form a closed, consistently oriented surface: every edge is passed as often
/// one way as the other. Then its winding number is the same along every ray from a point.
inline bool is_closed(const Triangle_surface& surface)
{
  return Edges_by_vertex(surface).are_balanced();
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IS_CLOSED_H
