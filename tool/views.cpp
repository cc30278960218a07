// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "views.h"

#include <cstddef>

namespace mapt {

namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

} // namespace

std::array<Frame, 3> arrange(const std::array<int, 3>& size)
{
  constexpr int first = palette::margin + 8, between = 3 * palette::margin;
  std::array<Frame, 3> frames;
  for(std::size_t i = 0; i < frames.size(); ++i)
    frames[i] = {first, first, size[std::size_t(views[i].right)], size[std::size_t(views[i].up)]};
  frames[1].x = frames[0].right() + between;
  frames[2].y = frames[0].bottom() + between;
  return frames;
}

void draw_axes(Canvas& canvas, const View& view, const Frame& frame)
{
  using namespace palette;
  canvas.fill(frame.x - 6, frame.bottom() + 4, frame.width + 6, 2, faint_ink);
  canvas.fill(frame.x - 6, frame.y, 2, frame.height + 6, faint_ink);
  canvas.write(frame.right() + 4, frame.bottom() - 2, axis_names[view.right], font_size, ink);
  canvas.write(frame.x - 9, frame.y - 18, axis_names[view.up], font_size, ink);
}

} // namespace mapt
