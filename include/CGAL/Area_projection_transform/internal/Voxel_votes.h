// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VOXEL_VOTES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VOXEL_VOTES_H

#include <CGAL/Area_projection_transform/Grid_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief integers that belong to voxels, in the order in which a `Ball_convolution` asks for them.
///
/// A projected surface meets few of the voxels of a grid; what it adds to them is kept as a list for
/// every layer and every few rows, which needs far less memory than the grid.
class Voxel_votes
{
public:
  explicit Voxel_votes(const Grid_3& grid)
      : m_layers(std::size_t(grid.size()[2]))
      , m_bins(std::size_t((grid.size()[1] + rows_of_bin - 1) / rows_of_bin) * m_layers)
  {}

  void clear()
  {
    for(std::vector<Vote>& bin : m_bins)
      bin.clear();
  }

  void add(int i, int j, int k, std::int32_t value)
  {
    m_bins[std::size_t(j) / rows_of_bin * m_layers + std::size_t(k)].push_back({i, j, value});
  }

  /// adds the votes of the rows `first`, …, `last - 1` of a layer to `row(j)[i]`.
  template <class Row>
  void operator()(int layer, int first, int last, Row&& row) const
  {
    for(int b = first / rows_of_bin; b * rows_of_bin < last; ++b)
      for(const Vote& vote : m_bins[std::size_t(b) * m_layers + std::size_t(layer)])
        if(vote.j >= first && vote.j < last)
          row(vote.j)[vote.i] += vote.value;
  }

private:
  static constexpr int rows_of_bin = 32;

  struct Vote
  {
    std::int32_t i, j, value;
  };

  std::size_t m_layers;
  std::vector<std::vector<Vote>> m_bins;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VOXEL_VOTES_H
