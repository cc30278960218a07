// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HESSIANS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HESSIANS_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/Layer_ring.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// the order of the derivative along each axis: `x`, `y`, `z`.
using Derivative_orders = std::array<std::size_t, 3>;

/// derivatives of a smoothed map along a row, or the smoothed map itself.
struct Derivative_row
{
  int first, last; ///< voxels of the row `j`, `k`
  int j, k;
  std::vector<const float*> derivatives; ///< each from the voxel `first` on
};

/// \brief convolves a map with a Gaussian or its derivatives, layer by layer, along `z`, `y` and `x`.
///
/// As in `Layer_smoother`, what the region of the map leaves out counts as zero. Derivatives of the same orders along
/// `z`, and then `y`, share their sums.
class Layer_derivatives
{
public:
  /// \param region of the map
  /// \param wanted where derivatives are asked for: a region of the same grid
  Layer_derivatives(const Row_spans& region, const std::vector<float>& map, const Row_spans& wanted,
                    const Gaussian_derivatives& gaussian,
                    const std::vector<Derivative_orders>& orders)
      : m_wanted(wanted)
      , m_gaussian(gaussian)
      , m_orders(orders)
      , m_reach(gaussian.reach())
      , m_layers(region, map, m_reach)
      , m_along_y(std::size_t(m_layers.width() + 2 * m_reach), 0.f)
      , m_derivatives(orders.size(), std::vector<float>(std::size_t(m_layers.width())))
  {
    for(const Derivative_orders& order : orders)
      while(m_along_z.size() <= order[2])
        m_along_z.push_back(m_layers.empty_layer());
  }

  /// hands the rows of the layers `first`, …, `last - 1` to `sink(const Derivative_row&)`.
  template <class Sink>
  void compute(int first, int last, Sink&& sink)
  {
    int loaded = first - m_reach; // below that, nothing is
    for(int k = first; k < last; ++k) {
      if(!find_needed_places(m_wanted, k, m_reach, m_needed))
        continue;
      for(loaded = std::max(loaded, k - m_reach); loaded <= k + m_reach; ++loaded)
        m_layers.load(loaded);
      sum_along_z(k);
      for(int j = 0; j < m_layers.height(); ++j)
        differentiate_row(j, k, sink);
    }
  }

private:
  void sum_along_z(int k)
  {
    for(int j = 0; j < m_layers.height(); ++j) {
      const Places& needed = m_needed[std::size_t(j)];
      if(!needed.is_empty())
        for(std::size_t order = 0; order < m_along_z.size(); ++order)
          sum_rows(
              m_gaussian, order, [&](int d) { return m_layers.layer(k + d).row(j); }, needed.first,
              needed.last, m_along_z[order].row(j) + needed.first);
    }
  }

  template <class Sink>
  void differentiate_row(int j, int k, Sink& sink)
  {
    const Row_spans::Hull& h = m_wanted.hull(m_wanted.grid().row(j, k));
    if(h.first == h.last)
      return;
    const int first = std::max(h.first - m_reach, 0),
              last = std::min(h.last + m_reach, m_layers.width());
    float* along_y = m_along_y.data() + m_reach; // in a margin of zeros
    Derivative_row result{h.first, h.last, j, k, {}};
    for(std::size_t i = 0; i < m_orders.size(); ++i) {
      const auto& [x, y, z] = m_orders[i];
      Padded_layer& along_z = m_along_z[z];
      sum_rows(
          m_gaussian, y, [&](int d) { return along_z.row(j + d); }, first, last, along_y + first);
      sum_rows(
          m_gaussian, x, [&](int d) { return along_y + d; }, h.first, h.last,
          m_derivatives[i].data());
      result.derivatives.push_back(m_derivatives[i].data());
    }
    sink(result);
  }

  const Row_spans& m_wanted;
  const Gaussian_derivatives& m_gaussian;
  const std::vector<Derivative_orders>& m_orders;
  int m_reach;
  Layer_ring m_layers;
  std::vector<Padded_layer> m_along_z; // by order
  std::vector<float> m_along_y;
  std::vector<std::vector<float>> m_derivatives;
  std::vector<Places> m_needed;
};

/// \brief hands derivatives of a map, smoothed by a Gaussian of `s` voxels and times `s` for each order, to
/// `sink(const Derivative_row&)`: one call for each row of `wanted`, for many rows at a time.
template <class ConcurrencyTag, class Sink>
void for_each_derivative_row(const Row_spans& region, const std::vector<float>& map,
                             const Row_spans& wanted, double s,
                             const std::vector<Derivative_orders>& orders, Sink&& sink)
{
  const Gaussian_derivatives gaussian(s);
  const std::size_t layers = std::size_t(region.grid().size()[2]);
  run_workers<ConcurrencyTag>(layers, [&](std::size_t worker, std::size_t workers) {
    Layer_derivatives derivatives(region, map, wanted, gaussian, orders);
    derivatives.compute(int(layers * worker / workers), int(layers * (worker + 1) / workers), sink);
  });
}

/// \brief the same voxels in a grid with a margin around it. Their order, and so their places in storage, stay.
inline Row_spans with_margin(const Row_spans& region, int margin)
{
  const Grid_3& grid = region.grid();
  const auto& [nx, ny, nz] = grid.size();
  const Grid_3 larger(grid.point(-margin, -margin, -margin), grid.spacing(),
                      {nx + 2 * margin, ny + 2 * margin, nz + 2 * margin});
  const int rows = ny, layers = nz;
  return Row_spans(larger, [&, rows, layers](std::size_t row, std::vector<Row_spans::Run>& runs) {
    const int j = int(row % std::size_t(rows + 2 * margin)) - margin;
    const int k = int(row / std::size_t(rows + 2 * margin)) - margin;
    if(j < 0 || j >= rows || k < 0 || k >= layers)
      return;
    const auto [begin, end] = region.runs(grid.row(j, k));
    for(auto run = begin; run != end; ++run)
      runs.push_back({run->first + margin, run->last + margin});
  });
}

/// in each row, one run that covers all voxels which are no farther than `reach` from one of a region along each axis.
inline Row_spans widened(const Row_spans& region, int reach)
{
  const auto& [nx, ny, nz] = region.grid().size();
  const int width = nx, height = ny, depth = nz;
  std::vector<Row_spans::Run> along_y(region.number_of_rows(), {width, 0}), all = along_y;
  const auto cover = [](Row_spans::Run& run, std::int32_t first, std::int32_t last) {
    if(first < last)
      run = {std::min(run.first, first), std::max(run.last, last)};
  };
  const auto around = [&](int place, int size, auto&& visit) {
    for(int p = std::max(place - reach, 0); p <= std::min(place + reach, size - 1); ++p)
      visit(p);
  };
  for(int k = 0; k < depth; ++k)
    for(int j = 0; j < height; ++j)
      around(j, height, [&](int near) {
        const Row_spans::Hull& hull = region.hull(region.grid().row(near, k));
        cover(along_y[region.grid().row(j, k)], hull.first, hull.last);
      });
  for(int k = 0; k < depth; ++k)
    for(int j = 0; j < height; ++j)
      around(k, depth, [&](int near) {
        const Row_spans::Run& run = along_y[region.grid().row(j, near)];
        cover(all[region.grid().row(j, k)], run.first, run.last);
      });
  return Row_spans(region.grid(), [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    if(all[row].first < all[row].last)
      runs.push_back({std::max(all[row].first - reach, 0), std::min(all[row].last + reach, width)});
  });
}

/// the derivatives of a Hessian: `xx`, `yy`, `zz`, `xy`, `xz`, `yz`.
inline const std::vector<Derivative_orders>& hessian_orders()
{
  static const std::vector<Derivative_orders> orders{{2, 0, 0}, {0, 2, 0}, {0, 0, 2},
                                                     {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  return orders;
}

/// \brief hands the second derivatives of a map, smoothed by a Gaussian of `s` voxels and times `s²`, to
/// `sink(const Derivative_row&, factor)`, by which they are to be multiplied: one call for each row of `wanted`, for many
/// rows at a time.
///
/// A wide Gaussian is that of one voxel after another one, so that the six derivatives take a few weights each. The
/// values do not depend on the number of threads.
template <class ConcurrencyTag, class Sink>
void for_each_hessian_row(const Row_spans& region, const std::vector<float>& map,
                          const Row_spans& wanted, double s, Sink&& sink)
{
  constexpr double narrow = 1;
  if(s <= 2 * narrow) {
    for_each_derivative_row<ConcurrencyTag>(region, map, wanted, s, hessian_orders(),
                                            [&](const Derivative_row& row) { sink(row, 1.f); });
    return;
  }
  // What is smoothed reaches out of the grid.
  const int margin = Gaussian_derivatives(narrow).reach();
  const Row_spans inner = with_margin(wanted, margin), around = widened(inner, margin);
  std::vector<float> smoothed(around.storage_size());
  for_each_derivative_row<ConcurrencyTag>(
      with_margin(region, margin), map, around, std::sqrt(s * s - narrow * narrow), {{0, 0, 0}},
      [&](const Derivative_row& row) {
        std::copy_n(row.derivatives[0], row.last - row.first,
                    smoothed.data() + around.index(row.first, row.j, row.k));
      });
  for_each_derivative_row<ConcurrencyTag>(around, smoothed, inner, narrow, hessian_orders(),
                                          [&](Derivative_row row) {
                                            row.first -= margin;
                                            row.last -= margin;
                                            row.j -= margin;
                                            row.k -= margin;
                                            sink(row, float(s * s / (narrow * narrow)));
                                          });
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HESSIANS_H
