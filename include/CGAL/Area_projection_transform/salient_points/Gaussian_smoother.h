// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_GAUSSIAN_SMOOTHER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_GAUSSIAN_SMOOTHER_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/Layer_ring.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief the weighted sum of rows that lie symmetrically about one: its own weight comes first.
///
/// Opposite rows are added before they are weighted, so that the mirror image of a map becomes the mirror
/// image of the result, bit by bit.
class Symmetric_sum
{
public:
  explicit Symmetric_sum(const std::vector<float>& weights)
      : m_weights(weights), m_rows(2 * weights.size())
  {}

  /// `row_at(d)` is the row at the distance `d`, of either sign.
  template <class RowAt>
  void set_rows(RowAt&& row_at)
  {
    for(std::size_t d = 0; d < m_weights.size(); ++d) {
      m_rows[2 * d] = row_at(-int(d));
      m_rows[2 * d + 1] = row_at(int(d));
    }
  }

  /// writes the sums at the places `first`, …, `last - 1` of the rows to `out`.
  void write(int first, int last, float* out) const
  {
    int i = first;
    for(; i + block <= last; i += block, out += block)
      write_block<block>(i, out);
    for(; i < last; ++i, ++out)
      write_block<1>(i, out);
  }

private:
  static constexpr int block = 16; // sums stay in registers

  template <int Size>
  void write_block(int first, float* out) const
  {
    float sums[Size];
    const float* centre = m_rows[0] + first;
    for(int i = 0; i < Size; ++i)
      sums[i] = m_weights[0] * centre[i];
    for(std::size_t d = 1; d < m_weights.size(); ++d) {
      const float weight = m_weights[d];
      const float *before = m_rows[2 * d] + first, *after = m_rows[2 * d + 1] + first;
      for(int i = 0; i < Size; ++i)
        sums[i] += weight * (before[i] + after[i]);
    }
    std::copy(sums, sums + Size, out);
  }

  const std::vector<float>& m_weights;
  std::vector<const float*> m_rows;
};

/// smooths the layers of a map, one after the other, along `z`, `y` and `x`.
class Layer_smoother
{
public:
  Layer_smoother(const Row_spans& region, const std::vector<float>& weights,
                 const std::vector<float>& map, std::vector<float>& smoothed)
      : m_region(region)
      , m_reach(int(weights.size()) - 1)
      , m_smoothed(smoothed)
      , m_sum(weights)
      , m_layers(region, map, m_reach)
      , m_along_z(m_layers.empty_layer())
      , m_along_y(width() + 2 * std::size_t(m_reach), 0.f)
  {}

  /// smooths the layers `first`, …, `last - 1`.
  void smooth(int first, int last)
  {
    for(int k = first - m_reach; k < first + m_reach; ++k)
      m_layers.load(k);
    for(int k = first; k < last; ++k) {
      m_layers.load(k + m_reach);
      find_needed_places(m_region, k, m_reach, m_needed);
      sum_along_z(k);
      sum_along_y_and_x(k);
    }
  }

private:
  int width() const { return m_region.grid().size()[0]; }
  int height() const { return m_region.grid().size()[1]; }
  const Row_spans::Hull& hull(int j, int k) const
  {
    return m_region.hull(m_region.grid().row(j, k));
  }

  void sum_along_z(int k)
  {
    for(int j = 0; j < height(); ++j) {
      const Places& needed = m_needed[std::size_t(j)];
      if(needed.is_empty())
        continue;
      m_sum.set_rows([&](int d) { return m_layers.layer(k + d).row(j); });
      m_sum.write(needed.first, needed.last, m_along_z.row(j) + needed.first);
    }
  }

  void sum_along_y_and_x(int k)
  {
    float* along_y = m_along_y.data() + m_reach; // in a margin of zeros
    for(int j = 0; j < height(); ++j) {
      const Row_spans::Hull& h = hull(j, k);
      if(h.first == h.last)
        continue;
      const int first = std::max(h.first - m_reach, 0), last = std::min(h.last + m_reach, width());
      m_sum.set_rows([&](int d) { return m_along_z.row(j + d); });
      m_sum.write(first, last, along_y + first);
      m_sum.set_rows([&](int d) { return along_y + d; });
      const auto [begin, end] = m_region.runs(m_region.grid().row(j, k));
      for(auto run = begin; run != end; ++run)
        m_sum.write(run->first, run->last, m_smoothed.data() + h.offset + (run->first - h.first));
    }
  }

  const Row_spans& m_region;
  int m_reach;
  std::vector<float>& m_smoothed;
  Symmetric_sum m_sum;
  Layer_ring m_layers;
  Padded_layer m_along_z;
  std::vector<float> m_along_y;
  std::vector<Places> m_needed;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief convolves maps over a region with a Gaussian.
///
/// The Gaussian is separable, taken at whole voxels, cut off at three standard deviations (rounded up) and
/// scaled to a sum of 1 along each axis. Outside of the region the map is zero: there the map of an interior
/// ends, and nothing is known that could be made up for it. So near the boundary values are smaller. The
/// map stays zero between the runs of a row.
///
/// The result has the same bits for any number of threads; mirror images of maps have mirror images of
/// the result.
class Gaussian_smoother
{
public:
  /// \param sigma the standard deviation, in voxels; 0: the map stays as it is
  /// \throw std::invalid_argument if `sigma` is negative or more than 100.
  explicit Gaussian_smoother(double sigma = 1)
  {
    if(!(sigma >= 0 && sigma <= 100))
      throw std::invalid_argument("smoothing is " + internal::to_text(sigma) +
                                  " voxels: must be at least 0 and at most 100");
    double sum = -1;
    std::vector<double> weights;
    for(int d = 0; d <= std::ceil(3 * sigma); ++d) {
      weights.push_back(d == 0 ? 1. : std::exp(-0.5 * (d / sigma) * (d / sigma)));
      sum += 2 * weights.back();
    }
    for(double weight : weights)
      m_weights.push_back(float(weight / sum));
  }

  /// the weights along an axis, at the distances 0, 1, … voxels.
  const std::vector<float>& weights() const { return m_weights; }

  /// \brief smooths a map.
  ///
  /// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  /// `CGAL::Parallel_if_available_tag`
  /// \param region the voxels; those that have no storage count as zero
  /// \param map values at the places that `region.index()` gives
  /// \param smoothed the result, at the same places; not `map`
  ///
  /// Complexity: linear in the number of voxels with storage times `sigma`, and, for each layer, in the
  /// number of voxels of the box. Memory: for each thread `2⌈3·sigma⌉ + 2` layers of the box.
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  void smooth(const Row_spans& region, const std::vector<float>& map,
              std::vector<float>& smoothed) const
  {
    smoothed.assign(region.storage_size(), 0.f);
    const std::size_t layers = std::size_t(region.grid().size()[2]);
    internal::run_workers<ConcurrencyTag>(layers, [&](std::size_t worker, std::size_t workers) {
      internal::Layer_smoother smoother(region, m_weights, map, smoothed);
      smoother.smooth(int(layers * worker / workers), int(layers * (worker + 1) / workers));
    });
  }

private:
  std::vector<float> m_weights;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_GAUSSIAN_SMOOTHER_H
