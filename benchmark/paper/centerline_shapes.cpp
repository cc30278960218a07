// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "centerline_shapes.h"

#include "implicit_tubes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace Paper {

namespace {

constexpr double pi = 3.14159265358979323846;

Vector_3 normalized(const Vector_3& v)
{
  return v / std::sqrt(v.squared_length());
}

enum class Cap { ROUND, FLAT, OPEN };

/// how a line becomes a surface.
struct Sweep
{
  int sides = 32;
  double elongation = 1; ///< of the quadrangles, along the axis
  Cap cap = Cap::ROUND;
  double aspect = 1; ///< of the semi-axes, whose product is the square of the radius
};

/// a curve over [0, 1], sampled finely.
template <class Curve, class Radius>
True_line sampled(Curve&& curve, Radius&& radius, int pieces, bool is_closed = false)
{
  True_line line;
  line.is_closed = is_closed;
  for(int i = 0; i < pieces + (is_closed ? 0 : 1); ++i) {
    const double t = double(i) / pieces;
    line.points.push_back(curve(t));
    line.radii.push_back(radius(t));
  }
  return line;
}

True_line straight(const Point_3& a, const Point_3& b, double ra = 1, double rb = 1)
{
  return sampled([&](double t) { return a + t * (b - a); },
                 [&](double t) { return ra + t * (rb - ra); }, 60);
}

/// makes rings of points around a line.
class Sweeper
{
public:
  Sweeper(const True_line& line, const Sweep& sweep) : m_line(line), m_sweep(sweep)
  {
    set_frames();
    add_rings();
    if(!line.is_closed && sweep.cap != Cap::OPEN) {
      add_cap(0, false);
      add_cap(m_line.points.size() - 1, true);
    }
  }

  const Soup& soup() const { return m_soup; }

private:
  struct Frame
  {
    Vector_3 along, x, y;
  };

  Vector_3 tangent(std::size_t i) const
  {
    const std::size_t n = m_line.points.size();
    if(m_line.is_closed)
      return normalized(m_line.points[(i + 1) % n] - m_line.points[(i + n - 1) % n]);
    if(i > 0 && i + 1 < n)
      return normalized(m_line.points[i + 1] - m_line.points[i - 1]);
    // A parabola through the last three points.
    const auto& p = m_line.points;
    return i == 0 ? normalized(4 * (p[1] - p[0]) - (p[2] - p[0]))
                  : normalized(4 * (p[n - 1] - p[n - 2]) - (p[n - 1] - p[n - 3]));
  }

  void set_frames()
  {
    const std::size_t n = m_line.points.size();
    Vector_3 x(0.3, 0.5, 0.7);
    for(std::size_t i = 0; i < n; ++i) {
      const Vector_3 t = tangent(i);
      x = normalized(x - (x * t) * t);
      m_frames.push_back({t, x, CGAL::cross_product(t, x)});
    }
    if(!m_line.is_closed)
      return;
    // What is left over after a turn is shared out.
    const Vector_3 t = m_frames.front().along, last = normalized(x - (x * t) * t);
    const double twist = std::atan2(last * m_frames.front().y, last * m_frames.front().x);
    for(std::size_t i = 0; i < n; ++i) {
      const double a = -twist * double(i) / double(n);
      const Frame f = m_frames[i];
      m_frames[i].x = std::cos(a) * f.x + std::sin(a) * f.y;
      m_frames[i].y = CGAL::cross_product(f.along, m_frames[i].x);
    }
  }

  std::vector<std::uint32_t> ring(std::size_t i, double fraction, double ahead)
  {
    std::vector<std::uint32_t> ring;
    const double r = fraction * m_line.radii[i], root = std::sqrt(m_sweep.aspect);
    for(int k = 0; k < m_sweep.sides; ++k) {
      const double a = 2 * pi * k / m_sweep.sides;
      ring.push_back(std::uint32_t(m_soup.points.size()));
      m_soup.points.push_back(m_line.points[i] + ahead * m_frames[i].along +
                              r * root * std::cos(a) * m_frames[i].x +
                              r / root * std::sin(a) * m_frames[i].y);
    }
    return ring;
  }

  void join(const std::vector<std::uint32_t>& back, const std::vector<std::uint32_t>& front)
  {
    const std::size_t n = back.size();
    for(std::size_t k = 0; k < n; ++k) {
      const std::size_t l = (k + 1) % n;
      m_soup.triangles.push_back({back[k], back[l], front[l]});
      m_soup.triangles.push_back({back[k], front[l], front[k]});
    }
  }

  /// rings at points of the line that are as far apart as the sides are wide.
  void add_rings()
  {
    const std::size_t n = m_line.points.size();
    double gone = 0;
    m_first = ring(0, 1, 0);
    m_last = m_first;
    for(std::size_t i = 1; i < n; ++i) {
      gone += std::sqrt(CGAL::squared_distance(m_line.points[i - 1], m_line.points[i]));
      const double wanted = m_sweep.elongation * 2 * pi * m_line.radii[i] / m_sweep.sides;
      const bool is_step = std::abs(m_line.radii[i] - m_line.radii[i - 1]) > 0.02;
      if(gone < wanted && i + 1 < n && !is_step)
        continue;
      std::vector<std::uint32_t> next = ring(i, 1, 0);
      join(m_last, next);
      m_last = std::move(next);
      gone = 0;
    }
    if(m_line.is_closed)
      join(m_last, m_first);
  }

  void add_cap(std::size_t i, bool is_ahead)
  {
    std::vector<std::uint32_t> outer = is_ahead ? m_last : m_first;
    const int rings = std::max(2, m_sweep.sides / 4);
    const double sign = is_ahead ? 1 : -1;
    for(int k = 1; k < rings; ++k) {
      const double a = pi / 2 * k / rings;
      std::vector<std::uint32_t> inner =
          m_sweep.cap == Cap::ROUND ? ring(i, std::cos(a), sign * std::sin(a) * m_line.radii[i])
                                    : ring(i, 1 - double(k) / rings, 0);
      is_ahead ? join(outer, inner) : join(inner, outer);
      outer = std::move(inner);
    }
    const std::uint32_t top = std::uint32_t(m_soup.points.size());
    const double ahead = m_sweep.cap == Cap::ROUND ? sign * m_line.radii[i] : 0;
    m_soup.points.push_back(m_line.points[i] + ahead * m_frames[i].along);
    for(std::size_t k = 0; k < outer.size(); ++k) {
      const std::uint32_t a = outer[k], b = outer[(k + 1) % outer.size()];
      m_soup.triangles.push_back(is_ahead ? Soup::Triangle{a, b, top} : Soup::Triangle{b, a, top});
    }
  }

  True_line m_line;
  Sweep m_sweep;
  std::vector<Frame> m_frames;
  std::vector<std::uint32_t> m_first, m_last;
  Soup m_soup;
};

Centerline_shape swept(const std::string& name, True_line line, const Sweep& sweep = {})
{
  Centerline_shape shape;
  shape.name = name;
  shape.soup = Sweeper(line, sweep).soup();
  if(!line.is_closed && sweep.cap == Cap::ROUND)
    line.beyond = {{line.radii.front(), line.radii.back()}};
  shape.leaves = line.is_closed ? 0 : 2;
  shape.cycles = line.is_closed ? 1 : 0;
  shape.is_closed = sweep.cap != Cap::OPEN || line.is_closed;
  shape.lines = {std::move(line)};
  return shape;
}

/// the free ends of lines have caps, those that meet have none.
void set_caps(std::vector<True_line>& lines)
{
  std::map<Point_3, int> ends;
  for(const True_line& line : lines)
    for(const Point_3& p : {line.points.front(), line.points.back()})
      ++ends[p];
  for(True_line& line : lines) {
    line.beyond[0] = ends[line.points.front()] == 1 ? line.radii.front() : 0;
    line.beyond[1] = ends[line.points.back()] == 1 ? line.radii.back() : 0;
  }
}

Centerline_shape united(const std::string& name, std::vector<True_line> lines, double spacing = 0.3)
{
  Centerline_shape shape;
  shape.name = name;
  shape.soup = union_of_tubes(lines, spacing);
  set_caps(lines);
  for(const True_line& line : lines)
    shape.leaves += (line.beyond[0] > 0 ? 1 : 0) + (line.beyond[1] > 0 ? 1 : 0);
  shape.lines = std::move(lines);
  return shape;
}

True_line arc(double bend_radius, double angle)
{
  return sampled(
      [=](double t) {
        const double a = angle * t;
        return Point_3(bend_radius * std::cos(a), bend_radius * std::sin(a), 0);
      },
      [](double) { return 1.; }, 240);
}

constexpr auto unit_radius = [](double) { return 1.; };

True_line helix()
{
  return sampled(
      [](double t) {
        const double a = 2 * pi * 2.5 * t;
        return Point_3(4 * std::cos(a), 4 * std::sin(a), 9 * t);
      },
      unit_radius, 1600);
}

True_line knot()
{
  return sampled(
      [](double t) {
        const double a = 2 * pi * t;
        return Point_3(3 * (std::sin(a) + 2 * std::sin(2 * a)),
                       3 * (std::cos(a) - 2 * std::cos(2 * a)), -3 * std::sin(3 * a));
      },
      unit_radius, 2000, true);
}

True_line ring(double radius)
{
  return sampled(
      [=](double t) {
        return Point_3(radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t), 0);
      },
      unit_radius, 400, true);
}

std::vector<True_line> star(const std::vector<Point_3>& ends)
{
  std::vector<True_line> lines;
  for(const Point_3& end : ends)
    lines.push_back(straight(Point_3(0, 0, 0), end));
  return lines;
}

/// a body along x, and an arm that comes down to it and then lies on it, sunk in a little.
std::vector<True_line> body_and_arm()
{
  const double away = 2.4; // radii 2 and 0.6: sunk in by 0.2
  const True_line body = straight(Point_3(-8, 0, 0), Point_3(8, 0, 0), 2, 2);
  const double bend = 3, angle = pi / 4;
  const auto curve = [=](double t) {
    const double lying = 6, turning = bend * angle, raised = 4, s = t * (lying + turning + raised);
    if(s < lying)
      return Point_3(-5 + s, away, 0);
    const double a = std::min((s - lying) / bend, angle), rest = std::max(s - lying - turning, 0.);
    return Point_3(1 + bend * std::sin(a) + rest * std::cos(angle),
                   away + bend * (1 - std::cos(a)) + rest * std::sin(angle), 0);
  };
  return {body, sampled(
                    curve, [](double) { return 0.6; }, 300)};
}

/// a square with a diagonal and two free ends, of tubes of radius 1.
std::vector<True_line> network()
{
  const std::array<Point_3, 4> p{
      {Point_3(0, 0, 0), Point_3(12, 0, 1), Point_3(12, 12, 0), Point_3(0, 12, -1)}};
  std::vector<True_line> lines;
  for(std::size_t i = 0; i < 4; ++i)
    lines.push_back(straight(p[i], p[(i + 1) % 4]));
  lines.push_back(straight(p[0], p[2]));
  lines.push_back(straight(p[1], Point_3(20, -5, 3)));
  lines.push_back(straight(p[3], Point_3(-8, 17, -3)));
  return lines;
}

Centerline_shape hard(Centerline_shape shape)
{
  shape.is_hard = true;
  return shape;
}

} // namespace

std::vector<Centerline_shape> centerline_shapes()
{
  const True_line line = straight(Point_3(0, 0, 0), Point_3(12, 3, 2));
  std::vector<Centerline_shape> shapes;
  shapes.push_back(swept("straight", line));
  shapes.push_back(swept("flat caps", line, {32, 1, Cap::FLAT}));
  shapes.push_back(swept("open", line, {32, 1, Cap::OPEN}));
  shapes.push_back(swept("bent", arc(3.3, 0.9 * pi), {32}));
  shapes.push_back(swept("helix", helix(), {24}));
  shapes.push_back(swept("torus", ring(4)));
  shapes.push_back(swept("knot", knot(), {24}));
  shapes.push_back(swept("taper", straight(Point_3(0, 0, 0), Point_3(14, 0, 0), 1, 0.3)));
  shapes.push_back(united("Y", star({Point_3(-8, 0, 0), Point_3(6, 5, 1), Point_3(6, -5, 0.5)})));
  shapes.push_back(swept("touching", straight(Point_3(0, 0, 0), Point_3(12, 0, 0))));
  const Centerline_shape other = swept("", straight(Point_3(1, 2, 0), Point_3(13, 2, 0)));
  Centerline_shape& pair = shapes.back();
  for(const auto& t : other.soup.triangles) {
    const std::uint32_t n = std::uint32_t(pair.soup.points.size());
    pair.soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  pair.soup.points.insert(pair.soup.points.end(), other.soup.points.begin(),
                          other.soup.points.end());
  pair.lines.push_back(other.lines.front());
  pair.leaves = 4;
  pair.components = 2;
  shapes.push_back(united("merged", {straight(Point_3(0, 0, 0), Point_3(12, 0, 0)),
                                     straight(Point_3(1, 1.86, 0), Point_3(13, 1.86, 0))}));
  shapes.back().components = 2;
  shapes.push_back(united("body and arm", body_and_arm(), 0.24));
  shapes.back().components = 2;
  return shapes;
}

std::vector<Centerline_shape> hard_centerline_shapes()
{
  const True_line line = straight(Point_3(0, 0, 0), Point_3(12, 3, 2));
  std::vector<Centerline_shape> shapes;
  shapes.push_back(hard(
      swept("cone 1:5", straight(Point_3(0, 0, 0), Point_3(9, 0, 0), 2, 0.2), {40, 1, Cap::FLAT})));
  shapes.push_back(hard(swept("cone 1:3", straight(Point_3(0, 0, 0), Point_3(6, 0, 0), 2.2, 0.2),
                              {40, 1, Cap::FLAT})));
  shapes.push_back(hard(united("crossing", star({Point_3(-7, 0, 0), Point_3(7, 0, 0),
                                                 Point_3(0.5, 7, 0), Point_3(-0.5, -7, 0)}))));
  shapes.push_back(hard(united("network", network())));
  shapes.back().cycles = 2;
  shapes.push_back(hard(swept("10 sides", line, {10, 1, Cap::FLAT})));
  shapes.push_back(hard(swept("10 sides, long", line, {10, 6, Cap::FLAT})));
  shapes.push_back(hard(swept("10 sides, bent", arc(5, 0.8 * pi), {10, 1, Cap::FLAT})));
  shapes.push_back(hard(swept("ellipse 1:1.5", line, {40, 1, Cap::FLAT, 1.5})));
  shapes.push_back(hard(swept("ellipse 1:2", line, {40, 1, Cap::FLAT, 2})));
  True_line bent = arc(5, 0.8 * pi);
  shapes.push_back(hard(swept("ellipse, bent", bent, {40, 1, Cap::FLAT, 1.6})));
  const auto steps = [](double t) { return t < 1. / 3 ? 1 : t < 2. / 3 ? 0.75 : 0.55; };
  shapes.push_back(hard(swept("steps", sampled([](double t) { return Point_3(18 * t, 0, 0); },
                                               [&](double t) { return steps(t); }, 1800))));
  return shapes;
}

Soup add_local_noise(const Soup& soup, double ratio, std::uint64_t seed)
{
  std::vector<double> lengths(soup.points.size(), 0), numbers(soup.points.size(), 0);
  for(const auto& t : soup.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      for(const std::uint32_t v : {t[i], t[(i + 1) % 3]}) {
        lengths[v] +=
            std::sqrt(CGAL::squared_distance(soup.points[t[i]], soup.points[t[(i + 1) % 3]]));
        numbers[v] += 1;
      }
  Random random(seed);
  Soup noisy = soup;
  for(std::size_t v = 0; v < noisy.points.size(); ++v) {
    Vector_3 offset;
    do
      offset =
          Vector_3(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    while(offset.squared_length() > 1);
    if(numbers[v] > 0)
      noisy.points[v] = noisy.points[v] + ratio * lengths[v] / numbers[v] * offset;
  }
  return noisy;
}

} // namespace Paper
