// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIND_LINES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIND_LINES_H

#include <CGAL/Area_projection_transform/centerlines/Line_samples.h>
#include <CGAL/Area_projection_transform/centerlines/Line_tracer.h>
#include <CGAL/Area_projection_transform/centerlines/find_seed.h>
#include <CGAL/Area_projection_transform/internal/Progress_report.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief finds the lines of a surface, each on its own.
///
/// Seeds are drawn in rounds from the samples that do not belong to a line yet. The best of a round comes first: it
/// is followed as far as it goes, and takes what surrounds it away from the others.
template <class ConcurrencyTag>
class Line_finder
{
public:
  /// \param progress lives as long as the finder; once it is cancelled, nothing more is found
  Line_finder(const Line_samples& samples, const Sample_levels& levels, Progress_report& progress)
      : m_samples(samples)
      , m_levels(levels)
      , m_progress(progress)
      , m_tracer(levels, samples.smallest_radius(), samples.largest_radius())
      , m_claims(samples.size(), -1)
      , m_claimed_points(samples.size(), 0)
      , m_misfits(samples.size(), 1)
  {}

  std::vector<Traced_line> find(double least_length)
  {
    const std::vector<std::uint32_t> order = seed_order();
    std::size_t next = 0, barren = 0;
    for(std::size_t tried = 0; tried < most_seeds && barren < most_barren && next < order.size() &&
                               !m_progress.is_cancelled();) {
      std::vector<std::uint32_t> batch;
      for(; next < order.size() && batch.size() < seeds_of_round; ++next)
        if(m_claims[order[next]] < 0)
          batch.push_back(order[next]);
      tried += batch.size();
      barren = follow_seeds(batch, least_length) ? 0 : barren + 1;
      m_progress.advance(double(batch.size()) / most_seeds);
    }
    return std::move(m_lines);
  }

  /// the line that each sample belongs to, or -1.
  const Claims& claims() const { return m_claims; }
  /// the point of that line that it is beside.
  const std::vector<std::uint32_t>& claimed_points() const { return m_claimed_points; }

private:
  static constexpr std::size_t seeds_of_round = 96, most_seeds = 1500, most_barren = 3;
  static constexpr double least_score = 0.01;

  struct Axis_point
  {
    Eigen::Vector3d position;
    double radius;
  };

  struct Candidate
  {
    std::uint32_t sample;
    double score;
    Fitted_canal start;
  };

  std::vector<std::uint32_t> seed_order() const
  {
    std::vector<std::uint32_t> order;
    for(std::uint32_t i = 0; i < m_samples.size(); ++i)
      if(m_samples[i].area > 0)
        order.push_back(i);
    std::sort(order.begin(), order.end(), [](std::uint32_t i, std::uint32_t j) {
      return std::pair(hashed_fraction(i), i) < std::pair(hashed_fraction(j), j);
    });
    return order;
  }

  std::vector<Candidate> candidates(const std::vector<std::uint32_t>& batch) const
  {
    std::vector<std::optional<Candidate>> found(batch.size());
    for_each_index<ConcurrencyTag>(batch.size(), [&](std::size_t k) {
      const Line_seed seed = find_seed(m_levels, m_samples, batch[k]);
      if(!(seed.score > least_score) || is_explained(seed.canal.tube))
        return;
      Line_tracer tracer(m_levels, m_samples.smallest_radius(), m_samples.largest_radius());
      if(const std::optional<Fitted_canal> start = tracer.start(seed.canal))
        found[k] = Candidate{batch[k], seed.score, *start};
    });
    std::vector<Candidate> result;
    for(const std::optional<Candidate>& candidate : found)
      if(candidate)
        result.push_back(*candidate);
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    return result;
  }

  /// whether a seed is in a tube that was found: caps, and what bulges, are no tubes of their own.
  bool is_explained(const Tube& seed) const
  {
    constexpr double inside = 0.8, as_large = 0.5;
    return std::any_of(m_axis.begin(), m_axis.end(), [&](const Axis_point& point) {
      return seed.radius > as_large * point.radius &&
             (seed.center - point.position).squaredNorm() <
                 inside * inside * point.radius * point.radius;
    });
  }

  /// follows the seeds of a round; returns whether there was a line.
  bool follow_seeds(const std::vector<std::uint32_t>& batch, double least_length)
  {
    constexpr double of_failures = 0.5; // one need not try again so near
    const std::size_t before = m_lines.size();
    for(const Candidate& candidate : candidates(batch)) {
      if(m_claims[candidate.sample] >= 0 || is_explained(candidate.start.canal.tube))
        continue;
      Traced_line line = m_tracer.trace(candidate.start, m_claims);
      if(line.length() > least_length * line.mean_radius()) {
        claim(line);
        for(const Fitted_canal& point : line.points)
          m_axis.push_back({point.canal.tube.center, point.canal.smallest_semi_axis()});
        m_lines.push_back(std::move(line));
      } else
        m_axis.push_back({candidate.start.canal.tube.center,
                          of_failures * candidate.start.canal.smallest_semi_axis()});
    }
    return m_lines.size() > before;
  }

  /// takes what surrounds a line, if it fits better than to the lines before.
  void claim(const Traced_line& line)
  {
    constexpr double along = 0.7, tolerance = 0.35, least_cosine = 0.4;
    const std::int32_t number = std::int32_t(m_lines.size());
    for(std::size_t k = 0; k < line.points.size(); ++k) {
      const Canal& canal = line.points[k].canal;
      const double r = canal.tube.radius;
      const double reach = std::hypot(along * r, canal.largest_semi_axis() + tolerance * r);
      const Sample_levels::Level& level = m_levels.finest();
      const Canal::View view(canal);
      level.cells.for_each_in_ball(canal.tube.center, reach, [&](std::size_t i, double) {
        const Canal::Place at = view(level.positions[i]);
        const double misfit = std::abs(at.residual()) / r;
        if(!(std::abs(at.along) < along * r) || !(misfit < tolerance) ||
           !(misfit < m_misfits[level.indices[i]]) ||
           !(at.cosine(level.normals[i], canal.tube.slope) > least_cosine))
          return;
        m_misfits[level.indices[i]] = misfit;
        m_claims[level.indices[i]] = number;
        m_claimed_points[level.indices[i]] = std::uint32_t(k);
      });
    }
  }

  const Line_samples& m_samples;
  const Sample_levels& m_levels;
  Progress_report& m_progress;
  Line_tracer m_tracer;
  std::vector<Traced_line> m_lines;
  std::vector<Axis_point> m_axis;
  Claims m_claims;
  std::vector<std::uint32_t> m_claimed_points;
  std::vector<double> m_misfits;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_FIND_LINES_H
