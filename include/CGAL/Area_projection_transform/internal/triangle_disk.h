// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TRIANGLE_DISK_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TRIANGLE_DISK_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// whether the origin lies within a triangle given in counterclockwise order.
inline bool contains_origin(const std::array<std::complex<double>, 3>& corners)
{
  for(int i = 0; i < 3; ++i)
    if(std::imag(std::conj(corners[i]) * corners[(i + 1) % 3]) < 0)
      return false;
  return true;
}

/// \brief returns the area of the part of a planar triangle within a disk around the origin.
///
/// By Green's theorem, half the sum over the boundary of the intersection: along its straight parts
/// the cross products of their ends, along its arcs `radius²` times their angle. An edge outside
/// of the disk stands for an arc of the angle under which it is seen. The angles are multiplied
/// as complex numbers, so that one arctangent serves the whole triangle. All cross products are parts of
/// that of an edge: those of its ends, which may be almost the same seen from far away, would cancel.
///
/// It errs by a few roundings of the product of the radius and the longest edge.
///
/// \param corners in counterclockwise order
/// \param area the area of the triangle
inline double triangle_disk_area(const std::array<std::complex<double>, 3>& corners, double radius,
                                 double area)
{
  constexpr double pi = 3.14159265358979323846;
  const auto dot = [](auto u, auto v) { return u.real() * v.real() + u.imag() * v.imag(); };
  const auto cross = [](auto u, auto v) { return u.real() * v.imag() - u.imag() * v.real(); };

  const double squared_radius = radius * radius;
  if(std::max({std::norm(corners[0]), std::norm(corners[1]), std::norm(corners[2])}) <=
     squared_radius)
    return area;
  const auto seen = [&](auto from, auto to, double from_cross_to) {
    return std::complex<double>(dot(from, to), from_cross_to) / squared_radius;
  };
  double straight = 0;
  std::complex<double> arcs = 1;
  bool has_straight = false;
  for(int i = 0; i < 3; ++i) {
    const std::complex<double> p = corners[i], q = corners[(i + 1) % 3], d = q - p;
    // The edge p + t d crosses the circle where a t² + 2 b t + c = 0.
    const double a = dot(d, d), b = dot(p, d), c = dot(p, p) - squared_radius;
    const double whole = cross(p, d);
    const double discriminant = b * b - a * c;
    double enter = 1, leave = 0;
    if(discriminant > 0) {
      const double root = std::sqrt(discriminant);
      enter = std::max((-b - root) / a, 0.);
      leave = std::min((-b + root) / a, 1.);
    }
    if(enter < leave) {
      const std::complex<double> in = enter > 0 ? p + enter * d : p;
      const std::complex<double> out = leave < 1 ? p + leave * d : q;
      straight += (leave - enter) * whole;
      has_straight = true;
      if(enter > 0)
        arcs *= seen(p, in, enter * whole);
      if(leave < 1)
        arcs *= seen(out, q, (1 - leave) * whole);
    } else
      arcs *= seen(p, q, whole);
  }

  if(!has_straight) // no edge meets the disk: it lies within the triangle, or outside
    return contains_origin(corners) ? pi * squared_radius : 0;
  double angle = std::arg(arcs);
  if(angle < 0)
    angle += 2 * pi;
  // A sum of nothing may come out as just below a full turn. The arcs can be nearly the whole
  // circle only if the disk nearly fits into the triangle.
  if(angle > 2 * pi - 1e-9 && area < pi * squared_radius)
    angle = 0;
  return std::clamp(0.5 * (straight + squared_radius * angle), 0.,
                    std::min(area, pi * squared_radius));
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TRIANGLE_DISK_H
