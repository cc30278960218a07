// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Included once for each instruction set; see Ball_convolution.h.

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// writes `a + b` to `sum`; the columns `begin` and `end` are multiples of 16.
inline void add_rows(const std::int32_t* a, const std::int32_t* b, int begin, int end,
                     std::int32_t* sum)
{
  for(int x = begin; x < end; x += lanes)
    store(load(a + x) + load(b + x), sum + x);
}

/// sums the disks around a row, in 4 times `lanes` columns from `x`.
inline void sum_disks_of_4_lanes(const Disks_of_row& row, const Disk_layout& layout, int x)
{
  const std::int32_t* const rows = row.rows + x;
  std::int32_t* disk = row.disks + layout.reach * layout.stride + x;
  Ints a{}, b{}, c{}, d{};
  int n = 0;
  for(int ring = 0; ring <= layout.reach; ++ring, disk -= layout.stride) {
    for(; n < row.ends[ring]; ++n) {
      const std::int32_t* const summand = rows + row.offsets[n];
      a += load(summand);
      b += load(summand + lanes);
      c += load(summand + 2 * lanes);
      d += load(summand + 3 * lanes);
    }
    store(a, disk);
    store(b, disk + lanes);
    store(c, disk + 2 * lanes);
    store(d, disk + 3 * lanes);
  }
}

/// sums the disks around a row, in `lanes` columns from `x`.
inline void sum_disks_of_lanes(const Disks_of_row& row, const Disk_layout& layout, int x)
{
  const std::int32_t* const rows = row.rows + x;
  std::int32_t* disk = row.disks + layout.reach * layout.stride + x;
  Ints a{};
  int n = 0;
  for(int ring = 0; ring <= layout.reach; ++ring, disk -= layout.stride) {
    for(; n < row.ends[ring]; ++n)
      a += load(rows + row.offsets[n]);
    store(a, disk);
  }
}

/// writes the sums over the balls around twice `lanes` voxels from `x`, from the sums over disks.
inline void sum_balls(const Disks_of_row& row, const Disk_layout& layout, int x, float* sums)
{
  const std::int32_t* disk = row.disks + x;
  Ints a = load(disk), b = load(disk + lanes);
  for(int w = 1; w <= layout.reach; ++w) {
    disk += layout.stride;
    a += load(disk - w) + load(disk + w);
    b += load(disk - w + lanes) + load(disk + w + lanes);
  }
  Floats c = to_floats(a) * all(layout.weight), d = to_floats(b) * all(layout.weight);
  if(layout.is_added) {
    c += load(sums);
    d += load(sums + lanes);
  }
  store(c, sums);
  store(d, sums + lanes);
}

/// \brief writes the sums of a row as far as its disks are summed, that is, before column `end`.
///
/// Soon after they were written, the sums over disks are still in the fastest cache.
inline void sum_balls_before(Disks_of_row& row, const Disk_layout& layout, int end)
{
  for(; row.first + 2 * lanes <= std::min(end - layout.reach, row.last); row.first += 2 * lanes) {
    sum_balls(row, layout, row.first, row.sums);
    row.sums += 2 * lanes;
  }
}

/// writes the sums of a row that are left when all disks are summed.
inline void sum_last_balls(Disks_of_row& row, const Disk_layout& layout)
{
  sum_balls_before(row, layout, row.last + layout.reach);
  if(row.first == row.last)
    return;
  const std::size_t size = sizeof(float) * std::size_t(row.last - row.first);
  float sums[2 * lanes] = {};
  if(layout.is_added)
    std::memcpy(sums, row.sums, size);
  sum_balls(row, layout, row.first, sums);
  std::memcpy(row.sums, sums, size);
}

/// computes the sums over balls around the voxels of some neighbouring rows.
inline void sum_balls_of_rows(Disks_of_row* rows, int number, const Disk_layout& layout)
{
  int x = layout.begin;
  for(; x + 4 * lanes <= layout.end; x += 4 * lanes)
    for(int i = 0; i < number; ++i) {
      sum_disks_of_4_lanes(rows[i], layout, x);
      sum_balls_before(rows[i], layout, x + 4 * lanes);
    }
  for(; x < layout.end; x += lanes)
    for(int i = 0; i < number; ++i) {
      sum_disks_of_lanes(rows[i], layout, x);
      sum_balls_before(rows[i], layout, x + lanes);
    }
  for(int i = 0; i < number; ++i)
    sum_last_balls(rows[i], layout);
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
