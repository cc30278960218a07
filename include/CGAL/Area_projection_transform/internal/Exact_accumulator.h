// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_ACCUMULATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_ACCUMULATOR_H

#include <CGAL/Area_projection_transform/Row_spans.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief what kernels need to add to an `Exact_accumulator`, as plain arrays.
///
/// The hull of row `r` is `first[r]`, …, `last[r] - 1`; its voxel `i` is at `place[r] + i`. These arrays
/// may be read as whole vectors from any row on.
struct Exact_target
{
  std::array<int, 3> size; ///< of the grid
  const std::int32_t *first, *last, *place;
  std::uint32_t* runs;   ///< added to a voxel, counts for all from there to the end of the row
  std::uint32_t* voxels; ///< added to a voxel, counts for it alone
};

/// \brief sums of runs of voxels and of single voxels over a region.
///
/// Unsigned arithmetic wraps around, so the sums are exact and the same for any order.
class Exact_accumulator
{
public:
  /// \throw std::invalid_argument if the region has more than 2^31 voxels.
  explicit Exact_accumulator(const Row_spans& region) : m_region(region)
  {
    // Each row has one place more than voxels, for the end of runs that reach its last voxel.
    const std::size_t places = region.storage_size() + region.number_of_rows();
    if(places > std::size_t(std::numeric_limits<std::int32_t>::max()))
      throw std::invalid_argument("region has " + std::to_string(region.storage_size()) +
                                  " voxels: at most 2^31 are supported");
    m_runs.assign(places, 0);
    m_voxels.assign(places, 0);
    for(std::size_t row = 0; row < region.number_of_rows(); ++row) {
      const Row_spans::Hull& hull = region.hull(row);
      m_first.push_back(hull.first);
      m_last.push_back(hull.last);
      m_place.push_back(std::int32_t(hull.offset + row) - hull.first);
    }
    for(auto* rows : {&m_first, &m_last, &m_place})
      rows->resize(region.number_of_rows() + 16); // as many as there may be lanes
  }

  Exact_target target()
  {
    return {m_region.grid().size(), m_first.data(), m_last.data(),
            m_place.data(),         m_runs.data(),  m_voxels.data()};
  }

  /// \brief writes the sums of the hull of a row of the grid, times `factor`, to `out`, and clears
  /// the row.
  void take_row(std::size_t row, double factor, float* out)
  {
    const Row_spans::Hull& hull = m_region.hull(row);
    const std::size_t size = std::size_t(hull.last - hull.first);
    std::uint32_t* const runs = m_runs.data() + hull.offset + row;
    std::uint32_t* const voxels = m_voxels.data() + hull.offset + row;
    std::uint32_t sum = 0;
    for(std::size_t i = 0; i < size; ++i) {
      sum += runs[i];
      out[i] = float(double(std::int32_t(sum + voxels[i])) * factor);
    }
    std::fill(runs, runs + size + 1, 0);
    std::fill(voxels, voxels + size + 1, 0);
  }

private:
  const Row_spans& m_region;
  std::vector<std::int32_t> m_first, m_last, m_place;
  std::vector<std::uint32_t> m_runs, m_voxels;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_ACCUMULATOR_H
