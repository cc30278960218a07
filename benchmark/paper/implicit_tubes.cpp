// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "implicit_tubes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace Paper {

namespace {

/// a piece of an axis.
struct Segment
{
  Point_3 a, b;
  double ra, rb;

  double parameter(const Point_3& p) const
  {
    const Vector_3 d = b - a;
    return std::clamp((p - a) * d / d.squared_length(), 0., 1.);
  }

  /// how far a point is from the surface of the piece, which has round ends; negative inside.
  double distance(const Point_3& p) const
  {
    const double t = parameter(p);
    return std::sqrt(CGAL::squared_distance(p, a + t * (b - a))) - (ra + t * (rb - ra));
  }
};

std::vector<Segment> segments(const std::vector<True_line>& lines)
{
  std::vector<Segment> all;
  for(const True_line& line : lines) {
    const std::size_t n = line.points.size();
    for(std::size_t i = 0; i + 1 < n + (line.is_closed ? 1 : 0); ++i) {
      const std::size_t j = (i + 1) % n;
      all.push_back({line.points[i], line.points[j], line.radii[i], line.radii[j]});
    }
  }
  return all;
}

/// distances at the points of a lattice, right where it is near the surface.
class Lattice
{
public:
  Lattice(const std::vector<Segment>& segments, double spacing) : m_spacing(spacing)
  {
    CGAL::Bbox_3 box;
    for(const Segment& s : segments) {
      const double r = std::max(s.ra, s.rb) + 3 * spacing;
      for(const Point_3& p : {s.a, s.b})
        box += CGAL::Bbox_3(p.x() - r, p.y() - r, p.z() - r, p.x() + r, p.y() + r, p.z() + r);
    }
    m_origin = Point_3(box.xmin() - 0.123 * spacing, box.ymin() - 0.456 * spacing,
                       box.zmin() - 0.789 * spacing);
    for(int axis = 0; axis < 3; ++axis)
      m_size[std::size_t(axis)] = int(std::ceil((box.max(axis) - m_origin[axis]) / spacing)) + 1;
    m_values.assign(std::size_t(m_size[0]) * std::size_t(m_size[1]) * std::size_t(m_size[2]),
                    3 * spacing);
    for(const Segment& s : segments)
      add(s);
  }

  const std::array<int, 3>& size() const { return m_size; }
  std::uint32_t index(int i, int j, int k) const
  {
    return std::uint32_t(i + m_size[0] * (j + m_size[1] * k));
  }
  double value(std::uint32_t index) const { return m_values[index]; }
  Point_3 point(std::uint32_t index) const
  {
    const int i = int(index) % m_size[0], j = int(index) / m_size[0] % m_size[1],
              k = int(index) / m_size[0] / m_size[1];
    return m_origin + m_spacing * Vector_3(i, j, k);
  }

private:
  void add(const Segment& s)
  {
    const double r = std::max(s.ra, s.rb) + 3 * m_spacing;
    std::array<int, 3> low, high;
    for(int axis = 0; axis < 3; ++axis) {
      const double from = std::min(s.a[axis], s.b[axis]), to = std::max(s.a[axis], s.b[axis]);
      const std::size_t x = std::size_t(axis);
      low[x] = std::max(0, int((from - r - m_origin[axis]) / m_spacing));
      high[x] = std::min(m_size[x] - 1, int((to + r - m_origin[axis]) / m_spacing) + 1);
    }
    for(int k = low[2]; k <= high[2]; ++k)
      for(int j = low[1]; j <= high[1]; ++j)
        for(int i = low[0]; i <= high[0]; ++i) {
          double& value = m_values[index(i, j, k)];
          value = std::min(value, s.distance(point(index(i, j, k))));
        }
  }

  double m_spacing;
  Point_3 m_origin;
  std::array<int, 3> m_size;
  std::vector<double> m_values;
};

/// the surface where the values of a lattice change sign, from six tetrahedra in each of its cells.
class Tetrahedra_walker
{
public:
  explicit Tetrahedra_walker(const Lattice& lattice) : m_lattice(lattice)
  {
    constexpr int paths[6][3] = {{1, 3, 7}, {1, 5, 7}, {2, 3, 7}, {2, 6, 7}, {4, 5, 7}, {4, 6, 7}};
    const auto& n = lattice.size();
    for(int k = 0; k + 1 < n[2]; ++k)
      for(int j = 0; j + 1 < n[1]; ++j)
        for(int i = 0; i + 1 < n[0]; ++i)
          for(const auto& path : paths) {
            std::array<std::uint32_t, 4> corners{lattice.index(i, j, k)};
            for(std::size_t c = 0; c < 3; ++c)
              corners[c + 1] =
                  lattice.index(i + (path[c] & 1), j + (path[c] >> 1 & 1), k + (path[c] >> 2 & 1));
            add_tetrahedron(corners);
          }
  }

  Soup soup;

private:
  void add_tetrahedron(const std::array<std::uint32_t, 4>& corners)
  {
    std::vector<std::uint32_t> in, out;
    for(const std::uint32_t c : corners)
      (m_lattice.value(c) < 0 ? in : out).push_back(c);
    if(in.empty() || out.empty())
      return;
    const Vector_3 outward = middle(out) - middle(in);
    if(in.size() == 2) {
      const std::uint32_t a = crossing(in[0], out[0]), b = crossing(in[0], out[1]),
                          c = crossing(in[1], out[1]), d = crossing(in[1], out[0]);
      add_triangle({a, b, c}, outward);
      add_triangle({a, c, d}, outward);
    } else {
      const bool one_in = in.size() == 1;
      const std::uint32_t apex = one_in ? in[0] : out[0];
      const std::vector<std::uint32_t>& base = one_in ? out : in;
      add_triangle({crossing(apex, base[0]), crossing(apex, base[1]), crossing(apex, base[2])},
                   outward);
    }
  }

  Point_3 middle(const std::vector<std::uint32_t>& corners) const
  {
    Vector_3 sum(0, 0, 0);
    for(const std::uint32_t c : corners)
      sum = sum + (m_lattice.point(c) - CGAL::ORIGIN);
    return CGAL::ORIGIN + sum / double(corners.size());
  }

  void add_triangle(Soup::Triangle t, const Vector_3& outward)
  {
    const Point_3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    if(CGAL::cross_product(b - a, c - a) * outward < 0)
      std::swap(t[1], t[2]);
    soup.triangles.push_back(t);
  }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b)
  {
    const auto [low, high] = std::minmax(a, b);
    const auto [place, is_new] =
        m_crossings.try_emplace(std::uint64_t(low) << 32 | high, std::uint32_t(soup.points.size()));
    if(is_new) {
      const double va = m_lattice.value(low), vb = m_lattice.value(high);
      const Point_3 p = m_lattice.point(low), q = m_lattice.point(high);
      soup.points.push_back(p + std::clamp(va / (va - vb), 0.02, 0.98) * (q - p));
    }
    return place->second;
  }

  const Lattice& m_lattice;
  std::unordered_map<std::uint64_t, std::uint32_t> m_crossings;
};

/// moves a point onto the surface, straight away from the axis that is nearest.
Point_3 projected(const std::vector<Segment>& segments, Point_3 p, int times)
{
  for(int i = 0; i < times; ++i) {
    const Segment* nearest = &segments.front();
    double least = std::numeric_limits<double>::max();
    for(const Segment& s : segments) {
      const double d = s.distance(p);
      if(d < least) {
        least = d;
        nearest = &s;
      }
    }
    const double t = nearest->parameter(p);
    const Point_3 foot = nearest->a + t * (nearest->b - nearest->a);
    const Vector_3 away = p - foot;
    const double radius = nearest->ra + t * (nearest->rb - nearest->ra);
    if(away.squared_length() > 0)
      p = foot + radius / std::sqrt(away.squared_length()) * away;
  }
  return p;
}

/// moves each vertex towards the middle of its neighbours, along the surface: tetrahedra leave slivers.
void even_out(Soup& soup, const std::vector<Segment>& segments)
{
  std::vector<Vector_3> sums(soup.points.size());
  std::vector<int> numbers(soup.points.size());
  constexpr int rounds = 6;
  for(int round = 1; round <= rounds; ++round) {
    std::fill(sums.begin(), sums.end(), Vector_3(0, 0, 0));
    std::fill(numbers.begin(), numbers.end(), 0);
    for(const auto& t : soup.triangles)
      for(std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = t[i], w = t[(i + 1) % 3];
        sums[v] = sums[v] + (soup.points[w] - soup.points[v]);
        ++numbers[v];
      }
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      if(numbers[v] > 0)
        soup.points[v] = projected(segments, soup.points[v] + 0.7 / numbers[v] * sums[v],
                                   round == rounds ? 6 : 1);
  }
}

} // namespace

Soup union_of_tubes(const std::vector<True_line>& lines, double spacing)
{
  const std::vector<Segment> all = segments(lines);
  const Lattice lattice(all, spacing);
  Soup soup = Tetrahedra_walker(lattice).soup;
  even_out(soup, all);
  return soup;
}

} // namespace Paper
