// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TANGENT_CELL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TANGENT_CELL_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the part of a plane that is nearer to the origin than to other points: a convex polygon.
class Tangent_cell
{
public:
  /// begins with a regular polygon whose sides are at the distance `radius`. Its sides are as many as
  /// lattices have symmetries, so that no direction of them is special.
  void begin(const Vector_3& normal, double radius)
  {
    m_normal = normal;
    m_has_axes = false;
    m_corners.clear();
    for(int i = 0; i < number_of_sides; ++i) {
      const double angle = (2 * i + 1) * half_angle, distance = radius / std::cos(half_angle);
      m_corners.push_back({distance * std::cos(angle), distance * std::sin(angle)});
    }
  }

  /// the distance of the sides of a first polygon that has the given area.
  static double radius_of_area(double area)
  {
    return std::sqrt(area / (number_of_sides * std::tan(half_angle)));
  }

  /// takes away what is nearer to the projection of `offset` along the normal. The first offset fixes
  /// the directions in the plane, so that the cell turns with the points. Offsets along the normal
  /// take nothing away.
  void cut(const Vector_3& offset)
  {
    const Vector_3 flat = offset - (offset * m_normal) * m_normal;
    const double squared_length = flat.squared_length();
    if(!(squared_length > 1e-20 * offset.squared_length()))
      return;
    if(!m_has_axes) {
      m_x = flat / std::sqrt(squared_length);
      m_y = CGAL::cross_product(m_normal, m_x);
      m_has_axes = true;
    }
    cut(m_x * flat, m_y * flat, squared_length / 2);
  }

  /// the squared distance of the farthest corner.
  double squared_reach() const
  {
    double largest = 0;
    for(const Corner& c : m_corners)
      largest = std::max(largest, c.x * c.x + c.y * c.y);
    return largest;
  }

  /// whether a corner is more than `ratio` times as far away as both its sides.
  bool has_spike(double ratio) const
  {
    const std::size_t number = m_corners.size();
    for(std::size_t i = 0; i < number; ++i) {
      const Corner &a = m_corners[i], &b = m_corners[(i + 1) % number],
                   &c = m_corners[(i + 2) % number];
      const double nearer = ratio * std::max(distance_of_side(a, b), distance_of_side(b, c));
      if(b.x * b.x + b.y * b.y > nearer * nearer)
        return true;
    }
    return false;
  }

  double area() const
  {
    double doubled = 0;
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Corner &a = m_corners[i], &b = m_corners[i + 1 < m_corners.size() ? i + 1 : 0];
      doubled += a.x * b.y - a.y * b.x;
    }
    return doubled / 2;
  }

private:
  static constexpr int number_of_sides = 24;
  static constexpr double half_angle = 3.14159265358979323846 / number_of_sides;

  struct Corner
  {
    double x, y;
  };

  static double distance_of_side(const Corner& a, const Corner& b)
  {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return length > 0 ? (a.x * b.y - a.y * b.x) / length : 0;
  }

  // Keeps the corners c with c·(x, y) <= bound, and adds those on the line.
  void cut(double x, double y, double bound)
  {
    m_kept.clear();
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Corner &a = m_corners[i], &b = m_corners[i + 1 < m_corners.size() ? i + 1 : 0];
      const double beyond_a = x * a.x + y * a.y - bound, beyond_b = x * b.x + y * b.y - bound;
      if(beyond_a <= 0)
        m_kept.push_back(a);
      if((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0)) {
        const double t = beyond_a / (beyond_a - beyond_b);
        m_kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
    m_corners.swap(m_kept);
  }

  Vector_3 m_normal, m_x, m_y;
  bool m_has_axes = false;
  std::vector<Corner> m_corners, m_kept;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TANGENT_CELL_H
