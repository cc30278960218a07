// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FINISH_GRAPH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FINISH_GRAPH_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Draft_graph.h>
#include <CGAL/Area_projection_transform/centerlines/find_lines.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// makes the result of a draft: numbers its vertices along its branches, and measures those.
class Graph_finisher
{
public:
  using Index = Draft_graph::Index;

  explicit Graph_finisher(const Draft_graph& draft)
      : m_draft(draft), m_number(draft.vertices.size(), none), m_branch(draft.vertices.size(), none)
  {
    for(Index v = 0; v < draft.vertices.size(); ++v)
      if(draft.degree(v) != 2)
        for(const Index next : draft.neighbours[v])
          add_branch(draft.chain(v, next));
    // What is left are closed curves.
    for(Index v = 0; v < draft.vertices.size(); ++v)
      if(draft.degree(v) == 2 && m_number[v] == none)
        add_branch(draft.chain(v, draft.neighbours[v].front()));
  }

  Centerline_graph& graph() { return m_graph; }

  /// the branch that a vertex of the draft belongs to, of nodes one of them; -1 if it was dropped.
  std::int32_t branch_of(Index v) const
  {
    return m_branch[v] == none ? -1 : std::int32_t(m_branch[v]);
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// each branch is met from both of its ends; closed ones from both sides of their node.
  void add_branch(const std::vector<Index>& chain)
  {
    const std::pair<Index, Index> forward{chain.front(), chain[1]},
        backward{chain.back(), chain[chain.size() - 2]};
    if(m_done.count(backward) > 0)
      return;
    m_done[forward] = true;
    m_done[backward] = true;
    Centerline_branch branch;
    const std::uint32_t number = std::uint32_t(bundle().branches.size());
    for(std::size_t i = 0; i < chain.size(); ++i) {
      branch.vertices.push_back(number_of(chain, i));
      if(m_branch[chain[i]] == none)
        m_branch[chain[i]] = number;
      if(i > 0)
        boost::add_edge(branch.vertices[i - 1], branch.vertices[i], Centerline_edge{number},
                        m_graph);
    }
    measure(branch);
    bundle().branches.push_back(std::move(branch));
  }

  Centerline_branches& bundle() { return m_graph[boost::graph_bundle]; }

  /// the vertex of the result, a new one if there is none yet, with a tangent along the chain.
  std::size_t number_of(const std::vector<Index>& chain, std::size_t i)
  {
    const Index v = chain[i];
    if(m_number[v] != none)
      return m_number[v];
    Centerline_vertex vertex = m_draft.vertices[v];
    const Eigen::Vector3d before = to_eigen(m_draft.vertices[chain[i > 0 ? i - 1 : 0]].point),
                          after = to_eigen(
                              m_draft.vertices[chain[std::min(i + 1, chain.size() - 1)]].point);
    const Eigen::Vector3d along = after - before;
    if(m_draft.degree(v) > 2 || vertex.tangent == Vector_3(0, 0, 0))
      vertex.tangent = to_vector_3(along.norm() > 0 ? Eigen::Vector3d(along.normalized()) : along);
    else if(to_eigen(vertex.tangent).dot(along) < 0)
      vertex.tangent = -vertex.tangent;
    m_number[v] = std::uint32_t(boost::add_vertex(vertex, m_graph));
    return m_number[v];
  }

  void measure(Centerline_branch& branch) const
  {
    double covered = 0, volume = 0;
    for(std::size_t i = 1; i < branch.vertices.size(); ++i) {
      const Centerline_vertex &a = m_graph[branch.vertices[i - 1]],
                              &b = m_graph[branch.vertices[i]];
      const double length = distance(a, b);
      branch.length += length;
      volume += length * 0.5 * (a.radius + b.radius);
      if(a.origin == Centerline_origin::FITTED && b.origin == Centerline_origin::FITTED)
        covered += length * 0.5 * (a.coverage + b.coverage);
    }
    if(branch.length > 0) {
      branch.mean_radius = volume / branch.length;
      branch.score = covered / branch.length;
    }
  }

  const Draft_graph& m_draft;
  std::vector<std::uint32_t> m_number, m_branch;
  std::map<std::pair<Index, Index>, bool> m_done;
  Centerline_graph m_graph;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FINISH_GRAPH_H
