// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DROP_LOOPS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DROP_LOOPS_H

#include <CGAL/Area_projection_transform/centerlines/Draft_graph.h>

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the shortest loop that a chain is part of: the chain, and the way from its end back to its start, which is not
/// repeated; empty if there is none.
inline std::vector<Draft_graph::Index> loop_through(const Draft_graph& graph,
                                                    const std::vector<Draft_graph::Index>& chain)
{
  using Index = Draft_graph::Index;
  std::map<Index, std::pair<double, Index>> reached; // by which length, and from where
  std::set<std::pair<double, Index>> queue{{0, chain.back()}};
  reached[chain.back()] = {0, chain.back()};
  while(!queue.empty() && queue.begin()->second != chain.front()) {
    const auto [length, v] = *queue.begin();
    queue.erase(queue.begin());
    for(const Index w : graph.neighbours[v]) {
      const bool is_of_chain = (v == chain.back() && w == chain[chain.size() - 2]) ||
                               (w == chain.front() && v == chain[1]);
      const double next = length + distance(graph.vertices[v], graph.vertices[w]);
      const auto known = reached.find(w);
      if(is_of_chain || (known != reached.end() && known->second.first <= next))
        continue;
      if(known != reached.end())
        queue.erase({known->second.first, w});
      reached[w] = {next, v};
      queue.insert({next, w});
    }
  }
  if(queue.empty())
    return {};
  std::vector<Index> back;
  for(Index v = chain.front(); v != chain.back(); v = reached[v].second)
    back.push_back(v);
  std::vector<Index> loop = chain;
  loop.insert(loop.end(), back.rbegin(), back.rend());
  loop.pop_back(); // the start
  return loop;
}

/// \brief whether a loop is too narrow to go around a hole.
///
/// On opposite sides of a hole are two tubes, whose axes are as far apart as their radii together, when the hole
/// is a point. Opposite is what is half of the length away.
inline bool is_narrow(const Draft_graph& graph, const std::vector<Draft_graph::Index>& loop)
{
  constexpr double narrow = 0.8;
  std::vector<double> along{0};
  for(std::size_t i = 0; i < loop.size(); ++i)
    along.push_back(along.back() +
                    distance(graph.vertices[loop[i]], graph.vertices[loop[(i + 1) % loop.size()]]));
  const double half = along.back() / 2;
  for(std::size_t i = 0, j = 0; i < loop.size() && along[i] < half; ++i) {
    while(j + 1 < loop.size() && along[j] < along[i] + half)
      ++j;
    const Centerline_vertex &a = graph.vertices[loop[i]], &b = graph.vertices[loop[j]];
    if(distance(a, b) < narrow * (a.radius + b.radius))
      return true;
  }
  return false;
}

/// \brief the longest part of a chain that is a bridge, from one that is none to the next; empty if there is none.
inline std::vector<Draft_graph::Index> bridge_of(const Draft_graph& graph,
                                                 const std::vector<Draft_graph::Index>& chain)
{
  std::vector<Draft_graph::Index> bridge;
  const auto is_bridged = [&](std::size_t i) {
    return graph.vertices[chain[i]].origin == Centerline_origin::BRIDGED;
  };
  for(std::size_t begin = 0; begin + 1 < chain.size();) {
    std::size_t end = begin + 1;
    while(end + 1 < chain.size() && is_bridged(end))
      ++end;
    if(end > begin + 1 && end - begin + 1 > bridge.size())
      bridge.assign(chain.begin() + std::ptrdiff_t(begin), chain.begin() + std::ptrdiff_t(end) + 1);
    begin = end;
  }
  return bridge;
}

/// \brief opens loops that are too narrow to go around a hole: of a loop the longest bridge goes.
inline void drop_narrow_loops(Draft_graph& graph)
{
  using Chain = std::vector<Draft_graph::Index>;
  while(true) {
    Chain longest;
    double length = 0;
    for(Draft_graph::Index v = 0; v < graph.vertices.size(); ++v) {
      if(graph.degree(v) < 3)
        continue;
      for(const Draft_graph::Index next : graph.neighbours[v]) {
        const Chain chain = graph.chain(v, next), bridge = bridge_of(graph, chain);
        if(bridge.empty() || !(graph.length(bridge) > length) || graph.degree(chain.back()) < 3)
          continue;
        const Chain loop = loop_through(graph, chain);
        if(loop.empty() || !is_narrow(graph, loop))
          continue;
        longest = bridge;
        length = graph.length(bridge);
      }
    }
    if(longest.empty())
      return;
    graph.remove(longest);
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DROP_LOOPS_H
