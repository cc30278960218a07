// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "canvas.h"

#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <algorithm>
#include <cmath>
#include <new>

#include <png.h>

namespace mapt {

namespace {

namespace IO = CGAL::Area_projection::IO;

struct Glyph
{
  char letter;
  const char* pixels; // seven rows of five
};

// clang-format off
constexpr Glyph glyphs[] = {
  {'0', " ### #   ##  ### # ###  ##   # ### "},
  {'1', "  #   ##    #    #    #    #   ### "},
  {'2', " ### #   #    #   #   #   #   #####"},
  {'3', "#####   #   #     #     ##   # ### "},
  {'4', "   #   ##  # # #  # #####   #    # "},
  {'5', "######    ####     #    ##   # ### "},
  {'6', "  ##  #   #    #### #   ##   # ### "},
  {'7', "#####    #   #   #   #    #    #   "},
  {'8', " ### #   ##   # ### #   ##   # ### "},
  {'9', " ### #   ##   # ####    #   #  ##  "},
  {'.', "                          ##   ##  "},
  {',', "                          ##   #   "},
  {'-', "               #####               "},
  {'+', "       #    #  #####  #    #       "},
  {'%', "##   ##  #   #   #   #   #  ##   ##"},
  {'a', "          ####     # #####   # ####"},
  {'b', "#    #    #### #   ##   ##   ##### "},
  {'c', "           #####    #    #     ####"},
  {'d', "    #    # #####   ##   ##   # ####"},
  {'e', "           ### #   ######     ### "},
  {'f', "  ### #    #   ####  #    #    #   "},
  {'g', "           #####   # ####    # ### "},
  {'h', "#    #    #### #   ##   ##   ##   #"},
  {'i', "  #        ##    #    #    #   ### "},
  {'j', "   #        ##    #    # #  #  ##  "},
  {'k', "#    #    #  # # #  ##   # #  #  # "},
  {'l', " ##    #    #    #    #    #   ### "},
  {'m', "          ## # # # ## # ## # ## # #"},
  {'n', "          #### #   ##   ##   ##   #"},
  {'o', "           ### #   ##   ##   # ### "},
  {'p', "          #### #   ##### #    #    "},
  {'q', "           #####   # ####    #    #"},
  {'r', "          # ## ##   #    #    #    "},
  {'s', "           #####     ###     ##### "},
  {'t', " #    #   ####  #    #    #     ## "},
  {'u', "          #   ##   ##   ##   # ####"},
  {'v', "          #   ##   ##   # # #   #  "},
  {'w', "          #   ##   ## # ## # # # # "},
  {'x', "          #   # # #   #   # # #   #"},
  {'y', "          #   ##   # ####    # ### "},
  {'z', "          #####   #   #   #   #####"},
};
// clang-format on

const char* pixels_of(char letter)
{
  for(const Glyph& glyph : glyphs)
    if(glyph.letter == letter)
      return glyph.pixels;
  return nullptr;
}

} // namespace

Colour mix(const Colour& first, const Colour& second, double share)
{
  Colour colour;
  for(std::size_t c = 0; c < colour.size(); ++c)
    colour[c] = std::uint8_t(std::lround((1 - share) * first[c] + share * second[c]));
  return colour;
}

Colour colour_of(double value)
{
  // Anchors of the colour map inferno of matplotlib, which is in the public domain.
  constexpr std::array<Colour, 9> anchors{{{0, 0, 4},
                                           {31, 12, 72},
                                           {85, 15, 109},
                                           {136, 34, 106},
                                           {186, 54, 85},
                                           {227, 89, 51},
                                           {249, 140, 10},
                                           {249, 201, 50},
                                           {252, 255, 164}}};
  const double place = std::clamp(value, 0., 1.) * double(anchors.size() - 1);
  const std::size_t below = std::min(std::size_t(place), anchors.size() - 2);
  const double fraction = place - double(below);
  return mix(anchors[below], anchors[below + 1], fraction);
}

Canvas::Canvas(int width, int height, const Colour& ground)
    : m_width(width), m_height(height), m_bytes(3 * std::size_t(width) * std::size_t(height))
{
  fill(0, 0, width, height, ground);
}

void Canvas::fill(int x, int y, int width, int height, const Colour& colour)
{
  const int last_x = std::min(x + width, m_width), last_y = std::min(y + height, m_height);
  for(int row = std::max(y, 0); row < last_y; ++row)
    for(int column = std::max(x, 0); column < last_x; ++column)
      std::copy(colour.begin(), colour.end(), m_bytes.begin() + std::ptrdiff_t(index(column, row)));
}

void Canvas::blend(int x, int y, const Colour& colour, double opacity)
{
  if(x < 0 || y < 0 || x >= m_width || y >= m_height)
    return;
  const std::size_t i = index(x, y);
  const Colour below{m_bytes[i], m_bytes[i + 1], m_bytes[i + 2]};
  fill(x, y, 1, 1, mix(below, colour, opacity));
}

void Canvas::draw_halved(const Canvas& other, int x, int y)
{
  for(int row = 0; row < other.m_height / 2; ++row)
    for(int column = 0; column < other.m_width / 2; ++column) {
      const std::size_t above = other.index(2 * column, 2 * row);
      const std::size_t below = other.index(2 * column, 2 * row + 1);
      Colour mean;
      for(std::size_t c = 0; c < mean.size(); ++c)
        mean[c] = std::uint8_t((other.m_bytes[above + c] + other.m_bytes[above + 3 + c] +
                                other.m_bytes[below + c] + other.m_bytes[below + 3 + c] + 2) /
                               4);
      fill(x + column, y + row, 1, 1, mean);
    }
}

void Canvas::write(int x, int y, const std::string& text, int size, const Colour& colour)
{
  for(char letter : text) {
    if(const char* pixels = pixels_of(letter))
      for(int i = 0; i < 5 * text_height && pixels[i] != '\0'; ++i)
        if(pixels[i] == '#')
          fill(x + i % 5 * size, y + i / 5 * size, size, size, colour);
    x += 6 * size;
  }
}

int Canvas::text_width(const std::string& text)
{
  return std::max(6 * int(text.size()) - 1, 0);
}

void Canvas::write_PNG(const std::string& file) const
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(m_width);
  image.height = png_uint_32(m_height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> png(size);
  if(!png_image_write_to_memory(&image, png.data(), &size, 0, m_bytes.data(), 0, nullptr))
    throw IO::Output_error(file + ": cannot be made: " + image.message);
  IO::internal::Atomic_file output(file);
  output.stream().write(png.data(), std::streamsize(size));
  output.commit();
}

} // namespace mapt
