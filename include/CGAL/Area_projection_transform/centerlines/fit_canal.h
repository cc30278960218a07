// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIT_CANAL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIT_CANAL_H

#include <CGAL/Area_projection_transform/centerlines/Canal.h>
#include <CGAL/Area_projection_transform/centerlines/Sample_levels.h>
#include <CGAL/Area_projection_transform/internal/solve_symmetric.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the samples around a piece of tube, together in memory.
struct Canal_neighbours
{
  using Vector = Eigen::Vector3d;

  std::vector<Vector> positions, normals;
  std::vector<double> areas, weights;
  std::vector<std::uint32_t> indices; ///< of the samples

  void gather(const Sample_levels& levels, const Canal& canal, double half_length)
  {
    positions.clear();
    normals.clear();
    areas.clear();
    weights.clear();
    indices.clear();
    const double r = canal.tube.radius;
    const double reach = std::hypot(half_length * r, canal.largest_semi_axis() + 0.4 * r);
    const Sample_levels::Level& level = levels.at(canal.round_radius());
    // A bend brings places on its outside nearer; and the axis may tilt a little while it is fitted.
    const double furthest =
        half_length * (r + 1.5 * canal.tube.curvature.norm() * r * r) + 0.15 * r;
    level.cells.for_each_in_ball(canal.tube.center, reach, [&](std::size_t i, double) {
      if(std::abs((level.positions[i] - canal.tube.center).dot(canal.tube.axis)) > furthest)
        return;
      positions.push_back(level.positions[i]);
      normals.push_back(level.normals[i]);
      areas.push_back(level.areas[i]);
      weights.push_back(level.weights[i]);
      indices.push_back(level.indices[i]);
    });
  }
};

/// \brief which samples belong to a piece of tube, and how much they count.
///
/// Lengths are in units of its radius.
struct Canal_window
{
  double half_length = 0.7;
  double tolerance = 0.2;
  double least_cosine = 0.6; ///< between the normals of surface and model

  /// the weight in (0, 1], or 0 of what does not belong.
  double operator()(const Canal& canal, const Canal::Place& at, const Eigen::Vector3d& normal) const
  {
    const double s = at.along / (half_length * canal.tube.radius);
    const double e = at.residual() / (tolerance * canal.tube.radius);
    if(!(s * s < 1) || !(e * e < 1))
      return 0;
    const double cosine = at.cosine(normal, canal.tube.slope);
    if(!(cosine > least_cosine))
      return 0;
    const double robust = 1 - e * e;
    return (1 - s * s) * robust * robust * cosine;
  }
};

/// \brief fits a piece of tube to the samples around it by iterated reweighted least squares.
///
/// The window narrows while it is fitted. What was given must be near.
class Canal_fit
{
public:
  explicit Canal_fit(const Sample_levels& levels) : m_levels(&levels) {}

  /// the fit at a seed, of which little is known but where it is.
  void from_seed(Canal& canal)
  {
    iterate(canal, 7, 0.35);
    iterate(canal, 4, 0.25);
  }

  /// the fit one step further.
  void from_neighbour(Canal& canal) { iterate(canal, 4, 0.35); }

  /// looks at what is around a fit that was made before.
  void look_at(const Canal& canal)
  {
    m_window.tolerance = least_tolerance;
    gather(canal);
  }

  /// the window of the last fit.
  const Canal_window& window() const { return m_window; }
  /// what there was around it.
  const Canal_neighbours& neighbours() const { return m_neighbours; }

private:
  static constexpr double least_tolerance = 0.2, shrinkage = 0.85;

  void iterate(Canal& canal, int times, double tolerance)
  {
    m_window.tolerance = tolerance;
    gather(canal);
    for(int i = 0; i < times; ++i) {
      const bool is_still = !improve(canal);
      m_window.tolerance = std::max(least_tolerance, shrinkage * m_window.tolerance);
      if(is_still && m_window.tolerance == least_tolerance)
        return;
    }
  }

  /// \brief finds what is around, further along the axis where there is little.
  ///
  /// Errors of the points fall with the square root of their number, and those of the tilt with the length.
  void gather(const Canal& canal)
  {
    constexpr double half_length = 0.7, longest = 1.4, enough = 60;
    m_window.half_length = half_length;
    m_neighbours.gather(*m_levels, canal, half_length);
    const double number = effective_number(canal);
    if(number >= enough)
      return;
    m_window.half_length = std::min(half_length * enough / std::max(number, 1.), longest);
    m_neighbours.gather(*m_levels, canal, m_window.half_length);
  }

  /// how many points of equal weight would tell as much.
  double effective_number(const Canal& canal) const
  {
    const Canal::View view(canal);
    double sum = 0, squares = 0;
    for(std::size_t i = 0; i < m_neighbours.positions.size(); ++i) {
      if(!(m_neighbours.weights[i] > 0))
        continue;
      const Canal::Place at = view(m_neighbours.positions[i]);
      const double weight = m_neighbours.weights[i] * m_window(canal, at, m_neighbours.normals[i]);
      sum += weight;
      squares += weight * weight;
    }
    return squares > 0 ? sum * sum / squares : 0;
  }

  /// one step; returns whether it changed much.
  bool improve(Canal& canal)
  {
    using Matrix = Eigen::Matrix<double, Canal::size, Canal::size>;
    Matrix hessian = Matrix::Zero();
    Canal::Row gradient = Canal::Row::Zero();
    double sum = 0;
    const auto [e1, e2] = canal.across();
    const Canal::View view(canal);
    for(std::size_t i = 0; i < m_neighbours.positions.size(); ++i) {
      const double fitted = m_neighbours.weights[i];
      if(!(fitted > 0))
        continue;
      const Canal::Place at = view(m_neighbours.positions[i]);
      const double weight = fitted * m_window(canal, at, m_neighbours.normals[i]);
      if(!(weight > 0))
        continue;
      const Canal::Row row = canal.derivative(at, e1, e2);
      hessian.noalias() += (weight * row) * row.transpose();
      gradient += weight * at.residual() * row;
      sum += weight;
    }
    if(!(sum > 0))
      return false;
    Canal::Row ridge;
    ridge << 1e-4, 1e-4, 0.003, 0.003, 0.004, 0.004, 1e-4, 0.01, 0.03, 0.03;
    hessian.diagonal() += sum * ridge;
    const Canal::Row step = solve_symmetric(hessian, -gradient);
    if(!step.allFinite())
      return false;
    canal.move(step, e1, e2);
    return step.squaredNorm() > 1e-8 * canal.tube.radius * canal.tube.radius;
  }

  const Sample_levels* m_levels;
  Canal_neighbours m_neighbours;
  Canal_window m_window;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIT_CANAL_H
