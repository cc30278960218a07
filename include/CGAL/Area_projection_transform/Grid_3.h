// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_GRID_3_H
#define CGAL_AREA_PROJECTION_TRANSFORM_GRID_3_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/lengths.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief a regular lattice of points with the same spacing along the three axes.
///
/// The lattice point (`i`, `j`, `k`) is `origin() + spacing() * (i, j, k)`: the origin is the
/// centre of the first voxel, not its corner. `x` runs fastest; a row is all points that share
/// (`j`, `k`) and has the index `j + size()[1] * k`.
class Grid_3
{
public:
  /// \brief constructs a lattice.
  /// \param origin the centre of the first voxel
  /// \param spacing the distance of neighbours, in the unit of the points
  /// \param size the numbers of lattice points along the axes
  /// \throw std::invalid_argument if `spacing` is not positive or more than `largest_length`, a
  /// coordinate of `origin` is not finite, or a size is not positive.
  Grid_3(const Point_3& origin, double spacing, const std::array<int, 3>& size)
      : m_origin(origin), m_spacing(spacing), m_size(size)
  {
    internal::check_positive(spacing, "spacing");
    for(int axis = 0; axis < 3; ++axis) {
      if(!std::isfinite(origin[axis]))
        throw std::invalid_argument("origin has a coordinate that is not finite");
      if(size[axis] < 1)
        throw std::invalid_argument("size[" + std::to_string(axis) + "] is " +
                                    std::to_string(size[axis]) + ": must be at least 1");
    }
  }

  /// the centre of the voxel (0, 0, 0).
  const Point_3& origin() const { return m_origin; }
  /// the distance of neighbours, which is the side of a voxel.
  double spacing() const { return m_spacing; }
  /// the numbers of lattice points along the axes.
  const std::array<int, 3>& size() const { return m_size; }

  /// how many rows there are: `size()[1] * size()[2]`.
  std::size_t number_of_rows() const { return std::size_t(m_size[1]) * std::size_t(m_size[2]); }
  /// how many lattice points there are.
  std::size_t number_of_voxels() const { return number_of_rows() * std::size_t(m_size[0]); }

  /// the index of the row of all points with these `j` and `k`.
  std::size_t row(int j, int k) const
  {
    return std::size_t(j) + std::size_t(m_size[1]) * std::size_t(k);
  }

  /// the lattice point (`i`, `j`, `k`), inside the grid or not.
  Point_3 point(int i, int j, int k) const
  {
    return Point_3(m_origin.x() + m_spacing * i, m_origin.y() + m_spacing * j,
                   m_origin.z() + m_spacing * k);
  }

  /// the coordinates of `p` in units of the spacing: lattice points have integer coordinates.
  Vector_3 lattice_coordinates(const Point_3& p) const { return (p - m_origin) / m_spacing; }

  friend bool operator==(const Grid_3& a, const Grid_3& b)
  {
    return a.m_origin == b.m_origin && a.m_spacing == b.m_spacing && a.m_size == b.m_size;
  }

private:
  Point_3 m_origin;
  double m_spacing;
  std::array<int, 3> m_size;
};

/// \ingroup PkgAreaProjectionTransformGround
/// \brief returns the smallest lattice of the given spacing that is centred on `box` and covers
/// it with at least `margin` to spare on every side.
///
/// Centring makes the lattice follow the shape under translation.
/// \param box the box, in any unit of length
/// \param spacing the distance of neighbours, in the same unit, positive
/// \param margin how far the lattice reaches beyond the box at least, in the same unit, not negative
/// \throw std::invalid_argument if `spacing` is not positive or more than `largest_length`, `margin` is
/// negative, `box` is empty, or a side would have more than 2^24 lattice points.
inline Grid_3 grid_around(const Bbox_3& box, double spacing, double margin = 0)
{
  internal::check_positive(spacing, "spacing");
  if(!(margin >= 0))
    throw std::invalid_argument("margin is " + internal::to_text(margin) +
                                ": must not be negative");
  std::array<double, 3> first;
  std::array<int, 3> size;
  for(int axis = 0; axis < 3; ++axis) {
    const double extent = box.max(axis) - box.min(axis) + 2 * margin;
    if(!(box.max(axis) >= box.min(axis)) || !std::isfinite(extent))
      throw std::invalid_argument("box is empty or not finite");
    const double intervals = std::ceil(extent / spacing);
    if(!(intervals < double(1 << 24)))
      throw std::invalid_argument("spacing is " + internal::to_text(spacing) +
                                  ": too small for a box " + internal::to_text(extent) + " wide");
    size[axis] = int(intervals) + 1;
    first[axis] = 0.5 * (box.min(axis) + box.max(axis)) - 0.5 * spacing * intervals;
  }
  return Grid_3(Point_3(first[0], first[1], first[2]), spacing, size);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_GRID_3_H
