// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "medial_picture.h"

#include "body_picture.h"
#include "canvas.h"
#include "marks.h"
#include "text.h"
#include "views.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mapt {

namespace {

using namespace palette;
using AP::Medial_ball;

constexpr int legend_width = 340, legend_height = 120;
constexpr std::size_t most_outlines = 400; // more balls would hide each other

// Walls, tubes and spheres have 1/8, 1/2 and 1.
Colour colour_of_mapt(double mapt)
{
  return colour_from_blue_to_red(mapt);
}

void draw_balls(Canvas& page, const Camera& camera, const std::vector<Medial_ball>& balls,
                const std::vector<std::size_t>& kept)
{
  constexpr double faint = 0.3;
  std::vector<std::size_t> order =
      kept; // large ones first, so that small ones are seen before them
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return balls[a].radius > balls[b].radius; });
  for(const std::size_t i : order) {
    const Medial_ball& ball = balls[i];
    if(kept.size() > most_outlines)
      draw_ball(page, camera, ball.center, 0, colour_of_mapt(ball.mapt));
    else
      draw_sphere(page, camera, ball.center, ball.radius, {colour_of_mapt(ball.mapt), faint});
  }
}

void draw_legend(Canvas& canvas, int x, int y, std::size_t number, bool has_holes)
{
  canvas.write(x, y, counted(number, "ball", "balls"), font_size, ink);
  for(int i = 0; i < 65; ++i)
    canvas.fill(x + 2 * i, y + 34, 2, 14, colour_of_mapt(i / 64.));
  canvas.write(x + 142, y + 34, "mapt", font_size, ink);
  canvas.write(x, y + 54, "0", font_size, faint_ink);
  canvas.write(x + 56, y + 54, "0.5", font_size, faint_ink);
  canvas.write(x + 124, y + 54, "1", font_size, faint_ink);
  if(has_holes)
    draw_legend_of_holes(canvas, x, y + 88);
}

} // namespace

void write_medial_picture(const std::string& file, const Picture_source& surface,
                          const std::vector<Medial_ball>& balls,
                          const std::vector<std::size_t>& kept, const std::vector<Segment>& holes)
{
  CGAL::Bbox_3 box;
  for(const std::size_t i : kept)
    box += balls[i].center.bbox();
  Body_picture picture{surface, box, holes, legend_width, legend_height, {}, {}};
  picture.draw_marks = [&](Canvas& page, const Camera& camera) {
    draw_balls(page, camera, balls, kept);
  };
  picture.draw_legend = [&](Canvas& canvas, int x, int y) {
    draw_legend(canvas, x, y, kept.size(), !holes.empty());
  };
  write_body_picture(file, picture);
}

} // namespace mapt
