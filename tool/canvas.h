// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_CANVAS_H
#define MAPT_CANVAS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mapt {

using Colour = std::array<std::uint8_t, 3>; // red, green, blue

/// between two colours: the second for a share of 1.
Colour mix(const Colour& first, const Colour& second, double share);

/// the colour of a value in [0, 1]: from black by purple and orange to a light yellow, evenly to the
/// eye and also without colours ("inferno").
Colour colour_of(double value);

/// pixels to draw on; (0, 0) is at the top left.
class Canvas
{
public:
  Canvas(int width, int height, const Colour& ground);

  int width() const { return m_width; }
  int height() const { return m_height; }
  const std::vector<std::uint8_t>& bytes() const { return m_bytes; }

  /// fills a rectangle, as much of it as there is on the canvas.
  void fill(int x, int y, int width, int height, const Colour& colour);

  /// lets a colour cover a pixel in part; nothing happens off the canvas.
  void blend(int x, int y, const Colour& colour, double opacity);

  /// draws another canvas at half its size; (x, y) is the top left.
  void draw_halved(const Canvas& other, int x, int y);

  /// writes digits, small letters and signs in pixels of the given size; (x, y) is their top left.
  void write(int x, int y, const std::string& text, int size, const Colour& colour);

  /// the width of a text, in units of `size`.
  static int text_width(const std::string& text);
  static constexpr int text_height = 7;

  /// \throw Output_error if the file cannot be written.
  void write_PNG(const std::string& file) const;

private:
  std::size_t index(int x, int y) const
  {
    return 3 * (std::size_t(x) + std::size_t(m_width) * std::size_t(y));
  }

  int m_width;
  int m_height;
  std::vector<std::uint8_t> m_bytes;
};

} // namespace mapt

#endif // MAPT_CANVAS_H
