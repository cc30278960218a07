// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_H

#include <CGAL/Area_projection_transform/fitting/Sphere.h>
#include <CGAL/Area_projection_transform/fitting/Tube.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <variant>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a sphere, or a piece of a tube.
struct Shape
{
  using Vector = Eigen::Vector3d;

  /// where a point is, seen from the shape.
  struct Place
  {
    double residual; ///< the distance from the shape, positive outside
    Vector normal;   ///< of the shape, nearest to the point
    double along;    ///< of a tube: from its centre, along the axis
  };

  std::variant<Sphere, Tube> model;
  double first = 0, last = 0; ///< the piece of the tube
  double deviation = 0;       ///< of the points from the shape
  /// the part of the deviation that neighbours share: that is not noise, but another shape.
  double misfit = 0;

  bool is_sphere() const { return std::holds_alternative<Sphere>(model); }
  const Sphere& sphere() const { return std::get<Sphere>(model); }
  const Tube& tube() const { return std::get<Tube>(model); }

  double radius() const { return is_sphere() ? sphere().radius : tube().radius; }
  double length() const { return last - first; }

  /// the radius where it is largest.
  double largest_radius() const
  {
    return is_sphere() ? sphere().radius
                       : std::max(tube().radius_at(first), tube().radius_at(last));
  }

  Vector center() const
  {
    return is_sphere() ? sphere().center : tube().point_at(0.5 * (first + last));
  }

  /// of a ball around `center()` that holds the shape.
  double reach() const { return is_sphere() ? sphere().radius : 0.5 * length() + largest_radius(); }

  Place place(const Vector& p) const
  {
    if(is_sphere()) {
      const Vector u = p - sphere().center;
      const double distance = u.norm();
      return {distance - sphere().radius, distance > 0 ? Vector(u / distance) : Vector::Zero(), 0};
    }
    const Tube::Place at = tube().place(p);
    return {tube().residual(at), tube().normal_at(at), at.along};
  }

  bool is_along(double along, double margin) const
  {
    return is_sphere() || (along >= first - margin && along <= last + margin);
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_H
