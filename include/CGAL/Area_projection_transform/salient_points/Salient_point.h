// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SALIENT_POINT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SALIENT_POINT_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief what the surface around a salient point is like.
enum class Salient_shape {
  SPHERE,
  TUBE,  ///< a cylinder, straight or bent
  CONE,  ///< a tube of which the radius changes along the axis
  OTHER, ///< round, but none of these; or not fitted at all
};

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief what the eigenvalues of the inertia of the map around a point tell: three numbers in [0, 1].
///
/// With the standard deviations `a >= b >= c` of the map around the point along its principal axes:
struct Inertia_descriptors
{
  double blobness = 0;   ///< `c / a`: 1 if it extends as far in all directions
  double flatness = 0;   ///< `(b - c) / a`: 1 for a disk
  double vesselness = 0; ///< `(a - b) / a`: 1 for a line
};

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief a centre of radial symmetry, and the part of the surface that it is the centre of.
///
/// Lengths are in the units of the surface. What was not determined is NaN, or empty.
struct Salient_point
{
  /// what was not determined: not a number.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  /// the centre of a sphere; of a tube the point of its axis in the middle of the part that was found.
  Point_3 position = Point_3(0, 0, 0);
  /// the radius `R` at which the transform is largest at `position`: about two thirds of the radius of a
  /// sphere, 85 % of that of a tube.
  double scale = unknown;
  /// the largest value of `APT / (4πR²)` over the radii at `position`, attained at `scale`.
  double intensity = unknown;
  /// how alike the three extents of the map around the point are: the smallest over the largest.
  double sphericity = unknown;
  /// how the map lies around the point: as a blob, flat, or along a line.
  Inertia_descriptors inertia = {unknown, unknown, unknown};

  /// the shape that fits to the voters.
  Salient_shape shape = Salient_shape::OTHER;
  /// the radius of the sphere or, at `position`, of the tube that fits to the voters. `paper_salient_points()` fits
  /// nothing: it has `scale` here, and the smoothed value of the maximum as `intensity`.
  double radius = unknown;
  /// \name An interval that holds the radius with a probability of 95 %
  /// if the vertices are displaced independently of each other. It knows nothing of surfaces that are not
  /// round, nor of errors that neighbouring vertices share.
  /// @{

  /// its lower end.
  double radius_low = unknown;
  /// its upper end.
  double radius_high = unknown;
  /// @}
  /// the standard deviation (robust) of the distances of the voters from the shape.
  double residual = unknown;
  /// the part of the sphere, or of the tube along `length`, that is covered by the surface, in [0, 1].
  double observed_fraction = unknown;
  /// whether all that is there of the surface lies on one side of a plane through the centre (or the axis).
  bool is_seen_from_one_side = false;

  Vector_3 axis = Vector_3(0, 0, 0); ///< of a tube or cone, a unit vector; null otherwise
  double length = unknown;           ///< along the axis, of the part of the tube that was found
  double slope = 0; ///< of a cone: the change of the radius per length along `axis`
  /// of a bent tube: towards the centre of the bend, as long as one over its radius; null if straight.
  Vector_3 curvature = Vector_3(0, 0, 0);

  /// the faces of a mesh or the points of a point set that support the shape, ascending: positions in the
  /// input, as `Triangle_surface::sources` and `Surfels::sources` have them. No two salient points share one.
  std::vector<std::uint32_t> voters;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_SALIENT_POINT_H
