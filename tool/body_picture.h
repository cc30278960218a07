// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What pictures with marks in a body share: three views of it, its holes, and room for a legend.

#ifndef MAPT_BODY_PICTURE_H
#define MAPT_BODY_PICTURE_H

#include "body_view.h"
#include "picture.h"

#include <CGAL/Bbox_3.h>

#include <functional>
#include <string>
#include <vector>

namespace mapt {

struct Body_picture
{
  Picture_source surface;
  CGAL::Bbox_3 marks; // of all that is drawn besides the surface
  std::vector<Segment> holes;
  int legend_width, legend_height;
  std::function<void(Canvas& page, const Camera& camera)> draw_marks;
  std::function<void(Canvas& canvas, int x, int y)> draw_legend; // (x, y) is its top left
};

CGAL::Bbox_3 bbox_of(const Picture_source& surface);

// A line of the legend for the holes.
void draw_legend_of_holes(Canvas& canvas, int x, int y);

// Writes a picture; marks far outside of the body are cut off.
// \throw Output_error if the file cannot be written.
void write_body_picture(const std::string& file, const Body_picture& picture);

} // namespace mapt

#endif // MAPT_BODY_PICTURE_H
