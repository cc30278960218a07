// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FIT_TUBE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FIT_TUBE_H

#include <CGAL/Area_projection_transform/salient_points/fit_shape.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// puts the centre of a tube into the middle of its piece.
inline void recenter(Shape& shape)
{
  const double middle = 0.5 * (shape.first + shape.last);
  shape.model = shape.tube().seen_from(middle);
  shape.first -= middle;
  shape.last -= middle;
}

/// the least evidence for a taper or a bend.
struct Tube_evidence
{
  static constexpr double slope_deviations = 4.5;
  static constexpr double bend_deviations = 5;
  static constexpr double least_effect = 0.006; ///< on the surface, in units of the radius
};

/// \brief which of the parameters of a tube, all of which were fitted, are needed to explain the points.
inline Tube::Freedom needed_freedom(const Shape& shape, const std::vector<Eigen::Vector3d>& points)
{
  const Tube& tube = shape.tube();
  const Tube::Freedom all{true, true};
  const Tube::Equations::Matrix covariance =
      tube.equations(points, shape.deviation, all).covariance(all.free_parameters());
  const double r = tube.radius, half = 0.5 * shape.length() / r;
  Tube::Freedom needed;
  const double slope = tube.slope * r;
  needed.slope = slope * slope > Tube_evidence::slope_deviations * Tube_evidence::slope_deviations *
                                     covariance(Tube::SLOPE, Tube::SLOPE) &&
                 std::abs(tube.slope) * half > Tube_evidence::least_effect;
  const double bend = tube.curvature.norm() * r;
  // The mean of the variances along the two directions: bends have no preferred one.
  const double variance = 0.5 * (covariance(Tube::CURVATURE, Tube::CURVATURE) +
                                 covariance(Tube::CURVATURE + 1, Tube::CURVATURE + 1));
  needed.curvature = bend * bend * r * r > Tube_evidence::bend_deviations *
                                               Tube_evidence::bend_deviations * variance &&
                     0.5 * bend * half * half > Tube_evidence::least_effect;
  return needed;
}

/// drops what is not needed, and fits the rest again.
inline bool simplify_tube(const Free_clusters& clusters, Shape& shape)
{
  std::vector<Eigen::Vector3d> points;
  std::vector<double> residuals;
  collect_points(clusters, shape, band_of_round(3, shape.radius(), shape.deviation), points,
                 residuals);
  if(points.size() <= std::size_t(Tube::size) + 2)
    return true;
  const Tube::Freedom needed = needed_freedom(shape, points);
  if(needed.slope && needed.curvature)
    return true;
  Tube& tube = std::get<Tube>(shape.model);
  if(!needed.slope)
    tube.slope = 0;
  if(!needed.curvature)
    tube.curvature.setZero();
  return fit_shape(clusters, shape, needed, 2);
}

/// \brief fits a tube near its centre: a cylinder first, then all that it may be.
inline bool fit_short_tube(const Free_clusters& clusters, Shape& shape)
{
  constexpr double half_length = 1; // in units of the radius
  if(!fit_shape(clusters, shape, {false, false}))
    return false;
  recenter(shape);
  shape.last = half_length * shape.radius();
  shape.first = -shape.last;
  return fit_shape(clusters, shape, {true, true}, 1);
}

/// the part of the circumference that the surface covers, in bins along the axis.
class Tube_coverage
{
public:
  static constexpr double bin_length = 0.5; ///< in units of the radius

  /// \param tolerance how far from the tube the surface may be
  Tube_coverage(const Free_clusters& clusters, const Shape& shape, double reach, double tolerance)
      : m_bin(bin_length * shape.radius())
      , m_first(shape.first - reach)
      , m_areas(std::size_t(std::ceil((shape.length() + 2 * reach) / m_bin)), 0.)
  {
    const Vote_level& level = *clusters.level;
    clusters.for_each_near(shape, tolerance, reach, [&](std::size_t i, const Shape::Place& place) {
      const double cosine = level.normal(i).dot(place.normal);
      if(std::abs(place.residual) < tolerance && cosine > Fit_limits::least_cosine)
        add(place.along, level.area(i) * cosine);
    });
    constexpr double two_pi = 6.28318530717958647693;
    for(std::size_t b = 0; b < m_areas.size(); ++b)
      m_areas[b] /=
          two_pi * m_bin * std::max(shape.tube().radius_at(place(b)), 0.1 * shape.radius());
  }

  std::size_t size() const { return m_areas.size(); }
  double coverage(std::size_t bin) const { return m_areas[bin]; }
  std::size_t bin(double along) const
  {
    return std::size_t(std::clamp((along - m_first) / m_bin, 0., double(size() - 1)));
  }
  double begin(std::size_t bin) const { return m_first + double(bin) * m_bin; }
  double end(std::size_t bin) const { return begin(bin + 1); }
  double place(std::size_t bin) const { return m_first + (double(bin) + 0.5) * m_bin; }

private:
  // Clusters are nearly as long as a bin: each is shared by the two nearest ones.
  void add(double along, double area)
  {
    const double at = (along - m_first) / m_bin - 0.5;
    const double below = std::floor(at), fraction = at - below;
    const auto add_to = [&](double bin, double part) {
      if(bin >= 0 && bin < double(size()))
        m_areas[std::size_t(bin)] += part * area;
    };
    add_to(below, 1 - fraction);
    add_to(below + 1, fraction);
  }

  double m_bin, m_first;
  std::vector<double> m_areas;
};

/// the piece of a tube after the next walk along its axis: as far as it is covered like the piece it has.
inline bool lengthen(const Free_clusters& clusters, Shape& shape)
{
  constexpr double least_share = 0.35; // of the coverage of the piece
  const double radius = shape.radius();
  const double reach = std::max(0.6 * shape.length(), 1.5 * radius);
  const double tolerance = std::max(6 * shape.deviation, 0.12 * radius);
  const Tube_coverage coverage(clusters, shape, reach, tolerance);
  std::vector<double> inner;
  for(std::size_t b = 0; b < coverage.size(); ++b)
    if(coverage.place(b) > shape.first && coverage.place(b) < shape.last)
      inner.push_back(coverage.coverage(b));
  const double least = least_share * median(inner);
  const auto holds = [&](std::size_t b) {
    return b < coverage.size() && coverage.coverage(b) > least;
  };
  double first = shape.first, last = shape.last;
  // One bin without surface is bridged.
  for(std::size_t b = coverage.bin(shape.last); holds(b) || holds(b + 1); ++b)
    if(holds(b))
      last = std::max(last, coverage.end(b));
  for(std::size_t b = coverage.bin(shape.first); holds(b) || (b > 0 && holds(b - 1)); --b) {
    if(holds(b))
      first = std::min(first, coverage.begin(b));
    if(b == 0)
      break;
  }
  const bool is_longer = last - first > shape.length() + 0.3 * radius;
  shape.first = first;
  shape.last = last;
  return is_longer;
}

/// ends a tube where its surface ends.
inline void trim(const Free_clusters& clusters, Shape& shape)
{
  const double radius = shape.radius();
  const double tolerance = std::max(5 * shape.deviation, 0.05 * radius);
  double first = shape.last, last = shape.first;
  std::vector<double> places;
  clusters.for_each_near(
      shape, tolerance, 0.5 * radius, [&](std::size_t i, const Shape::Place& place) {
        if(std::abs(place.residual) < tolerance &&
           clusters.level->normal(i).dot(place.normal) > Fit_limits::least_cosine)
          places.push_back(place.along);
      });
  for(double along : places) {
    first = std::min(first, along);
    last = std::max(last, along);
  }
  if(first < last) {
    shape.first = first;
    shape.last = last;
  }
}

/// \brief whether what a tube misses is small for its thinner end, too: a finger does not go on as the palm.
inline bool is_thick_enough(const Shape& tube)
{
  constexpr double most_misfit = 0.13; // of the smaller radius
  return tube.misfit < most_misfit * std::min(tube.tube().radius_at(tube.first),
                                              tube.tube().radius_at(tube.last));
}

/// \brief follows a tube along its axis as far as it goes, fitting it to all of it.
inline void follow_tube(const Free_clusters& clusters, Shape& shape)
{
  constexpr int most_walks = 12;
  constexpr double closed = 6.0; // radians: nearly once around
  for(int walk = 0; walk < most_walks; ++walk) {
    Shape longer = shape;
    if(!lengthen(clusters, longer))
      break;
    recenter(longer);
    const double bend = longer.tube().curvature.norm();
    const bool is_closed = bend * longer.length() > closed;
    if(is_closed) {
      longer.last = 3.14159265358979323846 / bend;
      longer.first = -longer.last;
    }
    if(!fit_shape(clusters, longer, {true, true}, 2) ||
       longer.deviation > 1.5 * shape.deviation + 0.01 * shape.radius() || !is_thick_enough(longer))
      break;
    shape = longer;
    if(is_closed)
      break;
  }
  trim(clusters, shape);
  recenter(shape);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FIT_TUBE_H
