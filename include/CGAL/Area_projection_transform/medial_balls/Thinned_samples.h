// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_THINNED_SAMPLES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_THINNED_SAMPLES_H

#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_samples.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the samples of a surface at several densities, so that large balls need not look at all of them: in the middle
/// of a sphere or a tube every ball sees much of the surface.
///
/// The finest level has all. Of each level the next one keeps samples, in their order, that are apart; what is dropped gives
/// its area to the nearest one that is kept and faces the same way. Only distances and the order of the
/// samples matter, so that the levels of a shape that is turned are those of the shape, turned.
class Thinned_samples
{
public:
  using Vector = Eigen::Vector3d;

  struct Level
  {
    std::vector<Vector> positions, normals;
    std::vector<double> areas;
    std::vector<std::uint32_t> indices; ///< among all samples
    Cell_list cells;

    std::size_t size() const { return positions.size(); }
  };

  explicit Thinned_samples(const Medial_samples& samples)
  {
    const double area = std::accumulate(samples.areas.begin(), samples.areas.end(), 0.);
    if(!(area > 0))
      return;
    m_spacing = finest_spacing(samples, area);
    add_all(samples);
    // Long thin parts have many samples and next to no area: the number counts, too.
    const double extent = 2 * samples.largest_radius();
    for(double s = ratio * m_spacing;
        area / (s * s) > fewest_samples ||
        (double(m_levels.back()->size()) > fewest_samples && s < extent);
        s *= ratio)
      add_level(s);
  }

  bool empty() const { return m_levels.empty(); }
  const Level& finest() const { return *m_levels.front(); }

  /// the coarsest level whose samples are no farther apart than that, or the finest.
  const Level& at(double spacing) const
  {
    const double step = std::floor(std::log(spacing / m_spacing) / std::log(ratio));
    return *m_levels[std::size_t(std::clamp(step, 0., double(m_levels.size() - 1)))];
  }

  /// the finest level with no more than a number of samples, or the coarsest.
  const Level& with_at_most(std::size_t number) const
  {
    for(const auto& level : m_levels)
      if(level->size() <= number)
        return *level;
    return *m_levels.back();
  }

private:
  static constexpr double ratio = 1.4142135623730951;
  static constexpr double cell_size = 5; // in units of the spacing
  static constexpr double fewest_samples = 50;
  static constexpr double apart =
      0.76; ///< in units of the spacing, the root of the area that each stands for
  static constexpr double least_cosine = 0.5;

  /// \brief the root of the area of a small sample, since cells that suit large ones would be crowded by the small ones.
  ///
  /// One that is a millionth of the mean spacing is small enough: it bounds the number of levels.
  static double finest_spacing(const Medial_samples& samples, double area)
  {
    std::vector<double> areas = samples.areas;
    const auto tenth = areas.begin() + std::ptrdiff_t(areas.size() / 10);
    std::nth_element(areas.begin(), tenth, areas.end());
    return std::sqrt(std::max(*tenth, 1e-12 * area / double(areas.size())));
  }

  void add_all(const Medial_samples& samples)
  {
    m_levels.push_back(std::make_unique<Level>());
    Level& level = *m_levels.back();
    level.positions = samples.positions;
    level.normals = samples.normals;
    level.areas = samples.areas;
    level.indices.resize(samples.size());
    std::iota(level.indices.begin(), level.indices.end(), std::uint32_t(0));
    level.cells = Cell_list(level.positions, cell_size * m_spacing);
  }

  /// \brief for each sample of a level, the one that stands for it among those that are apart: the nearest.
  ///
  /// Nearer by rounding is not nearer: regular meshes have many samples in the middle of two.
  static std::vector<std::uint32_t> representatives(const Level& level, double distance)
  {
    constexpr std::uint32_t none = std::uint32_t(-1);
    std::vector<std::uint32_t> nearest(level.size(), none);
    std::vector<double> squares(level.size(), std::numeric_limits<double>::infinity());
    for(std::uint32_t kept = 0; kept < level.size(); ++kept) {
      if(nearest[kept] != none)
        continue;
      nearest[kept] = kept;
      squares[kept] = 0;
      level.cells.for_each_in_ball(level.positions[kept], distance,
                                   [&](std::size_t i, double squared_distance) {
                                     if(squared_distance < (1 - 1e-9) * squares[i] &&
                                        level.normals[i].dot(level.normals[kept]) > least_cosine) {
                                       nearest[i] = kept;
                                       squares[i] = squared_distance;
                                     }
                                   });
    }
    return nearest;
  }

  void add_level(double spacing)
  {
    const Level& finer = *m_levels.back();
    const std::vector<std::uint32_t> nearest = representatives(finer, apart * spacing);
    std::vector<double> areas(finer.size(), 0.);
    for(std::size_t i = 0; i < finer.size(); ++i)
      areas[nearest[i]] += finer.areas[i];
    auto level = std::make_unique<Level>();
    for(std::size_t i = 0; i < finer.size(); ++i)
      if(nearest[i] == i) {
        level->positions.push_back(finer.positions[i]);
        level->normals.push_back(finer.normals[i]);
        level->areas.push_back(areas[i]);
        level->indices.push_back(finer.indices[i]);
      }
    level->cells = Cell_list(level->positions, cell_size * spacing);
    m_levels.push_back(std::move(level));
  }

  double m_spacing = 0;
  std::vector<std::unique_ptr<Level>>
      m_levels; ///< pointers, since the cells know where the points are
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_THINNED_SAMPLES_H
