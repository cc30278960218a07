// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_INTERIOR_BY_VOTES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_INTERIOR_BY_VOTES_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/Interior_votes.h>
#include <CGAL/Area_projection_transform/internal/region_by_slabs.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a region, and the votes of its voxels.
struct Voted_region
{
  Row_spans region;
  std::size_t votes;

  /// the mean fraction of the six directions from which the voxels see the surface from inside.
  double coverage() const
  {
    const std::size_t voxels = region.number_of_voxels();
    return voxels > 0 ? double(votes) / (6. * double(voxels)) : 0;
  }
};

/// \brief appends the runs of voxels that `is_inside(i)` chooses, and returns the sum of their votes.
template <class Predicate>
std::size_t append_chosen(const std::int8_t* votes, std::int32_t number, const Predicate& is_inside,
                          std::vector<Row_spans::Run>& runs)
{
  std::size_t sum = 0;
  for(std::int32_t i = 0; i < number; ++i) {
    const std::int32_t first = i;
    for(; i < number && is_inside(i); ++i)
      sum += std::size_t(votes[i]);
    if(i > first)
      runs.push_back({first, i});
  }
  return sum;
}

/// the voxels to which at least half of the directions vote.
template <class ConcurrencyTag>
Voted_region majority_region(const Interior_votes& votes, const Grid_3& grid)
{
  std::atomic<std::size_t> sum{0};
  Row_spans region = region_by_slabs<ConcurrencyTag>(grid, [&](Slab& slab) {
    std::vector<Row_spans::Run> runs;
    votes.for_each_row(slab.first_layer(), slab.last_layer(),
                       [&](int, int, const std::vector<std::int8_t>& row) {
                         runs.clear();
                         sum += append_chosen(
                             row.data(), std::int32_t(row.size()),
                             [&row](std::int32_t i) { return row[std::size_t(i)] >= 3; }, runs);
                         slab.append_row(runs);
                       });
  });
  return {std::move(region), sum};
}

/// \brief the votes of some layers, with a margin of one voxel all around, and sums over the
/// neighbours.
class Layers_of_votes
{
public:
  Layers_of_votes(const Interior_votes& votes, const Grid_3& grid, int first_layer, int last_layer)
      : m_size(grid.size())
      , m_first_layer(first_layer)
      , m_votes(std::size_t(m_size[0] + 2) * std::size_t(m_size[1] + 2) *
                    std::size_t(last_layer - first_layer + 2),
                0)
  {
    votes.for_each_row(std::max(first_layer - 1, 0), std::min(last_layer + 1, m_size[2]),
                       [this](int j, int k, const std::vector<std::int8_t>& row) {
                         std::copy(row.begin(), row.end(), row_of(j, k));
                       });
  }

  /// the votes of a row.
  const std::int8_t* votes(int j, int k) const { return m_votes.data() + place(j, k); }

  /// the sums, for the voxels of a row, over the voxels at most one away along each axis.
  void sum_neighbours(int j, int k, std::vector<int>& sums) const
  {
    const std::size_t number = std::size_t(m_size[0]);
    std::vector<int> columns(number + 2, 0);
    for(int dk = -1; dk <= 1; ++dk)
      for(int dj = -1; dj <= 1; ++dj) {
        const std::int8_t* row = votes(j + dj, k + dk) - 1;
        for(std::size_t i = 0; i < number + 2; ++i)
          columns[i] += row[i];
      }
    sums.resize(number);
    for(std::size_t i = 0; i < number; ++i)
      sums[i] = columns[i] + columns[i + 1] + columns[i + 2];
  }

private:
  std::size_t place(int j, int k) const
  {
    return (std::size_t(k - m_first_layer + 1) * std::size_t(m_size[1] + 2) + std::size_t(j + 1)) *
               std::size_t(m_size[0] + 2) +
           1;
  }

  std::int8_t* row_of(int j, int k) { return m_votes.data() + place(j, k); }

  std::array<int, 3> m_size;
  int m_first_layer;
  std::vector<std::int8_t> m_votes;
};

/// \brief the voxels that see enough of the surface from inside, in the mean of their
/// neighbourhood: where faces are missing at random, the six directions of a single voxel are too
/// few to tell.
/// \param fraction how many of the directions are enough
template <class ConcurrencyTag>
Voted_region neighbourhood_region(const Interior_votes& votes, const Grid_3& grid, double fraction)
{
  const int enough = int(std::ceil(fraction * 6 * 27));
  std::atomic<std::size_t> sum{0};
  Row_spans region = region_by_slabs<ConcurrencyTag>(grid, [&](Slab& slab) {
    const Layers_of_votes layers(votes, grid, slab.first_layer(), slab.last_layer());
    std::vector<Row_spans::Run> runs;
    std::vector<int> sums;
    for(int k = slab.first_layer(); k < slab.last_layer(); ++k)
      for(int j = 0; j < grid.size()[1]; ++j) {
        const std::int8_t* const row = layers.votes(j, k);
        layers.sum_neighbours(j, k, sums);
        runs.clear();
        // Where all directions agree on the inside there is no doubt.
        sum += append_chosen(
            row, grid.size()[0],
            [&](std::int32_t i) { return row[i] == 6 || sums[std::size_t(i)] >= enough; }, runs);
        slab.append_row(runs);
      }
  });
  return {std::move(region), sum};
}

/// \brief how much of a surface is there, if that much of it is missing at random that the voxels
/// with three or more votes have the mean fraction `coverage` of all: what solves
/// `coverage = E[votes | votes >= 3] / 6` for a binomial distribution of the votes.
inline double observed_fraction(double coverage)
{
  const auto expected = [](double f) {
    const double g = 1 - f;
    const double three = 20 * g * g * g, four = 15 * f * g * g, five = 6 * f * f * g,
                 six = f * f * f;
    return (3 * three + 4 * four + 5 * five + 6 * six) / (three + four + five + six) / 6;
  };
  double low = 0, high = 1;
  for(int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (expected(middle) < coverage ? low : high) = middle;
  }
  return high;
}

/// \brief the voxels that most directions see as inside.
///
/// If more than a quarter of the surface is missing, its neighbours have a say in what a voxel is,
/// and the limit falls with what is there: inside, a fraction `f` of the directions vote for a
/// voxel; outside, where a ray crosses the surface twice and only one of the crossings is there,
/// `f (1 - f)` at most, and half as many where half of the rays miss. The limit is halfway between.
template <class ConcurrencyTag>
Voted_region interior_by_votes(const Triangle_surface& surface, const Grid_3& grid)
{
  const Interior_votes votes(ConcurrencyTag(), surface, grid);
  Voted_region result = majority_region<ConcurrencyTag>(votes, grid);
  const double f = observed_fraction(result.coverage());
  if(result.votes > 0 && f < 0.75)
    result = neighbourhood_region<ConcurrencyTag>(votes, grid, 0.5 * (f + 0.5 * f * (1 - f)));
  return result;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_INTERIOR_BY_VOTES_H
