// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_SAMPLE_LEVELS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_SAMPLE_LEVELS_H

#include <CGAL/Area_projection_transform/centerlines/Line_samples.h>
#include <CGAL/Area_projection_transform/internal/Cell_list.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a number in [0, 1) that goes with an index: all look random, and are always the same.
inline double hashed_fraction(std::uint64_t index)
{
  std::uint64_t h = index + 0x9e3779b97f4a7c15u; // splitmix64
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return double((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// \brief the samples of a surface, and fewer and fewer of them: large tubes need no small detail.
///
/// A level of spacing `s` has all samples that stand for more than `s²` of the area, and of the others each with
/// a probability that makes them stand for so much. It is the index that decides, so that levels are nested and do not
/// change as the surface is turned.
class Sample_levels
{
public:
  using Vector = Eigen::Vector3d;

  struct Level
  {
    double spacing;
    std::vector<Vector> positions;
    std::vector<Vector> normals;
    std::vector<double> areas, weights;
    std::vector<std::uint32_t> indices; ///< of the samples
    Cell_list cells;
  };

  explicit Sample_levels(const Line_samples& samples)
  {
    std::vector<double> areas;
    for(std::size_t i = 0; i < samples.size(); ++i)
      areas.push_back(share(samples[i]));
    if(areas.empty())
      return;
    const auto middle = areas.begin() + std::ptrdiff_t(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    const double finest = std::max(std::sqrt(*middle), fineness * samples.smallest_radius());
    // The finest level has everything, however small its samples are.
    add_level(samples, finest, true);
    for(double spacing = 2 * finest; spacing < fineness * samples.largest_radius(); spacing *= 2)
      add_level(samples, spacing, false);
  }

  /// the level for tubes and balls of a radius.
  const Level& at(double radius) const
  {
    const double steps = std::log2(fineness * radius / m_levels.front()->spacing);
    const double level = std::clamp(std::floor(steps), 0., double(m_levels.size() - 1));
    return *m_levels[std::size_t(level)];
  }

  /// all samples.
  const Level& finest() const { return *m_levels.front(); }
  bool empty() const { return m_levels.empty(); }

private:
  /// the spacing, in units of the radius, of which half is too fine.
  static constexpr double fineness = 0.2;
  static constexpr double cell_size = 5; // in units of the spacing

  static double share(const Line_samples::Sample& sample)
  {
    return std::max(sample.area, sample.weight);
  }

  void add_level(const Line_samples& samples, double spacing, bool is_complete)
  {
    m_levels.push_back(std::make_unique<Level>());
    Level& level = *m_levels.back();
    level.spacing = spacing;
    for(std::size_t i = 0; i < samples.size(); ++i) {
      const double part = is_complete ? 1 : std::min(share(samples[i]) / (spacing * spacing), 1.);
      if(!(hashed_fraction(i) < part))
        continue;
      level.positions.push_back(samples[i].position);
      level.normals.push_back(samples[i].normal);
      level.areas.push_back(samples[i].area / part);
      level.weights.push_back(samples[i].weight / part);
      level.indices.push_back(std::uint32_t(i));
    }
    level.cells = Cell_list(level.positions, cell_size * spacing);
  }

  std::vector<std::unique_ptr<Level>> m_levels;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_SAMPLE_LEVELS_H
