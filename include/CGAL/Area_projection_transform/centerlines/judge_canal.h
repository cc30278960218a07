// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_JUDGE_CANAL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_JUDGE_CANAL_H

#include <CGAL/Area_projection_transform/centerlines/fit_canal.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// what the surface says for and against a piece of tube.
struct Canal_support
{
  std::size_t voters = 0;
  double area = 0; ///< of the surface that lies on it
  double deviation =
      0;               ///< of the points that were fitted, root mean square, in units of the radius
  double coverage = 0; ///< the part of the circumference where there is a surface
  double isotropy =
      0; ///< of the normals across the axis: 1 for a half circle, 0 for two parallel walls
  double area_within = 0; ///< deep inside, of what does not face the axis, in units of `area`
  double ahead = 0;       ///< the part of the weight on the side where the axis goes to
  double last = 0;        ///< the furthest voter along the axis
  /// how much normals turn along the axis, in units of what they do on a sphere: 0 for tubes, bent ones, too.
  double closing = 0;
  /// the angle between the normals of the surface and those of the model, root mean square: large in
  /// corners.
  double normal_error = 0;
  double claimed = 0; ///< the part of the area that belongs to other lines already
};

/// the line that each sample belongs to, or -1.
using Claims = std::vector<std::int32_t>;

/// measures the support of a piece of tube that was fitted.
class Canal_judge
{
public:
  /// \param claims may be empty
  Canal_judge(const Canal& canal, const Canal_fit& fit, const Claims& claims)
      : m_canal(canal), m_claims(claims), m_across(canal.across())
  {
    const Canal_neighbours& near = fit.neighbours();
    const Canal::View view(canal);
    for(std::size_t i = 0; i < near.positions.size(); ++i) {
      const Canal::Place at = view(near.positions[i]);
      const double weight = fit.window()(canal, at, near.normals[i]);
      if(weight > 0)
        add_voter(at, near, i, weight);
      else if(std::abs(at.along) < fit.window().half_length * canal.tube.radius &&
              at.distance < deep * at.model && near.normals[i].dot(at.radial) > facing_inward)
        m_area_within += near.areas[i];
    }
  }

  Canal_support support() const
  {
    Canal_support support;
    support.voters = m_voters;
    support.area = m_area;
    if(!(m_fitted > 0) || !(m_weighed > 0))
      return support;
    support.deviation = std::sqrt(m_squares / m_fitted) / m_canal.tube.radius;
    support.coverage = coverage();
    const double mean = 0.5 * (m_xx + m_yy);
    const double off = std::hypot(0.5 * (m_xx - m_yy), m_xy);
    support.isotropy = (mean - off) / (mean + off);
    support.area_within = m_area_within / m_area;
    support.ahead = m_ahead / m_weighed;
    support.last = m_last;
    support.normal_error = std::sqrt(m_normal_errors / m_weighed);
    support.claimed = m_claimed / m_area;
    const double variance = m_ss - m_s * m_s / m_weighed;
    if(variance > 0)
      support.closing = (m_sn - m_s * m_n / m_weighed) / variance * m_canal.tube.radius;
    return support;
  }

private:
  static constexpr double deep = 0.6, facing_inward = -0.3;

  void add_voter(const Canal::Place& at, const Canal_neighbours& near, std::size_t i, double weight)
  {
    const double area = near.areas[i] * weight;
    ++m_voters;
    m_area += near.areas[i];
    if(!m_claims.empty() && m_claims[near.indices[i]] >= 0)
      m_claimed += near.areas[i];
    m_fitted += near.weights[i] * weight;
    m_squares += near.weights[i] * weight * at.residual() * at.residual();
    m_weighed += area;
    if(at.along > 0)
      m_ahead += area;
    m_last = std::max(m_last, at.along);
    const Eigen::Vector3d& n = near.normals[i];
    const double along = n.dot(at.tangent);
    const double cosine = at.cosine(n, m_canal.tube.slope);
    m_normal_errors += area * std::max(1 - cosine * cosine, 0.);
    m_s += area * at.along;
    m_ss += area * at.along * at.along;
    m_n += area * along;
    m_sn += area * at.along * along;
    const double x = n.dot(m_across.first), y = n.dot(m_across.second);
    m_xx += area * x * x;
    m_xy += area * x * y;
    m_yy += area * y * y;
    cover(at, near.areas[i]);
  }

  /// a sample covers as much of the circumference as a square of its area.
  void cover(const Canal::Place& at, double area)
  {
    const double middle =
        std::atan2(at.radial.dot(m_across.second), at.radial.dot(m_across.first)) / turn;
    const double length = std::min(std::sqrt(area) / (at.model * turn), 0.15);
    const double begin = middle - 0.5 * length, in_turn = begin - std::floor(begin);
    m_covered.emplace_back(in_turn, in_turn + length);
  }

  /// the part of the circumference that is covered, wherever angles are counted from.
  double coverage() const
  {
    std::vector<std::pair<double, double>> arcs = m_covered;
    std::sort(arcs.begin(), arcs.end());
    double covered_to = 0;
    for(const auto& [begin, end] : arcs)
      covered_to = std::max(covered_to, end);
    // What reaches beyond the turn covers its beginning.
    covered_to -= 1;
    double uncovered = 0;
    for(const auto& [begin, end] : arcs) {
      uncovered += std::max(begin - std::max(covered_to, 0.), 0.);
      covered_to = std::max(covered_to, end);
    }
    return 1 - uncovered - std::max(1 - std::max(covered_to, 0.), 0.);
  }

  static constexpr double turn = 2 * 3.14159265358979323846;
  const Canal& m_canal;
  const Claims& m_claims;
  std::pair<Eigen::Vector3d, Eigen::Vector3d> m_across;
  std::vector<std::pair<double, double>> m_covered; // in turns, from [0, 1) on
  std::size_t m_voters = 0;
  double m_area = 0, m_area_within = 0, m_fitted = 0, m_squares = 0, m_weighed = 0, m_ahead = 0,
         m_last = 0, m_claimed = 0;
  double m_normal_errors = 0;
  double m_s = 0, m_ss = 0, m_n = 0, m_sn = 0, m_xx = 0, m_xy = 0, m_yy = 0;
};

/// whether the surface around a piece of tube is that of a tube.
inline bool is_tube(const Canal& canal, const Canal_support& support, double smallest_radius,
                    double largest_radius)
{
  // Where tubes meet they look like one that widens fast, to which little fits well.
  const double most_deviation = 0.1 / (1 + 8 * std::abs(canal.tube.slope));
  // So does a tube in a corner, of which there is not much more than half.
  const double most_normal_error = support.coverage < 0.65 ? 0.22 : 0.5;
  const double r = canal.round_radius();
  return r > 0.7 * smallest_radius && r < 1.3 * largest_radius && support.voters >= 10 &&
         support.deviation < most_deviation && support.coverage > 0.5 && support.isotropy > 0.2 &&
         support.area_within < 0.25 && std::abs(support.closing) < 0.6 &&
         support.normal_error < most_normal_error;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_JUDGE_CANAL_H
