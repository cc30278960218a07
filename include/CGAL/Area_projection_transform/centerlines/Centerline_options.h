// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CENTERLINE_OPTIONS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CENTERLINE_OPTIONS_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief the choices of `centerlines()`.
struct Centerline_options
{
  /// the side of the surface on which lines are sought: the outside for bores.
  Side side = Side::INSIDE;
  /// the range of the radii, in the units of the surface.
  /// Default: 0.003 to 0.25 of twice the largest distance of the surface from its centroid, and from less if all of the surface
  /// may be one thinner tube. What is below 1e-9 of that is not looked for.
  std::optional<double> smallest_radius;
  std::optional<double> largest_radius; ///< \copydoc smallest_radius
  /// whether lines are joined where tubes meet, through the inside of the shape. Otherwise each is on its own.
  bool do_join = true;
  /// whether lines are extended beyond the last fit to the surface or the rim in which their tubes end.
  bool do_extend = true;
  /// branches with a free end that are not longer than that are dropped, in units of their radius: twigs. Positive.
  double least_length = 1.2;
  /// the distance of the vertices of a line, in units of its radius. Positive.
  double vertex_spacing = 0.12;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \throw std::invalid_argument
inline void check(const Centerline_options& options)
{
  if(options.smallest_radius)
    check_positive(*options.smallest_radius, "smallest_radius");
  if(options.largest_radius)
    check_positive(*options.largest_radius, "largest_radius");
  if(options.smallest_radius && options.largest_radius &&
     *options.smallest_radius > *options.largest_radius)
    throw std::invalid_argument(
        "smallest_radius is " + internal::to_text(*options.smallest_radius) +
        ": larger than largest_radius, " + internal::to_text(*options.largest_radius));
  check_positive(options.least_length, "least_length");
  check_positive(options.vertex_spacing, "vertex_spacing");
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CENTERLINE_OPTIONS_H
