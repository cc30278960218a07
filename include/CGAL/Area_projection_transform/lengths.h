// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_LENGTHS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_LENGTHS_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// the largest radius, `σ` or spacing, in whatever unit: the squares of larger ones are soon no numbers.
inline constexpr double largest_length = 1e150;

/// \ingroup PkgAreaProjectionTransformGround
/// the largest coordinate of a surface: squared areas, which are fourth powers, must be numbers.
inline constexpr double largest_coordinate = 1e75;

/// \cond SKIP_IN_MANUAL
namespace internal {

/// for the points of surfaces, of which messages name the kind and the position.
inline void check_coordinates(const Point_3& p, const char* kind, std::size_t index)
{
  if(std::abs(p.x()) <= largest_coordinate && std::abs(p.y()) <= largest_coordinate &&
     std::abs(p.z()) <= largest_coordinate) // NaN fails
    return;
  const bool is_finite = std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  throw std::invalid_argument(
      std::string(kind) + " " + std::to_string(index) +
      (is_finite ? " has a coordinate beyond 1e75: rescale the shape" : " is not finite"));
}

/// for lengths and factors.
inline void check_positive(double value, const std::string& name)
{
  if(!(value > 0) || !std::isfinite(value))
    throw std::invalid_argument(name + " is " + to_text(value) + ": must be positive and finite");
  if(value > largest_length)
    throw std::invalid_argument(name + " is " + to_text(value) +
                                ": must be at most 1e150, for its square to be a number");
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_LENGTHS_H
