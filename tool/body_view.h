// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_BODY_VIEW_H
#define MAPT_BODY_VIEW_H

#include "canvas.h"
#include "picture.h"
#include "rasterizer.h"
#include "views.h"

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Bbox_3.h>

#include <array>
#include <vector>

namespace mapt {

/// looks at space along an axis: from points of space to points of a page.
class Camera
{
public:
  /// \param box what the page is to show
  /// \param scale pixels per unit of length
  Camera(const View& view, const CGAL::Bbox_3& box, double scale);

  double scale() const { return m_scale; }
  int width() const { return m_width; }
  int height() const { return m_height; }

  Page_point operator()(const AP::Point_3& point) const;

  /// the components of a vector to the right, upward, and towards the viewer.
  std::array<double, 3> turned(const AP::Vector_3& vector) const;

private:
  View m_view;
  int m_towards; // the axis that points to the viewer, or away from the viewer
  double m_sign;
  AP::Point_3 m_corner;
  double m_scale;
  int m_width;
  int m_height;
};

/// the green of lines on a body.
constexpr Colour line_colour{70, 230, 110};

using Segment = std::array<AP::Point_3, 2>;

/// draws a surface in dim shades of grey, lit from the upper left, the inner side of its faces darker.
/// \param canvas of the size of the camera
/// \return what is seen at each pixel
Rasterizer draw_body(Canvas& canvas, const Camera& camera, const Picture_source& surface);

/// draws the parts of lines that a body hides, faintly, or those that it does not, in green.
void draw_lines(Canvas& canvas, const Camera& camera, const Rasterizer& body,
                const std::vector<Segment>& lines, bool are_hidden);

} // namespace mapt

#endif // MAPT_BODY_VIEW_H
