// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_LABELLED_SHAPES_H
#define AREA_PROJECTION_PAPER_LABELLED_SHAPES_H

#include "damage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace Paper {

enum class Truth_shape { SPHERE, TUBE, CONE, BENT_TUBE, ELLIPSOID };

/// the names of the shapes, in their order.
inline constexpr std::array<const char*, 5> names_of_truth_shapes = {"sphere", "tube", "cone",
                                                                     "bent tube", "ellipsoid"};

/// what is known of a round object.
struct Truth
{
  Truth_shape shape = Truth_shape::SPHERE;
  /// of a tube or cone the middle of its axis, of a bent tube that of its arc.
  Point_3 center = Point_3(0, 0, 0);
  /// a unit vector; of a bent tube the direction at `center`, of an ellipsoid the axis of revolution; null
  /// for spheres.
  Vector_3 axis = Vector_3(0, 0, 0);
  double radius = 1;                      ///< at `center`; of an ellipsoid the mean semi-axis
  double length = 0;                      ///< of the axis or arc, from cap to cap
  double slope = 0;                       ///< of a cone: the change of the radius along `axis`
  Vector_3 curvature = Vector_3(0, 0, 0); ///< towards the centre of the bend, one over its radius
  std::array<double, 3> semi_axes = {{0, 0, 0}}; ///< of an ellipsoid, the last one along `axis`
  std::vector<std::uint32_t> faces;              ///< what there is of it, ascending

  bool is_tubular() const
  {
    return shape != Truth_shape::SPHERE && shape != Truth_shape::ELLIPSOID;
  }
};

/// where and how an object lies: the images of the origin and of the three axes.
struct Pose
{
  Point_3 origin = Point_3(0, 0, 0);
  std::array<Vector_3, 3> axes = {{Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)}};

  Vector_3 operator()(const Vector_3& v) const
  {
    return v.x() * axes[0] + v.y() * axes[1] + v.z() * axes[2];
  }
  Point_3 operator()(const Point_3& p) const { return origin + (*this)(p - CGAL::ORIGIN); }
};

/// of the same probability for all directions.
Vector_3 random_direction(Random& random);

/// a unit vector at right angles to another one.
Vector_3 random_direction_across(const Vector_3& axis, Random& random);

/// a random orientation.
Pose random_pose(const Point_3& origin, Random& random);

struct Ball
{
  Point_3 center;
  double radius;
};

/// a mesh with its truth, and balls that cover it.
struct Labelled_shape
{
  Soup soup;
  Truth truth;
  std::vector<Ball> cover;
};

Labelled_shape posed(Labelled_shape shape, const Pose& pose);

/// removes the faces whose centroid is on the positive side of a plane through the centre.
Labelled_shape cut(Labelled_shape shape, const Vector_3& normal);

/// \name Shapes around the origin
/// whose axis is z, with vertices on the exact surface.
/// @{

Labelled_shape labelled_sphere(double radius, int levels);

/// the last semi-axis is that of revolution.
Labelled_shape labelled_ellipsoid(double across, double along, int levels);

struct Tube
{
  double radius, length;
  double slope = 0;
  double curvature = 0; ///< one over the radius of the bend, towards x
  int sides = 32;
  int rows = 16; ///< of quadrangles along the axis, each divided into two triangles
};

/// a tube with flat caps, of which the triangles are about as large as the sides are wide.
Labelled_shape labelled_tube(const Tube& tube);

/// as many rows as make quadrangles this number of times as long as they are wide.
int rows_for(const Tube& tube, double elongation);
/// @}

/// a closed ring around z, of a circle around a circle.
Soup torus(double radius, double tube_radius, int around, int sides);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_LABELLED_SHAPES_H
