// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_BALL_GRAPH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_BALL_GRAPH_H

#include <CGAL/Area_projection_transform/centerlines/Draft_line.h>
#include <CGAL/Area_projection_transform/centerlines/inner_balls.h>
#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the inside of a shape, as far as it can be walked through: inner balls and vertices of lines, those connected
/// of which one has the centre of the other within its ball.
class Ball_graph
{
public:
  using Vector = Eigen::Vector3d;

  struct Node
  {
    Vector position;
    double radius;
    std::int32_t line;    ///< or -1
    std::uint32_t vertex; ///< of the line
  };

  /// how another line is reached from the end of one.
  struct Arrival
  {
    std::int32_t line = -1;
    std::uint32_t vertex = 0;
    double cost = 0;
    double balls = 0;                ///< the length of the way in units of the radii along it
    std::vector<std::uint32_t> path; ///< nodes, from the end to the line that is reached
  };

  Ball_graph(const std::vector<Draft_line>& lines, std::vector<Inner_ball> balls)
  {
    for(std::size_t l = 0; l < lines.size(); ++l) {
      m_first_of_line.push_back(std::uint32_t(m_nodes.size()));
      for(std::size_t v = 0; v < lines[l].vertices.size(); ++v) {
        const Centerline_vertex& vertex = lines[l].vertices[v];
        m_nodes.push_back(
            {to_eigen(vertex.point), vertex.radius, std::int32_t(l), std::uint32_t(v)});
      }
    }
    for(const Inner_ball& ball : thinned(std::move(balls)))
      m_nodes.push_back({ball.center, ball.radius, -1, 0});
    connect();
  }

  const Node& operator[](std::size_t node) const { return m_nodes[node]; }

  /// \brief finds the lines that can be reached from an end of a line, each in the best way, the cheapest first.
  ///
  /// Wide ways are cheap (their length over the square of their radius), those that widen or narrow suddenly are dear,
  /// and at first those that leave the direction of the line.
  std::vector<Arrival> reach(std::int32_t line, std::size_t vertex, const Vector& direction) const
  {
    constexpr double most_balls = 8;
    const std::uint32_t start = m_first_of_line[std::size_t(line)] + std::uint32_t(vertex);
    std::vector<State> states(m_nodes.size());
    std::vector<Arrival> arrivals;
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    states[start].cost = 0;
    queue.push({0, start});
    while(!queue.empty()) {
      const auto [cost, i] = queue.top();
      queue.pop();
      if(states[i].is_settled)
        continue;
      states[i].is_settled = true;
      if(m_nodes[i].line >= 0 && i != start) {
        add_arrival(i, states, arrivals);
        continue;
      }
      for(std::size_t k = m_begin[i]; k < m_begin[i + 1]; ++k) {
        const std::uint32_t j = m_neighbours[k];
        if(states[j].is_settled || m_nodes[j].line == line)
          continue;
        const Step step = make_step(start, i, j, direction);
        const double balls = states[i].balls + step.balls;
        if(cost + step.cost < states[j].cost && balls < most_balls) {
          states[j] = {cost + step.cost, balls, i, false};
          queue.push({states[j].cost, j});
        }
      }
    }
    return arrivals;
  }

private:
  struct State
  {
    double cost = std::numeric_limits<double>::max();
    double balls = 0;
    std::uint32_t before = 0;
    bool is_settled = false;
  };

  struct Step
  {
    double cost, balls;
  };

  Step make_step(std::uint32_t start, std::uint32_t i, std::uint32_t j,
                 const Vector& direction) const
  {
    constexpr double of_change = 2, of_turn = 2, fading = 3;
    const Node &a = m_nodes[i], &b = m_nodes[j];
    const Vector way = b.position - a.position;
    const double length = way.norm(), mean = 0.5 * (a.radius + b.radius);
    const auto [low, high] = std::minmax(a.radius, b.radius);
    const Node& from = m_nodes[start];
    const double away = (b.position - from.position).norm() / (fading * from.radius);
    const double turn = length > 0 ? 1 - way.dot(direction) / length : 0;
    const double factor =
        (1 + of_change * (high / low - 1)) * (1 + of_turn * turn * std::max(1 - away, 0.));
    return {length / (mean * mean) * factor, length / mean};
  }

  void add_arrival(std::uint32_t node, const std::vector<State>& states,
                   std::vector<Arrival>& arrivals) const
  {
    const std::int32_t line = m_nodes[node].line;
    if(std::any_of(arrivals.begin(), arrivals.end(),
                   [line](const Arrival& a) { return a.line == line; }))
      return;
    Arrival arrival;
    arrival.line = line;
    arrival.vertex = m_nodes[node].vertex;
    arrival.cost = states[node].cost;
    arrival.balls = states[node].balls;
    for(std::uint32_t i = node; states[i].cost > 0; i = states[i].before)
      arrival.path.push_back(i);
    arrival.path.push_back(arrival.path.empty() ? node : states[arrival.path.back()].before);
    std::reverse(arrival.path.begin(), arrival.path.end());
    arrivals.push_back(std::move(arrival));
  }

  /// drops balls beside larger ones, and those in tubes of which there is a line.
  std::vector<Inner_ball> thinned(std::vector<Inner_ball> balls) const
  {
    constexpr double beside = 0.2, inside = 0.25, as_large = 1.25;
    std::stable_sort(balls.begin(), balls.end(),
                     [](const Inner_ball& a, const Inner_ball& b) { return a.radius > b.radius; });
    std::vector<Vector> centers;
    std::vector<double> radii;
    for(const Inner_ball& ball : balls) {
      centers.push_back(ball.center);
      radii.push_back(ball.radius);
    }
    const Cell_list cells(centers, std::max(inside * median(radii), 1e-300));
    std::vector<bool> is_dropped(balls.size(), false);
    for(const Node& node : m_nodes)
      cells.for_each_in_ball(node.position, inside * node.radius, [&](std::size_t i, double) {
        if(balls[i].radius < as_large * node.radius)
          is_dropped[i] = true;
      });
    std::vector<Inner_ball> kept;
    for(std::size_t i = 0; i < balls.size(); ++i) {
      if(is_dropped[i])
        continue;
      kept.push_back(balls[i]);
      cells.for_each_in_ball(balls[i].center, beside * balls[i].radius,
                             [&](std::size_t j, double) { is_dropped[j] = true; });
    }
    return kept;
  }

  void connect()
  {
    constexpr double reach = 1;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<Vector> positions;
    std::vector<double> radii;
    for(const Node& node : m_nodes) {
      positions.push_back(node.position);
      radii.push_back(node.radius);
    }
    const Cell_list cells(positions, std::max(median(radii), 1e-300));
    for(std::size_t i = 0; i < m_nodes.size(); ++i)
      cells.for_each_in_ball(positions[i], reach * m_nodes[i].radius, [&](std::size_t j, double) {
        if(i != j && (m_nodes[i].line < 0 || m_nodes[i].line != m_nodes[j].line)) {
          edges.push_back({std::uint32_t(i), std::uint32_t(j)});
          edges.push_back({std::uint32_t(j), std::uint32_t(i)});
        }
      });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    m_begin.assign(m_nodes.size() + 1, 0);
    for(const auto& [i, j] : edges) {
      ++m_begin[i + 1];
      m_neighbours.push_back(j);
    }
    for(std::size_t i = 0; i < m_nodes.size(); ++i)
      m_begin[i + 1] += m_begin[i];
  }

  std::vector<Node> m_nodes;
  std::vector<std::uint32_t> m_first_of_line;
  std::vector<std::size_t> m_begin;
  std::vector<std::uint32_t> m_neighbours;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_BALL_GRAPH_H
