// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_TRACER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_TRACER_H

#include <CGAL/Area_projection_transform/centerlines/fit_canal.h>
#include <CGAL/Area_projection_transform/centerlines/judge_canal.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a piece of tube that fits, and how well.
struct Fitted_canal
{
  Canal canal;
  Canal_support support;
};

/// pieces of tube one after the other; the axis of each points to the next.
struct Traced_line
{
  std::vector<Fitted_canal> points;
  bool is_closed = false;

  double length() const
  {
    double length = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
      length += (points[i].canal.tube.center - points[i - 1].canal.tube.center).norm();
    return length;
  }

  double mean_radius() const
  {
    double sum = 0;
    for(const Fitted_canal& point : points)
      sum += point.canal.round_radius();
    return points.empty() ? 0 : sum / double(points.size());
  }
};

/// \brief follows tubes along their axis, as long as a piece of tube fits to the surface around it.
class Line_tracer
{
public:
  Line_tracer(const Sample_levels& levels, double smallest_radius, double largest_radius)
      : m_fit(levels), m_smallest_radius(smallest_radius), m_largest_radius(largest_radius)
  {}

  /// fits a piece of tube at a seed; nothing if there is none.
  std::optional<Fitted_canal> start(const Canal& seed)
  {
    Canal canal = seed;
    m_fit.from_seed(canal);
    Fitted_canal start{canal, Canal_judge(canal, m_fit, Claims()).support()};
    if(!is_tube(canal, start.support, m_smallest_radius, m_largest_radius))
      return std::nullopt;
    return start;
  }

  /// \brief follows a tube from a piece of it, both ways.
  ///
  /// The line is empty if the piece belongs to another one.
  /// \param claims what belongs to other lines: there a line ends
  Traced_line trace(const Fitted_canal& start, const Claims& claims)
  {
    Traced_line line;
    m_fit.look_at(start.canal);
    if(Canal_judge(start.canal, m_fit, claims).support().claimed > most_claimed)
      return line;
    std::vector<Fitted_canal> backward;
    line.is_closed = follow(start, claims, line.points);
    if(!line.is_closed)
      follow({start.canal.reversed(), start.support}, claims, backward);
    std::reverse(backward.begin(), backward.end());
    for(Fitted_canal& point : backward) {
      point.canal = point.canal.reversed();
      point.support.ahead = 1 - point.support.ahead;
    }
    backward.push_back(start);
    backward.insert(backward.end(), line.points.begin(), line.points.end());
    line.points = std::move(backward);
    return line;
  }

  static constexpr double step = 0.35; ///< in units of the radius

private:
  static constexpr std::size_t most_points = 20000;
  static constexpr double most_claimed = 0.6;

  /// appends points ahead of `start`, without it; returns whether the line came back to it.
  bool follow(const Fitted_canal& start, const Claims& claims, std::vector<Fitted_canal>& points)
  {
    Fitted_canal last = start;
    double length = 0;
    while(points.size() < most_points) {
      std::optional<Fitted_canal> next = one_step(last.canal, claims);
      if(!next)
        return false;
      length += (next->canal.tube.center - last.canal.tube.center).norm();
      if(length > 4 * start.canal.tube.radius && is_back(next->canal, start.canal))
        return true;
      points.push_back(*next);
      last = *next;
    }
    return false;
  }

  /// whether the axis passes the start of the line within the next step.
  static bool is_back(const Canal& here, const Canal& start)
  {
    const Eigen::Vector3d way = start.tube.center - here.tube.center;
    const double r = start.tube.radius, along = way.dot(here.tube.axis);
    return here.tube.axis.dot(start.tube.axis) > 0.7 && along > -0.2 * r &&
           along < 1.2 * step * r && way.norm() < 1.3 * step * r;
  }

  std::optional<Fitted_canal> one_step(const Canal& last, const Claims& claims)
  {
    constexpr double least_advance = 0.3, least_cosine = 0.6, most_change = 1.35,
                     least_ahead = 0.12, least_last = 0.5;
    const double ahead = step * last.tube.radius;
    Fitted_canal next;
    next.canal = last.seen_from(ahead);
    const double expected = next.canal.round_radius();
    m_fit.from_neighbour(next.canal);
    const double ratio = next.canal.round_radius() / expected;
    if((next.canal.tube.center - last.tube.center).dot(last.tube.axis) < least_advance * ahead ||
       next.canal.tube.axis.dot(last.tube.axis) < least_cosine || !(ratio < most_change) ||
       !(ratio > 1 / most_change))
      return std::nullopt;
    next.support = Canal_judge(next.canal, m_fit, claims).support();
    if(!is_tube(next.canal, next.support, m_smallest_radius, m_largest_radius) ||
       (next.support.ahead < least_ahead &&
        next.support.last < least_last * next.canal.tube.radius) ||
       next.support.claimed > most_claimed)
      return std::nullopt;
    return next;
  }

  Canal_fit m_fit;
  double m_smallest_radius, m_largest_radius;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_TRACER_H
