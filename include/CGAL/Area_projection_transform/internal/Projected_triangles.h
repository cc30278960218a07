// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROJECTED_TRIANGLES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROJECTED_TRIANGLES_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/triangle_disk.h>

#include <algorithm>
#include <array>
#include <complex>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a triangle moved by `R` along its normal, and how much of it lies within a ball.
///
/// A flat triangle moves as a whole, so the part of it that lands in a ball is a triangle cut by the
/// disk in which the ball meets its plane.
class Projected_triangle
{
public:
  Projected_triangle(const Triangle_surface& surface, std::size_t t, double distance)
      : m_voting_area(surface.areas[t])
  {
    const Vector_3 shift = distance * surface.normals[t];
    for(int i = 0; i < 3; ++i)
      m_corners[i] = surface.corner(t, i) + shift;
    const Vector_3 u = m_corners[1] - m_corners[0], v = m_corners[2] - m_corners[0];
    const Vector_3 doubled = cross_product(u, v);
    const double length = std::sqrt(doubled.squared_length());
    // The plane is that of the corners: the normal of projection may be another one.
    m_normal = doubled / length;
    m_x_axis = normalized(u);
    m_y_axis = cross_product(m_normal, m_x_axis);
    m_area = 0.5 * length;
  }

  const Point_3& corner(int i) const { return m_corners[i]; }
  double voting_area() const { return m_voting_area; }

  /// the centre and the radius of a ball that holds the triangle.
  Point_3 centroid() const { return CGAL::centroid(m_corners[0], m_corners[1], m_corners[2]); }
  double circumscribed_radius() const
  {
    const Point_3 c = centroid();
    double squared = 0;
    for(const Point_3& p : m_corners)
      squared = std::max(squared, squared_distance(p, c));
    return std::sqrt(squared);
  }

  /// the voting area of the part within a ball.
  double area_within(const Point_3& center, double radius) const
  {
    const double height = (m_corners[0] - center) * m_normal;
    const double squared_disk = radius * radius - height * height;
    if(!(squared_disk > 0))
      return 0;
    std::array<std::complex<double>, 3> corners;
    for(int i = 0; i < 3; ++i) {
      const Vector_3 v = m_corners[i] - center;
      corners[i] = {v * m_x_axis, v * m_y_axis};
    }
    return triangle_disk_area(corners, std::sqrt(squared_disk), m_area) / m_area * m_voting_area;
  }

private:
  std::array<Point_3, 3> m_corners;
  Vector_3 m_normal, m_x_axis, m_y_axis;
  double m_area;
  double m_voting_area;
};

/// \throw std::invalid_argument if the normals vary over the triangles: those do not stay flat.
inline std::vector<Projected_triangle> project_triangles(const Triangle_surface& surface,
                                                         double distance)
{
  if(surface.has_interpolated_normals())
    throw std::invalid_argument("surface has interpolated normals: exact evaluation needs a "
                                "constant normal on each triangle");
  std::vector<Projected_triangle> triangles;
  triangles.reserve(surface.size());
  for(std::size_t t = 0; t < surface.size(); ++t)
    triangles.emplace_back(surface, t, distance);
  return triangles;
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROJECTED_TRIANGLES_H
