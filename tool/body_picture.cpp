// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "body_picture.h"

#include "canvas.h"
#include "views.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mapt {

namespace {

using namespace palette;

constexpr int oversampling = 2; // against stairs; `draw_halved()` undoes it

// The body with its marks, as far as they are not out of proportion.
CGAL::Bbox_3 page_box(const Body_picture& picture)
{
  const CGAL::Bbox_3 body = bbox_of(picture.surface);
  const double room = 0.1 * std::max({body.x_span(), body.y_span(), body.z_span()});
  const CGAL::Bbox_3 box = body + picture.marks;
  return {std::max(box.xmin(), body.xmin() - room), std::max(box.ymin(), body.ymin() - room),
          std::max(box.zmin(), body.zmin() - room), std::min(box.xmax(), body.xmax() + room),
          std::min(box.ymax(), body.ymax() + room), std::min(box.zmax(), body.zmax() + room)};
}

double scale_for(const CGAL::Bbox_3& box)
{
  constexpr double wanted_width = 1400, largest_height = 1800;
  return std::min(wanted_width / (box.x_span() + box.z_span()),
                  largest_height / (box.y_span() + box.z_span()));
}

void draw_view(Canvas& canvas, const Frame& frame, const Camera& camera,
               const Body_picture& picture)
{
  Canvas page(camera.width(), camera.height(), ground);
  const Rasterizer body = draw_body(page, camera, picture.surface);
  draw_lines(page, camera, body, picture.holes, true);
  picture.draw_marks(page, camera);
  draw_lines(page, camera, body, picture.holes, false);
  canvas.draw_halved(page, frame.x, frame.y);
}

} // namespace

CGAL::Bbox_3 bbox_of(const Picture_source& surface)
{
  return std::visit([](const auto* s) { return s->bbox(); }, surface);
}

void draw_legend_of_holes(Canvas& canvas, int x, int y)
{
  canvas.fill(x, y + 6, 26, 2, line_colour);
  canvas.write(x + 42, y, "hole", font_size, ink);
}

void write_body_picture(const std::string& file, const Body_picture& picture)
{
  const CGAL::Bbox_3 box = page_box(picture);
  const double scale = scale_for(box);
  std::array<int, 3> size;
  for(int axis = 0; axis < 3; ++axis)
    size[std::size_t(axis)] = 1 + int(scale * (box.max(axis) - box.min(axis)));
  const std::array<Frame, 3> frames = arrange(size);
  const int legend_x = frames[1].x, legend_y = frames[2].y;
  Canvas canvas(std::max(frames[1].right(), legend_x + picture.legend_width) + 2 * margin,
                std::max(frames[2].bottom(), legend_y + picture.legend_height) + margin + 8,
                ground);
  for(std::size_t i = 0; i < frames.size(); ++i) {
    draw_view(canvas, frames[i], Camera(views[i], box, oversampling * scale), picture);
    draw_axes(canvas, views[i], frames[i]);
  }
  picture.draw_legend(canvas, legend_x, legend_y);
  canvas.write_PNG(file);
}

} // namespace mapt
