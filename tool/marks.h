// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MARKS_H
#define MAPT_MARKS_H

#include "body_view.h"
#include "canvas.h"

#include <CGAL/Area_projection_transform/Kernel.h>

#include <vector>

namespace mapt {

/// a circle in space, across an axis.
struct Cross_section
{
  AP::Point_3 centre;
  AP::Vector_3 axis; // a unit vector
  double radius;
};

/// what a mark is drawn in.
struct Paint
{
  Colour colour;
  double strength = 1; // in [0, 1]: how much an outline stands out
};

// The colour of a value in [0, 1], from blue by violet to red. Green is left to holes.
Colour colour_from_blue_to_red(double value);

/// draws a solid ball.
/// \param radius in the units of space
void draw_ball(Canvas& canvas, const Camera& camera, const AP::Point_3& centre, double radius,
               const Colour& colour);

/// draws the outline of a ball with a dot at its centre; what is behind shines through.
void draw_sphere(Canvas& canvas, const Camera& camera, const AP::Point_3& centre, double radius,
                 const Paint& paint);

/// draws the outline of a tube, and its axis; what is behind shines through.
/// \pre two sections or more
void draw_tube(Canvas& canvas, const Camera& camera, const std::vector<Cross_section>& sections,
               const Paint& paint);

// A line through points, at least one.
void draw_polyline(Canvas& canvas, const Camera& camera, const std::vector<AP::Point_3>& points,
                   const Colour& colour);

} // namespace mapt

#endif // MAPT_MARKS_H
