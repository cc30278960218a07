// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NESTED_DISKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NESTED_DISKS_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the largest squared distance between voxels that is within `radius`.
///
/// A radius is often a round number of voxels times their size, divided by it: what rounding has made
/// of the root of an integer counts as that root.
inline int largest_squared_distance(double radius)
{
  return int(radius * radius * (1 + 1e-12));
}

/// the largest integer whose square is at most `square`; `square` is not negative.
inline int floor_of_root(int square)
{
  int root = int(std::sqrt(double(square)));
  while(root * root > square)
    --root;
  while((root + 1) * (root + 1) <= square)
    ++root;
  return root;
}

/// \brief a ball of voxels as nested disks of rows.
///
/// The rows of a ball that reach `w` voxels or more to either side form a disk, for
/// `w = reach(), …, 0`. Each disk is listed as what it adds to the one before: a ring.
class Nested_disks
{
public:
  /// the rows `j = first, …, last` of the layers `k` and `-k`.
  struct Run
  {
    int k, first, last;
  };

  /// \param squared_radius the largest squared distance of a voxel from the centre
  explicit Nested_disks(int squared_radius) : m_reach(floor_of_root(squared_radius))
  {
    int inner = -1; // the squared radius of the disk before
    for(int w = m_reach; w >= 0; --w) {
      const int outer = squared_radius - w * w;
      for(int k = 0; k * k <= outer; ++k)
        append_row_of_ring(k, k * k <= inner ? floor_of_root(inner - k * k) : -1,
                           floor_of_root(outer - k * k));
      m_ends.push_back(m_runs.size());
      inner = outer;
    }
  }

  /// how many voxels from the centre the ball ends, along each axis.
  int reach() const { return m_reach; }

  const std::vector<Run>& runs() const { return m_runs; }

  /// for each ring, from the innermost (`w = reach()`) to the outermost (`w = 0`), the end of its runs.
  const std::vector<std::size_t>& ends() const { return m_ends; }

  /// the number of rows in all rings, of both signs of `j` and of one sign of `k`.
  std::size_t number_of_rows() const { return m_rows; }

private:
  void append_row_of_ring(int k, int inner, int outer)
  {
    if(inner < 0)
      append({k, -outer, outer});
    else if(inner < outer) {
      append({k, -outer, -inner - 1});
      append({k, inner + 1, outer});
    }
  }

  void append(const Run& run)
  {
    m_runs.push_back(run);
    m_rows += std::size_t(run.last - run.first + 1);
  }

  int m_reach;
  std::vector<Run> m_runs;
  std::vector<std::size_t> m_ends;
  std::size_t m_rows = 0;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NESTED_DISKS_H
