// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rasterizer.h"

#include <algorithm>
#include <cmath>

namespace mapt {

namespace {

// The pixels [first, last) of which the centres lie between two coordinates.
struct Range
{
  int first, last;
};

Range pixels_between(double low, double high, int size)
{
  return {int(std::clamp(std::ceil(low - 0.5), 0., double(size))),
          int(std::clamp(std::floor(high - 0.5) + 1, 0., double(size)))};
}

// Twice the area of a triangle of the page, positive if c is to the right of the way from a to b.
double doubled_area(const Page_point& a, const Page_point& b, double x, double y)
{
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

} // namespace

Rasterizer::Rasterizer(int width, int height)
    : m_width(width)
    , m_height(height)
    , m_nearness(std::size_t(width) * std::size_t(height), nothing)
    , m_shade(m_nearness.size(), 0.f)
{}

void Rasterizer::add_triangle(const std::array<Page_point, 3>& corners, float shade)
{
  const auto& [a, b, c] = corners;
  const double area = doubled_area(a, b, c.x, c.y);
  if(area == 0)
    return; // seen from its edge
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [above, below] = std::minmax({a.y, b.y, c.y});
  const Range columns = pixels_between(left, right, m_width);
  const Range rows = pixels_between(above, below, m_height);
  for(int y = rows.first; y < rows.last; ++y)
    for(int x = columns.first; x < columns.last; ++x) {
      const double of_a = doubled_area(b, c, x + 0.5, y + 0.5) / area;
      const double of_b = doubled_area(c, a, x + 0.5, y + 0.5) / area;
      const double of_c = doubled_area(a, b, x + 0.5, y + 0.5) / area;
      if(of_a >= 0 && of_b >= 0 && of_c >= 0)
        put(x, y, of_a * a.nearness + of_b * b.nearness + of_c * c.nearness, shade);
    }
}

void Rasterizer::add_disk(const Page_point& centre, double radius, float shade)
{
  const Range rows = pixels_between(centre.y - radius, centre.y + radius, m_height);
  for(int y = rows.first; y < rows.last; ++y) {
    const double up = y + 0.5 - centre.y;
    const double half = std::sqrt(std::max(radius * radius - up * up, 0.));
    const Range columns = pixels_between(centre.x - half, centre.x + half, m_width);
    for(int x = columns.first; x < columns.last; ++x)
      put(x, y, centre.nearness, shade);
  }
}

} // namespace mapt
