// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_PLANES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_PLANES_H

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// integers that begin at a line of the cache, as the widest lanes like it.
using Aligned_ints =
    std::vector<std::int32_t, boost::alignment::aligned_allocator<std::int32_t, 64>>;

/// \brief the distance, in integers, at which rows of `columns` are best stored: whole lines of the
/// cache, an odd number of them, so that the same column of many rows does not fall on the same few
/// places of the cache.
inline int spread_stride(int columns)
{
  return ((columns + 15) / 16 | 1) * 16;
}

/// \brief planes of rows of integers. A plane knows which of its rows are empty; those stand for zeros.
class Row_planes
{
public:
  /// \param padding how many rows before the first and behind the last `is_used` may be asked for
  Row_planes(int planes, int rows, int columns, int padding)
      : m_rows(rows)
      , m_padding(padding)
      , m_stride(spread_stride(columns))
      , m_flags(std::size_t(rows + 2 * padding))
      , m_is_used(std::size_t(planes) * m_flags, 0)
      , m_ints(std::size_t(planes) * std::size_t(rows) * std::size_t(m_stride), 0)
  {}

  int rows() const { return m_rows; }

  /// the length of a row: its columns, and zeros up to a multiple of 16.
  int stride() const { return m_stride; }

  /// where a row begins in `data()`; rows of the padding are nowhere.
  std::ptrdiff_t offset(int plane, int row) const
  {
    return (std::ptrdiff_t(plane) * m_rows + row) * m_stride;
  }

  const std::int32_t* data() const { return m_ints.data(); }

  /// the rows of a plane that are not empty: 1 for each, 0 for the others and for the padding.
  const unsigned char* is_used(int plane) const
  {
    return m_is_used.data() + std::size_t(plane) * m_flags + m_padding;
  }

  /// \brief returns a row to write to; it is not empty from now on.
  ///
  /// Of a row that was empty, what it holds is of no meaning.
  std::int32_t* use(int plane, int row)
  {
    m_is_used[std::size_t(plane) * m_flags + std::size_t(m_padding + row)] = 1;
    return m_ints.data() + offset(plane, row);
  }

  /// returns a row to add to: it is all zero if it was empty.
  std::int32_t* use_sum(int plane, int row)
  {
    const bool was_used = is_used(plane)[row] != 0;
    std::int32_t* const ints = use(plane, row);
    if(!was_used)
      std::fill_n(ints, m_stride, 0);
    return ints;
  }

  /// makes all rows of a plane empty.
  void clear(int plane)
  {
    std::fill_n(m_is_used.begin() + std::ptrdiff_t(std::size_t(plane) * m_flags), m_flags,
                static_cast<unsigned char>(0));
  }

private:
  int m_rows, m_padding, m_stride;
  std::size_t m_flags;
  std::vector<unsigned char> m_is_used;
  Aligned_ints m_ints;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_PLANES_H
