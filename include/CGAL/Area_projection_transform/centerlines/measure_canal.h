// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_MEASURE_CANAL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_MEASURE_CANAL_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Line_tracer.h>
#include <CGAL/Area_projection_transform/centerlines/refine_chain.h>
#include <CGAL/Area_projection_transform/fitting/Robust_fit.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the section across a tube: the ellipse that was fitted, and what the surface has beside it, smoothed.
///
/// That is the means of the residuals in sectors, of which the waves of three to six periods are taken. With gaps in the
/// circumference it is the ellipse.
class Canal_section
{
public:
  Canal_section(const Canal& canal, const Canal_neighbours& near, const Canal_window& window)
      : m_canal(canal)
  {
    std::array<double, sectors> sums{}, weights{};
    const auto [e1, e2] = canal.across();
    for(std::size_t i = 0; i < near.positions.size(); ++i) {
      const Canal::Place at = canal.place(near.positions[i]);
      const double weight = near.weights[i] * window(canal, at, near.normals[i]);
      if(!(weight > 0))
        continue;
      const double turn = std::atan2(at.radial.dot(e2), at.radial.dot(e1)) / (2 * pi) + 1;
      const std::size_t k = std::size_t(turn * sectors) % sectors;
      sums[k] += weight * at.residual();
      weights[k] += weight;
    }
    if(*std::min_element(weights.begin(), weights.end()) > 0)
      for(std::size_t n = 0; n < waves; ++n)
        for(std::size_t k = 0; k < sectors; ++k)
          m_waves[n] += 2. / sectors * sums[k] / weights[k] *
                        std::polar(1., -double(n + first_wave) * angle(k, sectors));
    measure(e1, e2);
  }

  double area() const { return m_area; }
  double perimeter() const { return m_perimeter; }
  double inscribed_radius() const { return m_inscribed_radius; }

private:
  static constexpr double pi = 3.14159265358979323846;
  static constexpr std::size_t sectors = 24, first_wave = 3, waves = 4, corners = 96;

  /// of the middle of a sector.
  static double angle(std::size_t k, std::size_t number)
  {
    return 2 * pi * (double(k) + 0.5) / double(number);
  }

  double distance(const Eigen::Vector3d& direction, double a) const
  {
    const double u = direction.dot(m_canal.ellipse * direction);
    double d = m_canal.tube.radius / std::sqrt(1 + u);
    for(std::size_t n = 0; n < waves; ++n)
      d += std::real(m_waves[n] * std::polar(1., double(n + first_wave) * a));
    return d;
  }

  /// as a polygon of many corners; what a polygon lacks of a circle is given back.
  void measure(const Eigen::Vector3d& e1, const Eigen::Vector3d& e2)
  {
    std::array<Eigen::Vector2d, corners> points;
    m_inscribed_radius = m_canal.largest_semi_axis();
    for(std::size_t k = 0; k < corners; ++k) {
      const double a = angle(k, corners), x = std::cos(a), y = std::sin(a);
      const double d = distance(x * e1 + y * e2, a);
      points[k] = {d * x, d * y};
      m_inscribed_radius = std::min(m_inscribed_radius, d);
    }
    for(std::size_t k = 0; k < corners; ++k) {
      const Eigen::Vector2d &p = points[k], &q = points[(k + 1) % corners];
      m_area += 0.5 * (p.x() * q.y() - p.y() * q.x());
      m_perimeter += (q - p).norm();
    }
    const double sector = 2 * pi / corners;
    m_area *= sector / std::sin(sector);
    m_perimeter *= 0.5 * sector / std::sin(0.5 * sector);
  }

  const Canal& m_canal;
  std::array<std::complex<double>, waves> m_waves{};
  double m_area = 0, m_perimeter = 0, m_inscribed_radius = 0;
};

/// half of the interval that the radius is in with a probability of 95 %, from the residuals of the fit.
inline double radius_error(const Canal& canal, const Canal_neighbours& near,
                           const Canal_window& window)
{
  constexpr double in_95_percent = 1.96;
  Normal_equations<Canal::size> equations{
      Tukey(window.tolerance * canal.tube.radius / Tukey(1).limit)};
  const auto [e1, e2] = canal.across();
  for(std::size_t i = 0; i < near.positions.size(); ++i) {
    if(!(near.weights[i] > 0))
      continue;
    const Canal::Place at = canal.place(near.positions[i]);
    if(!(window(canal, at, near.normals[i]) > 0))
      continue;
    const double s = at.along / (window.half_length * canal.tube.radius);
    const double prior =
        near.weights[i] * (1 - s * s) * at.cosine(near.normals[i], canal.tube.slope);
    equations.add(at.residual(), canal.derivative(at, e1, e2), prior);
  }
  std::vector<int> all(Canal::size);
  std::iota(all.begin(), all.end(), 0);
  const double variance = equations.covariance(all)(Canal::RADIUS, Canal::RADIUS);
  return variance >= 0 ? in_95_percent * std::sqrt(variance) * canal.roundness()
                       : Centerline_vertex::unknown;
}

/// MAPT at the centre of a canal, at its radius and with `σ/R = 1/2` (paper, section 3).
inline double mapt_at(const Sample_levels& levels, const Canal& canal)
{
  constexpr double sigma_ratio = 0.5, pi = 3.14159265358979323846;
  const double r = canal.round_radius(), sigma = sigma_ratio * r;
  const Sample_levels::Level& level = levels.at(r);
  double area = 0;
  level.cells.for_each_in_ball(canal.tube.center, r + sigma, [&](std::size_t i, double) {
    const Eigen::Vector3d offset = level.positions[i] - r * level.normals[i] - canal.tube.center;
    if(offset.squaredNorm() <= sigma * sigma)
      area += std::min(level.areas[i], pi * sigma * sigma);
  });
  return area / (4 * pi * r * r);
}

/// what is known of a tube where a piece of it was fitted.
inline Centerline_vertex measure_canal(const Sample_levels& levels, const Fitted_canal& fitted)
{
  const Canal& canal = fitted.canal;
  Canal_fit fit(levels);
  fit.look_at(canal);
  const Canal_section section(canal, fit.neighbours(), fit.window());
  Centerline_vertex vertex;
  vertex.point = to_point_3(canal.tube.center);
  vertex.tangent = to_vector_3(canal.tube.axis);
  vertex.radius = canal.round_radius();
  const double error = radius_error(canal, fit.neighbours(), fit.window());
  vertex.radius_low = vertex.radius - error;
  vertex.radius_high = vertex.radius + error;
  vertex.coverage = fitted.support.coverage;
  vertex.mapt = mapt_at(levels, canal);
  vertex.area = section.area();
  vertex.perimeter = section.perimeter();
  vertex.inscribed_radius = section.inscribed_radius();
  vertex.origin = Centerline_origin::FITTED;
  return vertex;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_MEASURE_CANAL_H
