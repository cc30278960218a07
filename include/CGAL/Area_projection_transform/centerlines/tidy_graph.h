// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_TIDY_GRAPH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_TIDY_GRAPH_H

#include <CGAL/Area_projection_transform/centerlines/Draft_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// continues the line of an end to where its tube ends, along its bend at first and then straight.
inline void extend_end(Draft_graph& graph, Draft_graph::Index last, const Line_end& end,
                       double vertex_spacing)
{
  constexpr double least = 0.02; // in units of the radius
  const double r = end.canal.tube.radius;
  const std::size_t first = graph.vertices.size();
  // The rim may be before the end of what was followed.
  const double bent = std::min(end.dropped, end.dropped + end.extension), straight = end.extension;
  Vector_3 direction = to_vector_3(end.canal.tube.axis);
  const auto go_on = [&](const Eigen::Vector3d& place, const Eigen::Vector3d& tangent) {
    Centerline_vertex vertex = Draft_graph::bridged(graph.vertices[last]);
    vertex.point = to_point_3(place);
    vertex.tangent = to_vector_3(tangent);
    const Draft_graph::Index next = graph.add(vertex);
    graph.add_curve(last, direction, next, vertex.tangent, vertex_spacing);
    last = next;
    direction = vertex.tangent;
  };
  const Tube& tube = end.canal.tube;
  if(bent > least * r)
    go_on(tube.point_at(bent), tube.tangent_at(bent));
  if(straight > least * r)
    go_on(tube.point_at(end.dropped) + straight * tube.tangent_at(end.dropped),
          tube.tangent_at(end.dropped));
  for(std::size_t v = first; v < graph.vertices.size(); ++v)
    graph.vertices[v].origin = Centerline_origin::EXTENDED;
}

/// continues lines from their free ends.
inline void extend_ends(Draft_graph& graph, const std::vector<Draft_line>& lines,
                        double vertex_spacing)
{
  for(std::size_t l = 0; l < lines.size(); ++l)
    for(int k = 0; k < 2 && !lines[l].is_closed; ++k) {
      const auto last = Draft_graph::Index(graph.first_of_line[l] + lines[l].vertex_of_end(k));
      if(graph.degree(last) == 1)
        extend_end(graph, last, lines[l].ends[std::size_t(k)], vertex_spacing);
    }
}

/// \brief drops branches with a free end that are short, the shortest first: twigs, and whole lines.
///
/// A twig counts from the ball around the node in which it begins: what is in that belongs to the others.
/// \param least_length in units of their mean radius, or that of the node if it is larger
inline void prune_twigs(Draft_graph& graph, double least_length)
{
  using Chain = std::vector<Draft_graph::Index>;
  while(true) {
    Chain shortest;
    double least = least_length;
    for(Draft_graph::Index v = 0; v < graph.vertices.size(); ++v) {
      if(graph.degree(v) != 1)
        continue;
      const Chain chain = graph.chain(v, graph.neighbours[v].front());
      const double at_node =
          graph.degree(chain.back()) > 2 ? graph.vertices[chain.back()].radius : 0;
      const double length = graph.length(chain) / std::max(graph.mean_radius(chain), at_node);
      if(length < least) {
        least = length;
        shortest = chain;
      }
    }
    if(shortest.empty())
      return;
    graph.remove(shortest);
  }
}

/// \brief the shortest chain between two nodes that are within a part of their radius of each other, from the larger to the
/// smaller; empty if there is none.
inline std::vector<Draft_graph::Index> chain_of_near_nodes(const Draft_graph& graph)
{
  constexpr double near = 0.6; // of the radius
  std::vector<Draft_graph::Index> shortest;
  double least = near;
  for(Draft_graph::Index v = 0; v < graph.vertices.size(); ++v) {
    if(graph.degree(v) < 3)
      continue;
    for(const Draft_graph::Index next : graph.neighbours[v]) {
      const std::vector<Draft_graph::Index> chain = graph.chain(v, next);
      const Draft_graph::Index w = chain.back();
      const double radius = graph.vertices[v].radius, length = graph.length(chain) / radius;
      if(w == v || graph.degree(w) < 3 || graph.vertices[w].radius > radius || !(length < least))
        continue;
      least = length;
      shortest = chain;
    }
  }
  return shortest;
}

/// \brief makes one node of two that are within a part of their radius of each other, where the larger is: the nearest
/// first.
///
/// What was between them goes.
inline void merge_nodes(Draft_graph& graph)
{
  while(true) {
    const std::vector<Draft_graph::Index> chain = chain_of_near_nodes(graph);
    if(chain.empty())
      return;
    graph.remove(chain);
    const std::vector<Draft_graph::Index> others = graph.neighbours[chain.back()];
    for(const Draft_graph::Index other : others) {
      graph.disconnect(chain.back(), other);
      graph.connect(chain.front(), other);
    }
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_TIDY_GRAPH_H
