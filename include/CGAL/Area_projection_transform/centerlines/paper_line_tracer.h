// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_PAPER_LINE_TRACER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_PAPER_LINE_TRACER_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/fast_marching.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>
#include <CGAL/Area_projection_transform/vesselness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief a line in the middle of a tube, from one end to the other.
struct Centerline
{
  std::vector<Point_3> points; ///< from one end to the other
  std::vector<double> radii;   ///< at the points, in units of length; positive

  /// along the points, in units of length.
  double length() const
  {
    double length = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
      length += std::sqrt((points[i] - points[i - 1]).squared_length());
    return length;
  }
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief how lines are traced in a vesselness.
struct Paper_tracing_options
{
  /// the vesselness that is not negligible, in (0, 1]; a perfect line has 0.86.
  double threshold = 0.5;
  /// the cosine of the largest angle between the directions of neighbours, in [0, 1].
  double continuity = 0.85;
  /// the length of the shortest line that is returned, in units of its mean radius.
  double least_length = 2;
  /// \brief whether lines are sought in what is left of a region farther from its line than the radius of the map,
  /// and so on. In the paper there is one line in each region.
  bool repeat = false;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check(const Paper_tracing_options& options)
{
  if(!(options.threshold > 0 && options.threshold <= 1))
    throw std::invalid_argument("threshold is " + internal::to_text(options.threshold) +
                                ": must be greater than 0 and at most 1");
  if(!(options.continuity >= 0 && options.continuity <= 1))
    throw std::invalid_argument("continuity is " + internal::to_text(options.continuity) +
                                ": must be at least 0 and at most 1");
  if(!(options.least_length >= 0))
    throw std::invalid_argument("least_length is " + internal::to_text(options.least_length) +
                                ": must not be negative");
}

/// calls `function(voxel, place)` for the voxels whose vesselness is not below a threshold, in the order of storage.
template <class Function>
void for_each_line_voxel(const Vesselness_map& vesselness, double threshold, Function&& function)
{
  const Row_spans& region = *vesselness.region;
  const std::array<int, 3>& size = region.grid().size();
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j) {
      const Row_spans::Hull& hull = region.hull(region.grid().row(j, k));
      for(int i = hull.first; i < hull.last; ++i) {
        const std::size_t place = hull.offset + std::size_t(i - hull.first);
        if(vesselness.values[place] >= threshold)
          function(std::array<int, 3>{i, j, k}, place);
      }
    }
}

/// the lines of the paper, one region after the other.
class Paper_line_tracer
{
public:
  Paper_line_tracer(const Joint_map& map, const Vesselness_map& vesselness,
                    const Paper_tracing_options& options)
      : m_map(map)
      , m_region(*vesselness.region)
      , m_vesselness(vesselness)
      , m_options(options)
      , m_is_free(m_region.storage_size(), false)
  {
    check(options);
    if(!(map.grid() == m_region.grid()) || m_region.storage_size() != map.values().size())
      throw std::invalid_argument("vesselness is of another region than map");
    for_each_line_voxel(vesselness, options.threshold, [&](const Voxel& v, std::size_t place) {
      if(map.scale_indices()[place] == Joint_map::no_scale)
        return; // all of it comes from its neighbours: there is no radius
      m_seeds.push_back({v, place});
      m_is_free[place] = true;
    });
    std::stable_sort(m_seeds.begin(), m_seeds.end(), [&](const Member& a, const Member& b) {
      return vesselness.values[a.place] > vesselness.values[b.place];
    });
  }

  std::vector<Centerline> trace()
  {
    std::vector<Centerline> lines;
    for(std::size_t s = 0; s < m_seeds.size();) {
      if(!m_is_free[m_seeds[s].place]) {
        ++s;
        continue;
      }
      const std::vector<Member> members = grow(m_seeds[s]);
      Centerline line = line_through(members);
      const bool is_line = is_long_enough(line);
      if(is_line && m_options.repeat)
        free_those_far_from(line, members);
      if(is_line)
        lines.push_back(std::move(line));
    }
    return lines;
  }

private:
  using Voxel = std::array<int, 3>;

  struct Member
  {
    Voxel voxel;
    std::size_t place; // in the storage of the region of the map
  };

  std::size_t place_of(const Voxel& v) const { return m_region.index(v[0], v[1], v[2]); }

  bool is_continuous(std::size_t a, std::size_t b) const
  {
    const auto &u = m_vesselness.directions[a], &v = m_vesselness.directions[b];
    const double cosine = double(u[0]) * v[0] + double(u[1]) * v[1] + double(u[2]) * v[2];
    return std::abs(cosine) >= m_options.continuity;
  }

  /// takes the voxels of a region: the order of growth does not change which they are.
  std::vector<Member> grow(const Member& seed)
  {
    std::vector<Member> members{seed};
    m_is_free[seed.place] = false;
    for(std::size_t m = 0; m < members.size(); ++m)
      for(std::size_t axis = 0; axis < 3; ++axis)
        for(const int step : {-1, 1}) {
          const Member from = members[m];
          Voxel next = from.voxel;
          next[axis] += step;
          const std::size_t place = place_of(next);
          if(place == m_is_free.size() || !m_is_free[place] || !is_continuous(from.place, place))
            continue;
          m_is_free[place] = false;
          members.push_back({next, place});
        }
    std::sort(members.begin(), members.end(),
              [](const Member& a, const Member& b) { return a.place < b.place; });
    return members;
  }

  /// the voxels of some members, which are in the order of storage.
  std::shared_ptr<const Row_spans> region_of(const std::vector<Member>& members) const
  {
    auto next = members.begin();
    return std::make_shared<const Row_spans>(
        m_region.grid(), [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
          const Grid_3& grid = m_region.grid();
          for(; next != members.end() && grid.row(next->voxel[1], next->voxel[2]) == row; ++next) {
            const std::int32_t i = next->voxel[0];
            if(!runs.empty() && runs.back().last == i)
              ++runs.back().last;
            else
              runs.push_back({i, i + 1});
          }
        });
  }

  /// \brief the line from end to end of a region; empty if it cannot be long enough.
  Centerline line_through(const std::vector<Member>& members) const
  {
    if(m_map.scales().empty())
      return {};
    const double longest = std::sqrt(3.) * m_map.grid().spacing() * double(members.size());
    if(longest < m_options.least_length * m_map.scales().front().radius)
      return {};
    const std::shared_ptr<const Row_spans> region = region_of(members);
    std::vector<float> speeds(region->storage_size(), 1.f);
    const Member& middle =
        *std::max_element(members.begin(), members.end(), [&](const Member& a, const Member& b) {
          return m_map.values()[a.place] < m_map.values()[b.place];
        });
    const Voxel first = *fast_marching(region, speeds, {{middle.voxel}}).last_voxel();
    const Voxel last = *fast_marching(region, speeds, {{first}}).last_voxel();
    for(const Member& m : members)
      speeds[region->index(m.voxel[0], m.voxel[1], m.voxel[2])] = m_vesselness.values[m.place];
    Marching_options options;
    options.target = last;
    const Marching_path path =
        marching_path(fast_marching(region, speeds, {{first}}, options), last);
    return with_radii(path.points);
  }

  /// the radii are those of the map in the nearest voxels.
  Centerline with_radii(const std::vector<Point_3>& points) const
  {
    Centerline line{points, {}};
    for(const Point_3& p : points) {
      const Vector_3 c = m_map.grid().lattice_coordinates(p);
      line.radii.push_back(m_map.radius(int(std::floor(c.x() + 0.5)), int(std::floor(c.y() + 0.5)),
                                        int(std::floor(c.z() + 0.5))));
    }
    return line;
  }

  bool is_long_enough(const Centerline& line) const
  {
    double sum = 0;
    for(const double radius : line.radii)
      sum += radius;
    return line.points.size() > 1 &&
           line.length() * double(line.radii.size()) >= m_options.least_length * sum;
  }

  /// gives those members back that are farther from a line than its radius; not the nearest to it.
  void free_those_far_from(const Centerline& line, const std::vector<Member>& members)
  {
    const std::vector<std::size_t> near = places_near(line);
    for(const Member& m : members)
      m_is_free[m.place] = !std::binary_search(near.begin(), near.end(), m.place);
  }

  /// the places in storage of the voxels no farther from a line than its radius, in ascending order.
  std::vector<std::size_t> places_near(const Centerline& line) const
  {
    std::vector<bool> are_near(m_region.storage_size(), false);
    std::vector<std::size_t> places;
    for(std::size_t p = 0; p < line.points.size(); ++p) {
      const Vector_3 c = m_region.grid().lattice_coordinates(line.points[p]);
      const double reach = std::max(line.radii[p] / m_region.grid().spacing(), 1.);
      const auto low = [&](int axis) { return int(std::ceil(c[axis] - reach)); };
      const auto high = [&](int axis) { return int(std::floor(c[axis] + reach)); };
      for(int k = low(2); k <= high(2); ++k)
        for(int j = low(1); j <= high(1); ++j)
          for(int i = low(0); i <= high(0); ++i) {
            const std::size_t place = m_region.index(i, j, k);
            if(place == are_near.size() || are_near[place] ||
               (Vector_3(i, j, k) - c).squared_length() > reach * reach)
              continue;
            are_near[place] = true;
            places.push_back(place);
          }
    }
    std::sort(places.begin(), places.end());
    return places;
  }

  const Joint_map& m_map;
  const Row_spans& m_region;
  const Vesselness_map& m_vesselness;
  Paper_tracing_options m_options;
  std::vector<Member> m_seeds; // the largest vesselness first
  std::vector<bool> m_is_free; // above the threshold, and in no region yet
};

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_PAPER_LINE_TRACER_H
