// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_DETECTOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_DETECTOR_H

#include <CGAL/Area_projection_transform/internal/Progress_report.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/salient_points/fit_tube.h>
#include <CGAL/Area_projection_transform/salient_points/judge_shape.h>
#include <CGAL/Area_projection_transform/salient_points/start_shapes.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a shape that was found, and what speaks for it.
struct Found_shape
{
  Shape shape;
  Support support;
  double score; ///< of the candidate that it began with
};

/// \brief whether a tube goes on along the axis of another one, at most `gap` after its end.
///
/// Bent tubes are compared where they meet.
inline bool follows(const Shape& first, const Shape& second, double gap)
{
  constexpr double least_cosine = 0.95, most_radii = 0.15;
  const Tube::Place place = first.tube().place(second.center());
  const double radius = first.tube().radius_at(place.along);
  const double reach = 0.5 * second.length() + gap;
  return first.is_along(place.along, reach) && place.distance < most_radii * radius &&
         std::abs(second.radius() - radius) < most_radii * radius &&
         std::abs(first.tube().tangent_at(place.along).dot(second.tube().axis)) > least_cosine;
}

/// whether a piece of a tube lies on another tube, as far as its noise tells.
inline bool lies_on(const Shape& piece, const Shape& tube)
{
  const double tolerance = std::max(0.5 * piece.deviation, 0.02 * piece.radius());
  for(const double along : {piece.first, 0., piece.last}) {
    const Tube::Place place = tube.tube().place(piece.tube().point_at(along));
    if(place.distance > tolerance ||
       std::abs(tube.tube().radius_at(place.along) - piece.tube().radius_at(along)) > tolerance)
      return false;
  }
  return true;
}

/// \brief finds spheres and tubes: the places where votes meet are candidates, the best first; a candidate
/// that a shape fits to claims its surface, and those that follow have to do without.
template <class ConcurrencyTag>
class Shape_detector
{
public:
  /// \param progress lives as long as the detector; once it is cancelled, nothing more is found
  Shape_detector(const Feature_surface& surface, const std::vector<double>& radii,
                 Progress_report& progress)
      : m_progress(progress)
  {
    m_levels.resize(radii.size());
    std::vector<std::vector<Candidate>> found(radii.size());
    for_each_index<ConcurrencyTag>(radii.size(), [&](std::size_t k) {
      if(m_progress.is_cancelled())
        return;
      m_levels[k] = std::make_unique<Vote_level>(surface, radii[k]);
      m_levels[k]->append_candidates(least_score, least_voters, std::uint32_t(k), found[k]);
      m_progress.advance(part_of_levels / double(radii.size()));
    });
    if(m_progress.is_cancelled())
      return;
    for(std::size_t k = 0; k < radii.size(); ++k) {
      m_candidates.insert(m_candidates.end(), found[k].begin(), found[k].end());
      m_claimed_clusters.emplace_back(m_levels[k]->size(), 0);
      m_claimed_points.emplace_back(m_levels[k]->number_of_points(), 0);
    }
    std::stable_sort(m_candidates.begin(), m_candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  }

  std::vector<Found_shape> find();

private:
  static constexpr std::uint32_t least_voters = 8;
  static constexpr double least_score = 0.03;   // half a tube of which three quarters are missing
  static constexpr std::size_t batch_size = 16; // whatever the number of threads
  static constexpr double part_of_levels = 0.4; // of the time

  struct Failure
  {
    Eigen::Vector3d position;
    std::uint32_t level;
  };

  Free_clusters clusters_of(std::size_t level) const
  {
    return {m_levels[level].get(), &m_claimed_clusters[level], &m_claimed_points[level]};
  }

  std::size_t level_of(double radius) const
  {
    std::size_t best = 0;
    for(std::size_t k = 1; k < m_levels.size(); ++k)
      if(std::abs(std::log(m_levels[k]->radius() / radius)) <
         std::abs(std::log(m_levels[best]->radius() / radius)))
        best = k;
    return best;
  }

  bool is_near_failure(const Candidate& candidate) const
  {
    return std::any_of(m_failures.begin(), m_failures.end(), [&](const Failure& failure) {
      return failure.level == candidate.level && (failure.position - candidate.position).norm() <
                                                     0.3 * m_levels[candidate.level]->radius();
    });
  }

  std::vector<Candidate> next_batch();
  bool lengthen_known_tube(const Found_shape& piece, std::vector<Found_shape>& known) const;
  std::optional<Found_shape> fit(const Candidate& candidate) const;
  std::optional<Found_shape> fit_sphere(const Vote_level& level, const Voters& voters) const;
  std::optional<Found_shape> fit_tube(const Vote_level& level, const Voters& voters) const;
  std::optional<Found_shape> followed(Shape tube) const;
  std::optional<Found_shape> fit_ellipsoid(const Free_clusters& around,
                                           const Eigen::Vector3d& x) const;
  bool is_better(const Found_shape& a, const Found_shape& b) const;
  bool is_still_free(const Found_shape& found) const;
  void claim(const Shape& shape);

  Progress_report& m_progress;
  std::vector<std::unique_ptr<Vote_level>> m_levels;
  std::vector<std::vector<char>> m_claimed_clusters, m_claimed_points; // per level
  std::vector<Candidate> m_candidates;                                 // the best first
  std::size_t m_next = 0;
  std::vector<Candidate> m_postponed; // were near a better one
  std::vector<Failure> m_failures;
  Shape_limits m_limits;
};

template <class ConcurrencyTag>
std::optional<Found_shape> Shape_detector<ConcurrencyTag>::fit_sphere(const Vote_level& level,
                                                                      const Voters& voters) const
{
  std::optional<Shape> shape = start_sphere(level, voters);
  if(!shape)
    return std::nullopt;
  const Free_clusters clusters = clusters_of(level_of(shape->radius()));
  if(!fit_shape(clusters, *shape, {}))
    return std::nullopt;
  const Free_clusters best = clusters_of(level_of(shape->radius()));
  if(!is_close_fit(*shape, m_limits))
    return std::nullopt;
  const Support support = measure_support(best, *shape, support_tolerance(*shape));
  if(!is_supported(*shape, support, m_limits))
    return std::nullopt;
  return Found_shape{*shape, support, 0};
}

template <class ConcurrencyTag>
std::optional<Found_shape> Shape_detector<ConcurrencyTag>::fit_tube(const Vote_level& level,
                                                                    const Voters& voters) const
{
  std::optional<Shape> shape = start_tube(level, voters, 1);
  if(!shape)
    return std::nullopt;
  if(!fit_short_tube(clusters_of(level_of(shape->radius())), *shape))
    return std::nullopt;
  const Free_clusters clusters = clusters_of(level_of(shape->radius()));
  if(!is_close_fit(*shape, m_limits))
    return std::nullopt;
  Support support = measure_support(clusters, *shape, support_tolerance(*shape));
  if(!is_supported(*shape, support, m_limits))
    return std::nullopt;
  return Found_shape{*shape, support, 0};
}

/// \brief the one that more of the surface lies on, at the precision of the more precise one, which counts as well.
template <class ConcurrencyTag>
bool Shape_detector<ConcurrencyTag>::is_better(const Found_shape& a, const Found_shape& b) const
{
  constexpr double finest = 0.005; // of the radius: what is more precise than that is no better
  const double tolerance =
      std::max(4 * std::min(a.shape.deviation, b.shape.deviation), 0.03 * a.shape.radius());
  const auto merit = [&](const Found_shape& found) {
    const double deviation =
        std::max(found.shape.deviation / found.shape.radius(), finest) * found.shape.radius();
    return measure_support(clusters_of(level_of(found.shape.radius())), found.shape, tolerance)
               .area /
           std::sqrt(deviation);
  };
  return merit(a) > merit(b);
}

template <class ConcurrencyTag>
std::optional<Found_shape> Shape_detector<ConcurrencyTag>::fit(const Candidate& candidate) const
{
  constexpr double flat = 0.08;                           // the second spread of planes
  constexpr double least_sphere = 0.03, most_tube = 0.25; // the first spread
  const Free_clusters clusters = clusters_of(candidate.level);
  constexpr double least_ellipsoid = 0.08;
  const auto has_misfit = [](const Shape& shape) {
    return shape.misfit > std::max(0.01 * shape.radius(), 0.5 * shape.deviation);
  };
  const auto is_hopeless = [&](const Voters& voters) {
    return voters.clusters.size() < least_voters || voters.claimed_fraction > 0.5 ||
           voters.spread[1] < flat;
  };
  if(is_hopeless(find_voters(clusters, candidate.position)))
    return std::nullopt;
  const Eigen::Vector3d x = meeting_place(clusters, candidate.position);
  const Voters voters = find_voters(clusters, x);
  if(is_hopeless(voters))
    return std::nullopt;
  std::optional<Found_shape> best;
  const auto take_better = [&](std::optional<Found_shape> other) {
    if(other && (!best || is_better(*other, *best)))
      best = std::move(other);
  };
  // An ellipsoid bends to noise, too.
  const auto is_sharper = [&](const Found_shape& ellipsoid) {
    const Eigen::Vector3d axes = ellipsoid.shape.ellipsoid().axes().lengths;
    return ellipsoid.shape.deviation < 0.85 * best->shape.deviation && axes[2] > 1.1 * axes[0];
  };
  if(voters.spread[0] > least_sphere)
    best = fit_sphere(*clusters.level, voters);
  if(voters.spread[0] < most_tube || (best && has_misfit(best->shape)))
    take_better(fit_tube(*clusters.level, voters));
  if(best && best->shape.is_tube())
    best = followed(best->shape);
  if(voters.spread[0] > least_ellipsoid && (!best || has_misfit(best->shape)))
    if(auto ellipsoid = fit_ellipsoid(clusters, x); ellipsoid && (!best || is_sharper(*ellipsoid)))
      take_better(std::move(ellipsoid));
  if(best)
    best->score = candidate.score;
  return best;
}

template <class ConcurrencyTag>
std::optional<Found_shape>
Shape_detector<ConcurrencyTag>::fit_ellipsoid(const Free_clusters& around,
                                              const Eigen::Vector3d& x) const
{
  std::optional<Shape> shape = start_ellipsoid(around, x);
  if(!shape)
    return std::nullopt;
  if(!fit_shape(clusters_of(level_of(shape->radius())), *shape, {}))
    return std::nullopt;
  const Free_clusters clusters = clusters_of(level_of(shape->radius()));
  if(!is_close_fit(*shape, m_limits) || !(shape->ellipsoid().axes().lengths[0] > 0))
    return std::nullopt;
  const Support support = measure_support(clusters, *shape, support_tolerance(*shape));
  if(!is_supported(*shape, support, m_limits) || !is_supported_ellipsoid(*shape, support))
    return std::nullopt;
  return Found_shape{*shape, support, 0};
}

/// a tube, as far as it goes.
template <class ConcurrencyTag>
std::optional<Found_shape> Shape_detector<ConcurrencyTag>::followed(Shape tube) const
{
  const Free_clusters clusters = clusters_of(level_of(tube.radius()));
  follow_tube(clusters, tube);
  if(!simplify_tube(clusters, tube) || !is_close_fit(tube, m_limits))
    return std::nullopt;
  const Support support =
      measure_support(clusters_of(level_of(tube.radius())), tube, support_tolerance(tube));
  if(!is_supported(tube, support, m_limits))
    return std::nullopt;
  return Found_shape{tube, support, 0};
}

template <class ConcurrencyTag>
bool Shape_detector<ConcurrencyTag>::is_still_free(const Found_shape& found) const
{
  const Support now = measure_support(clusters_of(level_of(found.shape.radius())), found.shape,
                                      support_tolerance(found.shape));
  return now.area > 0.98 * found.support.area;
}

/// takes the surface of a shape, at all levels, out of what is free.
template <class ConcurrencyTag>
void Shape_detector<ConcurrencyTag>::claim(const Shape& shape)
{
  const double radius = shape.radius();
  const double band = std::max(6 * shape.deviation, 0.08 * radius);
  for(std::size_t k = 0; k < m_levels.size(); ++k) {
    const double width = Vote_level::cluster_size * m_levels[k]->radius();
    // Clusters that are large for the shape lie far inside of it.
    const double tolerance = band + std::min(0.5 * width * width / radius, 0.5 * radius);
    clusters_of(k).for_each_near(
        shape, tolerance, 0.3 * radius, [&](std::size_t i, const Shape::Place& place) {
          if(std::abs(place.residual) < tolerance && m_levels[k]->normal(i).dot(place.normal) > 0.3)
            m_claimed_clusters[k][i] = 1;
        });
    const Shape_bound bound(shape, band, 0.3 * radius);
    m_levels[k]->for_each_point_in_ball(bound.center(), bound.reach(), [&](std::size_t i, double) {
      if(!bound.may_hold(m_levels[k]->point(i)))
        return;
      const Shape::Place place = shape.place(m_levels[k]->point(i));
      if(shape.is_along(place.along, 0.3 * radius) && std::abs(place.residual) < band &&
         m_levels[k]->point_normal(i).dot(place.normal) > 0.3)
        m_claimed_points[k][i] = 1;
    });
  }
}

/// \brief lengthens a tube that was found before to include another piece of it, beyond a hole.
/// \return whether there is one
template <class ConcurrencyTag>
bool Shape_detector<ConcurrencyTag>::lengthen_known_tube(const Found_shape& piece,
                                                         std::vector<Found_shape>& known) const
{
  constexpr double largest_hole = 3; // in units of the radius
  if(!piece.shape.is_tube())
    return false;
  const double half = 0.5 * piece.shape.length();
  for(Found_shape& other : known) {
    if(!other.shape.is_tube() ||
       !follows(other.shape, piece.shape, largest_hole * piece.shape.radius()))
      continue;
    Shape longer = other.shape;
    const double along = longer.tube().place(piece.shape.center()).along;
    longer.first = std::min(longer.first, along - half);
    longer.last = std::max(longer.last, along + half);
    recenter(longer);
    if(!lies_on(piece.shape, longer))
      continue;
    other.shape = longer;
    other.support.area += piece.support.area;
    other.support.far_area += piece.support.far_area;
    return true;
  }
  return false;
}

/// \brief takes the next candidates that are far from each other: their fits do not depend on each other.
template <class ConcurrencyTag>
std::vector<Candidate> Shape_detector<ConcurrencyTag>::next_batch()
{
  std::vector<Candidate> batch, later;
  const auto take = [&](const Candidate& candidate) {
    if(is_near_failure(candidate))
      return;
    const bool is_near = std::any_of(batch.begin(), batch.end(), [&](const Candidate& other) {
      return (other.position - candidate.position).norm() <
             m_levels[candidate.level]->radius() + m_levels[other.level]->radius();
    });
    (is_near ? later : batch).push_back(candidate);
  };
  std::size_t i = 0;
  for(; i < m_postponed.size() && batch.size() < batch_size; ++i)
    take(m_postponed[i]);
  later.insert(later.end(), m_postponed.begin() + std::ptrdiff_t(i), m_postponed.end());
  while(m_next < m_candidates.size() && batch.size() < batch_size && later.size() < 4 * batch_size)
    take(m_candidates[m_next++]);
  m_postponed = std::move(later);
  return batch;
}

template <class ConcurrencyTag>
std::vector<Found_shape> Shape_detector<ConcurrencyTag>::find()
{
  std::vector<Found_shape> all;
  for(;;) {
    const std::size_t next_before = m_next;
    const std::vector<Candidate> batch = next_batch();
    if(batch.empty())
      break;
    std::vector<std::optional<Found_shape>> found(batch.size());
    for_each_index<ConcurrencyTag>(batch.size(), [&](std::size_t b) { found[b] = fit(batch[b]); });
    std::vector<Candidate> again;
    const std::size_t found_before = all.size();
    for(std::size_t b = 0; b < batch.size(); ++b) {
      if(!found[b])
        m_failures.push_back({batch[b].position, batch[b].level});
      else if(all.size() == found_before || is_still_free(*found[b])) {
        claim(found[b]->shape);
        if(!lengthen_known_tube(*found[b], all))
          all.push_back(std::move(*found[b]));
      } else
        again.push_back(batch[b]);
    }
    m_postponed.insert(m_postponed.begin(), again.begin(), again.end());
    m_progress.advance((1 - part_of_levels) * double(m_next - next_before) /
                       double(m_candidates.size()));
    if(m_progress.is_cancelled())
      break;
  }
  return all;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SHAPE_DETECTOR_H
