// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DRAFT_GRAPH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DRAFT_GRAPH_H

#include <CGAL/Area_projection_transform/centerlines/Draft_line.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief lines and what joins them, while it still changes. Vertices without neighbours do not count.
struct Draft_graph
{
  using Index = std::uint32_t;

  std::vector<Centerline_vertex> vertices;
  std::vector<std::vector<Index>> neighbours;
  std::vector<Index> first_of_line; ///< the vertices of a line are numbered one after the other

  explicit Draft_graph(const std::vector<Draft_line>& lines)
  {
    for(const Draft_line& line : lines) {
      first_of_line.push_back(Index(vertices.size()));
      for(const Centerline_vertex& vertex : line.vertices) {
        add(vertex);
        if(vertices.size() - 1 > first_of_line.back())
          connect(Index(vertices.size() - 2), Index(vertices.size() - 1));
      }
      if(line.is_closed)
        connect(Index(vertices.size() - 1), first_of_line.back());
    }
  }

  Index add(const Centerline_vertex& vertex)
  {
    vertices.push_back(vertex);
    neighbours.emplace_back();
    return Index(vertices.size() - 1);
  }

  void connect(Index a, Index b)
  {
    if(a == b || std::count(neighbours[a].begin(), neighbours[a].end(), b) > 0)
      return;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }

  void disconnect(Index a, Index b)
  {
    neighbours[a].erase(std::remove(neighbours[a].begin(), neighbours[a].end(), b),
                        neighbours[a].end());
    neighbours[b].erase(std::remove(neighbours[b].begin(), neighbours[b].end(), a),
                        neighbours[b].end());
  }

  std::size_t degree(Index v) const { return neighbours[v].size(); }

  /// \brief the vertices from a node along one of its edges to the next node, or back to itself.
  std::vector<Index> chain(Index node, Index next) const
  {
    std::vector<Index> chain{node, next};
    while(degree(chain.back()) == 2 && chain.back() != node) {
      const std::vector<Index>& two = neighbours[chain.back()];
      chain.push_back(two[two[0] == chain[chain.size() - 2] ? 1 : 0]);
    }
    return chain;
  }

  double length(const std::vector<Index>& chain) const
  {
    double length = 0;
    for(std::size_t i = 1; i < chain.size(); ++i)
      length += distance(vertices[chain[i - 1]], vertices[chain[i]]);
    return length;
  }

  double mean_radius(const std::vector<Index>& chain) const
  {
    double sum = 0;
    for(const Index v : chain)
      sum += vertices[v].radius;
    return sum / double(chain.size());
  }

  void remove(const std::vector<Index>& chain)
  {
    for(std::size_t i = 1; i < chain.size(); ++i)
      disconnect(chain[i - 1], chain[i]);
  }

  /// joins two vertices by a smooth curve that has these tangents, which point along it.
  void add_curve(Index a, const Vector_3& tangent_a, Index b, const Vector_3& tangent_b,
                 double vertex_spacing)
  {
    Centerline_vertex from = vertices[a], to = vertices[b];
    from.tangent = tangent_a;
    to.tangent = tangent_b;
    from.origin = to.origin = Centerline_origin::BRIDGED;
    for(Centerline_vertex* end : {&from, &to})
      *end = bridged(*end);
    std::vector<Centerline_vertex> curve;
    append_curve(from, to, vertex_spacing, curve);
    Index last = a;
    for(std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const Index next = add(curve[i]);
      connect(last, next);
      last = next;
    }
    connect(last, b);
  }

  /// a vertex of which nothing is known but place, direction and radius.
  static Centerline_vertex bridged(const Centerline_vertex& vertex)
  {
    Centerline_vertex result;
    result.point = vertex.point;
    result.tangent = vertex.tangent;
    result.radius = vertex.radius;
    result.origin = Centerline_origin::BRIDGED;
    return result;
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DRAFT_GRAPH_H
