// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Paper {

namespace {

constexpr double pi = 3.14159265358979323846;

Point_3 on_sphere(const Point_3& p)
{
  const Vector_3 v = p - CGAL::ORIGIN;
  return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
}

Soup icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Soup soup{{{-1, g, 0},
             {1, g, 0},
             {-1, -g, 0},
             {1, -g, 0},
             {0, -1, g},
             {0, 1, g},
             {0, -1, -g},
             {0, 1, -g},
             {g, 0, -1},
             {g, 0, 1},
             {-g, 0, -1},
             {-g, 0, 1}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for(Point_3& p : soup.points)
    p = on_sphere(p);
  return soup;
}

/// divides each face into four, with the middles of the edges on the sphere.
Soup divided(const Soup& soup)
{
  Soup fine;
  fine.points = soup.points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] =
        middles.emplace(std::minmax(a, b), std::uint32_t(fine.points.size()));
    if(is_new)
      fine.points.push_back(on_sphere(CGAL::midpoint(soup.points[a], soup.points[b])));
    return place->second;
  };
  for(const auto& [a, b, c] : soup.triangles) {
    const std::uint32_t d = middle(a, b), e = middle(b, c), f = middle(c, a);
    for(const Soup::Triangle& t : {Soup::Triangle{a, d, f}, Soup::Triangle{d, b, e},
                                   Soup::Triangle{f, e, c}, Soup::Triangle{d, e, f}})
      fine.triangles.push_back(t);
  }
  return fine;
}

/// of what a closed surface encloses.
double volume(const Soup& soup)
{
  const Point_3 origin(0, 0, 0);
  double sum = 0;
  for(const auto& [a, b, c] : soup.triangles)
    sum += CGAL::volume(origin, soup.points[a], soup.points[b], soup.points[c]);
  return sum;
}

/// makes the walls of a box out of squares, with common points at the edges.
class Box_builder
{
public:
  Box_builder(const std::array<int, 3>& sides, double spacing) : m_sides(sides), m_spacing(spacing)
  {}

  void add_wall(int axis, bool is_far)
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<int, 3> p;
    p[axis] = is_far ? m_sides[axis] : 0;
    for(p[u] = 0; p[u] < m_sides[u]; ++p[u])
      for(p[v] = 0; p[v] < m_sides[v]; ++p[v])
        add_square(p, is_far ? u : v, is_far ? v : u);
  }

  const Soup& soup() const { return m_soup; }

private:
  void add_square(std::array<int, 3> p, int first, int second)
  {
    const std::uint32_t a = point(p);
    ++p[first];
    const std::uint32_t b = point(p);
    ++p[second];
    const std::uint32_t c = point(p);
    --p[first];
    const std::uint32_t d = point(p);
    m_soup.triangles.push_back({a, b, c});
    m_soup.triangles.push_back({a, c, d});
  }

  std::uint32_t point(const std::array<int, 3>& p)
  {
    const auto [place, is_new] = m_known.emplace(p, std::uint32_t(m_soup.points.size()));
    if(is_new)
      m_soup.points.emplace_back(m_spacing * p[0], m_spacing * p[1], m_spacing * p[2]);
    return place->second;
  }

  std::array<int, 3> m_sides;
  double m_spacing;
  Soup m_soup;
  std::map<std::array<int, 3>, std::uint32_t> m_known;
};

} // namespace

Soup icosphere(int levels)
{
  Soup soup = icosahedron();
  for(int level = 0; level < levels; ++level)
    soup = divided(soup);
  return soup;
}

Soup cylinder(double radius, double length, int sides, int rows)
{
  Soup soup;
  for(int row = 0; row <= rows; ++row)
    for(int side = 0; side < sides; ++side) {
      const double phi = 2 * pi * side / sides;
      soup.points.emplace_back(radius * std::cos(phi), radius * std::sin(phi),
                               length * (double(row) / rows - 0.5));
    }
  const std::uint32_t low = std::uint32_t(soup.points.size()), high = low + 1;
  soup.points.emplace_back(0, 0, -0.5 * length);
  soup.points.emplace_back(0, 0, 0.5 * length);
  const auto index = [&](int row, int side) { return std::uint32_t(row * sides + side % sides); };
  for(int side = 0; side < sides; ++side) {
    for(int row = 0; row < rows; ++row) {
      const std::uint32_t a = index(row, side), b = index(row, side + 1),
                          c = index(row + 1, side + 1), d = index(row + 1, side);
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
    soup.triangles.push_back({low, index(0, side + 1), index(0, side)});
    soup.triangles.push_back({high, index(rows, side), index(rows, side + 1)});
  }
  return soup;
}

Soup joined(Soup a, const Soup& b)
{
  const std::uint32_t offset = std::uint32_t(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const Soup::Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

std::vector<Vector_3> even_directions(std::size_t number)
{
  const double turn = pi * (3 - std::sqrt(5.)); // the golden angle
  std::vector<Vector_3> directions;
  for(std::size_t i = 0; i < number; ++i) {
    const double z = 1 - (2 * double(i) + 1) / double(number), r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(turn * double(i)), r * std::sin(turn * double(i)), z);
  }
  return directions;
}

double Bumps::width() const
{
  return 1.9 / std::sqrt(double(number));
}

Bumpy_sphere bumpy_sphere(const Bumps& bumps, int levels)
{
  const std::vector<Vector_3> centres = even_directions(bumps.number);
  const double width = bumps.width();
  Soup soup = icosphere(levels);
  for(Point_3& p : soup.points) {
    const Vector_3 direction = p - CGAL::ORIGIN;
    double nearest = -1; // as a cosine
    for(const Vector_3& centre : centres)
      nearest = std::max(nearest, direction * centre);
    const double angle = std::acos(std::min(nearest, 1.));
    const double height = std::sqrt(std::max(width * width - angle * angle, 0.));
    p = p + bumps.amplitude * height * direction;
  }
  const double radius = 1 / std::cbrt(volume(soup) / (4. / 3 * pi));
  for(Point_3& p : soup.points)
    p = CGAL::ORIGIN + radius * (p - CGAL::ORIGIN);
  return {std::move(soup), radius};
}

Soup box(const std::array<int, 3>& sides, double spacing)
{
  Box_builder builder(sides, spacing);
  for(int axis = 0; axis < 3; ++axis)
    for(bool is_far : {false, true})
      builder.add_wall(axis, is_far);
  return builder.soup();
}

} // namespace Paper
