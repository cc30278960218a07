// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "marks.h"

#include "rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace mapt {

namespace {

// Pixels; of a canvas that is shown at half its size.
constexpr int rim = 4;
constexpr double dot = 6;
constexpr double axis_width = 3;

constexpr double pi = 3.141592653589793;

// The part of a canvas that a shape can cover, with room for its rim.
struct Window
{
  int left, top, width, height;
};

Window window_around(const Canvas& canvas, double left, double top, double right, double bottom)
{
  const auto clamped = [](double place, int size) {
    return int(std::clamp(place, -double(rim), double(size + rim)));
  };
  const int x = clamped(std::floor(left) - rim, canvas.width());
  const int y = clamped(std::floor(top) - rim, canvas.height());
  return {x, y, std::max(clamped(std::ceil(right) + rim, canvas.width()) - x, 1),
          std::max(clamped(std::ceil(bottom) + rim, canvas.height()) - y, 1)};
}

// Places around the origin at the distance of the rim.
std::array<std::array<int, 2>, 24> circle_of_rim()
{
  std::array<std::array<int, 2>, 24> circle;
  for(std::size_t i = 0; i < circle.size(); ++i) {
    const double angle = 2 * pi * double(i) / double(circle.size());
    circle[i] = {int(std::lround(rim * std::cos(angle))), int(std::lround(rim * std::sin(angle)))};
  }
  return circle;
}

// How much a mark covers what is behind it.
struct Opacity
{
  double inside, rim;
};

// The stronger, the less is seen of what is behind.
Opacity opacity_of(double strength)
{
  return {0.08 + 0.24 * strength, 0.55 + 0.4 * strength};
}

void stamp(Canvas& canvas, const Rasterizer& shape, const Window& window, const Paint& paint)
{
  const Opacity opacity = opacity_of(paint.strength);
  static const auto circle = circle_of_rim();
  for(int y = 0; y < shape.height(); ++y)
    for(int x = 0; x < shape.width(); ++x) {
      if(!shape.is_covered(x, y))
        continue;
      const bool is_at_rim = std::any_of(circle.begin(), circle.end(), [&](const auto& step) {
        return !shape.is_covered(x + step[0], y + step[1]);
      });
      canvas.blend(window.left + x, window.top + y, paint.colour,
                   is_at_rim ? opacity.rim : opacity.inside);
    }
}

// Calls `visit(x, y)` for the pixels of the canvas that a square may touch.
template <class Visit>
void for_each_pixel_near(const Canvas& canvas, const Page_point& centre, double radius, Visit visit)
{
  const auto clamped = [](double place, int size) {
    return int(std::clamp(place, 0., double(size)));
  };
  const int right = clamped(centre.x + radius + 1, canvas.width());
  const int bottom = clamped(centre.y + radius + 1, canvas.height());
  for(int y = clamped(centre.y - radius, canvas.height()); y < bottom; ++y)
    for(int x = clamped(centre.x - radius, canvas.width()); x < right; ++x)
      visit(x, y);
}

void draw_dot(Canvas& canvas, const Page_point& centre, double radius, const Colour& colour)
{
  for_each_pixel_near(canvas, centre, radius, [&](int x, int y) {
    if(std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y) <= radius)
      canvas.blend(x, y, colour, 1);
  });
}

void draw_line(Canvas& canvas, const Page_point& a, const Page_point& b, const Colour& colour)
{
  constexpr double most_steps = 10000; // more than any page is wide
  const double steps = std::min(1 + std::floor(std::hypot(b.x - a.x, b.y - a.y)), most_steps);
  for(double i = 0; i <= steps; ++i)
    draw_dot(canvas, {a.x + i / steps * (b.x - a.x), a.y + i / steps * (b.y - a.y)}, axis_width / 2,
             colour);
}

// Two unit vectors across an axis and across each other.
std::array<AP::Vector_3, 2> across(const AP::Vector_3& axis)
{
  const AP::Vector_3 other =
      std::abs(axis.x()) < 0.6 ? AP::Vector_3(1, 0, 0) : AP::Vector_3(0, 1, 0);
  AP::Vector_3 first = CGAL::cross_product(axis, other);
  first = first / std::sqrt(first.squared_length());
  return {first, CGAL::cross_product(axis, first)};
}

constexpr std::size_t sides = 48;
using Ring = std::array<Page_point, sides>;

std::vector<Ring> rings_of(const Camera& camera, const std::vector<Cross_section>& sections)
{
  std::vector<Ring> rings;
  // The frame of the first section is carried along: parallel enough, as the axis turns a little each time.
  AP::Vector_3 first = across(sections.front().axis)[0];
  for(const Cross_section& section : sections) {
    first = first - (first * section.axis) * section.axis;
    first = first / std::sqrt(first.squared_length());
    const AP::Vector_3 second = CGAL::cross_product(section.axis, first);
    rings.emplace_back();
    for(std::size_t i = 0; i < sides; ++i) {
      const double angle = 2 * pi * double(i) / sides;
      rings.back()[i] = camera(
          section.centre + section.radius * (std::cos(angle) * first + std::sin(angle) * second));
    }
  }
  return rings;
}

void fill_ring(Rasterizer& shape, const Ring& ring)
{
  for(std::size_t i = 1; i + 1 < sides; ++i)
    shape.add_triangle({ring[0], ring[i], ring[i + 1]}, 1);
}

} // namespace

Colour colour_from_blue_to_red(double value)
{
  constexpr Colour blue{70, 140, 255}, violet{190, 95, 235}, red{255, 84, 52};
  const double v = std::clamp(value, 0., 1.);
  return v < 0.5 ? mix(blue, violet, 2 * v) : mix(violet, red, 2 * v - 1);
}

void draw_ball(Canvas& canvas, const Camera& camera, const AP::Point_3& centre, double radius,
               const Colour& colour)
{
  constexpr Colour shadow{10, 10, 14};
  const Page_point c = camera(centre);
  const double r = std::max(camera.scale() * radius, dot);
  for_each_pixel_near(canvas, c, r, [&](int x, int y) {
    const double right = (x + 0.5 - c.x) / r, up = (c.y - y - 0.5) / r;
    const double square = right * right + up * up;
    if(square > 1)
      return;
    const double lit = -0.45 * right + 0.55 * up + 0.7 * std::sqrt(1 - square);
    canvas.blend(x, y, mix(shadow, colour, 0.35 + 0.65 * std::max(lit, 0.)), 0.96);
  });
}

void draw_sphere(Canvas& canvas, const Camera& camera, const AP::Point_3& centre, double radius,
                 const Paint& paint)
{
  const Page_point c = camera(centre);
  const double r = std::max(camera.scale() * radius, dot);
  const Window window = window_around(canvas, c.x - r, c.y - r, c.x + r, c.y + r);
  Rasterizer shape(window.width, window.height);
  shape.add_disk({c.x - window.left, c.y - window.top}, r, 1);
  stamp(canvas, shape, window, paint);
  draw_dot(canvas, c, dot, paint.colour);
}

void draw_tube(Canvas& canvas, const Camera& camera, const std::vector<Cross_section>& sections,
               const Paint& paint)
{
  std::vector<Ring> rings = rings_of(camera, sections);
  Page_point least = rings[0][0], most = least;
  for(const Ring& ring : rings)
    for(const Page_point& p : ring) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  const Window window = window_around(canvas, least.x, least.y, most.x, most.y);
  for(Ring& ring : rings)
    for(Page_point& p : ring)
      p = {p.x - window.left, p.y - window.top};

  Rasterizer shape(window.width, window.height);
  fill_ring(shape, rings.front());
  fill_ring(shape, rings.back());
  for(std::size_t r = 0; r + 1 < rings.size(); ++r)
    for(std::size_t i = 0; i < sides; ++i) {
      const std::size_t j = (i + 1) % sides;
      shape.add_triangle({rings[r][i], rings[r][j], rings[r + 1][i]}, 1);
      shape.add_triangle({rings[r + 1][i], rings[r][j], rings[r + 1][j]}, 1);
    }
  stamp(canvas, shape, window, paint);
  for(std::size_t r = 0; r + 1 < sections.size(); ++r)
    draw_line(canvas, camera(sections[r].centre), camera(sections[r + 1].centre), paint.colour);
}

void draw_polyline(Canvas& canvas, const Camera& camera, const std::vector<AP::Point_3>& points,
                   const Colour& colour)
{
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    draw_line(canvas, camera(points[i]), camera(points[i + 1]), colour);
}

} // namespace mapt
