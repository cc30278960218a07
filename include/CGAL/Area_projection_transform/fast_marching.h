// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_FAST_MARCHING_H
#define CGAL_AREA_PROJECTION_TRANSFORM_FAST_MARCHING_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/Marching_front.h>
#include <CGAL/Area_projection_transform/internal/descend.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief where a front starts, and when: the voxel has this time, even if the front comes by before.
struct Marching_source
{
  std::array<int, 3> voxel; ///< in the region
  double time = 0;          ///< when the front starts there
};

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief the choices of `fast_marching()`.
struct Marching_options
{
  /// \brief whether differences are of the second order wherever two voxels behind the front allow for it.
  ///
  /// Near a source the front bends too much for either order: whoever wants the error to fall with the
  /// square of the voxel gives all voxels in a ball of fixed size as sources, each with its time.
  bool is_second_order = false;
  /// the voxel at which the front stops; by default it stops when nothing is left to reach.
  std::optional<std::array<int, 3>> target;
};

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief when a front reaches the voxels of a region.
class Travel_times
{
public:
  /// the time of what is not reached.
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// \param region the voxels
  /// \param times their times, at the places that `Row_spans::index()` gives
  Travel_times(std::shared_ptr<const Row_spans> region, std::vector<double> times)
      : m_region(std::move(region)), m_times(std::move(times))
  {}

  /// the voxels.
  const Row_spans& region() const { return *m_region; }

  /// the time of a voxel; infinite if it was not reached, lies outside of the region, or comes after the target.
  double time(int i, int j, int k) const
  {
    const std::size_t place = m_region->index(i, j, k);
    return place < m_times.size() ? m_times[place] : never;
  }

  /// the times at the places that `Row_spans::index()` gives.
  const std::vector<double>& times() const { return m_times; }

  /// the voxel that is reached last, of equal ones the first in storage; none if none is.
  std::optional<std::array<int, 3>> last_voxel() const
  {
    std::optional<std::array<int, 3>> last;
    double latest = -never;
    const std::array<int, 3>& size = m_region->grid().size();
    for(int k = 0; k < size[2]; ++k)
      for(int j = 0; j < size[1]; ++j) {
        const Row_spans::Hull& hull = m_region->hull(m_region->grid().row(j, k));
        for(int i = hull.first; i < hull.last; ++i) {
          const double t = m_times[hull.offset + std::size_t(i - hull.first)];
          if(t < never && t > latest) {
            latest = t;
            last = {i, j, k};
          }
        }
      }
    return last;
  }

private:
  std::shared_ptr<const Row_spans> m_region;
  std::vector<double> m_times;
};

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief a path of a front, from a source to the voxel that was asked for.
struct Marching_path
{
  std::vector<Point_3> points; ///< empty if the front does not get there
  double time;                 ///< at the end; infinite if the front does not get there

  /// whether the front gets to the voxel that was asked for.
  bool is_reached() const { return !points.empty(); }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline std::string text_of(const std::array<int, 3>& voxel)
{
  return "(" + std::to_string(voxel[0]) + ", " + std::to_string(voxel[1]) + ", " +
         std::to_string(voxel[2]) + ")";
}

inline void check_voxel(const Row_spans& region, const std::array<int, 3>& voxel,
                        const std::string& name)
{
  if(!region.contains(voxel[0], voxel[1], voxel[2]))
    throw std::invalid_argument(name + " is " + text_of(voxel) + ": not a voxel of the region");
}

inline void check_speeds(const Row_spans& region, const std::vector<float>& speeds)
{
  if(speeds.size() != region.storage_size())
    throw std::invalid_argument("speeds has " + std::to_string(speeds.size()) +
                                " elements: must have " + std::to_string(region.storage_size()));
  for(std::size_t row = 0; row < region.number_of_rows(); ++row) {
    const Row_spans::Hull& hull = region.hull(row);
    const auto [begin, end] = region.runs(row);
    for(auto run = begin; run != end; ++run)
      for(std::int32_t i = run->first; i < run->last; ++i) {
        const std::size_t place = hull.offset + std::size_t(i - hull.first);
        if(!(speeds[place] >= 0 && std::isfinite(speeds[place])))
          throw std::invalid_argument("speeds[" + std::to_string(place) + "] is " +
                                      internal::to_text(speeds[place]) +
                                      ": must be finite and not negative");
      }
  }
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief returns when a front that moves with a given speed reaches the voxels of a region (Sethian, 1996): the
/// solution of `|∇T| = 1 / speed`, by differences against the wind.
///
/// The error falls as `h log h` with the spacing `h`, or as its square with `is_second_order` and sources
/// that allow for it. With speeds of 1 times are distances within the region. Fronts pass from a voxel to the
/// six that share a side with it. What is not reached has an infinite time.
///
/// \param region the voxels
/// \param speeds at the places that `Row_spans::index()` gives, in units of length per unit of time; a speed of 0
/// is a wall
/// \param sources where the front starts; with `time` where some have a lead
/// \param options the choices
/// \throw std::invalid_argument if a speed in the region is negative or not finite, their number is not that of the
/// voxels with storage, there is no source, one of them or the target is not in the region or, a source, in a wall,
/// or its time is not finite.
///
/// Complexity: `O(n log n)` for `n` voxels that are reached; the results are always the same, bit by bit. Memory:
/// 9 bytes for each voxel with storage, and 64 for each voxel of the front.
inline Travel_times fast_marching(std::shared_ptr<const Row_spans> region,
                                  const std::vector<float>& speeds,
                                  const std::vector<Marching_source>& sources,
                                  const Marching_options& options = {})
{
  internal::check_speeds(*region, speeds);
  if(sources.empty())
    throw std::invalid_argument("sources is empty");
  if(options.target)
    internal::check_voxel(*region, *options.target, "target");
  internal::Marching_front front(*region, speeds, options.is_second_order);
  for(std::size_t s = 0; s < sources.size(); ++s) {
    const auto& [voxel, time] = sources[s];
    const std::string name = "sources[" + std::to_string(s) + "]";
    internal::check_voxel(*region, voxel, name);
    if(!std::isfinite(time))
      throw std::invalid_argument(name + " has a time that is not finite");
    if(!(speeds[region->index(voxel[0], voxel[1], voxel[2])] > 0))
      throw std::invalid_argument(name + " is " + internal::text_of(voxel) + ": lies in a wall");
    front.start(voxel, time);
  }
  front.march(options.target);
  return Travel_times(std::move(region), front.take_times());
}

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief returns the path on which a front got to a voxel.
///
/// Goes down the gradient of the times in steps of half a voxel. Where that does not go down as it should (along
/// walls and creases, or where a neighbour was not reached), it goes to the lowest voxel next to it. Each
/// step goes down, by no less than a fixed part of what some voxel of the region allows for; so it ends, and it ends at a
/// source, since every other voxel that was reached has a lower one next to it.
///
/// \param times when the front reaches the voxels
/// \param target any voxel; if it was not reached, the path is empty and its time infinite
///
/// Complexity: linear in the length of the path in voxels, unless it gets stuck at every step.
inline Marching_path marching_path(const Travel_times& times, const std::array<int, 3>& target)
{
  const double time = times.time(target[0], target[1], target[2]);
  Marching_path path{{}, time};
  if(!(time < Travel_times::never))
    return path;
  const Grid_3& grid = times.region().grid();
  for(const Vector_3& place : internal::descend(times, target))
    path.points.push_back(grid.origin() + grid.spacing() * place);
  std::reverse(path.points.begin(), path.points.end());
  return path;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_FAST_MARCHING_H
