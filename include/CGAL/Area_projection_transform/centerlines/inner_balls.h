// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_INNER_BALLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_INNER_BALLS_H

#include <CGAL/Area_projection_transform/centerlines/Draft_line.h>
#include <CGAL/Area_projection_transform/centerlines/Sample_levels.h>
#include <CGAL/Area_projection_transform/centerlines/judge_canal.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <Eigen/Core>

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

struct Inner_ball
{
  Eigen::Vector3d center;
  double radius;
};

/// \brief the largest ball that touches the surface from inside at a sample and has no other surface in it.
///
/// Samples that are seen from the centre within 41 degrees of the first do not count: between those are the noise
/// and the coarseness of the surface.
inline std::optional<Inner_ball> inner_ball(const Sample_levels& levels,
                                            const Eigen::Vector3d& position,
                                            const Eigen::Vector3d& normal, double smallest_radius,
                                            double largest_radius)
{
  constexpr double least_sine = 0.35; // of half of the angle
  for(double reach = smallest_radius; reach < 2 * largest_radius; reach *= 1.5) {
    const Sample_levels::Level& level = levels.at(reach);
    double radius = reach;
    level.cells.for_each_in_ball(position - reach * normal, reach, [&](std::size_t i, double) {
      const Eigen::Vector3d chord = position - level.positions[i];
      const double squared = chord.squaredNorm(), along = chord.dot(normal);
      if(along > least_sine * std::sqrt(squared))
        radius = std::min(radius, squared / (2 * along));
    });
    if(radius < reach)
      return Inner_ball{position - radius * normal, radius};
  }
  return std::nullopt;
}

/// the first of some samples in an order of chance.
inline void keep_some(std::vector<std::uint32_t>& samples, std::size_t most)
{
  std::sort(samples.begin(), samples.end(), [](std::uint32_t i, std::uint32_t j) {
    return std::pair(hashed_fraction(i), i) < std::pair(hashed_fraction(j), j);
  });
  samples.resize(std::min(samples.size(), most));
}

/// \brief chooses the samples whose inner balls tell how lines can be joined.
///
/// Near the ends of lines they must be dense, however thin the tube. Elsewhere some thousands do: as many beside lines as
/// where there is none yet, which may be little of the surface.
inline std::vector<std::uint32_t> samples_of_balls(const Sample_levels& levels,
                                                   const Line_samples& samples,
                                                   const Claims& claims,
                                                   const std::vector<Draft_line>& lines)
{
  constexpr std::size_t most = 4000, most_near_end = 100;
  constexpr double near = 4; // in units of the radius
  std::vector<std::uint32_t> chosen, free, claimed;
  for(const Draft_line& line : lines)
    for(int k = 0; k < 2 && !line.is_closed; ++k) {
      const Tube& tube = line.ends[std::size_t(k)].canal.tube;
      std::vector<std::uint32_t> around;
      levels.finest().cells.for_each_in_ball(
          tube.center, near * tube.radius,
          [&](std::size_t i, double) { around.push_back(levels.finest().indices[i]); });
      keep_some(around, most_near_end);
      chosen.insert(chosen.end(), around.begin(), around.end());
    }
  for(std::uint32_t i = 0; i < samples.size(); ++i)
    (claims[i] < 0 ? free : claimed).push_back(i);
  keep_some(free, most);
  keep_some(claimed, most);
  chosen.insert(chosen.end(), free.begin(), free.end());
  chosen.insert(chosen.end(), claimed.begin(), claimed.end());
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

/// \brief inner balls between lines.
template <class ConcurrencyTag>
std::vector<Inner_ball> inner_balls(const Sample_levels& levels, const Line_samples& samples,
                                    const Claims& claims, const std::vector<Draft_line>& lines)
{
  const std::vector<std::uint32_t> chosen = samples_of_balls(levels, samples, claims, lines);
  std::vector<std::optional<Inner_ball>> found(chosen.size());
  for_each_index<ConcurrencyTag>(found.size(), [&](std::size_t i) {
    const Line_samples::Sample& sample = samples[chosen[i]];
    if(sample.area > 0)
      found[i] = inner_ball(levels, sample.position, sample.normal, samples.smallest_radius(),
                            samples.largest_radius());
  });
  std::vector<Inner_ball> balls;
  for(const std::optional<Inner_ball>& ball : found)
    if(ball)
      balls.push_back(*ball);
  return balls;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_INNER_BALLS_H
