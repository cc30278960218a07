// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MEDIAL_BALL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MEDIAL_BALL_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief a ball that touches a surface and has nothing of it inside, with what tells how much it matters.
///
/// All lengths are in the units of the surface.
struct Medial_ball
{
  Point_3 center = Point_3(0, 0, 0); ///< a point of the medial axis
  double radius = 0;                 ///< its distance from the surface

  /// \brief where the surface around the ball comes together, and the radius there: the ball fitted to its voters,
  /// or the ball itself if there is no such fit that keeps to its side of the surface.
  ///
  /// Far less sensitive to noise; but it rounds the ends of cones and the edges of boxes. The ball itself says
  /// what is inside the shape, this one what the shape is like there.
  Point_3 refitted_center = Point_3(0, 0, 0);
  double refitted_radius = 0; ///< \copydoc refitted_center

  Point_3 surface_point = Point_3(0, 0, 0); ///< where it touches, the sample that it was made for
  Point_3 contact = Point_3(0, 0, 0);       ///< the sample that stopped it
  std::uint32_t source = 0;         ///< the face, or point, of the input that `surface_point` is of
  std::uint32_t contact_source = 0; ///< that of `contact`

  /// \brief the normalized transform MAPT at the refitted centre and radius: the part of the ball that the surface
  /// follows. For `σ/R = 1/2` it is 1/8 between parallel walls, 1/2 in a tube and 1 in a sphere, of any size.
  double mapt = 0;
  /// \brief how far the voters, those points of the surface that are projected to the refitted centre, spread: the
  /// root of the mean squared distance from their centroid. A length.
  double spread = 0;
  /// the radius of the smallest ball around all contacts (the λ of the λ-medial axis). A length.
  double lambda = 0;
  /// \brief the largest angle under which the centre sees `surface_point` and another contact, in degrees: 180
  /// between walls and in tubes, 90 along the edges of a box.
  double angle = 0;
  /// \brief the factor by which all balls must grow for this one to be within one that is larger: the largest `s` for
  /// which it belongs to the scale axis. Infinite if there is no larger ball.
  double scale_axis = std::numeric_limits<double>::infinity();
};

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief ways to find the medial ball of a sample.
enum class Medial_ball_method {
  TOUCHING, ///< the largest ball that touches at the sample, by its normal, and is stopped by another one
  POLAR ///< the largest ball through the sample and three others, a vertex of their Voronoi diagram: the inner pole
};

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief the choices of `medial_balls()`.
struct Medial_ball_options
{
  /// \brief how balls are found. Touching balls follow the normals. Polar balls are where the samples say, so that
  /// normals only have to tell inside from outside.
  Medial_ball_method method = Medial_ball_method::TOUCHING;
  /// the side of the surface on which the balls lie.
  Side side = Side::INSIDE;
  /// \brief the spacing of the samples of a mesh, in its units, each of which has a ball. Faces are represented by one
  /// sample, unless they are larger. Default: 1.5 times the root of the mean area of the faces, where
  /// there are taken to be at least 8000. Has no effect on points.
  std::optional<double> spacing;
  /// \brief samples that a ball would see within less than that many degrees of its own do not stop it, in (0, 180):
  /// so near are only the noise and the coarseness of the surface. 20 suits clean meshes, 45 noisy ones; at 90 the
  /// edges of boxes are lost.
  double stop_angle = 20;
  /// faces that meet at more than that many degrees, in [0, 180], form a crease; normals are smooth elsewhere.
  double crease_angle = 40;
  /// `σ/R` for `Medial_ball::mapt` and `Medial_ball::spread`, in (0, 1).
  double sigma_ratio = 0.5;
  /// \brief whether the samples of a mesh that are beside gaps stand for what is missing there, too, as far as others are
  /// apart. Where single faces are missing, anywhere, `Medial_ball::mapt` is what it was. Has no effect on closed
  /// meshes, nor on points, whose areas are given.
  bool compensate = true;
};

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief ways to tell how much a ball matters.
enum class Medial_weight {
  IMPORTANCE, ///< the spread of the voters where they are more than chance, otherwise 0: a length
  MAPT,       ///< `Medial_ball::mapt`: what is like a sphere, however small
  RADIAL_MAPT, ///< the radius times `Medial_ball::mapt`: a length; suits the choice of some best ones
  LAMBDA,      ///< `Medial_ball::lambda`: a length
  ANGLE,       ///< `Medial_ball::angle`, in degrees
  SCALE_AXIS, ///< `Medial_ball::scale_axis`
  RADIUS      ///< `Medial_ball::radius`: a length
};

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the MAPT that a ball must have to count as seen by the surface: that of two parallel walls, less a
/// quarter.
///
/// Balls that escaped through a wrong normal or between samples have two contacts far from each other, which `λ`
/// takes for much; but there is hardly any surface that agrees with them.
/// \param sigma_ratio the ratio `σ/R`, in (0, 1)
inline double least_medial_mapt(double sigma_ratio)
{
  return 0.75 * sigma_ratio * sigma_ratio / 2;
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns a weight of a ball; the larger, the more it matters.
/// \param ball the ball
/// \param weight which one
/// \param sigma_ratio that of the options with which the ball was computed
inline double weight_of(const Medial_ball& ball, Medial_weight weight, double sigma_ratio = 0.5)
{
  switch(weight) {
  case Medial_weight::IMPORTANCE:
    return ball.mapt >= least_medial_mapt(sigma_ratio) ? ball.spread : 0;
  case Medial_weight::MAPT:
    return ball.mapt;
  case Medial_weight::RADIAL_MAPT:
    return ball.mapt * ball.radius;
  case Medial_weight::LAMBDA:
    return ball.lambda;
  case Medial_weight::ANGLE:
    return ball.angle;
  case Medial_weight::SCALE_AXIS:
    return ball.scale_axis;
  case Medial_weight::RADIUS:
    break;
  }
  return ball.radius;
}

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_angle(double angle, double low, double high, const std::string& name)
{
  if(!(angle >= low) || !(angle <= high))
    throw std::invalid_argument(name + " is " + internal::to_text(angle) + ": must be from " +
                                internal::to_text(low) + " to " + internal::to_text(high) +
                                " degrees");
}

inline void check(const Medial_ball_options& options)
{
  if(options.spacing)
    check_positive(*options.spacing, "spacing");
  check_angle(options.stop_angle, 1e-3, 179, "stop_angle");
  check_angle(options.crease_angle, 0, 180, "crease_angle");
  check_sigma_ratio(options.sigma_ratio);
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MEDIAL_BALL_H
