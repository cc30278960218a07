// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DESCEND_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DESCEND_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief goes down a field of times, in lattice coordinates.
///
/// The time of a place is interpolated between those corners of its cell (the cube of the lattice around it) that were
/// reached, and among which one can get to the nearest voxel along the edges of the cell: what lies behind a wall
/// does not count.
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
    const Cell cell = cell_around(m_place);
    const Voxel lowest = lowest_corner(cell);
    const Voxel next = lowest_neighbour(lowest);
    const double drop = time_of(lowest) - time_of(next);
    // Interpolated times are rounded: they must fall by far more than that, or there might be no end.
    if(drop > 1e-12 * std::abs(m_time) && step_along_gradient(cell, least_share * drop))
      return true;
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
  /// Down a slope, a step of half a voxel brings at least a quarter of that.
  static constexpr double least_share = 0.125;

  /// the corners of a cube of the lattice: which of them count, and their weights in linear interpolation.
  struct Cell
  {
    Voxel first;
    std::array<double, 8> weights;
    unsigned connected; // a bit for each corner

    Voxel corner(unsigned c) const
    {
      return {first[0] + int(c & 1), first[1] + int(c >> 1 & 1), first[2] + int(c >> 2)};
    }

    /// calls `function(corner, weight)` for the corners that count.
    template <class Function>
    void for_each_corner(Function&& function) const
    {
      for(unsigned c = 0; c < 8; ++c)
        if(connected >> c & 1)
          function(corner(c), weights[c]);
    }
  };

  static Vector_3 vector_of(const Voxel& v) { return Vector_3(v[0], v[1], v[2]); }
  double time_of(const Voxel& v) const { return m_times.time(v[0], v[1], v[2]); }

  static Voxel nearest(const Vector_3& p)
  {
    return {int(std::floor(p.x() + 0.5)), int(std::floor(p.y() + 0.5)),
            int(std::floor(p.z() + 0.5))};
  }

  /// \brief finds the corners of a cube to which one gets from one of them, along its edges, by voxels that were
  /// reached and are allowed.
  unsigned connected_corners(const Cell& cell, unsigned from, unsigned allowed) const
  {
    unsigned reached = 0;
    for(unsigned c = 0; c < 8; ++c)
      if(allowed >> c & 1 && time_of(cell.corner(c)) < never)
        reached |= 1u << c;
    unsigned connected = reached & 1u << from;
    for(int step = 0; step < 7; ++step)
      for(unsigned c = 0; c < 8; ++c)
        if(connected >> c & 1)
          connected |= reached & (1u << (c ^ 1) | 1u << (c ^ 2) | 1u << (c ^ 4));
    return connected;
  }

  static unsigned corner_of(const Cell& cell, const Voxel& v)
  {
    return unsigned(v[0] - cell.first[0]) | unsigned(v[1] - cell.first[1]) << 1 |
           unsigned(v[2] - cell.first[2]) << 2;
  }

  Cell cell_around(const Vector_3& p) const
  {
    Cell cell{{int(std::floor(p.x())), int(std::floor(p.y())), int(std::floor(p.z()))}, {}, 0};
    unsigned allowed = 0; // those of weights other than zero
    for(unsigned c = 0; c < 8; ++c) {
      const Voxel corner = cell.corner(c);
      double weight = 1;
      for(int axis = 0; axis < 3; ++axis)
        weight *= 1 - std::abs(p[axis] - corner[std::size_t(axis)]);
      cell.weights[c] = weight;
      if(weight > 0)
        allowed |= 1u << c;
    }
    cell.connected = connected_corners(cell, corner_of(cell, nearest(p)), allowed);
    return cell;
  }

  double time_at(const Cell& cell) const
  {
    double time = 0, sum = 0;
    cell.for_each_corner([&](const Voxel& corner, double weight) {
      time += weight * time_of(corner);
      sum += weight;
    });
    return sum > 0 ? time / sum : never;
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

  /// whether one gets from a voxel to another, whose coordinates differ by no more than one, within their cube.
  bool are_connected(const Voxel& a, const Voxel& b) const
  {
    Cell cube{{std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2])}, {}, 0};
    return connected_corners(cube, corner_of(cube, a), 0xff) >> corner_of(cube, b) & 1;
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
    const double time = time_at(cell_around(place));
    if(!(time <= m_time - least_drop) || !are_connected(nearest(m_place), nearest(place)))
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
