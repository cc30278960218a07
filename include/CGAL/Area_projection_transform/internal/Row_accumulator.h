// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_ACCUMULATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_ACCUMULATOR_H

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

/// \brief the rows of a region as arrays that kernels can load into lanes.
///
/// The hull of row `j` of layer `k` is `first`, …, `last - 1` at index `j + stride · k`; its voxel `i` has
/// its value at `values[place + i]`. Rows without voxels
/// have an empty hull, `first` being infinite.
struct Row_arrays
{
  const float* first; ///< as floats, for want of integer minima in SSE2
  const float* last;
  const std::int32_t* place;
  std::int32_t* values;
  int rows, layers; ///< in `y` and in `z`
  std::size_t stride;
};

/// \brief integer sums over the voxels of a region, which may be written up to `spare` places beyond the
/// end of a row, and read as many rows beyond the end of a layer.
///
/// Integers sum to the same in any order. The sum at a voxel must fit 31 bits.
class Row_accumulator
{
public:
  static constexpr int spare = 16;

  /// up to here floats resolve a hundredth of a voxel.
  static constexpr int largest_row = 1 << 16;

  /// \throw std::invalid_argument if the region has more than 2^31 places, or 2^16 voxels in a row.
  explicit Row_accumulator(const Row_spans& region) : m_region(region)
  {
    const auto& size = region.grid().size();
    if(size[0] > largest_row)
      throw std::invalid_argument("region has rows of " + std::to_string(size[0]) +
                                  " voxels: at most " + std::to_string(largest_row) +
                                  " are supported");
    m_stride = std::size_t(size[1]) + spare;
    const float infinity = std::numeric_limits<float>::infinity();
    m_first.assign(m_stride * std::size_t(size[2]), infinity);
    m_last.assign(m_first.size(), -infinity);
    m_place.assign(m_first.size(), 0);
    std::size_t places = 0;
    for(int k = 0; k < size[2]; ++k)
      for(int j = 0; j < size[1]; ++j) {
        const Row_spans::Hull& hull = region.hull(region.grid().row(j, k));
        if(hull.first == hull.last)
          continue;
        const std::size_t row = std::size_t(j) + m_stride * std::size_t(k);
        m_first[row] = float(hull.first);
        m_last[row] = float(hull.last);
        m_place[row] = std::int32_t(places) - hull.first;
        places += std::size_t(hull.last - hull.first) + spare;
        if(places > std::size_t(std::numeric_limits<std::int32_t>::max()))
          throw std::invalid_argument("region has " + std::to_string(region.storage_size()) +
                                      " voxels: more than a map can hold");
      }
    m_values.assign(places, 0);
  }

  Row_arrays arrays()
  {
    const auto& size = m_region.grid().size();
    return {m_first.data(), m_last.data(), m_place.data(), m_values.data(),
            size[1],        size[2],       m_stride};
  }

  /// \brief writes the sums of the hull of a row of the grid, times `factor`, to `out`, and clears the
  /// row.
  void take_row(std::size_t row, double factor, float* out)
  {
    const Row_spans::Hull& hull = m_region.hull(row);
    if(hull.first == hull.last)
      return;
    const std::size_t rows = std::size_t(m_region.grid().size()[1]);
    const std::size_t size = std::size_t(hull.last - hull.first);
    std::int32_t* values =
        m_values.data() + m_place[row % rows + m_stride * (row / rows)] + hull.first;
    for(std::size_t i = 0; i < size; ++i)
      out[i] = float(double(values[i]) * factor);
    std::fill(values, values + size + spare, 0);
  }

private:
  const Row_spans& m_region;
  std::size_t m_stride;
  std::vector<float> m_first, m_last;
  std::vector<std::int32_t> m_place;
  std::vector<std::int32_t> m_values;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_ACCUMULATOR_H
