// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_THINNED_SAMPLES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_THINNED_SAMPLES_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_samples.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the samples of a surface at several densities, so that large balls need not look at all of them: in the middle
/// of a sphere or a tube every ball sees much of the surface.
///
/// Thinned samples are taken at equal steps of area along a curve that fills space (Hilbert's): each stands for its step,
/// and sums over them have an error at the rim only. The finest level has all.
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
    const std::vector<std::size_t> order = along_a_curve(samples);
    add_all(samples);
    for(double s = ratio * m_spacing; area / (s * s) > fewest_samples; s *= ratio)
      add_level(samples, order, s);
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

  /// the root of the area of a small sample, since cells that suit large ones would be crowded by the small ones.
  static double finest_spacing(const Medial_samples& samples, double area)
  {
    std::vector<double> areas = samples.areas;
    const auto tenth = areas.begin() + std::ptrdiff_t(areas.size() / 10);
    std::nth_element(areas.begin(), tenth, areas.end());
    return std::sqrt(std::max(*tenth, 4e-4 * area / double(areas.size())));
  }

  static std::vector<std::size_t> along_a_curve(const Medial_samples& samples)
  {
    std::vector<Point_3> points;
    for(const Vector& p : samples.positions)
      points.emplace_back(p.x(), p.y(), p.z());
    using Map = typename Pointer_property_map<Point_3>::const_type;
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    hilbert_sort(
        order.begin(), order.end(),
        Spatial_sort_traits_adapter_3<Kernel, Map>(make_property_map(std::as_const(points))));
    return order;
  }

  static void push_back(const Medial_samples& samples, std::size_t i, double area, Level& level)
  {
    level.positions.push_back(samples.positions[i]);
    level.normals.push_back(samples.normals[i]);
    level.areas.push_back(area);
    level.indices.push_back(std::uint32_t(i));
  }

  void add_all(const Medial_samples& samples)
  {
    m_levels.push_back(std::make_unique<Level>());
    Level& level = *m_levels.back();
    for(std::size_t i = 0; i < samples.size(); ++i)
      push_back(samples, i, samples.areas[i], level);
    level.cells = Cell_list(level.positions, cell_size * m_spacing);
  }

  void add_level(const Medial_samples& samples, const std::vector<std::size_t>& order,
                 double spacing)
  {
    m_levels.push_back(std::make_unique<Level>());
    Level& level = *m_levels.back();
    const double step = spacing * spacing;
    double passed = 0.5 * step;
    for(const std::size_t i : order) {
      passed += samples.areas[i];
      const double steps = std::floor(passed / step);
      if(steps >= 1)
        push_back(samples, i, steps * step, level);
      passed -= steps * step;
    }
    level.cells = Cell_list(level.positions, cell_size * spacing);
  }

  double m_spacing = 0;
  std::vector<std::unique_ptr<Level>>
      m_levels; ///< pointers, since the cells know where the points are
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_THINNED_SAMPLES_H
