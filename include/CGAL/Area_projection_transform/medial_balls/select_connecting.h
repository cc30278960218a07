// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SELECT_CONNECTING_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SELECT_CONNECTING_H

#include <CGAL/Area_projection_transform/internal/Disjoint_sets.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_complex.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief of a ball that is within the union of others, and so is none of the vertices of their complex, the one into which its
/// centre is deepest; the ball itself if it is a vertex.
inline std::uint32_t vertex_around(std::uint32_t ball, const std::vector<Medial_ball>& balls,
                                   const std::vector<std::uint32_t>& vertices)
{
  if(vertices.empty() || std::binary_search(vertices.begin(), vertices.end(), ball))
    return ball;
  const auto height = [&](std::uint32_t other) {
    return std::sqrt(squared_distance(balls[ball].center, balls[other].center)) -
           balls[other].radius;
  };
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](std::uint32_t a, std::uint32_t b) { return height(a) < height(b); });
}

/// the shortest ways along a medial axis from some of its balls, each ball reached from the nearest of them.
class Ways_along_balls
{
public:
  using Ball = std::uint32_t;

  /// where the ways from two balls meet.
  struct Meeting
  {
    double length; ///< of both together
    Ball a, b;     ///< neighbours

    bool operator<(const Meeting& other) const
    {
      return std::tie(length, a, b) < std::tie(other.length, other.a, other.b);
    }
  };

  Ways_along_balls(const std::vector<Medial_ball>& balls, const Medial_complex& axis,
                   const std::vector<std::size_t>& sources)
      : m_balls(balls)
      , m_neighbours(balls.size())
      , m_length(balls.size(), std::numeric_limits<double>::infinity())
      , m_before(balls.size(), none)
      , m_source(balls.size(), none)
  {
    for(const auto& [a, b] : axis.edges)
      join(a, b);
    for(const std::size_t i : sources)
      if(const Ball vertex = vertex_around(Ball(i), balls, axis.vertices); vertex != i)
        join(Ball(i), vertex);
    search(sources);
  }

  double apart(Ball a, Ball b) const
  {
    return std::sqrt(squared_distance(m_balls[a].center, m_balls[b].center));
  }

  /// all, the shortest first.
  std::vector<Meeting> meetings() const
  {
    std::vector<Meeting> result;
    for(Ball a = 0; a < m_neighbours.size(); ++a)
      for(const Ball b : m_neighbours[a])
        if(a < b && std::isfinite(m_length[a]))
          result.push_back({m_length[a] + apart(a, b) + m_length[b], a, b});
    std::sort(result.begin(), result.end());
    return result;
  }

  /// from which a ball was reached.
  Ball source(Ball ball) const { return m_source[ball]; }

  /// the balls from one source to the other, both included.
  std::vector<Ball> way(const Meeting& meeting) const
  {
    std::vector<Ball> result = way_back(meeting.a);
    std::reverse(result.begin(), result.end());
    const std::vector<Ball> rest = way_back(meeting.b);
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
  }

private:
  static constexpr Ball none = Ball(-1);

  void join(Ball a, Ball b)
  {
    m_neighbours[a].push_back(b);
    m_neighbours[b].push_back(a);
  }

  std::vector<Ball> way_back(Ball ball) const
  {
    std::vector<Ball> result;
    for(; ball != none; ball = m_before[ball])
      result.push_back(ball);
    return result;
  }

  /// Dijkstra's.
  void search(const std::vector<std::size_t>& sources)
  {
    using Entry = std::pair<double, Ball>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for(const std::size_t i : sources) {
      m_length[i] = 0;
      m_source[i] = Ball(i);
      queue.emplace(0, Ball(i));
    }
    while(!queue.empty()) {
      const auto [length, ball] = queue.top();
      queue.pop();
      if(length > m_length[ball])
        continue;
      for(const Ball next : m_neighbours[ball]) {
        const double longer = length + apart(ball, next);
        if(longer < m_length[next]) {
          m_length[next] = longer;
          m_before[next] = ball;
          m_source[next] = m_source[ball];
          queue.emplace(longer, next);
        }
      }
    }
  }

  const std::vector<Medial_ball>& m_balls;
  std::vector<std::vector<Ball>> m_neighbours;
  std::vector<double> m_length;
  std::vector<Ball> m_before, m_source;
};

/// the balls between the ends of a way that are needed: each reaches the farthest that it overlaps.
inline std::vector<std::uint32_t> stepping_stones(const std::vector<Medial_ball>& balls,
                                                  const Ways_along_balls& ways,
                                                  const std::vector<std::uint32_t>& way)
{
  std::vector<std::uint32_t> stones;
  for(std::size_t i = 0; i + 1 < way.size();) {
    std::size_t next = way.size() - 1;
    while(next > i + 1 &&
          ways.apart(way[i], way[next]) > balls[way[i]].radius + balls[way[next]].radius)
      --next;
    i = next;
    if(i + 1 < way.size())
      stones.push_back(way[i]);
  }
  return stones;
}

/// the pieces of the union of selected balls, in which only these are joined.
inline Disjoint_sets pieces_of(const std::vector<Medial_ball>& balls,
                               const std::vector<std::size_t>& selected, double growth)
{
  const Medial_complex complex = medial_complex(balls, selected, growth);
  Disjoint_sets pieces(balls.size());
  for(const auto& [a, b] : complex.edges)
    pieces.unite(a, b);
  for(const std::size_t i : selected)
    pieces.unite(i, vertex_around(std::uint32_t(i), balls, complex.vertices));
  return pieces;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns some balls and, after them, those that join their pieces along the medial axis: what `select_covering()` selects
/// is few balls, but falls apart.
///
/// Pieces are joined by the shortest ways along the edges of the complex of all balls, as in a minimum spanning tree, of
/// which only so many balls are taken that each overlaps the next. What is one piece of all balls is one piece then. Loops
/// are as they come.
/// \param balls all of them
/// \param selected positions in `balls`
/// \param growth of the balls for their connections, see `crack_width()`
/// \throw std::invalid_argument if one of `selected` is out of range, or `growth` negative or not finite
///
/// Complexity: that of `medial_complex()` of all balls.
inline std::vector<std::size_t> select_connecting(const std::vector<Medial_ball>& balls,
                                                  const std::vector<std::size_t>& selected,
                                                  double growth = 0)
{
  internal::Disjoint_sets pieces = internal::pieces_of(balls, selected, growth);
  std::vector<std::size_t> all(balls.size()), result = selected;
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<bool> is_selected(balls.size(), false);
  const internal::Ways_along_balls ways(balls, medial_complex(balls, all, growth), selected);
  for(const auto& meeting : ways.meetings()) {
    const std::size_t from = pieces.find(ways.source(meeting.a)),
                      to = pieces.find(ways.source(meeting.b));
    if(from == to)
      continue;
    pieces.unite(from, to);
    for(const std::uint32_t ball : internal::stepping_stones(balls, ways, ways.way(meeting))) {
      if(!is_selected[ball]) // by another way
        result.push_back(ball);
      is_selected[ball] = true;
    }
  }
  return result;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SELECT_CONNECTING_H
