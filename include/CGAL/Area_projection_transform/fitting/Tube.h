// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_FITTING_TUBE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_FITTING_TUBE_H

#include <CGAL/Area_projection_transform/fitting/Robust_fit.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a tube around an arc of a circle, or a straight line, whose radius is constant or changes at a
/// constant rate: cylinders, cones and parts of tori, and how to fit them to points.
struct Tube
{
  using Vector = Eigen::Vector3d;

  Vector center = Vector::Zero();    ///< a point of the axis
  Vector axis = Vector::UnitX();     ///< the direction of the axis there
  Vector curvature = Vector::Zero(); ///< towards the centre of the bend, one over its radius long
  double radius = 0;                 ///< at the centre
  double slope = 0;                  ///< the change of the radius per length of the axis

  /// where a point is, seen from the axis.
  struct Place
  {
    double along;    ///< the length of the axis from the centre to the nearest point
    double distance; ///< from that point
    Vector radial;   ///< the unit vector from there
    Vector tangent;  ///< the direction of the axis there
  };

  Place place(const Vector& p) const
  {
    const Vector u = p - center;
    const double k = curvature.norm();
    const double alpha = u.dot(axis);
    if(!(k * std::abs(alpha) > 1e-9) && !(k * radius > 1e-9)) {
      const Vector across = u - alpha * axis;
      const double distance = across.norm();
      return {alpha, distance, distance > 0 ? Vector(across / distance) : Vector::Zero(), axis};
    }
    // In the plane of the bend, without the difference of two large radii where it is nearly straight.
    const Vector inward = curvature / k, normal = axis.cross(inward);
    const double beta = u.dot(inward), gamma = u.dot(normal);
    const double x = k * alpha, y = 1 - k * beta;
    const double s = std::sqrt(x * x + y * y);
    const double offset = (2 * beta - k * (alpha * alpha + beta * beta)) / (1 + s);
    const double sine = s > 0 ? x / s : 0, cosine = s > 0 ? y / s : 1;
    const Vector across = offset * (cosine * inward - sine * axis) + gamma * normal;
    const double distance = across.norm();
    return {std::atan2(x, y) / k, distance,
            distance > 0 ? Vector(across / distance) : Vector::Zero(),
            cosine * axis + sine * inward};
  }

  double radius_at(double along) const { return radius + slope * along; }

  double residual(const Place& place) const
  {
    return (place.distance - radius_at(place.along)) / std::sqrt(1 + slope * slope);
  }

  double residual(const Vector& p) const { return residual(place(p)); }

  /// the direction in which a normal points there.
  Vector normal_at(const Place& place) const
  {
    return (place.radial - slope * place.tangent) / std::sqrt(1 + slope * slope);
  }

  Vector tangent_at(double along) const
  {
    const double k = curvature.norm();
    if(!(k > 0))
      return axis;
    return std::cos(k * along) * axis + std::sin(k * along) * (curvature / k);
  }

  Vector point_at(double along) const
  {
    const double k = curvature.norm(), angle = k * along;
    if(!(std::abs(angle) > 1e-9))
      return center + along * axis;
    const double half = std::sin(angle / 2);
    return center + (std::sin(angle) / k) * axis + (2 * half * half / (k * k)) * curvature;
  }

  /// the same tube, told from another point of its axis.
  Tube seen_from(double along) const
  {
    Tube tube = *this;
    tube.center = point_at(along);
    tube.axis = tangent_at(along).normalized();
    const double k = curvature.norm();
    if(k > 0) {
      const Vector turned = std::cos(k * along) * (curvature / k) - std::sin(k * along) * axis;
      tube.curvature = k * (turned - turned.dot(tube.axis) * tube.axis).normalized();
    }
    tube.radius = radius_at(along);
    return tube;
  }

  /// \name Parameters of a fit, all of them lengths:
  /// the shift of the axis across itself (2), its tilt, the change of its curvature and of the slope, each at
  /// a distance of one radius; and the radius.
  /// @{
  static constexpr int size = 8;
  static constexpr double largest_slope = 0.8;
  static constexpr double largest_bend = 0.6; ///< radius of the tube over that of the bend
  enum Parameter { SHIFT = 0, TILT = 2, RADIUS = 4, SLOPE = 5, CURVATURE = 6 };
  using Equations = Normal_equations<size>;

  /// which of the parameters beyond those of a cylinder are fitted.
  struct Freedom
  {
    bool slope = false, curvature = false;

    int number() const { return 5 + (slope ? 1 : 0) + (curvature ? 2 : 0); }

    std::vector<int> free_parameters() const
    {
      std::vector<int> free{0, 1, 2, 3, 4};
      if(slope)
        free.push_back(SLOPE);
      if(curvature)
        free.insert(free.end(), {CURVATURE, CURVATURE + 1});
      return free;
    }
  };

  Equations equations(const std::vector<Vector>& points, double deviation,
                      const Freedom& freedom) const
  {
    Equations equations{Tukey(deviation)};
    const auto [e1, e2] = across();
    const double scale = 1 / std::sqrt(1 + slope * slope);
    for(const Vector& p : points) {
      const Place at = place(p);
      const double t = at.along / radius;
      const double r1 = -at.radial.dot(e1), r2 = -at.radial.dot(e2);
      Equations::Row row;
      row << r1, r2, t * r1, t * r2, -1, freedom.slope ? -t : 0,
          freedom.curvature ? 0.5 * t * t * r1 : 0, freedom.curvature ? 0.5 * t * t * r2 : 0;
      equations.add(residual(at), scale * row);
    }
    return equations;
  }

  void move(const Equations::Row& step)
  {
    const auto [e1, e2] = across();
    center += step[0] * e1 + step[1] * e2;
    const Vector bend = curvature + (step[6] * e1 + step[7] * e2) / (radius * radius);
    axis = (axis + (step[2] * e1 + step[3] * e2) / radius).normalized();
    curvature = bend - bend.dot(axis) * axis;
    slope = std::clamp(slope + step[5] / radius, -largest_slope, largest_slope);
    radius += step[4];
    const double bent = curvature.norm() * radius;
    if(bent > largest_bend)
      curvature *= largest_bend / bent;
  }
  /// @}

private:
  /// two directions across the axis.
  std::pair<Vector, Vector> across() const
  {
    const Vector e1 = axis.unitOrthogonal();
    return {e1, axis.cross(e1)};
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_FITTING_TUBE_H
