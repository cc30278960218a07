// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "centerline_score.h"

#include <CGAL/Iterator_range.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Paper {

namespace {

namespace AP = CGAL::Area_projection;

/// a place on an axis, or straight on from its end.
struct Foot
{
  double distance = std::numeric_limits<double>::max();
  double radius = 1;
  bool is_beyond = false;
};

void improve(Foot& foot, const Point_3& p, const Point_3& a, const Point_3& b, double ra, double rb,
             bool is_beyond)
{
  const Vector_3 d = b - a;
  const double length = d.squared_length();
  const double t = length > 0 ? std::clamp((p - a) * d / length, 0., 1.) : 0;
  const double distance = std::sqrt(CGAL::squared_distance(p, a + t * d));
  // At an end it is beside the axis or beyond it, whichever is nearer.
  if(distance < foot.distance)
    foot = {distance, ra + t * (rb - ra), is_beyond};
}

Point_3 beyond(const Point_3& end, const Point_3& before, double length)
{
  const Vector_3 d = end - before;
  return end + length / std::sqrt(d.squared_length()) * d;
}

Foot nearest(const std::vector<True_line>& lines, const Point_3& p)
{
  Foot foot;
  for(const True_line& line : lines) {
    const std::size_t n = line.points.size();
    for(std::size_t i = 0; i + 1 < n + (line.is_closed ? 1 : 0); ++i) {
      const std::size_t j = (i + 1) % n;
      improve(foot, p, line.points[i], line.points[j], line.radii[i], line.radii[j], false);
    }
    if(line.beyond[0] > 0)
      improve(foot, p, line.points[0], beyond(line.points[0], line.points[1], line.beyond[0]),
              line.radii[0], line.radii[0], true);
    if(line.beyond[1] > 0)
      improve(foot, p, line.points[n - 1],
              beyond(line.points[n - 1], line.points[n - 2], line.beyond[1]), line.radii[n - 1],
              line.radii[n - 1], true);
  }
  return foot;
}

/// sums over the lines, weighed by length.
class Distances
{
public:
  Distances(const Centerline_shape& shape, const AP::Centerline_graph& graph)
      : m_shape(shape), m_graph(graph)
  {
    for(const auto e : CGAL::make_range(edges(graph)))
      add(graph[source(e, graph)], graph[target(e, graph)]);
  }

  void write(Centerline_score& score) const
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    score.body = m_body_length > 0 ? m_body / m_body_length : nan;
    score.all = m_all_length > 0 ? m_all / m_all_length : nan;
    score.furthest = m_furthest;
    score.radius = m_radius_length > 0 ? m_radius / m_radius_length : nan;
    score.coverage = coverage();
  }

private:
  static constexpr double near = 0.2; // in units of the radius

  void add(const AP::Centerline_vertex& a, const AP::Centerline_vertex& b)
  {
    const double length = std::sqrt(CGAL::squared_distance(a.point, b.point));
    const double step = 0.02;
    const int pieces = std::max(1, int(std::ceil(length / step)));
    for(int i = 0; i < pieces; ++i) {
      const double t = (i + 0.5) / pieces, part = length / pieces;
      const Point_3 p = a.point + t * (b.point - a.point);
      const Foot foot = nearest(m_shape.lines, p);
      const double distance = foot.distance / foot.radius;
      m_samples.push_back(p);
      m_all += part * distance;
      m_all_length += part;
      m_furthest = std::max(m_furthest, distance);
      if(foot.is_beyond)
        continue;
      m_body += part * distance;
      m_body_length += part;
      const double radius = a.radius + t * (b.radius - a.radius);
      if(a.origin == AP::Centerline_origin::FITTED && b.origin == AP::Centerline_origin::FITTED &&
         std::isfinite(radius)) {
        m_radius += part * std::abs(radius - foot.radius) / foot.radius;
        m_radius_length += part;
      }
    }
  }

  double coverage() const
  {
    double covered = 0, whole = 0;
    for(const True_line& line : m_shape.lines) {
      const std::size_t n = line.points.size();
      for(std::size_t i = 0; i + 1 < n + (line.is_closed ? 1 : 0); ++i) {
        const Point_3 &a = line.points[i], &b = line.points[(i + 1) % n];
        const double length = std::sqrt(CGAL::squared_distance(a, b));
        const Point_3 middle = CGAL::midpoint(a, b);
        const double reach = near * line.radii[i];
        whole += length;
        if(std::any_of(m_samples.begin(), m_samples.end(), [&](const Point_3& p) {
             return CGAL::squared_distance(p, middle) < reach * reach;
           }))
          covered += length;
      }
    }
    return covered / whole;
  }

  const Centerline_shape& m_shape;
  const AP::Centerline_graph& m_graph;
  std::vector<Point_3> m_samples;
  double m_body = 0, m_body_length = 0, m_all = 0, m_all_length = 0, m_furthest = 0, m_radius = 0,
         m_radius_length = 0;
};

} // namespace

Centerline_score score(const Centerline_shape& shape, const AP::Centerline_graph& graph)
{
  Centerline_score score;
  Distances(shape, graph).write(score);
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) == 1)
      ++score.leaves;
  std::vector<int> component(num_vertices(graph));
  if(!component.empty())
    score.components = std::size_t(boost::connected_components(
        graph,
        boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph))));
  score.cycles = num_edges(graph) + score.components - num_vertices(graph);
  return score;
}

} // namespace Paper
