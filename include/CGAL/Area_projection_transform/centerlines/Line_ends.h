// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_ENDS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_ENDS_H

#include <CGAL/Area_projection_transform/centerlines/Line_tracer.h>
#include <CGAL/Area_projection_transform/centerlines/Sample_levels.h>
#include <CGAL/Area_projection_transform/fitting/Robust_fit.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// an end of a line, seen outward.
struct Line_end
{
  Canal canal;          ///< the last one; its axis points out of the line
  double dropped = 0;   ///< the length that was followed beyond it, to which the surface fits badly
  double extension = 0; ///< from there straight on to the surface or the rim
  bool is_tip = false;  ///< whether there is nothing but air behind that
};

/// \brief drops points at the ends of a line to which the surface fits badly, as it becomes a cap or widens.
///
/// In a round cap the sphere has no axis, so that the tangent drifts. Where tubes meet the radius grows.
class End_trimmer
{
public:
  struct Dropped
  {
    std::size_t points = 0;
    double length = 0;
  };

  /// \return what was dropped at the front and at the back
  static std::array<Dropped, 2> trim(Traced_line& line)
  {
    std::array<Dropped, 2> dropped;
    if(line.is_closed)
      return dropped;
    std::vector<Fitted_canal>& points = line.points;
    for(int end = 0; end < 2; ++end)
      dropped[std::size_t(end)].points = number_of_bad(points, end);
    while(dropped[0].points + dropped[1].points > 0 &&
          dropped[0].points + dropped[1].points + least_left > points.size())
      spare_one(dropped);
    for(int end = 0; end < 2; ++end) {
      Dropped& those = dropped[std::size_t(end)];
      for(std::size_t k = 0; k < those.points; ++k)
        those.length += distance(point_from(points, end, k), point_from(points, end, k + 1));
    }
    points.erase(points.end() - std::ptrdiff_t(dropped[1].points), points.end());
    points.erase(points.begin(), points.begin() + std::ptrdiff_t(dropped[0].points));
    return dropped;
  }

private:
  static constexpr std::size_t most_dropped = 8, least_left = 4;

  /// the radius of a line before its end, and how it changes there.
  struct Usual
  {
    double radius, slope;
  };

  /// where most is dropped one point less is, at both ends if they are alike.
  static void spare_one(std::array<Dropped, 2>& dropped)
  {
    const std::size_t most = std::max(dropped[0].points, dropped[1].points);
    for(Dropped& those : dropped)
      if(those.points == most)
        --those.points;
  }

  /// a point counted from the front (0) or the back (1).
  static const Fitted_canal& point_from(const std::vector<Fitted_canal>& points, int end,
                                        std::size_t k)
  {
    return points[end == 0 ? k : points.size() - 1 - k];
  }

  static double distance(const Fitted_canal& a, const Fitted_canal& b)
  {
    return (a.canal.tube.center - b.canal.tube.center).norm();
  }

  static std::size_t number_of_bad(const std::vector<Fitted_canal>& points, int end)
  {
    const Usual usual = usual_behind(points, end);
    const std::size_t most =
        points.size() > least_left ? std::min(most_dropped, points.size() - least_left) : 0;
    std::size_t bad = 0;
    while(bad < most && is_bad(point_from(points, end, bad), end, usual))
      ++bad;
    return bad;
  }

  static Usual usual_behind(const std::vector<Fitted_canal>& points, int end)
  {
    constexpr std::size_t first = 3, last = 12;
    std::vector<double> slopes, radii;
    for(std::size_t k = std::min(first, points.size() / 2); k < std::min(last, points.size());
        ++k) {
      const Fitted_canal& point = point_from(points, end, k);
      slopes.push_back(outward(end) * point.canal.tube.slope);
      // As it would be at the end.
      radii.push_back(point.canal.tube.radius +
                      slopes.back() * distance(point, point_from(points, end, 0)));
    }
    return {median(radii), median(slopes)};
  }

  /// whether axes point to the end (1) or away from it (-1)
  static double outward(int end) { return end == 0 ? -1 : 1; }

  static bool is_bad(const Fitted_canal& point, int end, const Usual& usual)
  {
    constexpr double least_ahead = 0.15, most_change = 0.08, most_closing = 0.25,
                     most_widened = 1.12;
    const double ahead = end == 1 ? point.support.ahead : 1 - point.support.ahead;
    return ahead < least_ahead || std::abs(point.support.closing) > most_closing ||
           std::abs(outward(end) * point.canal.tube.slope - usual.slope) > most_change ||
           point.canal.tube.radius > most_widened * usual.radius;
  }
};

/// \brief the winding number of a surface around a place, from samples: about 1 inside and 0 outside, and less where faces
/// are missing.
inline double winding_number(const Sample_levels::Level& level, const Eigen::Vector3d& place)
{
  double sum = 0;
  for(std::size_t i = 0; i < level.positions.size(); ++i) {
    const Eigen::Vector3d d = level.positions[i] - place;
    // A sample is as wide as its area: from near it is no point.
    const double squared = d.squaredNorm() + 0.1 * level.areas[i];
    if(squared > 0)
      sum += level.areas[i] * level.normals[i].dot(d) / (squared * std::sqrt(squared));
  }
  return sum / (4 * 3.14159265358979323846);
}

/// finds where the tube around the end of a line ends.
class End_finder
{
public:
  /// \param canal the last piece, whose axis points outward
  /// \param dropped the length that fitted badly beyond it
  static Line_end find(const Sample_levels& levels, const Canal& canal, double dropped)
  {
    constexpr double near_cap = 1.35, beyond = 0.25, least_change = 0.5;
    const double r = canal.round_radius();
    Line_end end;
    end.canal = canal;
    end.dropped = dropped;
    // Where it was dropped it still bent.
    Tube tube = canal.tube.seen_from(dropped);
    tube.curvature.setZero();
    const Ahead ahead = look_ahead(levels, canal, tube);
    end.extension = ahead.cap < 2 * r ? ahead.cap : std::max(ahead.wall, -dropped);
    if(ahead.cap > near_cap * r)
      return end;
    const Sample_levels::Level& level = levels.at(r);
    const Eigen::Vector3d behind = tube.center + (ahead.cap + beyond * r) * tube.axis;
    end.is_tip =
        winding_number(level, behind) < least_change * winding_number(level, canal.tube.center);
    return end;
  }

private:
  static constexpr double far = std::numeric_limits<double>::max();

  struct Ahead
  {
    double cap = far;   ///< the nearest surface across the axis, facing outward
    double wall = -far; ///< the furthest of the tube itself
  };

  /// \param tube where the line leaves the canal, straight on
  static Ahead look_ahead(const Sample_levels& levels, const Canal& canal, const Tube& tube)
  {
    constexpr double distance = 3, around_axis = 0.35, facing = 0.3, tolerance = 0.2,
                     furthest = 1.5;
    const double r = canal.round_radius();
    const Sample_levels::Level& level = levels.finest();
    Ahead ahead;
    level.cells.for_each_in_ball(tube.center, distance * r, [&](std::size_t i, double) {
      const Eigen::Vector3d d = level.positions[i] - tube.center;
      const Eigen::Vector3d& n = level.normals[i];
      const double s = d.dot(tube.axis), across = (d - s * tube.axis).norm();
      if(s > -0.5 * r && across < around_axis * r && n.dot(tube.axis) > facing)
        ahead.cap = std::min(ahead.cap, std::max(s, 0.));
      const Canal::Place at = canal.place(level.positions[i]);
      if(at.along > 0 && s < furthest * r && std::abs(at.residual()) < tolerance * r &&
         n.dot(at.radial) > facing)
        ahead.wall = std::max(ahead.wall, s);
    });
    return ahead;
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_ENDS_H
