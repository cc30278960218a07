// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_ROW_SPANS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_ROW_SPANS_H

#include <CGAL/Area_projection_transform/Grid_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the region of interest of a grid: in each row, a list of runs of voxels.
///
/// Values over the region are stored for the *hull* of each row only, the interval from its first
/// to its last voxel of interest. For the interior of a body this is about an eighth of the
/// bounding box, needs no index per voxel, and keeps the voxels of a row together. Voxels of the
/// hull between two runs have storage but are not of interest.
class Row_spans
{
public:
  /// the voxels `first`, …, `last - 1` of a row.
  struct Run
  {
    std::int32_t first; ///< the index along the row of the first voxel
    std::int32_t last;  ///< one more than that of the last voxel
  };

  /// the hull of a row, and the place of its first voxel in the storage of the region.
  struct Hull
  {
    std::int32_t first = 0; ///< the first voxel of the first run
    std::int32_t last =
        0; ///< one more than the last voxel of the last run; `first` in an empty row
    std::size_t offset = 0; ///< the place of `first` in the storage of the region
  };

  /// constructs the region of all voxels of `grid`.
  explicit Row_spans(const Grid_3& grid) : m_grid(grid)
  {
    const Run everything{0, grid.size()[0]};
    m_hulls.reserve(grid.number_of_rows());
    m_first_run.reserve(grid.number_of_rows() + 1);
    m_runs.reserve(grid.number_of_rows());
    for(std::size_t row = 0; row < grid.number_of_rows(); ++row)
      append_row(&everything, &everything + 1);
    m_first_run.push_back(m_runs.size());
  }

  /// \brief constructs the region from `runs_of_row(row, runs)`, which appends the runs of a row
  /// to the empty vector `runs`: disjoint, not empty, ascending, within the grid.
  template <class RunsOfRow>
  Row_spans(const Grid_3& grid, RunsOfRow&& runs_of_row) : m_grid(grid)
  {
    std::vector<Run> runs;
    m_hulls.reserve(grid.number_of_rows());
    m_first_run.reserve(grid.number_of_rows() + 1);
    for(std::size_t row = 0; row < grid.number_of_rows(); ++row) {
      runs.clear();
      runs_of_row(row, runs);
      append_row(runs.data(), runs.data() + runs.size());
    }
    m_first_run.push_back(m_runs.size());
    m_runs.shrink_to_fit();
  }

  /// the lattice on which the voxels lie.
  const Grid_3& grid() const { return m_grid; }

  /// how many rows the lattice has, empty ones included.
  std::size_t number_of_rows() const { return m_hulls.size(); }
  /// the hull of a row, whose index is that of `Grid_3::row()`.
  const Hull& hull(std::size_t row) const { return m_hulls[row]; }

  /// the runs of a row as a pair of pointers.
  std::pair<const Run*, const Run*> runs(std::size_t row) const
  {
    return {m_runs.data() + m_first_run[row], m_runs.data() + m_first_run[row + 1]};
  }

  /// the number of voxels of interest.
  std::size_t number_of_voxels() const { return m_voxels; }

  /// the number of voxels that have storage: those of interest and those between their runs.
  std::size_t storage_size() const { return m_storage; }

  /// the place of a voxel in the storage of the region, or `storage_size()` if it has none; the voxel
  /// may lie outside of the grid.
  std::size_t index(int i, int j, int k) const
  {
    if(!has_row(j, k))
      return m_storage;
    const Hull& h = m_hulls[m_grid.row(j, k)];
    return i >= h.first && i < h.last ? h.offset + std::size_t(i - h.first) : m_storage;
  }

  /// whether a voxel is of interest.
  bool contains(int i, int j, int k) const
  {
    if(!has_row(j, k))
      return false;
    const auto [begin, end] = runs(m_grid.row(j, k));
    return std::any_of(begin, end, [i](const Run& r) { return i >= r.first && i < r.last; });
  }

private:
  bool has_row(int j, int k) const
  {
    return j >= 0 && j < m_grid.size()[1] && k >= 0 && k < m_grid.size()[2];
  }

  void append_row(const Run* begin, const Run* end)
  {
    m_first_run.push_back(m_runs.size());
    Hull hull;
    hull.offset = m_storage;
    if(begin != end) {
      hull.first = begin->first;
      hull.last = (end - 1)->last;
    }
    m_storage += std::size_t(hull.last - hull.first);
    for(const Run* run = begin; run != end; ++run)
      m_voxels += std::size_t(run->last - run->first);
    m_runs.insert(m_runs.end(), begin, end);
    m_hulls.push_back(hull);
  }

  Grid_3 m_grid;
  std::vector<Hull> m_hulls;
  std::vector<std::size_t> m_first_run;
  std::vector<Run> m_runs;
  std::size_t m_voxels = 0;
  std::size_t m_storage = 0;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_ROW_SPANS_H
