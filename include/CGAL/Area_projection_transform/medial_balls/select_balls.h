// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SELECT_BALLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SELECT_BALLS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_balls/bounded_spacing.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <queue>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the positions, in `balls`, of those whose weight is at least a threshold, in their order.
/// \param balls the balls
/// \param weight what they are weighed by
/// \param threshold in the unit of the weight, for `IMPORTANCE` and `LAMBDA` a length
/// \param sigma_ratio that of the options with which the balls were computed
/// \throw std::invalid_argument if the threshold is not a number
inline std::vector<std::size_t> select_by_weight(const std::vector<Medial_ball>& balls,
                                                 Medial_weight weight, double threshold,
                                                 double sigma_ratio = 0.5)
{
  if(std::isnan(threshold))
    throw std::invalid_argument("threshold is not a number");
  std::vector<std::size_t> selected;
  for(std::size_t i = 0; i < balls.size(); ++i)
    if(weight_of(balls[i], weight, sigma_ratio) >= threshold)
      selected.push_back(i);
  return selected;
}

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_suppression(double suppression)
{
  if(!(suppression >= 0) || !std::isfinite(suppression))
    throw std::invalid_argument("suppression is " + internal::to_text(suppression) +
                                ": must be finite and not negative");
}

/// the first ones of an order that are not too near to one before.
inline std::vector<std::size_t> select_in_order(const std::vector<Medial_ball>& balls,
                                                const std::vector<std::size_t>& order,
                                                std::size_t number, double suppression)
{
  std::vector<std::size_t> selected;
  for(std::size_t k = 0; k < order.size() && selected.size() < number; ++k) {
    const Medial_ball& ball = balls[order[k]];
    const auto is_near = [&](std::size_t other) {
      const double reach = suppression * std::min(ball.radius, balls[other].radius);
      return squared_distance(ball.center, balls[other].center) < reach * reach;
    };
    if(std::none_of(selected.begin(), selected.end(), is_near))
      selected.push_back(order[k]);
  }
  return selected;
}

/// places on a surface, to see which of them balls cover.
class Covered_surface
{
public:
  template <class Source>
  Covered_surface(const Source& surface, std::size_t number, double tolerance)
      : m_tolerance(tolerance)
  {
    const double area = surface.total_area();
    if(!(area > 0))
      return;
    const double most = double(surface.size()) + 6 * double(number);
    const double spacing = bounded_spacing(surface, std::sqrt(area / double(number)), most);
    surface.for_each_batch(spacing, [&](const Surfels& batch) {
      for(std::size_t i = 0; i < batch.size(); ++i) {
        m_points.push_back(to_eigen(batch.positions[i]));
        m_areas.push_back(batch.areas[i]);
      }
    });
    m_cells = Cell_list(m_points, 4 * spacing);
  }

  Covered_surface(const Covered_surface&) = delete; // the cells know where the points are
  Covered_surface& operator=(const Covered_surface&) = delete;

  /// calls `function(place)` for the places that are no farther from a ball than the tolerance.
  template <class Function>
  void for_each_covered(const Point_3& center, double radius, Function&& function) const
  {
    if(!m_points.empty())
      m_cells.for_each_in_ball(to_eigen(center), radius + m_tolerance,
                               [&](std::size_t i, double) { function(i); });
  }

  template <class Function>
  void for_each_covered(const Medial_ball& ball, Function&& function) const
  {
    for_each_covered(ball.center, ball.radius, function);
  }

  std::size_t size() const { return m_points.size(); }
  double area(std::size_t place) const { return m_areas[place]; }
  double total_area() const { return std::accumulate(m_areas.begin(), m_areas.end(), 0.); }

private:
  double m_tolerance;
  std::vector<Eigen::Vector3d> m_points;
  std::vector<double> m_areas;
  Cell_list m_cells;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the positions, in `balls`, of those with the largest weights, the largest first.
///
/// Balls that are near to a stronger one are left out; without that, they are all at the same place.
/// \param balls the balls
/// \param weight what they are weighed by
/// \param number how many at most
/// \param suppression how near, in units of the smaller one of the two radii; not negative
/// \param sigma_ratio that of the options with which the balls were computed
/// \throw std::invalid_argument if `suppression` is negative or not finite
///
/// Complexity: `O(n log n + n m)` for `m` selected of `n` balls.
inline std::vector<std::size_t> select_strongest(const std::vector<Medial_ball>& balls,
                                                 Medial_weight weight, std::size_t number,
                                                 double suppression = 0.6, double sigma_ratio = 0.5)
{
  internal::check_suppression(suppression);
  std::vector<std::size_t> order(balls.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<double> weights;
  for(const Medial_ball& ball : balls)
    weights.push_back(weight_of(ball, weight, sigma_ratio));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  return internal::select_in_order(balls, order, number, suppression);
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the positions, in `balls`, of some taken by chance, none near to another: what any weight must be
/// better than.
/// \param balls the balls
/// \param number how many at most
/// \param seed another seed, another choice; the same on every platform
/// \param suppression as for `select_strongest()`
/// \throw std::invalid_argument if `suppression` is negative or not finite
inline std::vector<std::size_t> select_random(const std::vector<Medial_ball>& balls,
                                              std::size_t number, std::uint64_t seed = 0,
                                              double suppression = 0.6)
{
  internal::check_suppression(suppression);
  std::mt19937_64 random(seed);
  std::vector<std::size_t> order(balls.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for(std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[std::size_t(random() % i)]);
  return internal::select_in_order(balls, order, number, suppression);
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the positions, in `balls`, of some that cover the surface: each covers the most of what those before it
/// do not.
///
/// Greedy set cover, the measure of how few balls are enough: with the same number it keeps more of a shape than any
/// weight does; but the balls that it takes are not neighbours along the axis.
/// \tparam Source `Triangle_surface` or `Surfels`
/// \param balls the balls
/// \param surface that of the balls
/// \param tolerance the surface is covered up to that distance from a ball, in its units, positive
/// \param number how many at most; by default as many as add something
/// \throw std::invalid_argument if the tolerance is not positive and finite
///
/// Complexity: of about 8000 places on the surface, each ball is asked for those that it covers, some times.
template <class Source>
std::vector<std::size_t> select_covering(const std::vector<Medial_ball>& balls,
                                         const Source& surface, double tolerance,
                                         std::size_t number = std::size_t(-1))
{
  internal::check_positive(tolerance, "tolerance");
  const internal::Covered_surface places(surface, 8000, tolerance);
  std::vector<bool> is_covered(places.size(), false);
  const auto gain = [&](std::size_t ball) {
    double sum = 0;
    places.for_each_covered(balls[ball], [&](std::size_t i) {
      if(!is_covered[i])
        sum += places.area(i);
    });
    return sum;
  };
  // Gains only fall, so that one that is still the largest after it was computed anew is the largest of all.
  struct Candidate
  {
    double gain;
    std::size_t ball;
    bool operator<(const Candidate& other) const
    {
      return gain < other.gain || (gain == other.gain && ball > other.ball);
    }
  };
  std::priority_queue<Candidate> queue;
  for(std::size_t i = 0; i < balls.size(); ++i)
    queue.push({gain(i), i});
  std::vector<std::size_t> selected;
  while(!queue.empty() && queue.top().gain > 0 && selected.size() < number) {
    Candidate best = queue.top();
    queue.pop();
    best.gain = gain(best.ball);
    if(!queue.empty() && best < queue.top()) {
      queue.push(best);
      continue;
    }
    if(best.gain > 0)
      selected.push_back(best.ball);
    places.for_each_covered(balls[best.ball], [&](std::size_t i) { is_covered[i] = true; });
  }
  return selected;
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the first ones of an order of balls that cover a part of the surface, or all if they do not.
/// \tparam Source `Triangle_surface` or `Surfels`
/// \param balls all of them
/// \param order positions in `balls`
/// \param surface that of the balls
/// \param tolerance the surface is covered up to that distance from a ball, in its units, positive
/// \param part of the area, in [0, 1]
/// \throw std::invalid_argument if the tolerance is not positive and finite, or the part not in its range
template <class Source>
std::vector<std::size_t> select_until_covered(const std::vector<Medial_ball>& balls,
                                              const std::vector<std::size_t>& order,
                                              const Source& surface, double tolerance, double part)
{
  internal::check_positive(tolerance, "tolerance");
  if(!(part >= 0 && part <= 1))
    throw std::invalid_argument("part is " + internal::to_text(part) + ": must be from 0 to 1");
  const internal::Covered_surface places(surface, 20000, tolerance);
  const double enough = part * places.total_area();
  std::vector<bool> is_covered(places.size(), false);
  std::vector<std::size_t> selected;
  double covered = 0;
  for(const std::size_t ball : order) {
    if(covered >= enough)
      break;
    selected.push_back(ball);
    places.for_each_covered(balls[ball], [&](std::size_t i) {
      if(!is_covered[i])
        covered += places.area(i);
      is_covered[i] = true;
    });
  }
  return selected;
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the part of the area of a surface that is no farther than a tolerance from the union of some of its
/// balls, in [0, 1].
/// \tparam Source `Triangle_surface` or `Surfels`
/// \param balls the balls
/// \param selected positions in `balls`
/// \param surface that of the balls
/// \param tolerance in the units of the surface, positive
/// \throw std::invalid_argument if the tolerance is not positive and finite
template <class Source>
double covered_part(const std::vector<Medial_ball>& balls, const std::vector<std::size_t>& selected,
                    const Source& surface, double tolerance)
{
  internal::check_positive(tolerance, "tolerance");
  const internal::Covered_surface places(surface, 20000, tolerance);
  std::vector<bool> is_covered(places.size(), false);
  for(const std::size_t ball : selected)
    places.for_each_covered(balls[ball], [&](std::size_t i) { is_covered[i] = true; });
  double covered = 0;
  for(std::size_t i = 0; i < places.size(); ++i)
    if(is_covered[i])
      covered += places.area(i);
  const double area = places.total_area();
  return area > 0 ? std::min(covered / area, 1.) : 0;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_SELECT_BALLS_H
