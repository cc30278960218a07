// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_LATTICE_AXIS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_LATTICE_AXIS_H

#include <CGAL/Area_projection_transform/Grid_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the coordinates of the lattice points along one axis, as `Grid_3::point()` rounds them.
///
/// Ascending, since rounding is monotone. Places among them are first guessed by a multiplication.
class Lattice_axis
{
public:
  Lattice_axis(const Grid_3& grid, int axis)
      : m_axis(axis), m_origin(grid.origin()[axis]), m_inverse(1 / grid.spacing())
  {
    const int size = grid.size()[std::size_t(axis)];
    m_coordinates.reserve(std::size_t(size));
    for(int i = 0; i < size; ++i)
      m_coordinates.push_back(m_origin + grid.spacing() * i);
  }

  int axis() const { return m_axis; }
  int size() const { return int(m_coordinates.size()); }
  double operator[](int i) const { return m_coordinates[std::size_t(i)]; }

  /// where `coordinate` belongs, good to rounding: an index from 0 to `size()`.
  int guess(double coordinate) const
  {
    const double place = (coordinate - m_origin) * m_inverse;
    return place > 0 ? place < size() ? int(place) + 1 : size() : 0; // also if it is not a number
  }

  /// the number of lattice points for which `precedes(index)` holds: it does so up to one and then no
  /// more. Asks about few besides `start`.
  template <class Predicate>
  int partition_point(int start, Predicate&& precedes) const
  {
    int i = start;
    while(i > 0 && !precedes(i - 1))
      --i;
    while(i < size() && precedes(i))
      ++i;
    return i;
  }

  /// the number of lattice points below `coordinate`.
  int number_below(double coordinate) const
  {
    return partition_point(guess(coordinate),
                           [&](int i) { return m_coordinates[std::size_t(i)] < coordinate; });
  }

private:
  int m_axis;
  double m_origin, m_inverse;
  std::vector<double> m_coordinates;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_LATTICE_AXIS_H
