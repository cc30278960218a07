// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_BALL_CONVOLUTION_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_BALL_CONVOLUTION_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/Nested_disks.h>
#include <CGAL/Area_projection_transform/internal/Row_planes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a row of voxels and the rows of the ball around it, as kernels take them.
struct Disks_of_row
{
  const std::int32_t* rows;
  const std::ptrdiff_t* offsets; ///< from `rows`, of the rows of the ball, ring by ring
  const int* ends;               ///< for each ring, the end of its offsets
  std::int32_t* disks;           ///< for the sums over the outermost disk
  int first, last;               ///< the voxels that are wanted
  float* sums;                   ///< for the sums over the balls around them
};

/// what the rows of a group share.
struct Disk_layout
{
  int reach;             ///< of the ball
  float weight;          ///< what the sums are multiplied with
  bool is_added;         ///< whether the sums are added to what is there
  int begin, end;        ///< the columns that the disks are summed in; multiples of 16
  std::ptrdiff_t stride; ///< from the sums over a disk to those over the next one inside
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#define CGAL_AREA_PROJECTION_KERNEL                                                                \
<CGAL/Area_projection_transform/internal/ball_convolution_impl.h>
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief sums of integers over balls of voxels, around the voxels of a region.
///
/// A ball is a union of nested disks of rows. Around a row of voxels the rows of the disks are summed,
/// from the innermost disk outwards; a disk whose rows reach `w` voxels to either side counts at `w`
/// voxels from either side of a voxel. As balls are symmetric, layers at the same distance from that
/// of the row are added up beforehand. In all, a voxel costs about `πr²/2` additions for a ball of `r`
/// voxels, many of them at once, where to sum up its voxels would cost `4πr³/3`.
///
/// Integers make the sums exact, whatever the order. Only rows with voxels of interest are computed,
/// from rows that are not empty. The layers pass one after the other, in tiles of rows: what is in
/// use is a window of `2r + 1` layers of a tile, which stays in the cache.
///
/// Products of Fourier transforms of the whole grid, whose cost does not depend on the radius, were
/// measured to take ten times as long at 1 voxel and four times at 6 voxels, and to win from a radius of
/// 11 to 13 voxels on (for 64³ to 256³ voxels, with 16 lanes, when every voxel is of interest): more
/// than maps of `σ = R/2` with `R` of up to 20 voxels ask for.
class Ball_convolution
{
public:
  struct Ball
  {
    int squared_radius;
    float weight;
  };

  /// \param region the voxels to compute; must outlive the convolution
  /// \param balls at least one; what they sum up is multiplied with their weights and added up
  Ball_convolution(const Row_spans& region, const std::vector<Ball>& balls)
      : m_region(region)
      , m_reach(largest_reach(balls))
      , m_window(std::min(2 * m_reach + 1, layers()))
      , m_rows_of_tile(std::max(32, 8192 / region.grid().size()[0]))
      , m_empty_plane(m_window + std::min(m_reach, (layers() - 1) / 2))
      , m_planes(m_empty_plane + 1, std::min(m_rows_of_tile + 2 * m_reach, rows_of_layer()),
                 region.grid().size()[0], m_reach)
      , m_zeros(std::size_t(m_planes.stride()), 0)
      , m_plane_at(std::size_t(m_reach + 1))
      , m_full_rows(std::size_t(m_planes.rows()))
      , m_margin(spread_stride(m_reach))
      , m_disk_stride(spread_stride(m_margin + m_planes.stride() + m_margin + 2 * most_lanes))
      , m_disks(std::size_t(rows_of_group * (m_reach + 1)) * std::size_t(m_disk_stride), 0)
  {
    for(const Ball& ball : balls)
      m_balls.push_back({Nested_disks(ball.squared_radius), ball.weight});
  }

  /// \brief writes the sums to `sums`, at the places of the voxels in the storage of the region.
  ///
  /// \param votes `votes(layer, first, last, row)` hands over the integers of the rows `first`, …,
  /// `last - 1` of a layer, by adding them to `row(j)[0]`, `row(j)[1]`, … for those rows `j` that are
  /// not empty. The sum over a ball must fit a signed integer of 32 bits.
  /// \param cancelled a nullary predicate; once it returns `true`, the rest is left out
  template <class Votes, class Cancelled>
  void operator()(const Votes& votes, Cancelled&& cancelled, float* sums)
  {
    for(int first = 0; first < rows_of_layer(); first += m_rows_of_tile)
      convolve_tile(first, std::min(first + m_rows_of_tile, rows_of_layer()), votes, cancelled,
                    sums);
  }

private:
  static constexpr int rows_of_group = 4;
  static constexpr int most_lanes = 16;

  struct Weighted_disks
  {
    Nested_disks disks;
    float weight;
  };

  /// the rows of a ball that are not empty.
  struct Row_list
  {
    std::vector<std::ptrdiff_t> offsets;
    std::vector<int> ends;
  };

  /// a row with voxels of interest: its place in the tile, and its hull.
  struct Wanted_row
  {
    int row;
    Row_spans::Hull hull;
  };

  static int largest_reach(const std::vector<Ball>& balls)
  {
    int largest = 0;
    for(const Ball& ball : balls)
      largest = std::max(largest, floor_of_root(ball.squared_radius));
    return largest;
  }

  int rows_of_layer() const { return m_region.grid().size()[1]; }
  int layers() const { return m_region.grid().size()[2]; }

  template <class Votes, class Cancelled>
  void convolve_tile(int first, int last, const Votes& votes, Cancelled&& cancelled, float* sums)
  {
    const int first_row = std::max(first - m_reach, 0);
    const int last_row = std::min(last + m_reach, rows_of_layer());
    for(int plane = 0; plane < m_empty_plane; ++plane)
      m_planes.clear(plane);
    int next = 0;
    for(int layer = 0; layer < layers() && !cancelled(); ++layer) {
      for(; next < std::min(layer + m_reach + 1, layers()); ++next) {
        const int plane = next % m_window;
        m_planes.clear(plane);
        votes(next, first_row, last_row,
              [&](int j) { return m_planes.use_sum(plane, j - first_row); });
      }
      list_wanted_rows(layer, first, last, first_row);
      if(!m_wanted.empty())
        convolve_layer(layer, sums);
    }
  }

  void list_wanted_rows(int layer, int first, int last, int first_row)
  {
    m_wanted.clear();
    for(int j = first; j < last; ++j) {
      const Row_spans::Hull& hull = m_region.hull(m_region.grid().row(j, layer));
      if(hull.first < hull.last)
        m_wanted.push_back({j - first_row, hull});
    }
  }

  void convolve_layer(int layer, float* sums)
  {
    fold_layers(layer);
    count_full_rows();
    for(const Weighted_disks& ball : m_balls) {
      list_rows(
          ball.disks, 0, [](const unsigned char*) { return 1; }, m_full_list);
      for(std::size_t i = 0; i < m_wanted.size(); i += rows_of_group)
        convolve_group(ball, i, std::min(m_wanted.size(), i + rows_of_group), sums);
    }
  }

  /// the columns within `reach` of the hulls of some rows, from a multiple of 16 to another.
  std::pair<int, int> columns(std::size_t first, std::size_t last, int reach) const
  {
    int begin = m_region.grid().size()[0], end = 0;
    for(std::size_t i = first; i < last; ++i) {
      begin = std::min(begin, int(m_wanted[i].hull.first));
      end = std::max(end, int(m_wanted[i].hull.last));
    }
    return {std::max(begin - reach, 0) / 16 * 16,
            (std::min(end + reach, m_region.grid().size()[0]) + 15) / 16 * 16};
  }

  /// adds up the layers at the same distance below and above; a layer that has no partner stays as it is.
  void fold_layers(int layer)
  {
    const auto [begin, end] = columns(0, m_wanted.size(), m_reach);
    for(int d = 0; d <= m_reach; ++d) {
      const int below = layer - d, above = layer + d;
      if(below >= 0 && above < layers() && d > 0) {
        m_plane_at[d] = m_window + d - 1;
        fold_planes(below % m_window, above % m_window, m_plane_at[d], begin, end);
      } else if(below >= 0)
        m_plane_at[d] = below % m_window;
      else
        m_plane_at[d] = above < layers() ? above % m_window : m_empty_plane;
    }
  }

  void fold_planes(int below, int above, int sum, int begin, int end)
  {
    m_planes.clear(sum);
    for(int row = 0; row < m_planes.rows(); ++row)
      if(m_planes.is_used(below)[row] || m_planes.is_used(above)[row])
        CGAL_AREA_PROJECTION_DISPATCHED(add_rows, row_or_zeros(below, row),
                                        row_or_zeros(above, row), begin, end,
                                        m_planes.use(sum, row));
  }

  const std::int32_t* row_or_zeros(int plane, int row) const
  {
    return m_planes.is_used(plane)[row] ? m_planes.data() + m_planes.offset(plane, row)
                                        : m_zeros.data();
  }

  /// counts, for each row, the rows up to it that are empty at no distance of layers.
  void count_full_rows()
  {
    std::fill(m_full_rows.begin(), m_full_rows.end(), 1);
    for(const int plane : m_plane_at) {
      const unsigned char* const is_used = m_planes.is_used(plane);
      for(std::size_t row = 0; row < m_full_rows.size(); ++row)
        m_full_rows[row] &= is_used[row];
    }
    for(std::size_t row = 1; row < m_full_rows.size(); ++row)
      m_full_rows[row] *= 1 + m_full_rows[row - 1];
  }

  /// lists the rows of a ball around `row` for which `is_listed` returns 1, not 0.
  template <class IsListed>
  void list_rows(const Nested_disks& disks, int row, IsListed is_listed, Row_list& list) const
  {
    list.offsets.resize(disks.number_of_rows() + 1);
    list.ends.resize(disks.ends().size());
    std::ptrdiff_t* end = list.offsets.data();
    std::size_t r = 0;
    for(std::size_t ring = 0; ring < disks.ends().size(); ++ring) {
      for(; r < disks.ends()[ring]; ++r) {
        const Nested_disks::Run& run = disks.runs()[r];
        const int plane = m_plane_at[run.k];
        const unsigned char* const is_used = m_planes.is_used(plane) + row;
        std::ptrdiff_t offset = m_planes.offset(plane, row + run.first);
        for(int j = run.first; j <= run.last; ++j, offset += m_planes.stride()) {
          *end = offset; // to be overwritten by the next, if it is not listed
          end += is_listed(is_used + j);
        }
      }
      list.ends[ring] = int(end - list.offsets.data());
    }
  }

  /// the rows of a ball around `row`, and what their offsets count from.
  std::pair<const Row_list*, const std::int32_t*> rows_around(const Nested_disks& disks, int row,
                                                              Row_list& list) const
  {
    const int last = row + disks.reach();
    if(last < m_planes.rows() && m_full_rows[last] > 2 * disks.reach())
      return {&m_full_list, m_planes.data() + m_planes.offset(0, row)};
    list_rows(
        disks, row, [](const unsigned char* is_used) { return *is_used; }, list);
    return {&list, m_planes.data()};
  }

  void convolve_group(const Weighted_disks& ball, std::size_t first, std::size_t last, float* sums)
  {
    const int reach = ball.disks.reach();
    const auto [begin, end] = columns(first, last, reach);
    const bool is_added = &ball != m_balls.data();
    std::array<Disks_of_row, rows_of_group> rows;
    int number = 0;
    for(std::size_t i = first; i < last; ++i) {
      const Row_spans::Hull& hull = m_wanted[i].hull;
      const auto [list, data] = rows_around(ball.disks, m_wanted[i].row, m_lists[number]);
      if(list->ends.back() > 0) {
        std::int32_t* const disks =
            m_disks.data() + number * (m_reach + 1) * m_disk_stride + m_margin;
        rows[number++] = {data,      list->offsets.data(), list->ends.data(), disks, hull.first,
                          hull.last, sums + hull.offset};
      } else if(!is_added)
        std::fill_n(sums + hull.offset, hull.last - hull.first, 0.f);
    }
    CGAL_AREA_PROJECTION_DISPATCHED(sum_balls_of_rows, rows.data(), number,
                                    {reach, ball.weight, is_added, begin, end, m_disk_stride});
  }

  const Row_spans& m_region;
  int m_reach;
  int m_window;       ///< the number of layers in the planes of the window
  int m_rows_of_tile; ///< so many that the planes of balls of some voxels fit the second-level cache
  int m_empty_plane;  ///< behind the planes of the window and those of folded layers
  Row_planes m_planes;
  Aligned_ints m_zeros;        ///< a row
  std::vector<int> m_plane_at; ///< for each distance of layers
  std::vector<int> m_full_rows;
  int m_margin; ///< the zeros before the sums over disks, a multiple of 16
  std::ptrdiff_t m_disk_stride;
  Aligned_ints m_disks; ///< the sums over the disks of a group of rows
  std::vector<Weighted_disks> m_balls;
  std::vector<Wanted_row> m_wanted;
  std::array<Row_list, rows_of_group> m_lists;
  Row_list m_full_list; ///< of a ball without empty rows around row 0
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_BALL_CONVOLUTION_H
