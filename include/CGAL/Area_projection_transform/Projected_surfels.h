// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTED_SURFELS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTED_SURFELS_H

#include <CGAL/Area_projection_transform/Covariance_3.h>
#include <CGAL/Area_projection_transform/Kernel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformScaleSpace
/// \brief a parallel surface in small pieces: where the area of each lands, how much it is, and how far
/// it spreads.
///
/// Stored as parallel arrays.
struct Projected_surfels
{
  std::vector<Point_3> positions;        ///< the means of the pieces
  std::vector<double> areas;             ///< of the pieces, not negative
  std::vector<Covariance_3> covariances; ///< of the positions within each piece

  /// the number of pieces.
  std::size_t size() const { return positions.size(); }
  /// whether there are none.
  bool empty() const { return positions.empty(); }

  /// removes all pieces, and keeps the memory.
  void clear()
  {
    positions.clear();
    areas.clear();
    covariances.clear();
  }

  /// takes the memory for some pieces.
  void reserve(std::size_t number)
  {
    positions.reserve(number);
    areas.reserve(number);
    covariances.reserve(number);
  }

  /// adds a piece; without a covariance it is a point.
  void push_back(const Point_3& position, double area, const Covariance_3& covariance = {})
  {
    positions.push_back(position);
    areas.push_back(area);
    covariances.push_back(covariance);
  }
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTED_SURFELS_H
