// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_RUN_ACCUMULATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_RUN_ACCUMULATOR_H

#include <CGAL/Area_projection_transform/Row_spans.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief sums of runs of voxels over a region, kept as differences.
///
/// Adding a value to the voxels `first`, …, `last - 1` of a row writes two numbers, whatever the
/// length of the run; a prefix sum over each row gives the sums. Unsigned arithmetic wraps around,
/// so the sums are exact and the same for any order of the runs.
class Run_accumulator
{
public:
  static constexpr int rows_of_group = 4;

  /// up to here floats resolve a hundredth of a voxel.
  static constexpr int largest_row = 1 << 16;

  /// \param padding the number of empty rows to keep on every side in `y` and `z`, so that
  /// kernels that reach over the border need no test; at least `rows_of_group`.
  /// \throw std::invalid_argument if the region has more than 2^31 voxels, or 2^16 in a row.
  Run_accumulator(const Row_spans& region, int padding)
      : m_region(region)
      , m_padding(padding)
      , m_stride(std::size_t(region.grid().size()[1] + 2 * padding))
      , m_first(m_stride * std::size_t(region.grid().size()[2] + 2 * padding), 0.f)
      , m_last(m_first.size(), 0.f)
      , m_place(m_first.size(), 0)
      , m_group_first(m_first.size(), std::numeric_limits<float>::infinity())
      , m_group_last(m_first.size(), -std::numeric_limits<float>::infinity())
  {
    if(region.grid().size()[0] > largest_row)
      throw std::invalid_argument("region has rows of " + std::to_string(region.grid().size()[0]) +
                                  " voxels: at most " + std::to_string(largest_row) +
                                  " are supported");
    const std::size_t places = region.storage_size() + region.number_of_rows();
    if(places > std::size_t(std::numeric_limits<std::int32_t>::max()))
      throw std::invalid_argument("region has " + std::to_string(region.storage_size()) +
                                  " voxels: at most 2^31 are supported");
    m_differences.assign(places, 0);
    const auto& size = region.grid().size();
    for(int k = 0; k < size[2]; ++k)
      for(int j = 0; j < size[1]; ++j) {
        const std::size_t row = region.grid().row(j, k), padded = padded_row(j, k);
        const Row_spans::Hull& hull = region.hull(row);
        m_first[padded] = float(hull.first);
        m_last[padded] = float(hull.last);
        m_place[padded] = std::int32_t(first_difference(row)) - hull.first;
        if(hull.first < hull.last)
          for(std::size_t group = padded - (rows_of_group - 1); group <= padded; ++group) {
            m_group_first[group] = std::min(m_group_first[group], float(hull.first));
            m_group_last[group] = std::max(m_group_last[group], float(hull.last));
          }
      }
  }

  int padding() const { return m_padding; }
  std::size_t stride() const { return m_stride; }

  /// the index of a row, which may lie up to `padding()` rows outside of the grid.
  std::size_t padded_row(int j, int k) const
  {
    return std::size_t(j + m_padding) + m_stride * std::size_t(k + m_padding);
  }

  /// \name The rows, by padded index, as arrays that kernels can load into vectors.
  /// The hull of a row is `first`, …, `last - 1` (as floats, for want of integer minima in SSE2);
  /// voxel `i` has its difference at `place + i`. Rows without voxels have an empty hull.
  /// @{
  const float* first() const { return m_first.data(); }
  const float* last() const { return m_last.data(); }
  const std::int32_t* place() const { return m_place.data(); }
  /// The hull of a group: of the row and those after it, `rows_of_group` in all.
  const float* group_first() const { return m_group_first.data(); }
  const float* group_last() const { return m_group_last.data(); }
  /// @}

  /// \brief adds `value` to the run of voxels from one place to before another. Both lie in the hull
  /// of one row; the end may be one behind it.
  void add(std::int32_t begin_place, std::int32_t end_place, std::uint32_t value)
  {
    m_differences[std::size_t(begin_place)] += value;
    m_differences[std::size_t(end_place)] -= value;
  }

  /// \brief writes the sums of the hull of a row of the grid, times `factor`, to `out`, and clears
  /// the row.
  void take_row(std::size_t row, double factor, float* out)
  {
    const Row_spans::Hull& hull = m_region.hull(row);
    const std::size_t size = std::size_t(hull.last - hull.first);
    std::uint32_t* difference = m_differences.data() + first_difference(row);
    std::uint32_t sum = 0;
    for(std::size_t i = 0; i < size; ++i) {
      sum += difference[i];
      out[i] = float(double(std::int32_t(sum)) * factor);
    }
    std::fill(difference, difference + size + 1, 0);
  }

private:
  // Each row has one place more than voxels, for the end of runs that reach its last voxel.
  std::size_t first_difference(std::size_t row) const { return m_region.hull(row).offset + row; }

  const Row_spans& m_region;
  int m_padding;
  std::size_t m_stride;
  std::vector<float> m_first, m_last;
  std::vector<std::int32_t> m_place;
  std::vector<float> m_group_first, m_group_last;
  std::vector<std::uint32_t> m_differences;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_RUN_ACCUMULATOR_H
