// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_topology.h"

#include <CGAL/Area_projection_transform/internal/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace mapt {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

using CGAL::Area_projection::internal::Disjoint_sets;

// One side of a triangle, filed under its vertex of smaller index.
struct Side
{
  std::uint32_t other; // its vertex of larger index
  std::uint32_t triangle;
  bool is_ascending; // whether the triangle runs from the smaller to the larger
};

// Sides sorted by their two vertices: `m_begin[v]` is the first of vertex v.
class Sides
{
public:
  Sides(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& joined)
      : m_begin(joined.size() + 1, 0)
  {
    for_each(triangles, joined, [this](std::uint32_t low, const Side&) { ++m_begin[low + 1]; });
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_sides.resize(m_begin.back());
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for_each(triangles, joined,
             [&](std::uint32_t low, const Side& side) { m_sides[next[low]++] = side; });
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v)
      std::sort(m_sides.begin() + std::ptrdiff_t(m_begin[v]),
                m_sides.begin() + std::ptrdiff_t(m_begin[v + 1]), [](const Side& a, const Side& b) {
                  return std::pair(a.other, a.triangle) < std::pair(b.other, b.triangle);
                });
  }

  // calls `visit(vertex, first, last)` for each edge with the range of its sides.
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v)
      for(std::size_t i = m_begin[v]; i < m_begin[v + 1];) {
        std::size_t end = i + 1;
        while(end < m_begin[v + 1] && m_sides[end].other == m_sides[i].other)
          ++end;
        visit(std::uint32_t(v), m_sides.data() + i, m_sides.data() + end);
        i = end;
      }
  }

private:
  template <class Visit>
  static void for_each(const std::vector<Triangle>& triangles,
                       const std::vector<std::uint32_t>& joined, const Visit& visit)
  {
    for(std::size_t t = 0; t < triangles.size(); ++t) {
      for(std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = joined[triangles[t][i]];
        const std::uint32_t to = joined[triangles[t][(i + 1) % 3]];
        visit(std::min(from, to), Side{std::max(from, to), std::uint32_t(t), from < to});
      }
    }
  }

  std::vector<std::size_t> m_begin;
  std::vector<Side> m_sides;
};

struct Boundary_edge
{
  std::uint32_t from; // as its triangle runs
  std::uint32_t to;
  std::uint32_t triangle;
};

// Adds to the volumes the cones that close each hole from its centre of gravity: then the volume
// does not depend on the origin, and its sign tells which way an open piece looks.
std::size_t close_holes(const std::vector<Point_3>& points, const Point_3& origin,
                        const std::vector<Boundary_edge>& edges, Mesh_topology& topology)
{
  Disjoint_sets holes(points.size());
  for(const Boundary_edge& e : edges)
    holes.unite(e.from, e.to);
  std::vector<Vector_3> sum(points.size(), Vector_3(0, 0, 0));
  std::vector<double> count(points.size(), 0);
  for(const Boundary_edge& e : edges) {
    const std::size_t hole = holes.find(e.from);
    sum[hole] = sum[hole] + (points[e.from] - origin) + (points[e.to] - origin);
    count[hole] += 2;
  }
  for(const Boundary_edge& e : edges) {
    const std::size_t hole = holes.find(e.from);
    Mesh_topology::Component& component = topology.components[topology.component[e.triangle]];
    const Vector_3 a = points[e.to] - origin, b = points[e.from] - origin;
    const Vector_3 centre = sum[hole] / count[hole];
    component.volume += CGAL::determinant(a, b, centre) / 6;
    component.hole_area += std::sqrt(CGAL::cross_product(b - a, centre - a).squared_length()) / 2;
  }
  return std::size_t(std::count_if(count.begin(), count.end(), [](double n) { return n > 0; }));
}

// Numbers the components in the order of their first triangles.
void find_components(const std::vector<Triangle>& triangles, const Sides& sides,
                     Mesh_topology& topology)
{
  Disjoint_sets pieces(triangles.size());
  sides.for_each_edge([&](std::uint32_t, const Side* first, const Side* last) {
    for(const Side* side = first + 1; side < last; ++side)
      pieces.unite(first->triangle, side->triangle);
  });
  topology.component.assign(triangles.size(), none);
  for(std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::size_t root = pieces.find(t); // the smallest of its set
    if(root == t) {
      topology.component[t] = std::uint32_t(topology.components.size());
      topology.components.emplace_back();
    }
    topology.component[t] = topology.component[root];
  }
}

Boundary_edge boundary_edge(std::uint32_t low, const Side& side)
{
  return side.is_ascending ? Boundary_edge{low, side.other, side.triangle}
                           : Boundary_edge{side.other, low, side.triangle};
}

std::vector<Boundary_edge> count_edges(const Sides& sides, Mesh_topology& topology)
{
  std::vector<Boundary_edge> boundary;
  sides.for_each_edge([&](std::uint32_t low, const Side* first, const Side* last) {
    const auto degree = std::size_t(last - first);
    const auto ascending =
        std::size_t(std::count_if(first, last, [](const Side& side) { return side.is_ascending; }));
    Mesh_topology::Component& component = topology.components[topology.component[first->triangle]];
    topology.nonmanifold_edges += degree > 2 ? 1 : 0;
    --topology.euler_characteristic;
    const bool is_balanced = 2 * ascending == degree;
    // Two triangles that disagree may be turned over; more are copies of a face as likely as not.
    if(degree % 2 == 1 || (degree > 2 && !is_balanced))
      component.is_closed = false;
    if(degree % 2 == 0 && !is_balanced) {
      ++topology.inconsistent_edges;
      component.is_consistently_oriented = false;
    }
    if(degree == 1)
      boundary.push_back(boundary_edge(low, *first));
  });
  topology.boundary_edges = boundary.size();
  return boundary;
}

// A vertex that two components share is counted in both.
void count_vertices(const std::vector<std::uint32_t>& joined,
                    const std::vector<Triangle>& triangles, Mesh_topology& topology)
{
  std::vector<std::uint32_t> by_component(triangles.size());
  std::iota(by_component.begin(), by_component.end(), 0u);
  if(topology.components.size() > 1)
    std::stable_sort(by_component.begin(), by_component.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       return topology.component[a] < topology.component[b];
                     });
  std::vector<std::uint32_t> last_component(joined.size(), none);
  std::vector<bool> is_used(joined.size(), false);
  for(const std::uint32_t t : by_component)
    for(const std::uint32_t point : triangles[t]) {
      is_used[point] = true;
      std::uint32_t& last = last_component[joined[point]];
      if(last != topology.component[t])
        ++topology.euler_characteristic;
      last = topology.component[t];
    }
  topology.unused_vertices = std::size_t(std::count(is_used.begin(), is_used.end(), false));
}

void measure(const std::vector<Point_3>& points, const Point_3& origin,
             const std::vector<Triangle>& triangles, Mesh_topology& topology)
{
  for(std::size_t t = 0; t < triangles.size(); ++t) {
    Mesh_topology::Component& component = topology.components[topology.component[t]];
    const Vector_3 a = points[triangles[t][0]] - origin;
    const Vector_3 b = points[triangles[t][1]] - origin;
    const Vector_3 c = points[triangles[t][2]] - origin;
    component.volume += CGAL::determinant(a, b, c) / 6;
    component.area += std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
    for(const std::uint32_t v : triangles[t])
      component.box += points[v].bbox();
  }
}

} // namespace

std::vector<std::uint32_t> join_equal_points(const std::vector<Point_3>& points)
{
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&points](std::uint32_t a, std::uint32_t b) {
    const int by_position = CGAL::compare_lexicographically(points[a], points[b]);
    return by_position != 0 ? by_position < 0 : a < b;
  });
  std::vector<std::uint32_t> joined(points.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    joined[order[i]] =
        i > 0 && points[order[i]] == points[order[i - 1]] ? joined[order[i - 1]] : order[i];
  return joined;
}

Mesh_topology analyse(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& joined,
                      const std::vector<Triangle>& triangles)
{
  Mesh_topology topology;
  const Sides sides(triangles, joined);
  find_components(triangles, sides, topology);
  const std::vector<Boundary_edge> boundary = count_edges(sides, topology);
  count_vertices(joined, triangles, topology);
  topology.euler_characteristic += (long long)(triangles.size());

  // volumes are summed about a point of the shape, or a distant shape would lose all digits
  const Point_3 origin = triangles.empty() ? Point_3(CGAL::ORIGIN) : points[triangles[0][0]];
  measure(points, origin, triangles, topology);
  topology.holes = close_holes(points, origin, boundary, topology);
  return topology;
}

std::vector<std::array<std::uint32_t, 2>> boundary_edges(const std::vector<std::uint32_t>& joined,
                                                         const std::vector<Triangle>& triangles)
{
  std::vector<std::array<std::uint32_t, 2>> edges;
  Sides(triangles, joined)
      .for_each_edge([&](std::uint32_t low, const Side* first, const Side* last) {
        if(last - first == 1) {
          const Boundary_edge edge = boundary_edge(low, *first);
          edges.push_back({edge.from, edge.to});
        }
      });
  return edges;
}

} // namespace mapt
