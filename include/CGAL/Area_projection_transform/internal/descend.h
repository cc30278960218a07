// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DESCEND_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DESCEND_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <CGAL/Origin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief goes down a field of times, in lattice coordinates.
/// \tparam Times has `time(i, j, k)`, infinite where there is none; every voxel but those where all begins has one
/// of a lower time among the six next to it
template <class Times>
class Descent
{
public:
  using Voxel = std::array<int, 3>;

  Descent(const Times& times, const Voxel& start)
      : m_times(times), m_place(vector_of(start)), m_time(time_of(start))
  {}

  const Vector_3& place() const { return m_place; }

  /// \return whether there was a way down
  bool step()
  {
    const Cell cell(m_place);
    const Voxel lowest = lowest_corner(cell);
    const Voxel next = lowest_neighbour(lowest);
    const double drop = time_of(lowest) - time_of(next);
    // Interpolated times are rounded: they must fall by far more than that, or there might be no end.
    if(drop > 1e-12 * std::abs(m_time) && step_along_gradient(cell, least_share * drop))
      return true;
    // Within a cell whose corners were all reached there is nothing in the way.
    if(vector_of(lowest) != m_place)
      move_to(lowest);
    else if(drop > 0)
      move_to(next);
    else
      return false;
    return true;
  }

private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  static constexpr double length = 0.5; // of a step, in voxels
  /// \brief what a step has to bring, in units of the step to the lowest neighbour.
  ///
  /// Down a slope, a step of half a voxel brings at least a half of that.
  static constexpr double least_share = 0.125;

  /// the corners of the cube of the lattice around a place, and their weights in linear interpolation.
  struct Cell
  {
    explicit Cell(const Vector_3& p)
    {
      for(int axis = 0; axis < 3; ++axis) {
        const double floor = std::floor(p[axis]);
        first[std::size_t(axis)] = int(floor);
        fraction[std::size_t(axis)] = p[axis] - floor;
      }
    }

    /// calls `function(corner, weight)` for corners of weights other than zero.
    template <class Function>
    void for_each_corner(Function&& function) const
    {
      for(unsigned corner = 0; corner < 8; ++corner) {
        double weight = 1;
        Voxel voxel = first;
        for(std::size_t axis = 0; axis < 3; ++axis) {
          const bool is_upper = corner >> axis & 1;
          weight *= is_upper ? fraction[axis] : 1 - fraction[axis];
          voxel[axis] += is_upper;
        }
        if(weight > 0)
          function(voxel, weight);
      }
    }

    Voxel first;
    std::array<double, 3> fraction;
  };

  static Vector_3 vector_of(const Voxel& v) { return Vector_3(v[0], v[1], v[2]); }
  double time_of(const Voxel& v) const { return m_times.time(v[0], v[1], v[2]); }

  double time_at(const Cell& cell) const
  {
    double time = 0;
    cell.for_each_corner(
        [&](const Voxel& corner, double weight) { time += weight * time_of(corner); });
    return time;
  }

  Voxel lowest_corner(const Cell& cell) const
  {
    Voxel lowest = cell.first;
    double time = never;
    cell.for_each_corner([&](const Voxel& corner, double) {
      if(time_of(corner) < time) {
        time = time_of(corner);
        lowest = corner;
      }
    });
    return lowest;
  }

  /// the voxel itself, if none of the six next to it is lower.
  Voxel lowest_neighbour(const Voxel& voxel) const
  {
    Voxel lowest = voxel;
    for(std::size_t axis = 0; axis < 3; ++axis)
      for(const int step : {-1, 1}) {
        Voxel next = voxel;
        next[axis] += step;
        if(time_of(next) < time_of(lowest))
          lowest = next;
      }
    return lowest;
  }

  /// the gradient at a voxel, by differences against the wind, as in the equation that the times solve.
  Vector_3 gradient(const Voxel& voxel) const
  {
    std::array<double, 3> slope{0, 0, 0};
    const double time = time_of(voxel);
    for(std::size_t axis = 0; axis < 3; ++axis) {
      Voxel before = voxel, after = voxel;
      --before[axis];
      ++after[axis];
      const double fall_before = time - time_of(before), fall_after = time - time_of(after);
      if(fall_before > 0 && fall_before >= fall_after)
        slope[axis] = fall_before;
      else if(fall_after > 0)
        slope[axis] = -fall_after;
    }
    return Vector_3(slope[0], slope[1], slope[2]);
  }

  bool step_along_gradient(const Cell& cell, double least_drop)
  {
    Vector_3 sum(CGAL::NULL_VECTOR);
    cell.for_each_corner(
        [&](const Voxel& corner, double weight) { sum = sum + weight * gradient(corner); });
    const double norm = std::sqrt(sum.squared_length());
    if(!(norm > 0) || !std::isfinite(norm))
      return false;
    const Vector_3 place = m_place - (length / norm) * sum;
    const double time = time_at(Cell(place));
    if(!(time <= m_time - least_drop))
      return false;
    m_place = place;
    m_time = time;
    return true;
  }

  void move_to(const Voxel& voxel)
  {
    m_place = vector_of(voxel);
    m_time = time_of(voxel);
  }

  const Times& m_times;
  Vector_3 m_place;
  double m_time;
};

/// the places on the way down from a voxel, in lattice coordinates; the last is where no way leads on.
template <class Times>
std::vector<Vector_3> descend(const Times& times, const std::array<int, 3>& start)
{
  Descent<Times> descent(times, start);
  std::vector<Vector_3> path;
  do
    path.push_back(descent.place());
  while(descent.step());
  return path;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DESCEND_H
