// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SOLVE_SYMMETRIC_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SOLVE_SYMMETRIC_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a matrix of any size up to 10, without allocation.
///
/// One type for all of them, since whoever includes a fit would compile the decomposition of each size anew, which takes
/// longer than the fit itself.
using Small_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;

/// \brief returns the columns `x` of which `a x = b`, for a symmetric matrix `a` without negative eigenvalues, or without
/// positive ones.
inline Small_matrix solve_symmetric(const Small_matrix& a, const Small_matrix& b)
{
  return a.ldlt().solve(b);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SOLVE_SYMMETRIC_H
