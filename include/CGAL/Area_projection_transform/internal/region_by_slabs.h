// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_REGION_BY_SLABS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_REGION_BY_SLABS_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// appends a run to those of a row; joins it to the last one if they touch.
inline void append_run(const Row_spans::Run& run, std::vector<Row_spans::Run>& runs)
{
  if(!runs.empty() && runs.back().last == run.first)
    runs.back().last = run.last;
  else
    runs.push_back(run);
}

/// some layers of voxels, and the runs of their rows as they are found, row by row.
class Slab
{
public:
  Slab(const Grid_3& grid, int first_layer, int last_layer)
      : m_first_layer(first_layer), m_last_layer(last_layer)
  {
    const std::size_t layers = std::size_t(last_layer - first_layer);
    m_end_of_row.reserve(layers * std::size_t(grid.size()[1]));
  }

  int first_layer() const { return m_first_layer; }
  int last_layer() const { return m_last_layer; }

  void append_row(const std::vector<Row_spans::Run>& runs)
  {
    m_runs.insert(m_runs.end(), runs.begin(), runs.end());
    m_end_of_row.push_back(m_runs.size());
  }

  /// appends the runs of a row, which is counted from the first of the slab, to `runs`.
  void copy_row(std::size_t row, std::vector<Row_spans::Run>& runs) const
  {
    const std::size_t first = row == 0 ? 0 : m_end_of_row[row - 1];
    runs.insert(runs.end(), m_runs.begin() + std::ptrdiff_t(first),
                m_runs.begin() + std::ptrdiff_t(m_end_of_row[row]));
  }

private:
  int m_first_layer, m_last_layer;
  std::vector<Row_spans::Run> m_runs;
  std::vector<std::size_t> m_end_of_row;
};

/// \brief makes a region slab by slab.
/// \param find_rows `find_rows(slab)` appends all rows of a slab, in order; called concurrently.
template <class ConcurrencyTag, class FindRows>
Row_spans region_by_slabs(const Grid_3& grid, FindRows&& find_rows)
{
  constexpr int layers_of_slab = 16;
  std::vector<Slab> slabs;
  for(int layer = 0; layer < grid.size()[2]; layer += layers_of_slab)
    slabs.emplace_back(grid, layer, std::min(layer + layers_of_slab, grid.size()[2]));
  for_each_index<ConcurrencyTag>(slabs.size(), [&](std::size_t i) { find_rows(slabs[i]); });

  const std::size_t rows_of_slab = std::size_t(layers_of_slab) * std::size_t(grid.size()[1]);
  return Row_spans(grid, [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    slabs[row / rows_of_slab].copy_row(row % rows_of_slab, runs);
  });
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_REGION_BY_SLABS_H
