// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HESSIANS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HESSIANS_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/salient_points/Gaussian_smoother.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the weights of a Gaussian of the standard deviation `s` and of its derivatives along an axis, at the
/// distances 0, 1, … voxels, each derivative times `s` (normalised derivatives, with the exponent 1 for each order).
///
/// The sampled derivatives are scaled, and the second is shifted, so that sums over voxels are what integrals
/// would be: the first derivative of a ramp is its slope, the second of a parabola its own, and of a
/// constant both are zero, however small `s` is. Cut off at five standard deviations: so scaled, the second
/// derivative is off by 1 % if it is cut off at four, by 0.02 % at five.
struct Gaussian_derivatives
{
  explicit Gaussian_derivatives(double s)
  {
    const int reach = std::max(int(std::ceil(5 * s)), 1);
    std::vector<double> gaussian;
    double sum = 0, squares = 0, fourth_powers = 0;
    for(int d = 0; d <= reach; ++d) {
      gaussian.push_back(std::exp(-0.5 * (d / s) * (d / s)));
      const double both_sides = (d == 0 ? 1 : 2) * gaussian.back(), square = double(d) * d;
      sum += both_sides;
      squares += both_sides * square;
      fourth_powers += both_sides * square * square;
    }
    const double variance = squares / sum;
    const double curvature = 2 * s * s / (fourth_powers - variance * squares);
    for(int d = 0; d <= reach; ++d) {
      const double g = gaussian[std::size_t(d)];
      weights[0].push_back(float(g / sum));
      weights[1].push_back(float(s * d * g / squares));
      weights[2].push_back(float(curvature * (double(d) * d - variance) * g));
    }
  }

  int reach() const { return int(weights[0].size()) - 1; }

  std::array<std::vector<float>, 3> weights; ///< by the order of the derivative
};

/// \brief writes the weighted sums of the rows around one, at the places `first`, …, `last - 1`, to `out`.
/// \param order of a derivative: opposite rows are subtracted from each other if it is odd
/// \param row_at gives the row at a distance, of either sign
template <class RowAt>
void sum_rows(const Gaussian_derivatives& gaussian, std::size_t order, RowAt&& row_at, int first,
              int last, float* out)
{
  const std::vector<float>& weights = gaussian.weights[order];
  const std::size_t number = std::size_t(last - first);
  const float* centre = row_at(0) + first;
  for(std::size_t i = 0; i < number; ++i)
    out[i] = weights[0] * centre[i];
  for(std::size_t d = 1; d < weights.size(); ++d) {
    const float weight = weights[d];
    const float *before = row_at(-int(d)) + first, *after = row_at(int(d)) + first;
    if(order == 1)
      for(std::size_t i = 0; i < number; ++i)
        out[i] += weight * (after[i] - before[i]);
    else
      for(std::size_t i = 0; i < number; ++i)
        out[i] += weight * (after[i] + before[i]);
  }
}

/// the six second derivatives of a stretch of a row.
struct Hessian_row
{
  int first, last; ///< voxels of the row `j`, `k`
  int j, k;
  /// `xx`, `yy`, `zz`, `xy`, `xz`, `yz`, each from the voxel `first` on
  std::array<const float*, 6> derivatives;
};

/// \brief computes second derivatives of a smoothed map, layer by layer, along `z`, `y` and `x`.
///
/// As in `Layer_smoother`, what the region of the map leaves out counts as zero.
class Layer_hessians
{
public:
  /// \param region of the map
  /// \param wanted where derivatives are asked for: a region of the same grid
  Layer_hessians(const Row_spans& region, const std::vector<float>& map, const Row_spans& wanted,
                 const Gaussian_derivatives& gaussian)
      : m_region(region)
      , m_map(map)
      , m_wanted(wanted)
      , m_gaussian(gaussian)
      , m_reach(gaussian.reach())
      , m_layers(std::size_t(2 * m_reach + 1), empty_layer())
      , m_along_z(3, empty_layer())
      , m_needed(std::size_t(height()))
  {
    m_along_y.fill(std::vector<float>(std::size_t(width() + 2 * m_reach), 0.f));
    m_derivatives.fill(std::vector<float>(std::size_t(width())));
  }

  /// hands the rows of the layers `first`, …, `last - 1` to `sink(const Hessian_row&)`.
  template <class Sink>
  void compute(int first, int last, Sink&& sink)
  {
    int loaded = first - m_reach; // what is below is not in the ring, or not needed
    for(int k = first; k < last; ++k) {
      if(!find_needed_places(k))
        continue;
      for(loaded = std::max(loaded, k - m_reach); loaded <= k + m_reach; ++loaded)
        load(loaded);
      sum_along_z(k);
      for(int j = 0; j < height(); ++j)
        differentiate_row(j, k, sink);
    }
  }

private:
  struct Places
  {
    int first, last;
    bool is_empty() const { return first >= last; }
  };

  // Of each derivative the orders along `z`, `y`, `x`.
  static constexpr std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 0, 2}, {0, 2, 0}, {2, 0, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};

  int width() const { return m_region.grid().size()[0]; }
  int height() const { return m_region.grid().size()[1]; }
  Padded_layer empty_layer() const { return Padded_layer(width(), height(), m_reach); }

  Padded_layer& layer(int k)
  {
    const int number = 2 * m_reach + 1;
    return m_layers[std::size_t((k % number + number) % number)];
  }

  void load(int k)
  {
    layer(k).clear();
    if(k < 0 || k >= m_region.grid().size()[2])
      return;
    for(int j = 0; j < height(); ++j) {
      const std::size_t row = m_region.grid().row(j, k);
      const Row_spans::Hull& h = m_region.hull(row);
      const auto [begin, end] = m_region.runs(row);
      for(auto run = begin; run != end; ++run)
        std::copy_n(m_map.data() + h.offset + (run->first - h.first), run->last - run->first,
                    layer(k).row(j) + run->first);
    }
  }

  /// \brief in each row of the layer, the places at which sums along `z` are needed.
  /// \return whether there are any
  bool find_needed_places(int k)
  {
    std::fill(m_needed.begin(), m_needed.end(), Places{width(), 0});
    bool are_any = false;
    for(int j = 0; j < height(); ++j) {
      const Row_spans::Hull& h = m_wanted.hull(m_wanted.grid().row(j, k));
      if(h.first == h.last)
        continue;
      are_any = true;
      const int last_row = std::min(j + m_reach, height() - 1);
      for(int row = std::max(j - m_reach, 0); row <= last_row; ++row) {
        Places& needed = m_needed[std::size_t(row)];
        needed.first = std::min(needed.first, std::max(h.first - m_reach, 0));
        needed.last = std::max(needed.last, std::min(h.last + m_reach, width()));
      }
    }
    return are_any;
  }

  void sum_along_z(int k)
  {
    for(int j = 0; j < height(); ++j) {
      const Places& needed = m_needed[std::size_t(j)];
      if(!needed.is_empty())
        for(std::size_t order = 0; order < 3; ++order)
          sum_rows(
              m_gaussian, order, [&](int d) { return layer(k + d).row(j); }, needed.first,
              needed.last, m_along_z[order].row(j) + needed.first);
    }
  }

  template <class Sink>
  void differentiate_row(int j, int k, Sink& sink)
  {
    const Row_spans::Hull& h = m_wanted.hull(m_wanted.grid().row(j, k));
    if(h.first == h.last)
      return;
    const int first = std::max(h.first - m_reach, 0), last = std::min(h.last + m_reach, width());
    Hessian_row result{h.first, h.last, j, k, {}};
    for(std::size_t i = 0; i < orders.size(); ++i) {
      float* along_y = m_along_y[i].data() + m_reach; // in a margin of zeros
      sum_rows(
          m_gaussian, orders[i][1], [&](int d) { return m_along_z[orders[i][0]].row(j + d); },
          first, last, along_y + first);
      sum_rows(
          m_gaussian, orders[i][2], [&](int d) { return along_y + d; }, h.first, h.last,
          m_derivatives[i].data());
      result.derivatives[i] = m_derivatives[i].data();
    }
    sink(result);
  }

  const Row_spans& m_region;
  const std::vector<float>& m_map;
  const Row_spans& m_wanted;
  const Gaussian_derivatives& m_gaussian;
  int m_reach;
  std::vector<Padded_layer> m_layers;  // a ring, around the layer at hand
  std::vector<Padded_layer> m_along_z; // by order
  std::array<std::vector<float>, 6> m_along_y, m_derivatives;
  std::vector<Places> m_needed;
};

/// \brief hands the second derivatives of a map, smoothed by a Gaussian of `s` voxels and times `s²`, to
/// `sink(const Hessian_row&)`: one call for each row of `wanted`, for many rows at a time.
///
/// The values do not depend on the number of threads.
template <class ConcurrencyTag, class Sink>
void for_each_hessian_row(const Row_spans& region, const std::vector<float>& map,
                          const Row_spans& wanted, double s, Sink&& sink)
{
  const Gaussian_derivatives gaussian(s);
  const std::size_t layers = std::size_t(region.grid().size()[2]);
  run_workers<ConcurrencyTag>(layers, [&](std::size_t worker, std::size_t workers) {
    Layer_hessians hessians(region, map, wanted, gaussian);
    hessians.compute(int(layers * worker / workers), int(layers * (worker + 1) / workers), sink);
  });
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HESSIANS_H
