// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "labelled_shapes.h"

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Paper {

namespace {

constexpr double pi = 3.14159265358979323846;

Vector_3 normalized(const Vector_3& v)
{
  return v / std::sqrt(v.squared_length());
}

/// the cross-section of a tube at a place of its axis: circles around it wind from `across[0]` to
/// `across[1]`, counterclockwise as seen from where the axis goes.
struct Section
{
  Point_3 center;
  std::array<Vector_3, 2> across;
  double radius;

  Point_3 at(double fraction_of_radius, double turns) const
  {
    const double a = 2 * pi * turns, r = fraction_of_radius * radius;
    return center + r * std::cos(a) * across[0] + r * std::sin(a) * across[1];
  }
};

Section section(const Tube& tube, double along)
{
  const double angle = along * tube.curvature;
  // from the middle of the arc, without loss of digits where there is hardly a bend
  const double bend = tube.curvature == 0 ? 0. : (1 - std::cos(angle)) / tube.curvature;
  const double ahead = tube.curvature == 0 ? along : std::sin(angle) / tube.curvature;
  return {{bend, 0, ahead},
          {{Vector_3(std::cos(angle), 0, -std::sin(angle)), Vector_3(0, 1, 0)}},
          tube.radius + tube.slope * along};
}

class Tube_builder
{
public:
  explicit Tube_builder(const Tube& tube) : m_tube(tube)
  {
    for(int row = 0; row <= tube.rows; ++row) {
      m_sections.push_back(section(tube, tube.length * (double(row) / tube.rows - 0.5)));
      m_rings.push_back(add_ring(m_sections.back(), 1, tube.sides));
    }
  }

  void add_side()
  {
    for(std::size_t row = 1; row < m_rings.size(); ++row)
      for(std::size_t i = 0; i < m_rings[row].size(); ++i) {
        const std::size_t next = (i + 1) % m_rings[row].size();
        const std::uint32_t a = m_rings[row - 1][i], b = m_rings[row - 1][next];
        const std::uint32_t c = m_rings[row][next], d = m_rings[row][i];
        m_soup.triangles.push_back({a, b, c});
        m_soup.triangles.push_back({a, c, d});
      }
  }

  void add_caps()
  {
    add_cap(m_sections.front(), m_rings.front(), false);
    add_cap(m_sections.back(), m_rings.back(), true);
  }

  const Soup& soup() const { return m_soup; }

private:
  using Ring = std::vector<std::uint32_t>;

  Ring add_ring(const Section& section, double fraction_of_radius, int sectors)
  {
    Ring ring;
    for(int i = 0; i < sectors; ++i) {
      ring.push_back(std::uint32_t(m_soup.points.size()));
      m_soup.points.push_back(section.at(fraction_of_radius, double(i) / sectors));
    }
    return ring;
  }

  /// rings that become smaller, with fewer sectors, and a point in the middle.
  void add_cap(const Section& section, Ring outer, bool is_ahead)
  {
    const int rings = std::max(1, int(std::lround(m_tube.sides / (2 * pi))));
    for(int left = rings - 1; left >= 0; --left) {
      const int sectors = std::max(3, int(std::lround(double(m_tube.sides) * left / rings)));
      const Ring inner =
          left > 0 ? add_ring(section, double(left) / rings, sectors) : add_ring(section, 0, 1);
      join(outer, inner, is_ahead);
      outer = inner;
    }
  }

  /// fills what is between two rings, always on where the next corner is nearer.
  void join(const Ring& outer, const Ring& inner, bool is_ahead)
  {
    const std::size_t inner_corners = inner.size() > 1 ? inner.size() : 0;
    for(std::size_t i = 0, j = 0; i < outer.size() || j < inner_corners;) {
      const bool is_outer_next =
          j == inner_corners ||
          (i < outer.size() && (i + 1) * inner_corners <= (j + 1) * outer.size());
      const std::uint32_t a = outer[i % outer.size()], b = inner[j % inner.size()];
      const std::uint32_t c = is_outer_next ? outer[++i % outer.size()] : inner[++j % inner.size()];
      m_soup.triangles.push_back(is_ahead ? Soup::Triangle{a, c, b} : Soup::Triangle{a, b, c});
    }
  }

  Tube m_tube;
  std::vector<Section> m_sections;
  std::vector<Ring> m_rings;
  Soup m_soup;
};

std::vector<std::uint32_t> all_faces(const Soup& soup)
{
  std::vector<std::uint32_t> faces(soup.triangles.size());
  std::iota(faces.begin(), faces.end(), std::uint32_t(0));
  return faces;
}

Truth_shape shape_of(const Tube& tube)
{
  if(tube.curvature != 0)
    return Truth_shape::BENT_TUBE;
  return tube.slope != 0 ? Truth_shape::CONE : Truth_shape::TUBE;
}

/// balls around the axis that are dense enough to cover the tube between their centres.
std::vector<Ball> cover_of(const Tube& tube)
{
  const double radius = tube.radius + 0.5 * std::abs(tube.slope) * tube.length;
  const int steps = int(std::ceil(2 * tube.length / radius));
  std::vector<Ball> balls;
  for(int i = 0; i <= steps; ++i)
    balls.push_back({section(tube, tube.length * (double(i) / steps - 0.5)).center, 1.05 * radius});
  return balls;
}

} // namespace

Vector_3 random_direction(Random& random)
{
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return normalized(Vector_3(x, y, z));
}

Vector_3 random_direction_across(const Vector_3& axis, Random& random)
{
  return normalized(CGAL::cross_product(axis, random_direction(random)));
}

Pose random_pose(const Point_3& origin, Random& random)
{
  const Vector_3 z = random_direction(random), x = random_direction_across(z, random);
  return {origin, {{x, CGAL::cross_product(z, x), z}}};
}

Labelled_shape posed(Labelled_shape shape, const Pose& pose)
{
  for(Point_3& p : shape.soup.points)
    p = pose(p);
  for(Ball& ball : shape.cover)
    ball.center = pose(ball.center);
  shape.truth.center = pose(shape.truth.center);
  shape.truth.axis = pose(shape.truth.axis);
  shape.truth.curvature = pose(shape.truth.curvature);
  return shape;
}

Labelled_shape cut(Labelled_shape shape, const Vector_3& normal)
{
  const Soup& soup = shape.soup;
  std::vector<Soup::Triangle> left;
  for(const auto& [a, b, c] : soup.triangles)
    if((CGAL::centroid(soup.points[a], soup.points[b], soup.points[c]) - shape.truth.center) *
           normal <=
       0)
      left.push_back({a, b, c});
  shape.soup.triangles = std::move(left);
  shape.truth.faces = all_faces(shape.soup);
  return shape;
}

Labelled_shape labelled_sphere(double radius, int levels)
{
  Labelled_shape sphere = labelled_ellipsoid(radius, radius, levels);
  sphere.truth.shape = Truth_shape::SPHERE;
  sphere.truth.axis = Vector_3(0, 0, 0);
  return sphere;
}

Labelled_shape labelled_ellipsoid(double across, double along, int levels)
{
  Soup soup = icosphere(levels);
  for(Point_3& p : soup.points)
    p = Point_3(across * p.x(), across * p.y(), along * p.z());
  Truth truth;
  truth.shape = Truth_shape::ELLIPSOID;
  truth.axis = Vector_3(0, 0, 1);
  truth.semi_axes = {{across, across, along}};
  truth.radius = across == along ? along : (2 * across + along) / 3;
  truth.faces = all_faces(soup);
  return {std::move(soup), truth, {{CGAL::ORIGIN, std::max(across, along)}}};
}

Labelled_shape labelled_tube(const Tube& tube)
{
  Tube_builder builder(tube);
  builder.add_side();
  builder.add_caps();
  Truth truth;
  truth.shape = shape_of(tube);
  truth.axis = Vector_3(0, 0, 1);
  truth.radius = tube.radius;
  truth.length = tube.length;
  truth.slope = tube.slope;
  truth.curvature = Vector_3(tube.curvature, 0, 0);
  truth.faces = all_faces(builder.soup());
  return {builder.soup(), truth, cover_of(tube)};
}

int rows_for(const Tube& tube, double elongation)
{
  const double width = 2 * pi * tube.radius / tube.sides;
  return std::max(1, int(std::lround(tube.length / (elongation * width))));
}

Soup torus(double radius, double tube_radius, int around, int sides)
{
  Soup soup;
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < sides; ++j) {
      const double a = 2 * pi * i / around, b = 2 * pi * j / sides;
      const double r = radius + tube_radius * std::cos(b);
      soup.points.emplace_back(r * std::cos(a), r * std::sin(a), tube_radius * std::sin(b));
      const auto index = [&](int k, int l) {
        return std::uint32_t((k % around) * sides + l % sides);
      };
      soup.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      soup.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return soup;
}

} // namespace Paper
