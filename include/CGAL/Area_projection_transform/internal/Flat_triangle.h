// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FLAT_TRIANGLE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FLAT_TRIANGLE_H

#include <CGAL/Area_projection_transform/Grid_3.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/triangle_disk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a triangle, and a frame of its plane in which the first corner is the origin and the first
/// edge points along the first axis; what kernels need to know of it.
///
/// Edge `i` leads from corner `i` to the next, counterclockwise about the normal.
struct Flat_triangle
{
  std::array<Point_3, 3> corners;
  Vector_3 x_axis, y_axis, normal;
  std::array<std::array<double, 2>, 3> directions; ///< of the edges, in the frame
  std::array<double, 3> lengths;
  /// of the angle from the direction of an edge to that of the next.
  std::array<double, 3> cosines, sines;
  double doubled_area;

  /// \brief the triangle `p`, `p + u`, `p + v`.
  ///
  /// The edges are given apart from the corners, whose rounding could make them parallel.
  Flat_triangle(const Point_3& p, const Vector_3& u, const Vector_3& v) : corners{p, p + u, p + v}
  {
    const Vector_3 doubled = cross_product(u, v);
    doubled_area = std::sqrt(doubled.squared_length());
    normal = (1 / doubled_area) * doubled;
    lengths[0] = std::sqrt(u.squared_length());
    x_axis = (1 / lengths[0]) * u;
    y_axis = cross_product(normal, x_axis);
    const double x = v * x_axis, y = doubled_area / lengths[0];
    lengths[1] = std::sqrt((x - lengths[0]) * (x - lengths[0]) + y * y);
    lengths[2] = std::sqrt(x * x + y * y);
    const std::array<double, 3> inverse{1 / lengths[0], 1 / lengths[1], 1 / lengths[2]};
    directions = {{{1, 0},
                   {(x - lengths[0]) * inverse[1], y * inverse[1]},
                   {-x * inverse[2], -y * inverse[2]}}};
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      cosines[i] = directions[i][0] * directions[next][0] + directions[i][1] * directions[next][1];
      sines[i] = doubled_area * inverse[i] * inverse[next];
    }
  }

  /// \brief the fraction of the triangle within a ball.
  ///
  /// For one ball and one triangle; kernels compute the same for many.
  double fraction_within(const Point_3& center, double radius) const
  {
    // From so far away the triangle is a point, and where its edges are would be chance.
    constexpr double far = 0x1p40;
    const double squared_distance = (corners[0] - center).squared_length();
    if(std::max(std::sqrt(squared_distance), radius) > far * longest_edge())
      return squared_distance <= radius * radius ? 1 : 0;
    const double height = (corners[0] - center) * normal;
    const double squared_disk = radius * radius - height * height;
    if(!(squared_disk > 0))
      return 0;
    std::array<std::complex<double>, 3> in_plane;
    for(std::size_t i = 0; i < 3; ++i) {
      const Vector_3 v = corners[i] - center;
      in_plane[i] = {v * x_axis, v * y_axis};
    }
    const double area = 0.5 * doubled_area;
    return std::clamp(triangle_disk_area(in_plane, std::sqrt(squared_disk), area) / area, 0., 1.);
  }

  Point_3 centroid() const { return CGAL::centroid(corners[0], corners[1], corners[2]); }
  double longest_edge() const { return std::max({lengths[0], lengths[1], lengths[2]}); }
  double least_height() const { return doubled_area / longest_edge(); }

  /// \brief where an edge begins, measured along it from the place that is nearest to a point of the
  /// plane, and how far to its left that point lies.
  struct Seen_edge
  {
    double start, height;
  };

  /// \param x, y the first corner relative to that point, in the frame
  Seen_edge seen_edge(std::size_t i, double x, double y) const
  {
    const auto& [along, across] = directions[i];
    if(i == 1) // begins at the other end of the first edge
      x += lengths[0];
    return {x * along + y * across - (i == 2 ? lengths[2] : 0), x * across - y * along};
  }
};

/// \throw std::invalid_argument if the normals vary over the triangles: those do not stay flat.
inline void check_flat(const Triangle_surface& surface)
{
  if(surface.has_interpolated_normals())
    throw std::invalid_argument("surface has interpolated normals: exact evaluation needs a "
                                "constant normal on each triangle");
}

/// \brief returns triangle `t` of a surface, moved by `distance` along its normal of projection.
///
/// A flat triangle moves as a whole, so the part of it that lands in a ball is a triangle cut by the disk
/// in which the ball meets its plane. That plane is the one of its corners: its normal may be another.
inline Flat_triangle projected_triangle(const Triangle_surface& surface, std::size_t t,
                                        double distance)
{
  const Point_3& p = surface.corner(t, 0);
  return Flat_triangle(p + distance * surface.normals[t], surface.corner(t, 1) - p,
                       surface.corner(t, 2) - p);
}

/// \brief the same in the coordinates of a lattice.
///
/// The frame is that of the surface: scaled first, the edges of a needle could become parallel.
inline Flat_triangle projected_triangle(const Triangle_surface& surface, std::size_t t,
                                        double distance, const Grid_3& lattice)
{
  const double factor = 1 / lattice.spacing();
  const Point_3& p = surface.corner(t, 0);
  const Vector_3 u = surface.corner(t, 1) - p, v = surface.corner(t, 2) - p;
  Flat_triangle triangle(p, u, v);
  const Point_3 q = CGAL::ORIGIN + factor * (p + distance * surface.normals[t] - lattice.origin());
  triangle.corners = {q, q + factor * u, q + factor * v};
  for(double& length : triangle.lengths)
    length *= factor;
  triangle.doubled_area *= factor * factor;
  return triangle;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FLAT_TRIANGLE_H
