// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_FITTING_ELLIPSOID_H
#define CGAL_AREA_PROJECTION_TRANSFORM_FITTING_ELLIPSOID_H

#include <CGAL/Area_projection_transform/fitting/Robust_fit.h>
#include <CGAL/Area_projection_transform/internal/solve_symmetric.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// an ellipsoid, `|B (p − center)| = 1` with a symmetric matrix `B`, and how to fit it to points.
struct Ellipsoid
{
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;
  using Equations = Normal_equations<9>; // the centre, the matrix by rows of its upper triangle

  Vector center = Vector::Zero();
  Matrix matrix = Matrix::Identity();

  /// ascending, and their directions; not positive ones are infinite.
  struct Axes
  {
    Vector lengths;
    Matrix directions; ///< one in each column
  };

  Axes axes() const
  {
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(matrix);
    return {eigen.eigenvalues().reverse().cwiseInverse(), eigen.eigenvectors().rowwise().reverse()};
  }

  /// of a ball of the same volume.
  double radius() const { return 1 / std::cbrt(std::abs(matrix.determinant())); }

  struct Place
  {
    double residual; ///< the distance to first order, positive outside
    Vector normal;
  };

  Place place(const Vector& p) const
  {
    const Gradient g = gradient(p);
    const double steepness = g.gradient.norm();
    if(!(steepness > 0))
      return {-radius(), Vector::Zero()};
    return {(g.value - 1) / steepness, g.gradient / steepness};
  }

  Equations equations(const std::vector<Vector>& points, double deviation) const
  {
    Equations equations{Tukey(deviation)};
    const double r = radius();
    for(const Vector& p : points) {
      const Gradient g = gradient(p);
      const double steepness = g.gradient.norm();
      if(!(steepness > 0))
        continue;
      const Vector u = p - center;
      const Vector w = g.image / (g.value * steepness * r * r);
      Equations::Row row;
      row << -g.gradient / steepness, w[0] * u[0], w[0] * u[1] + w[1] * u[0],
          w[0] * u[2] + w[2] * u[0], w[1] * u[1], w[1] * u[2] + w[2] * u[1], w[2] * u[2];
      equations.add((g.value - 1) / steepness, row);
    }
    return equations;
  }

  void move(const Equations::Row& step)
  {
    const double r = radius();
    Matrix change;
    change << step[3], step[4], step[5], step[4], step[6], step[7], step[5], step[7], step[8];
    center += step.head<3>();
    matrix += change / (r * r);
  }

private:
  struct Gradient
  {
    Vector image; ///< `B u`
    double value; ///< its length, 1 on the ellipsoid
    Vector gradient;
  };

  Gradient gradient(const Vector& p) const
  {
    const Vector image = matrix * (p - center);
    const double value = image.norm();
    return {image, value, value > 0 ? Vector(matrix * image / value) : Vector::Zero()};
  }
};

/// \brief returns the ellipsoid of the quadric that is zero at the points, and whose gradient is their normals,
/// as far as it can (least squares), or nothing if that is no ellipsoid.
/// \param length the unit in which the two are compared
inline std::optional<Ellipsoid> ellipsoid_with_normals(const std::vector<Eigen::Vector3d>& points,
                                                       const std::vector<Eigen::Vector3d>& normals,
                                                       const Eigen::Vector3d& origin, double length)
{
  using Row = Eigen::Matrix<double, 10, 1>; // xx, xy, xz, yy, yz, zz, x, y, z, 1
  Eigen::Matrix<double, 10, 10> hessian = Eigen::Matrix<double, 10, 10>::Zero();
  Row gradient = Row::Zero();
  const auto add = [&](const Row& row, double value) {
    hessian.noalias() += row * row.transpose();
    gradient += value * row;
  };
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = (points[i] - origin) / length;
    const double x = p.x(), y = p.y(), z = p.z();
    Row value, dx, dy, dz;
    value << x * x, x * y, x * z, y * y, y * z, z * z, x, y, z, 1;
    dx << 2 * x, y, z, 0, 0, 0, 1, 0, 0, 0;
    dy << 0, x, 0, 2 * y, z, 0, 0, 1, 0, 0;
    dz << 0, 0, x, 0, y, 2 * z, 0, 0, 1, 0;
    add(value, 0);
    add(dx, normals[i].x());
    add(dy, normals[i].y());
    add(dz, normals[i].z());
  }
  hessian.diagonal().array() += 1e-9 * double(points.size());
  const Row q = solve_symmetric(hessian, gradient);
  Eigen::Matrix3d a;
  a << q[0], q[1] / 2, q[2] / 2, q[1] / 2, q[3], q[4] / 2, q[2] / 2, q[4] / 2, q[5];
  const Eigen::Vector3d b = q.segment<3>(6);
  const Eigen::Vector3d center = -0.5 * solve_symmetric(a, b);
  const double level = center.dot(a * center) - q[9]; // (p - c)ᵀ A (p - c) = level
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(a / level);
  if(!(level > 0) || !(eigen.eigenvalues()[0] > 0) || !center.allFinite())
    return std::nullopt;
  Ellipsoid ellipsoid;
  ellipsoid.center = origin + length * center;
  ellipsoid.matrix = eigen.operatorSqrt() / length;
  return ellipsoid;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_FITTING_ELLIPSOID_H
