// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SCALE_MAXIMA_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SCALE_MAXIMA_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/salient_points/Gaussian_smoother.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief a local maximum of a map over space and scales.
struct Scale_maximum
{
  std::array<int, 3> voxel; ///< where
  std::size_t scale;        ///< 0, 1, … in the order in which the scales came
  float value;              ///< of the smoothed map
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the values of a map in a row of voxels and in the eight rows around it, in the order of storage.
class Rows_around
{
public:
  /// \param map empty: there is none, and nothing is around
  Rows_around(const Row_spans& region, const std::vector<float>& map, int j, int k)
  {
    for(std::size_t r = 0; r < m_rows.size(); ++r) {
      const int row_j = j + int(r % 3) - 1, row_k = k + int(r / 3) - 1;
      if(map.empty() || row_j < 0 || row_j >= region.grid().size()[1] || row_k < 0 ||
         row_k >= region.grid().size()[2])
        continue;
      const Row_spans::Hull& hull = region.hull(region.grid().row(row_j, row_k));
      m_rows[r] = {map.data() + hull.offset, hull.first, hull.last};
    }
  }

  /// whether the neighbours of the voxel `i` of the row in the middle, and this voxel itself, are all
  /// less than `value`.
  bool are_less(int i, float value) const
  {
    return are_all(0, 9, i - 1, i + 2, [value](float v) { return v < value; });
  }

  /// whether they are all less or equal.
  bool are_not_greater(int i, float value) const
  {
    return are_all(0, 9, i - 1, i + 2, [value](float v) { return v <= value; });
  }

  /// whether the neighbours that come before are less than `value`, and those that come after are less or
  /// equal.
  bool come_after(int i, float value) const
  {
    const auto is_less = [value](float v) { return v < value; };
    const auto is_not_greater = [value](float v) { return v <= value; };
    return are_all(4, 5, i - 1, i, is_less) && are_all(4, 5, i + 1, i + 2, is_not_greater) &&
           are_all(0, 4, i - 1, i + 2, is_less) && are_all(5, 9, i - 1, i + 2, is_not_greater);
  }

private:
  struct Row
  {
    const float* values = nullptr; // of the voxels `first`, …, `last - 1`
    int first = 0, last = 0;
  };

  template <class Predicate>
  bool are_all(std::size_t first_row, std::size_t last_row, int first, int last,
               Predicate predicate) const
  {
    for(std::size_t r = first_row; r < last_row; ++r) {
      const Row& row = m_rows[r];
      for(int i = std::max(first, row.first); i < std::min(last, row.last); ++i)
        if(!predicate(row.values[i - row.first]))
          return false;
    }
    return true;
  }

  std::array<Row, 9> m_rows;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief finds the local maxima of the four-dimensional map of (`x`, `y`, `z`, radius) in a stream of its
/// scales, of which it holds three.
///
/// The scales come in ascending order of their radii. Each is smoothed by a Gaussian. A voxel of the region
/// is a maximum if its value is positive, not less than the threshold and greater than those of its
/// neighbours: 26 in its own scale and 27 in each of the two scales beside it. The first and the last scale
/// have neighbours on one side only; what is outside of the region counts as zero.
///
/// Of neighbours with the same value, the one in the smaller scale counts as the greater one, and within a
/// scale the one that comes first in the storage of the region. So one voxel of a pair, a row or a block of
/// equal values is a maximum, not all of them and not none.
///
/// Takes 12 bytes for each voxel with storage, and what `Gaussian_smoother` takes.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the results have the same bits for any number of threads
template <class ConcurrencyTag = CGAL::Sequential_tag>
class Scale_maxima
{
public:
  /// \param region the voxels
  /// \param smoothing the standard deviation of the Gaussian, in voxels
  /// \param threshold the smallest value of a maximum
  /// \throw std::invalid_argument if `threshold` is negative or `smoothing` is out of range.
  Scale_maxima(std::shared_ptr<const Row_spans> region, double smoothing, double threshold)
      : m_region(std::move(region)), m_smoother(smoothing), m_threshold(threshold)
  {
    if(!(threshold >= 0))
      throw std::invalid_argument("threshold is " + internal::to_text(threshold) +
                                  ": must not be negative");
  }

  /// \brief takes the map of the next scale and returns the maxima in the scale before it, in the order of
  /// the storage of the region. There are none before the first scale.
  /// \param map values at the places that `Row_spans::index()` gives
  const std::vector<Scale_maximum>& push(const std::vector<float>& map)
  {
    make_room();
    m_smoother.template smooth<ConcurrencyTag>(*m_region, map, m_above);
    ++m_number_of_scales;
    find();
    return m_found;
  }

  /// \brief returns the maxima in the last scale.
  /// \pre nothing is pushed after that
  const std::vector<Scale_maximum>& finish()
  {
    make_room();
    m_above.clear();
    ++m_number_of_scales;
    find();
    return m_found;
  }

  /// the smoothed map in which the last maxima were found.
  const std::vector<float>& map_of_maxima() const { return m_middle; }

private:
  /// moves each scale one place down.
  void make_room()
  {
    m_below.swap(m_middle);
    m_middle.swap(m_above);
  }

  void find();
  void find_in_layer(int k, std::vector<Scale_maximum>& found) const;

  std::shared_ptr<const Row_spans> m_region;
  Gaussian_smoother m_smoother;
  double m_threshold;
  std::size_t m_number_of_scales = 0;
  std::vector<float> m_below, m_middle, m_above; // empty: there is no such scale
  std::vector<Scale_maximum> m_found;
};

/// finds the maxima in the scale in the middle.
template <class ConcurrencyTag>
void Scale_maxima<ConcurrencyTag>::find()
{
  m_found.clear();
  if(m_middle.empty())
    return;
  std::vector<std::vector<Scale_maximum>> layers(std::size_t(m_region->grid().size()[2]));
  internal::for_each_index<ConcurrencyTag>(
      layers.size(), [&](std::size_t k) { find_in_layer(int(k), layers[k]); });
  for(const std::vector<Scale_maximum>& layer : layers)
    m_found.insert(m_found.end(), layer.begin(), layer.end());
}

template <class ConcurrencyTag>
void Scale_maxima<ConcurrencyTag>::find_in_layer(int k, std::vector<Scale_maximum>& found) const
{
  const Grid_3& grid = m_region->grid();
  for(int j = 0; j < grid.size()[1]; ++j) {
    const std::size_t row = grid.row(j, k);
    const Row_spans::Hull& hull = m_region->hull(row);
    if(hull.first == hull.last)
      continue;
    const internal::Rows_around below(*m_region, m_below, j, k), own(*m_region, m_middle, j, k),
        above(*m_region, m_above, j, k);
    const float* values = m_middle.data() + hull.offset;
    // Between the runs the map is zero.
    for(int i = hull.first; i < hull.last; ++i) {
      const float value = values[i - hull.first];
      if(value > 0 && value >= m_threshold && own.come_after(i, value) &&
         below.are_less(i, value) && above.are_not_greater(i, value))
        found.push_back({{i, j, k}, m_number_of_scales - 2, value});
    }
  }
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SCALE_MAXIMA_H
