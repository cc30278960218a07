// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_FITTING_SPHERE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_FITTING_SPHERE_H

#include <CGAL/Area_projection_transform/fitting/Robust_fit.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a sphere, and how to fit it to points.
struct Sphere
{
  using Vector = Eigen::Vector3d;
  using Equations = Normal_equations<4>; // the centre, the radius

  Vector center = Vector::Zero();
  double radius = 0;

  double residual(const Vector& p) const { return (p - center).norm() - radius; }

  Equations equations(const std::vector<Vector>& points, double deviation) const
  {
    Equations equations{Tukey(deviation)};
    for(const Vector& p : points) {
      const Vector u = p - center;
      const double distance = u.norm();
      Equations::Row row;
      row << -u / distance, -1;
      if(distance > 0)
        equations.add(distance - radius, row);
    }
    return equations;
  }

  void move(const Equations::Row& step)
  {
    center += step.head<3>();
    radius += step[3];
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_FITTING_SPHERE_H
