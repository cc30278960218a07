// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_INTERIOR_VOTES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_INTERIOR_VOTES_H

#include <CGAL/Area_projection_transform/internal/signed_crossings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// calls `vote(first, last, number)` for the runs of a line whose points see the surface from inside in
/// `number` of the two directions of the line; `size` is the number of its points.
template <class Vote>
void vote_along_line(const Signed_crossings& crossings, std::size_t line, std::int32_t size,
                     Vote&& vote)
{
  int behind = 0; // signed crossings between the point and the end of the line
  for(auto c = crossings.begin(line); c != crossings.end(line); ++c)
    behind -= c->sign;
  int before = 0; // signed crossings between the beginning of the line and the point
  std::int32_t first = 0;
  for(auto c = crossings.begin(line); c != crossings.end(line); ++c) {
    const int number = (before > 0) + (behind > 0);
    if(number > 0 && first < c->first_after)
      vote(first, c->first_after, number);
    before += c->sign;
    behind += c->sign;
    first = c->first_after;
  }
  if(before > 0 && first < size)
    vote(first, size, 1);
}

/// \brief for each voxel, in how many of the six directions of the axes it sees a surface from inside.
///
/// The votes of some layers at a time are made from the crossings: memory grows with the number of
/// lines and of crossings, not with that of voxels.
class Interior_votes
{
public:
  template <class ConcurrencyTag>
  Interior_votes(ConcurrencyTag tag, const Triangle_surface& surface, const Grid_3& grid)
      : m_grid(grid)
      , m_along{Signed_crossings(tag, surface, grid, 0), Signed_crossings(tag, surface, grid, 1),
                Signed_crossings(tag, surface, grid, 2)}
  {}

  /// calls `row(j, k, votes)` for each row of the layers from `first_layer` to `last_layer`, in
  /// order; `votes` is a vector of numbers from 0 to 6.
  template <class Row>
  void for_each_row(int first_layer, int last_layer, Row&& row) const
  {
    const std::size_t nx = size(0), ny = size(1);
    const std::vector<std::int8_t> changes_along_z =
        changes_between_layers(first_layer, last_layer);
    std::vector<std::int8_t> changes_along_y((ny + 1) * nx), along_z(ny * nx, 0), along_y(nx),
        votes(nx);
    for(int k = first_layer; k < last_layer; ++k) {
      add(changes_along_z.data() + std::size_t(k - first_layer) * nx * ny, along_z);
      find_changes_within_layer(k, changes_along_y);
      std::fill(along_y.begin(), along_y.end(), std::int8_t(0));
      for(std::size_t j = 0; j < ny; ++j) {
        add(changes_along_y.data() + j * nx, along_y);
        std::copy_n(along_z.data() + j * nx, nx, votes.data());
        add(along_y.data(), votes);
        add_votes_along_x(j + ny * std::size_t(k), votes);
        row(int(j), k, votes);
      }
    }
  }

private:
  std::size_t size(std::size_t axis) const { return std::size_t(m_grid.size()[axis]); }

  static void add(const std::int8_t* values, std::vector<std::int8_t>& sums)
  {
    for(std::size_t i = 0; i < sums.size(); ++i)
      sums[i] = std::int8_t(sums[i] + values[i]);
  }

  /// how the votes along z change from each layer to the next; the first has what is there already.
  std::vector<std::int8_t> changes_between_layers(int first_layer, int last_layer) const
  {
    const std::size_t lines = size(0) * size(1);
    std::vector<std::int8_t> changes(lines * std::size_t(last_layer - first_layer), 0);
    const auto change = [&](int layer, std::size_t line) -> std::int8_t& {
      return changes[lines * std::size_t(layer - first_layer) + line];
    };
    for(std::size_t line = 0; line < lines; ++line) // of index i + size_x * j
      vote_along_line(m_along[2], line, m_grid.size()[2], [&](int first, int last, int number) {
        if(first < last_layer && last > first_layer)
          change(std::max(first, first_layer), line) += std::int8_t(number);
        if(last > first_layer && last < last_layer)
          change(last, line) -= std::int8_t(number);
      });
    return changes;
  }

  /// how the votes along y change from each row of a layer to the next.
  void find_changes_within_layer(int k, std::vector<std::int8_t>& changes) const
  {
    const std::size_t nx = size(0), nz = size(2);
    std::fill(changes.begin(), changes.end(), std::int8_t(0));
    for(std::size_t i = 0; i < nx; ++i)
      vote_along_line(m_along[1], std::size_t(k) + nz * i, m_grid.size()[1],
                      [&](int first, int last, int number) {
                        changes[std::size_t(first) * nx + i] += std::int8_t(number);
                        changes[std::size_t(last) * nx + i] -= std::int8_t(number);
                      });
  }

  void add_votes_along_x(std::size_t row, std::vector<std::int8_t>& votes) const
  {
    vote_along_line(m_along[0], row, m_grid.size()[0], [&](int first, int last, int number) {
      for(int i = first; i < last; ++i)
        votes[std::size_t(i)] = std::int8_t(votes[std::size_t(i)] + number);
    });
  }

  const Grid_3& m_grid;
  std::array<Signed_crossings, 3> m_along;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_INTERIOR_VOTES_H
