// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CANAL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CANAL_H

#include <CGAL/Area_projection_transform/fitting/Tube.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a short piece of tube whose axis may bend, whose radius may change, and whose section is an ellipse.
///
/// Seen from the axis in the unit direction `ρ` the surface is at `r(s) / √(1 + ρᵀEρ)`, where `E` is a tensor across
/// the axis without trace: those are exactly the ellipses. A tensor, and not two numbers, since the frame in which
/// they would be told turns along the axis.
struct Canal
{
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

  Tube tube; ///< its radius is that of `E = 0`; see `round_radius()`
  Matrix ellipse = Matrix::Zero();

  /// a point of space as the canal sees it.
  struct Place
  {
    double along;    ///< the axis
    double distance; ///< from the axis
    double model;    ///< the distance that the surface has there
    Vector radial;
    Vector tangent;
    Vector gradient; ///< of `distance - model`, across the axis
    double shrink;   ///< √(1 / (1 + ρᵀEρ))

    double residual() const { return distance - model; }

    /// the cosine of the angle between a unit vector and the normal of the model.
    double cosine(const Vector& n, double slope) const
    {
      const double steepness = slope * shrink;
      return (n.dot(gradient) - steepness * n.dot(tangent)) /
             std::sqrt(gradient.squaredNorm() + steepness * steepness);
    }
  };

  /// \brief sees many points: what they share is computed once.
  ///
  /// The ellipse goes along the bend with the axis.
  class View
  {
  public:
    explicit View(const Canal& canal)
        : m_center(canal.tube.center)
        , m_axis(canal.tube.axis)
        , m_radius(canal.tube.radius)
        , m_slope(canal.tube.slope)
        , m_bend(canal.tube.curvature.norm())
    {
      if(!(m_bend * m_radius > 1e-9))
        m_bend = 0;
      m_inward = m_bend > 0 ? Vector(canal.tube.curvature / m_bend) : m_axis.unitOrthogonal();
      m_normal = m_axis.cross(m_inward);
      m_xx = m_inward.dot(canal.ellipse * m_inward);
      m_xy = m_inward.dot(canal.ellipse * m_normal);
      m_yy = m_normal.dot(canal.ellipse * m_normal);
    }

    Place operator()(const Vector& p) const
    {
      const Vector u = p - m_center;
      const double alpha = u.dot(m_axis), beta = u.dot(m_inward), y = u.dot(m_normal);
      Place place;
      Vector inward = m_inward;
      double x = beta;
      place.along = alpha;
      place.tangent = m_axis;
      if(m_bend > 0) {
        const double a = m_bend * alpha, b = 1 - m_bend * beta, h = std::sqrt(a * a + b * b);
        const double sine = h > 0 ? a / h : 0, cosine = h > 0 ? b / h : 1;
        x = (2 * beta - m_bend * (alpha * alpha + beta * beta)) / (1 + h);
        place.along = std::atan2(a, b) / m_bend;
        place.tangent = cosine * m_axis + sine * m_inward;
        inward = cosine * m_inward - sine * m_axis;
      }
      place.distance = std::sqrt(x * x + y * y);
      see_section(place, inward, x, y);
      return place;
    }

  private:
    void see_section(Place& place, const Vector& inward, double x, double y) const
    {
      const double inverse = place.distance > 0 ? 1 / place.distance : 0;
      const double c = x * inverse, s = y * inverse;
      const double ex = m_xx * c + m_xy * s, ey = m_xy * c + m_yy * s;
      place.shrink = 1 / std::sqrt(std::max(1 + c * ex + s * ey, least));
      place.model = std::max(m_radius + m_slope * place.along, least * m_radius) * place.shrink;
      const double by_angle = -place.model * place.shrink * place.shrink * (c * ey - s * ex);
      const double turn = place.distance > least * m_radius ? by_angle * inverse : 0;
      place.radial = c * inward + s * m_normal;
      place.gradient = (c + turn * s) * inward + (s - turn * c) * m_normal;
    }

    Vector m_center, m_axis, m_inward, m_normal;
    double m_radius, m_slope, m_bend;
    double m_xx, m_xy, m_yy; ///< the ellipse
  };

  Place place(const Vector& p) const { return View(*this)(p); }

  /// the larger eigenvalue of the ellipse: its semi-axes are `r / √(1 ± eccentricity)`.
  double eccentricity() const { return ellipse.norm() / std::sqrt(2.); }

  /// the radius of the circle with the area of the section.
  double round_radius() const { return tube.radius * roundness(); }

  /// the part of it in the change of the radius.
  double roundness() const { return std::pow(1 - eccentricity() * eccentricity(), -0.25); }

  double largest_semi_axis() const { return tube.radius / std::sqrt(1 - eccentricity()); }
  double smallest_semi_axis() const { return tube.radius / std::sqrt(1 + eccentricity()); }

  /// the same canal, told from another point of its axis.
  Canal seen_from(double along) const
  {
    Canal canal = *this;
    canal.tube = tube.seen_from(along);
    canal.tube.radius = std::max(canal.tube.radius, 0.3 * tube.radius);
    canal.flatten_ellipse();
    return canal;
  }

  /// the canal that goes the other way.
  Canal reversed() const
  {
    Canal canal = *this;
    canal.tube.axis = -tube.axis;
    canal.tube.slope = -tube.slope;
    return canal;
  }

  /// \name Parameters of a fit, all of them lengths:
  /// the shift of the axis across itself (2), its tilt, the change of its curvature, of the slope and of the ellipse (2),
  /// each at a distance of one radius; and the radius.
  /// @{
  static constexpr int size = 10;
  static constexpr double largest_eccentricity = 0.85; // axes of 1 : 3.5
  using Row = Eigen::Matrix<double, size, 1>;
  enum Parameter { SHIFT = 0, TILT = 2, CURVATURE = 4, RADIUS = 6, SLOPE = 7, ELLIPSE = 8 };

  /// two directions across the axis.
  std::pair<Vector, Vector> across() const
  {
    const Vector e1 = tube.axis.unitOrthogonal();
    return {e1, tube.axis.cross(e1)};
  }

  /// the derivative of the residual.
  Row derivative(const Place& at, const Vector& e1, const Vector& e2) const
  {
    const double t = at.along / tube.radius, half = 0.5 * t * t;
    const double g1 = -at.gradient.dot(e1), g2 = -at.gradient.dot(e2);
    const double c1 = at.radial.dot(e1), c2 = at.radial.dot(e2);
    const double by_ellipse = 0.5 * at.model / tube.radius * at.shrink * at.shrink;
    Row row;
    row << g1, g2, t * g1, t * g2, half * g1, half * g2, -at.shrink, -t * at.shrink,
        by_ellipse * (c1 * c1 - c2 * c2), by_ellipse * 2 * c1 * c2;
    return row;
  }

  /// moves the parameters, none further than makes sense.
  void move(const Row& step, const Vector& e1, const Vector& e2)
  {
    constexpr double furthest = 0.3; // in units of the radius
    const double r = tube.radius;
    Vector shift = step[SHIFT] * e1 + step[SHIFT + 1] * e2;
    if(shift.norm() > furthest * r)
      shift *= furthest * r / shift.norm();
    const double a = step[ELLIPSE] / r, b = step[ELLIPSE + 1] / r;
    ellipse += a * (e1 * e1.transpose() - e2 * e2.transpose()) +
               b * (e1 * e2.transpose() + e2 * e1.transpose());
    Tube::Equations::Row of_tube;
    of_tube << shift.dot(e1), shift.dot(e2), step[TILT], step[TILT + 1],
        std::clamp(step[RADIUS], -furthest * r, furthest * r), step[SLOPE], step[CURVATURE],
        step[CURVATURE + 1];
    tube.move(of_tube); // whose directions across the axis are the same ones
    flatten_ellipse();
  }
  /// @}

private:
  static constexpr double least = 0.05;

  /// drops what of the tensor is not across the axis, and what is too much.
  void flatten_ellipse()
  {
    const Matrix flat = Matrix::Identity() - tube.axis * tube.axis.transpose();
    ellipse = flat * ellipse * flat;
    ellipse -= 0.5 * ellipse.trace() * flat;
    const double e = eccentricity();
    if(e > largest_eccentricity)
      ellipse *= largest_eccentricity / e;
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CANAL_H
