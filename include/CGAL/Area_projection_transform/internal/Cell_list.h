// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_LIST_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_LIST_H

#include <CGAL/Area_projection_transform/internal/Cell_index.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief points in cubic cells, to find those near a place.
///
/// Cells that are 2^20 apart along an axis share a list: distances tell their points apart, wherever they are.
class Cell_list
{
public:
  using Vector = Eigen::Vector3d;

  Cell_list() = default;

  /// \param points must stay where they are for as long as they are asked for
  /// \param cell_size if it is 0, as it is for a surface without area, all points share a cell
  Cell_list(const std::vector<Vector>& points, double cell_size)
      : m_points(&points), m_scale(cell_size > 0 ? 1 / cell_size : 0), m_cells(points.size() / 4)
  {
    if(!points.empty())
      m_origin = points.front();
    std::vector<std::uint32_t> cell_of(points.size());
    for(std::size_t i = 0; i < points.size(); ++i) {
      cell_of[i] = m_cells.insert(key(cell(points[i])));
      if(cell_of[i] == m_begin.size())
        m_begin.push_back(0);
      ++m_begin[cell_of[i]];
    }
    std::uint32_t sum = 0;
    for(std::uint32_t& begin : m_begin)
      begin = sum += begin; // the end of the cell, which becomes its beginning as it is filled
    m_begin.push_back(sum);
    m_order.resize(points.size());
    for(std::size_t i = points.size(); i-- > 0;)
      m_order[--m_begin[cell_of[i]]] = std::uint32_t(i);
  }

  /// \brief calls `function(index, squared_distance)` for the points within `radius` of a place.
  ///
  /// The order depends on the points, the cells and the place only.
  template <class Function>
  void for_each_in_ball(const Vector& center, double radius, Function&& function) const
  {
    if(m_order.empty())
      return;
    const Cell low = cell(center - Vector::Constant(radius));
    const Cell high = cell(center + Vector::Constant(radius));
    const double squared_radius = radius * radius;
    const auto visit = [&](std::uint32_t c) {
      for(std::uint32_t k = m_begin[c]; k < m_begin[c + 1]; ++k) {
        const double squared_distance = ((*m_points)[m_order[k]] - center).squaredNorm();
        if(squared_distance <= squared_radius)
          function(std::size_t(m_order[k]), squared_distance);
      }
    };
    double cells = 1;
    bool has_cell_twice = false;
    for(int axis = 0; axis < 3; ++axis) {
      cells *= double(high[axis] - low[axis]) + 1;
      has_cell_twice = has_cell_twice || high[axis] - low[axis] >= period;
    }
    if(has_cell_twice || cells > double(m_begin.size())) { // a ball as large as everything
      for(std::uint32_t c = 0; c + 1 < m_begin.size(); ++c)
        visit(c);
      return;
    }
    for(std::int64_t k = low[2]; k <= high[2]; ++k)
      for(std::int64_t j = low[1]; j <= high[1]; ++j)
        for(std::int64_t i = low[0]; i <= high[0]; ++i) {
          const std::uint32_t c = m_cells.find(key({i, j, k}));
          if(c != Cell_index::none)
            visit(c);
        }
  }

  /// \brief calls `function(i, j, squared_distance)` for all ordered pairs of points within `radius` of each
  /// other, a point and itself included.
  ///
  /// All pairs of the same `i` come one after the other.
  /// \pre `radius` is not larger than the cells
  template <class Function>
  void for_each_pair(double radius, Function&& function) const
  {
    const double squared_radius = radius * radius;
    std::vector<std::uint32_t> near;
    for(std::uint32_t c = 0; c + 1 < m_begin.size(); ++c) {
      near.clear();
      const Cell place = cell((*m_points)[m_order[m_begin[c]]]);
      for(std::int32_t k = -1; k <= 1; ++k)
        for(std::int32_t j = -1; j <= 1; ++j)
          for(std::int32_t i = -1; i <= 1; ++i) {
            const std::uint32_t other =
                m_cells.find(key({place[0] + i, place[1] + j, place[2] + k}));
            if(other != Cell_index::none)
              near.insert(near.end(), m_order.begin() + m_begin[other],
                          m_order.begin() + m_begin[other + 1]);
          }
      for(std::uint32_t k = m_begin[c]; k < m_begin[c + 1]; ++k)
        for(const std::uint32_t j : near) {
          const double squared_distance = ((*m_points)[j] - (*m_points)[m_order[k]]).squaredNorm();
          if(squared_distance <= squared_radius)
            function(std::size_t(m_order[k]), std::size_t(j), squared_distance);
        }
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  static constexpr std::int64_t period = std::int64_t(1) << 20;

  Cell cell(const Vector& p) const
  {
    // Beyond it, a double is coarser than the cells.
    constexpr double last = std::int64_t(1) << 53;
    const Vector c = ((p - m_origin) * m_scale).array().floor().min(last).max(-last);
    return {std::int64_t(c.x()), std::int64_t(c.y()), std::int64_t(c.z())};
  }

  static std::uint64_t key(const Cell& cell)
  {
    std::array<std::int32_t, 3> wrapped;
    for(int axis = 0; axis < 3; ++axis)
      wrapped[axis] = std::int32_t((cell[axis] & (period - 1)) - period / 2);
    return Cell_index::key(wrapped);
  }

  const std::vector<Vector>* m_points = nullptr;
  Vector m_origin = Vector::Zero();
  double m_scale = 1;
  Cell_index m_cells;
  std::vector<std::uint32_t> m_begin, m_order;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_LIST_H
