// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_H

#include <CGAL/Area_projection_transform/fitting/Ellipsoid.h>
#include <CGAL/Area_projection_transform/fitting/Sphere.h>
#include <CGAL/Area_projection_transform/fitting/Tube.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <variant>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a sphere, a piece of a tube, or an ellipsoid.
struct Shape
{
  using Vector = Eigen::Vector3d;

  /// where a point is, seen from the shape.
  struct Place
  {
    double residual; ///< the distance from the shape, positive outside
    Vector normal;   ///< of the shape, nearest to the point
    double along;    ///< of a tube: from its centre, along the axis; otherwise 0
    Vector axis;     ///< of a tube: its direction there; otherwise null
  };

  std::variant<Sphere, Tube, Ellipsoid> model;
  double first = 0, last = 0; ///< the piece of the tube
  double deviation = 0;       ///< of the points from the shape
  /// the part of the deviation that neighbours share: that is not noise, but another shape.
  double misfit = 0;

  bool is_sphere() const { return std::holds_alternative<Sphere>(model); }
  bool is_tube() const { return std::holds_alternative<Tube>(model); }
  const Sphere& sphere() const { return std::get<Sphere>(model); }
  const Tube& tube() const { return std::get<Tube>(model); }
  const Ellipsoid& ellipsoid() const { return std::get<Ellipsoid>(model); }

  double radius() const
  {
    return is_sphere() ? sphere().radius : is_tube() ? tube().radius : ellipsoid().radius();
  }

  double length() const { return last - first; }

  Vector center() const
  {
    return is_sphere() ? sphere().center
           : is_tube() ? tube().point_at(0.5 * (first + last))
                       : ellipsoid().center;
  }

  /// of a ball around `center()` that holds the shape.
  double reach() const
  {
    if(is_sphere())
      return sphere().radius;
    if(is_tube())
      return 0.5 * length() + std::max(tube().radius_at(first), tube().radius_at(last));
    return ellipsoid().axes().lengths[2];
  }

  Place place(const Vector& p) const
  {
    if(is_tube()) {
      const Tube::Place at = tube().place(p);
      return {tube().residual(at), tube().normal_at(at), at.along, at.tangent};
    }
    if(is_sphere()) {
      const Vector u = p - sphere().center;
      const double distance = u.norm();
      return {distance - sphere().radius, distance > 0 ? Vector(u / distance) : Vector::Zero(), 0,
              Vector::Zero()};
    }
    const Ellipsoid::Place at = ellipsoid().place(p);
    return {at.residual, at.normal, 0, Vector::Zero()};
  }

  bool is_along(double along, double margin) const
  {
    return !is_tube() || (along >= first - margin && along <= last + margin);
  }
};

/// \brief a ball, or a straight tube with a round end beyond its ends, that holds all points within some distance of a
/// shape: what is not in it need not be placed.
class Shape_bound
{
public:
  /// \param beyond how far the piece of a tube is lengthened at each end
  Shape_bound(const Shape& shape, double distance, double beyond = 0)
      : m_center(shape.center()), m_reach(shape.reach() + distance + beyond), m_across(m_reach)
  {
    if(!shape.is_tube())
      return;
    const Tube& tube = shape.tube();
    const double half = 0.5 * shape.length() + beyond;
    const double k = tube.curvature.norm();
    const double sagitta = k * half < 2 ? 0.5 * k * half * half : 2 / k;
    m_axis = tube.tangent_at(0.5 * (shape.first + shape.last));
    m_across = std::min(
        std::max(tube.radius_at(shape.first - beyond), tube.radius_at(shape.last + beyond)) +
            distance * std::sqrt(1 + tube.slope * tube.slope) + sagitta,
        m_reach);
  }

  const Shape::Vector& center() const { return m_center; }
  double reach() const { return m_reach; }

  bool may_hold(const Shape::Vector& p) const
  {
    const Shape::Vector u = p - m_center;
    const double along = u.dot(m_axis);
    return u.squaredNorm() - along * along <= m_across * m_across;
  }

private:
  Shape::Vector m_center, m_axis = Shape::Vector::Zero();
  double m_reach, m_across;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_H
