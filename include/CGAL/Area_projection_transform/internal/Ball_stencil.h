// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_BALL_STENCIL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_BALL_STENCIL_H

#include <CGAL/Area_projection_transform/internal/Run_accumulator.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief adds a value to all voxels within a ball of fixed radius, whose centre may lie anywhere
/// between the voxels.
///
/// In each row of voxels a ball covers one run. Rows are treated four at a time. Which of them a ball
/// can reach depends on the quarter of the voxel face in which its centre lies; there is a list for
/// each quarter.
class Ball_stencil
{
public:
  /// \param radius in voxels
  /// \param row_stride the distance between rows that are neighbours in `z`
  Ball_stencil(double radius, std::size_t row_stride)
      : m_squared_radius(float(radius * radius)), m_shift(float(int(radius) + 2))
  {
    for(int quarter = 0; quarter < 4; ++quarter)
      list_groups(radius, quarter & 1, quarter >> 1, std::ptrdiff_t(row_stride),
                  m_quarters[quarter]);
  }

  /// how many voxels outside of a grid the centre of a ball may lie and still reach into it.
  static int margin(double radius) { return int(radius + 0.5) + 1; }

  /// the padding that an accumulator needs for balls up to that far outside.
  static int padding(double radius) { return 2 * margin(radius) + lanes; }

  /// \param nearest_row, nearest_x the voxel nearest to the centre
  /// \param x, y, z the position of the centre relative to that voxel, each in [-1/2, 1/2]
  void add(Run_accumulator& accumulator, std::size_t nearest_row, int nearest_x, float x, float y,
           float z, std::uint32_t value) const
  {
    const Floats steps(0.f, 1.f, 2.f, 3.f);
    const float voxel = float(nearest_x);
    const float* const group_first = accumulator.group_first() + nearest_row;
    const float* const group_last = accumulator.group_last() + nearest_row;
    for(const Group& group : m_quarters[(y > 0) + 2 * (z > 0)]) {
      // Most rows within reach of a ball have no voxel of interest in its way.
      if(group_last[group.offset] - 1 < voxel + x - group.half ||
         group_first[group.offset] > voxel + x + group.half)
        continue;
      const float dz = z - group.z;
      const Floats dy = steps + (group.y - y);
      const Floats squared_half = (m_squared_radius - dz * dz) - dy.square();
      // A row out of reach gets a negative half width, hence an empty run, without a branch.
      const Floats half = (squared_half.max(0.f).sqrt() + 1e6f * squared_half.min(0.f)).max(-1.f);
      // Truncation rounds positive numbers down; the shift makes all numbers positive.
      const Floats low = (half + (m_shift - x)).cast<int>().cast<float>();
      const Floats high = (half + (m_shift + x)).cast<int>().cast<float>();

      const std::size_t row = nearest_row + std::size_t(group.offset);
      const Eigen::Map<const Floats> first(accumulator.first() + row);
      const Eigen::Map<const Floats> last(accumulator.last() + row);
      const Eigen::Map<const Ints> place(accumulator.place() + row);
      const Floats begin = ((voxel + m_shift) - low).max(first).min(last);
      const Floats end = (high + (voxel - m_shift + 1)).min(last).max(begin);
      Ints begin_place = begin.cast<int>();
      Ints end_place = end.cast<int>();
      begin_place += place;
      end_place += place;
      for(int i = 0; i < lanes; ++i)
        accumulator.add(begin_place[i], end_place[i], value);
    }
  }

private:
  // Eigen, because compilers do not vectorise this under -frounding-math, which CGAL needs elsewhere.
  static constexpr int lanes = Run_accumulator::rows_of_group;
  using Floats = Eigen::Array<float, lanes, 1>;
  using Ints = Eigen::Array<std::int32_t, lanes, 1>;

  /// rows `y`, …, `y + lanes - 1` of layer `z`, relative to the voxel nearest to the centre.
  struct Group
  {
    float y, z;
    float half; ///< the largest half width of a run in these rows
    std::ptrdiff_t offset;
  };

  static void list_groups(double radius, int upper_y, int upper_z, std::ptrdiff_t stride,
                          std::vector<Group>& groups)
  {
    // The distance from a row to the quarter [0, 1/2] (upper) or [-1/2, 0] (lower) of an axis.
    const auto distance = [](int row, int upper) {
      const double low = upper ? 0. : -0.5;
      return std::max({low - row, row - low - 0.5, 0.});
    };
    const int reach = int(radius + 0.5);
    for(int z = -reach; z <= reach; ++z) {
      const double dz = distance(z, upper_z);
      const auto squared_half = [&](int y) {
        const double dy = distance(y, upper_y);
        return radius * radius - dy * dy - dz * dz;
      };
      int y = -reach;
      while(y <= reach)
        if(squared_half(y) >= 0) {
          double largest = 0;
          for(int i = 0; i < lanes; ++i)
            largest = std::max(largest, squared_half(y + i));
          // A little more, for the rounding of coordinates of voxels.
          groups.push_back({float(y), float(z), float(std::sqrt(largest) + 0.02), y + stride * z});
          y += lanes;
        } else
          ++y;
    }
  }

  float m_squared_radius;
  float m_shift;
  std::array<std::vector<Group>, 4> m_quarters;
};

/// \brief the voxel nearest to a point, and the place of the point relative to it.
struct Lattice_place
{
  std::array<int, 3> nearest{};
  std::array<float, 3> offset{};
  bool is_outside = false;      ///< whether the nearest voxel does not belong to the grid
  bool is_out_of_reach = false; ///< whether it is farther from the grid than `margin` voxels

  /// \param voxels_per_unit the inverse of the spacing of the grid
  Lattice_place(const Grid_3& grid, double voxels_per_unit, const Point_3& p, int margin)
  {
    for(int axis = 0; axis < 3; ++axis) {
      const double c = (p[axis] - grid.origin()[axis]) * voxels_per_unit;
      const double limit = grid.size()[axis] - 0.5;
      is_outside |= !(c >= -0.5 && c <= limit);
      is_out_of_reach |= !(c >= -0.5 - margin && c <= limit + margin);
      if(is_out_of_reach)
        return;
      nearest[axis] = int(c + 0.5 + margin) - margin;
      offset[axis] = float(c - nearest[axis]);
    }
  }
};

/// adds `value` to the voxels within a ball around a place that is not out of reach.
inline void add_ball(Run_accumulator& accumulator, const Ball_stencil& ball,
                     const Lattice_place& place, std::uint32_t value)
{
  ball.add(accumulator, accumulator.padded_row(place.nearest[1], place.nearest[2]),
           place.nearest[0], place.offset[0], place.offset[1], place.offset[2], value);
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_BALL_STENCIL_H
