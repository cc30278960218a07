// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "body_view.h"

#include <algorithm>
#include <cmath>

namespace mapt {

namespace {

constexpr Colour darkest{26, 27, 33};
constexpr Colour lightest{122, 125, 135};
constexpr double pi = 3.141592653589793;

// How light a face is, in [0, 1], by its normal: to the right, upward, towards the viewer.
float shade_of(const std::array<double, 3>& normal)
{
  constexpr std::array<double, 3> light{-0.45, 0.55, 0.70};
  const bool is_inner = normal[2] < 0;
  double lit = 0;
  for(std::size_t i = 0; i < 3; ++i)
    lit += (is_inner ? -1 : 1) * normal[i] * light[i];
  const double shade = 0.22 + 0.78 * std::max(lit, 0.);
  return float(is_inner ? 0.35 * shade : shade);
}

void add(const AP::Triangle_surface& surface, const Camera& camera, Rasterizer& rasterizer)
{
  for(std::size_t t = 0; t < surface.size(); ++t)
    rasterizer.add_triangle(
        {camera(surface.corner(t, 0)), camera(surface.corner(t, 1)), camera(surface.corner(t, 2))},
        shade_of(camera.turned(surface.normals[t])));
}

// Disks that just overlap.
void add(const AP::Surfels& points, const Camera& camera, Rasterizer& rasterizer)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    rasterizer.add_disk(camera(points.positions[i]),
                        std::max(1., 1.2 * camera.scale() * std::sqrt(points.areas[i] / pi)),
                        shade_of(camera.turned(points.normals[i])));
}

// What is farther is a little darker.
void draw(Canvas& canvas, const Rasterizer& rasterizer)
{
  float nearest = std::numeric_limits<float>::lowest(), farthest = -nearest;
  const auto for_each_pixel = [&](const auto& visit) {
    for(int y = 0; y < rasterizer.height(); ++y)
      for(int x = 0; x < rasterizer.width(); ++x)
        if(rasterizer.is_covered(x, y))
          visit(x, y, rasterizer.nearness(x, y));
  };
  for_each_pixel([&](int, int, float nearness) {
    nearest = std::max(nearest, nearness);
    farthest = std::min(farthest, nearness);
  });
  for_each_pixel([&](int x, int y, float nearness) {
    const double depth = nearest > farthest ? (nearest - nearness) / (nearest - farthest) : 0;
    canvas.fill(x, y, 1, 1, mix(darkest, lightest, rasterizer.shade(x, y) * (1 - 0.35 * depth)));
  });
}

// Dots along a line of the page, those before or those behind the body.
void draw_line(Canvas& canvas, const Rasterizer& body, const Page_point& a, const Page_point& b,
               bool is_hidden)
{
  const int width = is_hidden ? 2 : 3;
  const double opacity = is_hidden ? 0.3 : 0.8;
  constexpr double tolerance = 4; // pixels, since the line lies on the surface
  const int steps = 1 + int(std::hypot(b.x - a.x, b.y - a.y));
  for(int i = 0; i <= steps; ++i) {
    const double place = double(i) / steps;
    const int x = int(std::floor(a.x + place * (b.x - a.x)));
    const int y = int(std::floor(a.y + place * (b.y - a.y)));
    const double nearness = a.nearness + place * (b.nearness - a.nearness);
    if(is_hidden == (body.is_covered(x, y) && body.nearness(x, y) > nearness + tolerance))
      for(int dot = 0; dot < width * width; ++dot)
        canvas.blend(x + dot % width - width / 2, y + dot / width - width / 2, line_colour,
                     opacity);
  }
}

} // namespace

Camera::Camera(const View& view, const CGAL::Bbox_3& box, double scale)
    : m_view(view)
    , m_towards(3 - view.right - view.up)
    , m_sign((view.up - view.right + 3) % 3 == 1 ? 1 : -1) // of the cross product of the two axes
    , m_corner(box.xmin(), box.ymin(), box.zmin())
    , m_scale(scale)
    , m_width(std::max(int(std::ceil(scale * (box.max(view.right) - box.min(view.right)))), 1))
    , m_height(std::max(int(std::ceil(scale * (box.max(view.up) - box.min(view.up)))), 1))
{}

Page_point Camera::operator()(const AP::Point_3& point) const
{
  const AP::Vector_3 v = point - m_corner;
  return {m_scale * v[m_view.right], m_height - m_scale * v[m_view.up],
          m_sign * m_scale * v[m_towards]};
}

std::array<double, 3> Camera::turned(const AP::Vector_3& v) const
{
  return {v[m_view.right], v[m_view.up], m_sign * v[m_towards]};
}

Rasterizer draw_body(Canvas& canvas, const Camera& camera, const Picture_source& surface)
{
  Rasterizer body(camera.width(), camera.height());
  std::visit([&](const auto* source) { add(*source, camera, body); }, surface);
  draw(canvas, body);
  return body;
}

void draw_lines(Canvas& canvas, const Camera& camera, const Rasterizer& body,
                const std::vector<Segment>& lines, bool are_hidden)
{
  for(const Segment& line : lines)
    draw_line(canvas, body, camera(line[0]), camera(line[1]), are_hidden);
}

} // namespace mapt
