// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_VIEWS_H
#define MAPT_VIEWS_H

#include "canvas.h"

#include <array>

namespace mapt {

/// what pictures are drawn in.
namespace palette {
constexpr Colour ground{18, 18, 22};
constexpr Colour silhouette{58, 58, 66};
constexpr Colour ink{215, 215, 220};
constexpr Colour faint_ink{90, 90, 98};
constexpr int margin = 20; // room around a view; its axes are drawn in it
constexpr int font_size = 2;
} // namespace palette

/// which axes of space the page shows to the right and upward.
struct View
{
  int right, up;
};

/// from the front; from the side, to the right of it; from the top, below it: as in a technical drawing,
/// so that neighbours share an axis.
constexpr std::array<View, 3> views{{{0, 1}, {2, 1}, {0, 2}}};

/// a rectangle of the page, in pixels.
struct Frame
{
  int x, y, width, height;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

/// returns the place of each view of a box that has so many pixels along the axes of space.
std::array<Frame, 3> arrange(const std::array<int, 3>& size);

/// draws the axes of a view at its left and below it, with their names at their ends.
void draw_axes(Canvas& canvas, const View& view, const Frame& frame);

} // namespace mapt

#endif // MAPT_VIEWS_H
