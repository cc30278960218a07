// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_OFFSET_CHORDS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_OFFSET_CHORDS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a part of a line parallel to the x axis; empty if it ends before it begins.
struct Chord
{
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();

  bool is_empty() const { return !(first <= last); }

  static Chord whole_line()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, infinity};
  }

  /// keeps the part where `slope * x + constant` is not negative.
  void clip(double slope, double constant)
  {
    if(slope > 0)
      first = std::max(first, -constant / slope);
    else if(slope < 0)
      last = std::min(last, -constant / slope);
    else if(constant < 0)
      *this = Chord();
  }

  /// keeps the part where `a x² - 2 b x + c` is not positive; `a` is not negative.
  void clip_by_quadratic(double a, double b, double c)
  {
    if(!(a > 0))
      return clip(2 * b, -c);
    const double discriminant = b * b - a * c;
    if(discriminant < 0) {
      *this = Chord();
      return;
    }
    const double root = std::sqrt(discriminant);
    first = std::max(first, (b - root) / a);
    last = std::min(last, (b + root) / a);
  }

  /// extends the chord to another part of the same convex set.
  void join(const Chord& other)
  {
    if(!other.is_empty()) {
      first = std::min(first, other.first);
      last = std::max(last, other.last);
    }
  }
};

/// the chord that a ball cuts out of the line through `line` along x, relative to that point.
inline Chord chord_of_ball(const Point_3& line, const Point_3& center, double radius)
{
  const Vector_3 d = center - line;
  const double squared_half = radius * radius - d.y() * d.y() - d.z() * d.z();
  if(squared_half < 0)
    return Chord();
  const double half = std::sqrt(squared_half);
  return {d.x() - half, d.x() + half};
}

/// the part of the line that has its nearest point of the line `a b` between the two, within `radius`.
inline Chord chord_of_cylinder(const Point_3& line, const Point_3& a, const Point_3& b,
                               double radius)
{
  const Vector_3 edge = b - a, from_a = line - a;
  const double length = edge.squared_length();
  Chord chord;
  if(!(length > 0))
    return chord;
  chord = Chord::whole_line();
  const double along = from_a * edge;
  chord.clip(edge.x(), along);
  chord.clip(-edge.x(), length - along);
  // The squared distance from the edge is the squared cross product, divided by the squared length.
  const Vector_3 cross = cross_product(from_a, edge);
  const double a2 = edge.y() * edge.y() + edge.z() * edge.z();
  const double ab = cross.y() * edge.z() - cross.z() * edge.y();
  chord.clip_by_quadratic(a2, ab, cross.squared_length() - radius * radius * length);
  return chord;
}

/// the part of the line that has its nearest point of the plane in the triangle, within `radius`.
inline Chord chord_of_prism(const Point_3& line, const std::array<Point_3, 3>& corners,
                            double radius)
{
  const Vector_3 normal = cross_product(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = std::sqrt(normal.squared_length());
  Chord chord;
  if(!(length > 0))
    return chord;
  chord = Chord::whole_line();
  const double height = (line - corners[0]) * normal;
  chord.clip(normal.x(), height + radius * length);
  chord.clip(-normal.x(), radius * length - height);
  for(std::size_t i = 0; i < 3; ++i) {
    const Vector_3 inward = cross_product(normal, corners[(i + 1) % 3] - corners[i]);
    chord.clip(inward.x(), (line - corners[i]) * inward);
  }
  return chord;
}

/// \brief the offset solids of the triangles of a surface: all that is within a distance of one.
///
/// Each is convex, the union of a prism, three cylinders and three balls.
class Offset_triangles
{
public:
  Offset_triangles(const Triangle_surface& surface, double distance)
      : m_surface(surface), m_distance(distance)
  {}

  std::size_t size() const { return m_surface.size(); }

  /// the bounding box of the triangle itself.
  Bbox_3 bbox(std::size_t t) const
  {
    return m_surface.corner(t, 0).bbox() + m_surface.corner(t, 1).bbox() +
           m_surface.corner(t, 2).bbox();
  }

  /// the chord of the line through `line` along x, relative to that point.
  Chord chord(std::size_t t, const Point_3& line) const
  {
    const std::array<Point_3, 3> corners{m_surface.corner(t, 0), m_surface.corner(t, 1),
                                         m_surface.corner(t, 2)};
    Chord chord;
    chord.join(chord_of_prism(line, corners, m_distance));
    for(std::size_t i = 0; i < 3; ++i) {
      chord.join(chord_of_cylinder(line, corners[i], corners[(i + 1) % 3], m_distance));
      chord.join(chord_of_ball(line, corners[i], m_distance));
    }
    return chord;
  }

private:
  const Triangle_surface& m_surface;
  double m_distance;
};

/// the balls around points.
class Offset_points
{
public:
  Offset_points(std::vector<Point_3> points, double distance)
      : m_points(std::move(points)), m_distance(distance)
  {}

  std::size_t size() const { return m_points.size(); }
  Bbox_3 bbox(std::size_t i) const { return m_points[i].bbox(); }

  Chord chord(std::size_t i, const Point_3& line) const
  {
    return chord_of_ball(line, m_points[i], m_distance);
  }

private:
  std::vector<Point_3> m_points;
  double m_distance;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_OFFSET_CHORDS_H
