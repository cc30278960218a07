// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// No include guard: the kernel of `Weighted_point_cells`, compiled for each instruction set by
// `for_each_instruction_set.h`.

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// adds the weights of those of a run of points that are in the ball.
inline void add_run(const Weighted_point_cells_arrays& cells, std::size_t first, std::size_t last,
                    const Weighted_points_ball& ball, Longs& sum)
{
  Longs lane{};
  for(int i = 0; i < double_lanes; ++i)
    lane[i] = i;
  for(; first < last; first += double_lanes) {
    const std::int64_t* before = cells.weight_before.data() + first;
    const Doubles x = load(cells.position[0].data() + first) - ball.center[0];
    const Doubles y = load(cells.position[1].data() + first) - ball.center[1];
    const Doubles z = load(cells.position[2].data() + first) - ball.center[2];
    sum += (load(before + 1) - load(before)) & (x * x + y * y + z * z <= ball.squared_radius) &
           (lane < all(std::int64_t(last - first)));
  }
}

struct Cell_range
{
  std::int64_t first, last; ///< the last is not included
};

/// the cells along an axis that an interval about the centre of the ball meets.
inline Cell_range cells_of(const Weighted_point_cells_arrays& cells, int axis, double center,
                           double half_length)
{
  const double middle = center - cells.low[axis], length = half_length + cells.tolerance;
  const std::int64_t number = cells.number[axis];
  const double first = __builtin_floor((middle - length) / cells.size);
  const double last = __builtin_floor((middle + length) / cells.size) + 1;
  return {first > 0 ? std::int64_t(first) : 0, last < double(number) ? std::int64_t(last) : number};
}

/// those of them that are inside the interval.
inline Cell_range inner_cells(const Weighted_point_cells_arrays& cells, double center,
                              double half_length, Cell_range outer)
{
  const double middle = center - cells.low[0], length = half_length - cells.tolerance;
  const auto first = std::int64_t(__builtin_ceil((middle - length) / cells.size));
  const auto last = std::int64_t(__builtin_floor((middle + length) / cells.size));
  return {first > outer.first ? first : outer.first, last < outer.last ? last : outer.last};
}

/// how far the nearest and the farthest point of a cell can be from the centre along an axis.
struct Distances
{
  double nearest, farthest;
};

inline Distances distances(const Weighted_point_cells_arrays& cells, int axis, std::int64_t cell,
                           double center)
{
  const double low = cells.low[axis] + double(cell) * cells.size - center;
  const double high = low + cells.size;
  const double nearest = (low > -high ? low : -high) - cells.tolerance;
  return {nearest > 0 ? nearest : 0, (high > -low ? high : -low) + cells.tolerance};
}

inline void add_row(const Weighted_point_cells_arrays& cells, const std::uint32_t* first_points,
                    Cell_range outer, double inner_square, const Weighted_points_ball& ball,
                    Longs& sum)
{
  if(first_points[outer.first] == first_points[outer.last])
    return;
  Cell_range inner{outer.last, outer.last};
  if(inner_square > 0)
    inner = inner_cells(cells, ball.center[0], __builtin_sqrt(inner_square), outer);
  if(inner.first >= inner.last)
    return add_run(cells, first_points[outer.first], first_points[outer.last], ball, sum);
  add_run(cells, first_points[outer.first], first_points[inner.first], ball, sum);
  add_run(cells, first_points[inner.last], first_points[outer.last], ball, sum);
  sum[0] += cells.weight_before[first_points[inner.last]] -
            cells.weight_before[first_points[inner.first]];
}

inline std::int64_t sum_of_cells(const Weighted_point_cells_arrays& cells,
                                 const Weighted_points_ball& ball)
{
  Longs weights{};
  const double larger = ball.squared_radius * (1 + 1e-12),
               smaller = ball.squared_radius * (1 - 1e-12);
  const Cell_range layers = cells_of(cells, 2, ball.center[2], __builtin_sqrt(larger));
  for(std::int64_t k = layers.first; k < layers.last; ++k) {
    const Distances z = distances(cells, 2, k, ball.center[2]);
    const double in_layer = larger - z.nearest * z.nearest;
    if(in_layer < 0)
      continue;
    const Cell_range rows = cells_of(cells, 1, ball.center[1], __builtin_sqrt(in_layer));
    for(std::int64_t j = rows.first; j < rows.last; ++j) {
      const Distances y = distances(cells, 1, j, ball.center[1]);
      const double in_row = in_layer - y.nearest * y.nearest;
      if(in_row < 0)
        continue;
      const Cell_range outer = cells_of(cells, 0, ball.center[0], __builtin_sqrt(in_row));
      if(outer.first < outer.last)
        add_row(cells, cells.first.data() + (k * cells.number[1] + j) * cells.number[0], outer,
                smaller - z.farthest * z.farthest - y.farthest * y.farthest, ball, weights);
    }
  }
  return sum(weights);
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
