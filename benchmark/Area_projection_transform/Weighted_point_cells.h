// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_BENCHMARK_WEIGHTED_POINT_CELLS_H
#define AREA_PROJECTION_TRANSFORM_BENCHMARK_WEIGHTED_POINT_CELLS_H

// What the tree of the library was chosen over.

#include <CGAL/Area_projection_transform/internal/Weighted_points.h>
#include <CGAL/Area_projection_transform/internal/simd/instruction_set.h>

#include <CGAL/Bbox_3.h>

#include <array>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the arrays of `Weighted_point_cells` as its kernel reads them.
struct Weighted_point_cells_arrays
{
  static constexpr std::size_t padding = 16; ///< points that a kernel may read beyond the last

  double low[3];
  double size;                      ///< of a cell
  double tolerance;                 ///< more than points are off their cells by rounding
  std::int64_t number[3];           ///< of cells along each axis
  std::vector<std::uint32_t> first; ///< the first point of each cell, and their number
  std::array<std::vector<double>, 3> position;
  std::vector<std::int64_t> weight_before; ///< of all points before a point
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#define CGAL_AREA_PROJECTION_KERNEL "weighted_point_cells_impl.h"
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief sums the weights of the points in a ball by a grid of cells, best for balls of about one radius.
///
/// Points are sorted by cell, along rows of cells. What a ball has in the inner cells of a row is the
/// difference of two sums; only the points of the outer cells are looked at.
class Weighted_point_cells
{
public:
  /// cells are larger than `size` if they would be more than four for each point.
  Weighted_point_cells(const std::vector<Weighted_point>& points, double size)
  {
    place_cells(points, size);
    std::vector<std::uint32_t> cells(points.size());
    std::vector<std::uint32_t>& first = m_arrays.first;
    for(std::size_t i = 0; i < points.size(); ++i) {
      cells[i] = cell(points[i]);
      ++first[cells[i] + 1];
    }
    for(std::size_t c = 1; c < first.size(); ++c)
      first[c] += first[c - 1];
    for(auto& coordinates : m_arrays.position)
      coordinates.resize(points.size() + m_arrays.padding);
    m_arrays.weight_before.resize(points.size() + m_arrays.padding + 1);
    std::vector<std::uint32_t> next = first;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t place = next[cells[i]]++;
      for(std::size_t axis = 0; axis < 3; ++axis)
        m_arrays.position[axis][place] = points[i].position[axis];
      m_arrays.weight_before[place + 1] = points[i].weight;
    }
    for(std::size_t i = 1; i < m_arrays.weight_before.size(); ++i)
      m_arrays.weight_before[i] += m_arrays.weight_before[i - 1];
  }

  std::int64_t sum(const Weighted_points_ball& ball) const
  {
    return CGAL_AREA_PROJECTION_DISPATCHED(sum_of_cells, m_arrays, ball);
  }

private:
  void place_cells(const std::vector<Weighted_point>& points, double size)
  {
    Bbox_3 box;
    for(const Weighted_point& p : points)
      box += Point_3(p.position[0], p.position[1], p.position[2]).bbox();
    for(;; size *= 1.1) {
      double all = 1;
      for(int axis = 0; axis < 3; ++axis)
        all *= std::floor((box.max(axis) - box.min(axis)) / size) + 1;
      if(all <= 4. * double(points.size()))
        break;
    }
    std::size_t number = 1;
    for(int axis = 0; axis < 3; ++axis) {
      m_arrays.low[axis] = box.min(axis);
      m_arrays.number[axis] = std::int64_t((box.max(axis) - box.min(axis)) / size) + 1;
      number *= std::size_t(m_arrays.number[axis]);
    }
    m_arrays.size = size;
    m_arrays.tolerance = 1e-12 * (box.x_span() + box.y_span() + box.z_span());
    m_arrays.first.assign(number + 1, 0);
  }

  std::uint32_t cell(const Weighted_point& point) const
  {
    std::int64_t result = 0;
    for(int axis = 2; axis >= 0; --axis)
      result = result * m_arrays.number[axis] +
               std::int64_t((point.position[axis] - m_arrays.low[axis]) / m_arrays.size);
    return std::uint32_t(result);
  }

  Weighted_point_cells_arrays m_arrays;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // AREA_PROJECTION_TRANSFORM_BENCHMARK_WEIGHTED_POINT_CELLS_H
