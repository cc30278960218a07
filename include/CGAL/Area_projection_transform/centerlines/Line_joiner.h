// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_JOINER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_JOINER_H

#include <CGAL/Area_projection_transform/centerlines/Ball_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Draft_graph.h>
#include <CGAL/Area_projection_transform/internal/Disjoint_sets.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/internal/solve_symmetric.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief joins the ends of lines that are inside the shape to other lines.
///
/// Ends that are near each other and point to one place meet there; one that points to another line goes straight
/// to it. Others go through inner balls.
template <class ConcurrencyTag>
class Line_joiner
{
public:
  using Vector = Eigen::Vector3d;
  using Index = Draft_graph::Index;

  Line_joiner(const std::vector<Draft_line>& lines, const Ball_graph& balls, double vertex_spacing)
      : m_lines(lines)
      , m_balls(balls)
      , m_vertex_spacing(vertex_spacing)
      , m_graph(lines)
      , m_components(lines.size())
  {}

  Draft_graph join()
  {
    find_ends();
    meet();
    for(End& end : m_ends)
      if(!end.is_tip && !end.is_joined)
        go_straight(end);
    bridge();
    join_tips();
    return std::move(m_graph);
  }

private:
  struct End
  {
    std::int32_t line;
    std::uint32_t vertex; ///< of the line
    Index index;          ///< of the graph
    Vector position, direction;
    double radius;
    bool is_tip;
    bool is_joined = false;
    std::vector<Ball_graph::Arrival> arrivals;

    /// how far a place is ahead, and how far from the ray.
    std::pair<double, double> seen(const Vector& place) const
    {
      const Vector way = place - position;
      const double ahead = way.dot(direction);
      return {ahead, (way - ahead * direction).norm()};
    }
  };

  void find_ends()
  {
    for(std::size_t l = 0; l < m_lines.size(); ++l)
      for(int k = 0; k < 2; ++k) {
        const Draft_line& line = m_lines[l];
        if(line.is_closed)
          continue;
        const Line_end& end = line.ends[std::size_t(k)];
        const Tube& tube = end.canal.tube;
        const std::size_t v = line.vertex_of_end(k);
        m_ends.push_back({std::int32_t(l),
                          std::uint32_t(v),
                          m_graph.first_of_line[l] + Index(v),
                          tube.center,
                          tube.axis,
                          line.vertices[v].radius,
                          end.is_tip,
                          false,
                          {}});
      }
    for_each_index<ConcurrencyTag>(m_ends.size(), [&](std::size_t e) {
      m_ends[e].arrivals = m_balls.reach(m_ends[e].line, m_ends[e].vertex, m_ends[e].direction);
    });
  }

  /// \name Ends that meet
  /// @{

  /// \brief whether two ends are near each other, each is ahead of the other or beside that, and their axes pass each
  /// other nearby.
  bool do_meet(const End& a, const End& b) const
  {
    constexpr double near = 2, most_gap = 0.6;
    if(a.line == b.line && m_lines[std::size_t(a.line)].vertices.size() < 40)
      return false;
    const Vector way = b.position - a.position;
    if(way.norm() > near * (a.radius + b.radius) || !(do_face(a, b) || do_converge(a, b)))
      return false;
    const Vector across = a.direction.cross(b.direction);
    const double sine = across.norm();
    const double gap =
        sine > 0.2 ? std::abs(way.dot(across)) / sine : way.cross(a.direction).norm();
    return gap < most_gap * std::min(a.radius, b.radius) && is_reached(a, b);
  }

  static bool do_face(const End& a, const End& b)
  {
    constexpr double ahead = -0.3, most_cosine = 0.3;
    const Vector way = b.position - a.position;
    return a.direction.dot(b.direction) <= most_cosine &&
           way.dot(a.direction) >= ahead * a.radius && -way.dot(b.direction) >= ahead * b.radius;
  }

  /// \brief whether the axes of two ends that point the same way come together not far ahead.
  ///
  /// Tubes that meet at a small angle are one long before their axes meet.
  static bool do_converge(const End& a, const End& b)
  {
    constexpr double most_cosine = 0.85, furthest = 4;
    const Vector way = b.position - a.position;
    const double cosine = a.direction.dot(b.direction);
    if(cosine > most_cosine)
      return false;
    // Where on each axis the other is nearest.
    const double p = way.dot(a.direction), q = way.dot(b.direction), d = 1 - cosine * cosine;
    const double along_a = (p - cosine * q) / d, along_b = (cosine * p - q) / d;
    return along_a > 0 && along_a < furthest * a.radius && along_b > 0 &&
           along_b < furthest * b.radius;
  }

  /// whether there is a way from one end to the line of the other, inside the shape.
  static bool is_reached(const End& a, const End& b)
  {
    return std::any_of(a.arrivals.begin(), a.arrivals.end(),
                       [&](const auto& arrival) { return arrival.line == b.line; }) ||
           std::any_of(b.arrivals.begin(), b.arrivals.end(),
                       [&](const auto& arrival) { return arrival.line == a.line; });
  }

  void meet()
  {
    Disjoint_sets groups(m_ends.size());
    for(std::size_t a = 0; a < m_ends.size(); ++a)
      for(std::size_t b = a + 1; b < m_ends.size(); ++b)
        if(do_meet(m_ends[a], m_ends[b]))
          groups.unite(a, b);
    std::vector<std::vector<std::size_t>> members(m_ends.size());
    for(std::size_t e = 0; e < m_ends.size(); ++e)
      members[groups.find(e)].push_back(e);
    for(const std::vector<std::size_t>& group : members)
      if(group.size() == 2 && !is_line_between(m_ends[group[0]], m_ends[group[1]]))
        continue_line(m_ends[group[0]], m_ends[group[1]]);
      else if(group.size() > 2)
        make_node(group);
  }

  /// whether another line passes between two ends, to which they are joined then.
  bool is_line_between(const End& a, const End& b) const
  {
    constexpr double near = 0.6;
    // The middle of the curve that would join them.
    const Vector middle = 0.5 * (a.position + b.position) +
                          (b.position - a.position).norm() / 8 * (a.direction + b.direction);
    for(std::size_t l = 0; l < m_lines.size(); ++l)
      if(std::int32_t(l) != a.line && std::int32_t(l) != b.line)
        for(const Centerline_vertex& vertex : m_lines[l].vertices)
          if((to_eigen(vertex.point) - middle).norm() < near * vertex.radius)
            return true;
    return false;
  }

  void continue_line(End& a, End& b)
  {
    m_graph.add_curve(a.index, to_vector_3(a.direction), b.index, to_vector_3(-b.direction),
                      m_vertex_spacing);
    a.is_joined = b.is_joined = true;
    m_components.unite(std::size_t(a.line), std::size_t(b.line));
  }

  /// the place that the axes pass nearest.
  Vector meeting_place(const std::vector<std::size_t>& group) const
  {
    constexpr double ridge = 0.02;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vector right = Vector::Zero();
    for(const std::size_t e : group) {
      const End& end = m_ends[e];
      const Eigen::Matrix3d across =
          (1 + ridge) * Eigen::Matrix3d::Identity() - end.direction * end.direction.transpose();
      sum += across / (end.radius * end.radius);
      right += across * end.position / (end.radius * end.radius);
    }
    return solve_symmetric(sum, right);
  }

  void make_node(const std::vector<std::size_t>& group)
  {
    const Vector place = meeting_place(group);
    Centerline_vertex node;
    node.point = to_point_3(place);
    node.origin = Centerline_origin::BRIDGED;
    node.radius = 0;
    for(const std::size_t e : group)
      node.radius += m_ends[e].radius / double(group.size());
    const Index index = m_graph.add(node);
    for(const std::size_t e : group) {
      retreat(m_ends[e], place);
      connect_straight(m_ends[e], index);
      m_components.unite(std::size_t(m_ends[e].line), std::size_t(m_ends[group[0]].line));
    }
  }

  /// \brief lets a line end before a place that it has passed, so that it need not come back.
  ///
  /// More than half of a line remains.
  void retreat(End& end, const Vector& place)
  {
    const std::vector<Centerline_vertex>& vertices = m_lines[std::size_t(end.line)].vertices;
    const bool is_front = end.vertex == 0;
    for(std::size_t k = 1; 2 * k + 1 < vertices.size() && end.seen(place).first < 0; ++k) {
      end.vertex = is_front ? end.vertex + 1 : end.vertex - 1;
      const Centerline_vertex& vertex = vertices[end.vertex];
      const Index before = m_graph.first_of_line[std::size_t(end.line)] + end.vertex;
      m_graph.disconnect(end.index, before);
      end.index = before;
      end.position = to_eigen(vertex.point);
      end.direction = to_eigen(vertex.tangent) * (is_front ? -1 : 1);
      end.radius = vertex.radius;
    }
  }

  /// whether a line did not retreat from one of its vertices.
  bool is_left(std::int32_t line, std::size_t vertex) const
  {
    return m_graph.degree(m_graph.first_of_line[std::size_t(line)] + Index(vertex)) > 0;
  }

  /// the vertex of the graph where a line is, or ends now, near one of its vertices.
  Index nearest_left(std::int32_t line, std::size_t vertex) const
  {
    const std::size_t number = m_lines[std::size_t(line)].vertices.size();
    while(!is_left(line, vertex))
      vertex = 2 * vertex < number ? vertex + 1 : vertex - 1;
    return m_graph.first_of_line[std::size_t(line)] + Index(vertex);
  }

  void connect_straight(End& end, Index to)
  {
    const Vector way = to_eigen(m_graph.vertices[to].point) - end.position;
    const Vector_3 direction =
        to_vector_3(way.norm() > 0 ? Vector(way.normalized()) : end.direction);
    m_graph.add_curve(end.index, to_vector_3(end.direction), to, direction, m_vertex_spacing);
    end.is_joined = true;
  }
  /// @}

  /// \brief joins an end to the line that it points to, if that passes near.
  void go_straight(End& end)
  {
    constexpr double furthest = 3, most_gap = 0.6, before = -0.3;
    for(const Ball_graph::Arrival& arrival : end.arrivals) {
      const Draft_line& line = m_lines[std::size_t(arrival.line)];
      std::optional<std::size_t> best;
      double least = 0;
      for(std::size_t v = 0; v < line.vertices.size(); ++v) {
        const double r = std::max(line.vertices[v].radius, end.radius);
        const auto [ahead, gap] = end.seen(to_eigen(line.vertices[v].point));
        if(is_left(arrival.line, v) && ahead > before * end.radius && ahead < furthest * r &&
           gap < most_gap * r && (!best || gap < least)) {
          best = v;
          least = gap;
        }
      }
      if(!best)
        continue;
      connect_straight(end, m_graph.first_of_line[std::size_t(arrival.line)] + Index(*best));
      m_components.unite(std::size_t(end.line), std::size_t(arrival.line));
      return;
    }
  }

  /// \name Ways through balls
  /// @{

  void bridge()
  {
    bridge([](const End& end, const Ball_graph::Arrival&) { return !end.is_tip; });
  }

  /// \brief joins tips in which lines turn back, such as a knee: beyond it there is air, but a short way leads to
  /// another line, too.
  void join_tips()
  {
    bridge([this](const End& end, const Ball_graph::Arrival& arrival) {
      return end.is_tip && !is_beside(end, arrival.line);
    });
  }

  /// \brief whether another line passes beside the line of an end, seen from some radii before that.
  ///
  /// Two tubes that are fused along their side have ways between them wherever they are, and are two.
  bool is_beside(const End& end, std::int32_t other) const
  {
    constexpr double before = 4, near = 1.15;
    const std::vector<Centerline_vertex>& vertices = m_lines[std::size_t(end.line)].vertices;
    const auto distance_to_end = [&](const Centerline_vertex& vertex) {
      return (to_eigen(vertex.point) - end.position).norm();
    };
    std::size_t v = end.vertex;
    const std::size_t furthest = v == 0 ? vertices.size() - 1 : 0;
    while(v != furthest && distance_to_end(vertices[v]) < before * end.radius)
      v = v < furthest ? v + 1 : v - 1;
    return std::any_of(
        m_lines[std::size_t(other)].vertices.begin(), m_lines[std::size_t(other)].vertices.end(),
        [&](const Centerline_vertex& vertex) {
          return distance(vertex, vertices[v]) < near * (vertex.radius + vertices[v].radius);
        });
  }

  /// the cheapest first of the ways that are allowed, as long as they connect what is not connected.
  template <class IsAllowed>
  void bridge(const IsAllowed& is_allowed)
  {
    std::vector<std::tuple<double, std::size_t, std::size_t>> ways;
    for(std::size_t e = 0; e < m_ends.size(); ++e)
      for(std::size_t k = 0; k < m_ends[e].arrivals.size(); ++k)
        if(is_allowed(m_ends[e], m_ends[e].arrivals[k]))
          ways.emplace_back(m_ends[e].arrivals[k].cost, e, k);
    std::sort(ways.begin(), ways.end());
    for(const auto& [cost, e, k] : ways) {
      End& end = m_ends[e];
      const Ball_graph::Arrival& arrival = end.arrivals[k];
      if(end.is_joined || !m_components.unite(std::size_t(end.line), std::size_t(arrival.line)))
        continue;
      add_bridge(end, arrival);
    }
  }

  void add_bridge(End& end, const Ball_graph::Arrival& arrival)
  {
    constexpr int times = 10;
    std::vector<Vector> places;
    for(const std::uint32_t node : arrival.path)
      places.push_back(m_balls[node].position);
    for(int i = 0; i < times; ++i)
      for(std::size_t k = 1; k + 1 < places.size(); ++k)
        places[k] = 0.5 * places[k] + 0.25 * (places[k - 1] + places[k + 1]);
    const Index target = nearest_left(arrival.line, arrival.vertex);
    Index last = end.index;
    Vector direction = end.direction;
    for(std::size_t k = 1; k < places.size(); ++k) {
      Centerline_vertex vertex;
      vertex.point = to_point_3(places[k]);
      vertex.radius = m_balls[arrival.path[k]].radius;
      vertex.origin = Centerline_origin::BRIDGED;
      const bool is_last = k + 1 == places.size();
      const Index next = is_last ? target : m_graph.add(vertex);
      const Vector ahead =
          (places[std::min(k + 1, places.size() - 1)] - places[k - 1]).normalized();
      m_graph.vertices[next].tangent =
          is_last ? m_graph.vertices[next].tangent : to_vector_3(ahead);
      m_graph.add_curve(last, to_vector_3(direction), next, to_vector_3(ahead), m_vertex_spacing);
      last = next;
      direction = ahead;
    }
    end.is_joined = true;
  }
  /// @}

  const std::vector<Draft_line>& m_lines;
  const Ball_graph& m_balls;
  double m_vertex_spacing;
  Draft_graph m_graph;
  std::vector<End> m_ends;
  Disjoint_sets m_components;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_JOINER_H
