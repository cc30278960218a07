// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_FITTING_ROBUST_FIT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_FITTING_ROBUST_FIT_H

#include <CGAL/Area_projection_transform/internal/solve_symmetric.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the element in the middle of an order; 0 of none. Reorders the values.
inline double median(std::vector<double>& values)
{
  if(values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// the standard deviation of normally distributed residuals around zero, few of which are outliers.
inline double robust_deviation(const std::vector<double>& residuals)
{
  std::vector<double> sizes;
  sizes.reserve(residuals.size());
  for(double residual : residuals)
    sizes.push_back(std::abs(residual));
  return 1.4826 * median(sizes);
}

/// \brief Tukey's biweight: the weight of a residual, and the slope of residual times weight.
///
/// With 4.685 standard deviations the estimate has 95 % of the efficiency of least squares.
struct Tukey
{
  double limit;

  explicit Tukey(double deviation) : limit(4.685 * deviation) {}

  double weight(double residual) const
  {
    const double u = residual / limit;
    const double v = 1 - u * u;
    return v > 0 ? v * v : 0;
  }

  double slope(double residual) const
  {
    const double u = residual / limit;
    const double v = 1 - u * u;
    return v > 0 ? v * (1 - 5 * u * u) : 0;
  }
};

/// \brief the normal equations of a robust fit, and what they tell of its precision.
///
/// Residuals are `observed - model`; a row of the Jacobian is the derivative of a residual.
template <int Size>
class Normal_equations
{
public:
  using Row = Eigen::Matrix<double, Size, 1>;
  using Matrix = Eigen::Matrix<double, Size, Size>;

  explicit Normal_equations(const Tukey& tukey) : m_tukey(tukey) {}

  /// \param prior how much the point counts, whatever its residual
  void add(double residual, const Row& row, double prior = 1)
  {
    const double weight = prior * m_tukey.weight(residual);
    if(weight > 0) {
      m_hessian.noalias() += weight * row * row.transpose();
      m_gradient += weight * residual * row;
      const double psi = weight * residual;
      m_scatter.noalias() += psi * psi * row * row.transpose();
    }
    m_sum_of_weights += weight;
    m_sum_of_slopes += prior * m_tukey.slope(residual);
    ++m_number;
  }

  std::size_t number() const { return m_number; }

  /// \brief the change of the parameters that lessens the residuals; a parameter that `is_fixed` stays.
  /// \param ridge is added to the diagonal, in units of the sum of the weights
  Row step(const Row& ridge) const
  {
    Matrix hessian = m_hessian;
    hessian.diagonal() += m_sum_of_weights * ridge;
    return solve_symmetric(hessian, -m_gradient);
  }

  /// \brief the covariance of the parameters (Huber's sandwich, corrected for the number of parameters).
  /// \param free the parameters that were fitted
  Matrix covariance(const std::vector<int>& free) const
  {
    const Eigen::Index n = Eigen::Index(free.size());
    Small_matrix hessian(n, n), scatter(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < n; ++j) {
        hessian(i, j) = m_hessian(free[std::size_t(i)], free[std::size_t(j)]);
        scatter(i, j) = m_scatter(free[std::size_t(i)], free[std::size_t(j)]);
      }
    const Small_matrix inverse = solve_symmetric(hessian, Small_matrix::Identity(n, n));
    const double slopes = m_sum_of_slopes > 0 ? m_sum_of_weights / m_sum_of_slopes : 1;
    const double numbers = double(m_number) / std::max(double(m_number) - double(n), 1.);
    const Small_matrix reduced = inverse * scatter * inverse * (slopes * slopes * numbers);
    Matrix all = Matrix::Zero();
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < n; ++j)
        all(free[std::size_t(i)], free[std::size_t(j)]) = reduced(i, j);
    return all;
  }

private:
  Tukey m_tukey;
  Matrix m_hessian = Matrix::Zero();
  Matrix m_scatter = Matrix::Zero();
  Row m_gradient = Row::Zero();
  double m_sum_of_weights = 0;
  double m_sum_of_slopes = 0;
  std::size_t m_number = 0;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_FITTING_ROBUST_FIT_H
