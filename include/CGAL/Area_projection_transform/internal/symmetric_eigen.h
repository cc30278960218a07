// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SYMMETRIC_EIGEN_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SYMMETRIC_EIGEN_H

#include <CGAL/Area_projection_transform/Covariance_3.h>
#include <CGAL/Area_projection_transform/Kernel.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Area_projection {
namespace internal {

inline Eigen::Matrix3d symmetric_matrix(const Covariance_3& m)
{
  Eigen::Matrix3d matrix;
  matrix << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return matrix;
}

/// \brief returns the eigenvalues of a symmetric matrix, by their magnitude, the smallest first.
///
/// In closed form: the error is up to the root of the machine epsilon (1e-8), relative to the largest of
/// them. That is what a value is good for, not a direction: where two eigenvalues are that close, the
/// closed form has vectors that are not orthogonal, or none.
inline std::array<double, 3> eigenvalues_by_magnitude(const Covariance_3& m)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(symmetric_matrix(m), Eigen::EigenvaluesOnly);
  std::array<double, 3> values{solver.eigenvalues()[0], solver.eigenvalues()[1],
                               solver.eigenvalues()[2]};
  const auto order = [&](std::size_t i, std::size_t j) {
    if(std::abs(values[j]) < std::abs(values[i]))
      std::swap(values[i], values[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return values;
}

/// \brief a direction, as a unit vector whose last component other than zero is positive: of the two, always
/// the same.
inline Vector_3 without_sign(const Eigen::Vector3d& v)
{
  const bool is_positive = v[2] != 0 ? v[2] > 0 : v[1] != 0 ? v[1] > 0 : v[0] > 0;
  const double sign = is_positive ? 1 : -1;
  return Vector_3(sign * v[0], sign * v[1], sign * v[2]);
}

/// \brief returns the direction of the eigenvalue of the smallest magnitude; where two are the smallest, any
/// in their plane.
///
/// By iteration, which is backward stable: the vector belongs to a matrix that differs from this by the
/// rounding of its norm, whatever the eigenvalues.
inline Vector_3 direction_of_smallest(const Covariance_3& m)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric_matrix(m));
  Eigen::Index smallest = 0;
  solver.eigenvalues().cwiseAbs().minCoeff(&smallest);
  return without_sign(solver.eigenvectors().col(smallest));
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SYMMETRIC_EIGEN_H
