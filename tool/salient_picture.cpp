// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_picture.h"

#include "body_picture.h"
#include "canvas.h"
#include "marks.h"
#include "text.h"
#include "views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace mapt {

namespace {

using namespace palette;
using AP::Salient_point;
using AP::Salient_shape;

bool is_tube(const Salient_point& point)
{
  return point.shape == Salient_shape::TUBE || point.shape == Salient_shape::CONE;
}

// What was fitted tells the kind of shape better than the sphericity of the map, which then only tints.
double drawn_sphericity(const Salient_point& point, Salient_style style)
{
  const bool is_fitted = style == Salient_style::FITS;
  const double sphericity = std::isnan(point.sphericity) ? 0.5 : point.sphericity;
  if(is_fitted && point.shape == Salient_shape::SPHERE)
    return 0.8 + 0.2 * sphericity;
  if(is_fitted && is_tube(point))
    return 0.2 * sphericity;
  return sphericity;
}

// The share of an intensity in the largest, as the eye likes it.
double strength_of(double intensity, double largest)
{
  return intensity > 0 && largest > 0 ? std::min(std::sqrt(intensity / largest), 1.) : 0;
}

Colour dimmed(const Colour& colour, double strength)
{
  return mix(ground, colour, 0.45 + 0.55 * strength);
}

Paint paint_of(const Salient_point& point, double largest, Salient_style style)
{
  const double strength = strength_of(point.intensity, largest);
  return {dimmed(colour_from_blue_to_red(drawn_sphericity(point, style)), strength), strength};
}

// The cross-sections of a tube, straight or bent, as a function of the length along its axis.
std::vector<Cross_section> sections_of(const Salient_point& tube)
{
  const double bend = std::sqrt(tube.curvature.squared_length());
  const double length = tube.length > 0 ? tube.length : 2 * tube.radius;
  const int steps = bend > 0 ? 2 + int(20 * std::min(bend * length, 6.)) : 1;
  std::vector<Cross_section> sections;
  for(int i = 0; i <= steps; ++i) {
    const double along = length * (double(i) / steps - 0.5);
    const double radius = std::max(tube.radius + tube.slope * along, 0.);
    if(bend == 0) {
      sections.push_back({tube.position + along * tube.axis, tube.axis, radius});
      continue;
    }
    const AP::Vector_3 inward = tube.curvature / bend;
    const double angle = bend * along, s = std::sin(angle), c = std::cos(angle);
    sections.push_back({tube.position + (s / bend) * tube.axis + ((1 - c) / bend) * inward,
                        c * tube.axis + s * inward, radius});
  }
  return sections;
}

double half_scale(const Salient_point& point)
{
  return point.scale > 0 ? 0.5 * point.scale : 0;
}

void draw_point(Canvas& canvas, const Camera& camera, const Salient_point& point,
                const Paint& paint, Salient_style style)
{
  const bool is_fitted = style == Salient_style::FITS && point.radius > 0;
  if(is_fitted && is_tube(point))
    draw_tube(canvas, camera, sections_of(point), paint);
  else if(is_fitted && point.shape == Salient_shape::SPHERE)
    draw_sphere(canvas, camera, point.position, point.radius, paint);
  else
    draw_ball(canvas, camera, point.position, half_scale(point), paint.colour);
}

double largest_intensity(const std::vector<Salient_point>& points)
{
  double largest = 0;
  for(const Salient_point& point : points)
    if(point.intensity > largest)
      largest = point.intensity;
  return largest;
}

// Large ones first, so that small ones are seen before them.
std::vector<std::size_t> order_of_drawing(const std::vector<Salient_point>& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto size = [&](std::size_t i) {
    return points[i].radius > 0 ? points[i].radius : half_scale(points[i]);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  return order;
}

// What a mark covers, roughly.
CGAL::Bbox_3 box_of(const Salient_point& point, Salient_style style)
{
  const bool is_fitted = style == Salient_style::FITS && point.radius > 0;
  const double radius = is_fitted ? point.radius : half_scale(point);
  CGAL::Bbox_3 box;
  const auto add = [&](const AP::Point_3& p) {
    box += (p + AP::Vector_3(radius, radius, radius)).bbox();
    box += (p - AP::Vector_3(radius, radius, radius)).bbox();
  };
  if(is_fitted && is_tube(point))
    for(const Cross_section& section : sections_of(point))
      add(section.centre);
  else
    add(point.position);
  return box;
}

// -- the legend -----------------------------------------------------------------------------------

constexpr int legend_width = 340, legend_height = 250;

void draw_gradient(Canvas& canvas, int x, int y, const std::string& name, const std::string& first,
                   const std::string& last, const std::array<Colour, 65>& colours)
{
  constexpr int height = 14;
  for(int i = 0; i < int(colours.size()); ++i)
    canvas.fill(x + 2 * i, y, 2, height, colours[std::size_t(i)]);
  const int right = x + 2 * int(colours.size());
  canvas.write(right + 12, y, name, font_size, ink);
  canvas.write(x, y + height + 6, first, font_size, faint_ink);
  canvas.write(right - font_size * Canvas::text_width(last), y + height + 6, last, font_size,
               faint_ink);
}

// What the marks look like, each drawn as on the page.
void draw_symbol(Canvas& canvas, int x, int y, const Salient_point& point, Salient_style style)
{
  Canvas symbol(52, 52, ground);
  const Camera camera(views[0], CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), 26);
  draw_point(symbol, camera, point, paint_of(point, point.intensity, style), style);
  canvas.draw_halved(symbol, x, y);
}

Salient_point symbol_of(Salient_shape shape)
{
  Salient_point point;
  point.shape = shape;
  point.radius = shape == Salient_shape::TUBE ? 0.45 : 0.9;
  point.length = 1.5;
  point.axis = AP::Vector_3(0.8, 0.6, 0);
  point.scale = point.intensity = 1;
  point.sphericity = shape == Salient_shape::SPHERE ? 1 : shape == Salient_shape::TUBE ? 0 : 0.5;
  return point;
}

// A line of the legend; returns where the next one begins.
int draw_kind(Canvas& canvas, int x, int y, const Salient_point& symbol, const std::string& name)
{
  draw_symbol(canvas, x, y, symbol, Salient_style::FITS);
  canvas.write(x + 42, y + 6, name, font_size, ink);
  return y + 32;
}

int draw_kinds(Canvas& canvas, int x, int y, const std::vector<Salient_point>& points)
{
  const struct
  {
    Salient_shape shape;
    const char* one;
    const char* many;
  } kinds[] = {{Salient_shape::SPHERE, "sphere", "spheres"},
               {Salient_shape::TUBE, "tube", "tubes"},
               {Salient_shape::OTHER, "other", "others"}};
  for(const auto& kind : kinds) {
    const auto number = std::count_if(points.begin(), points.end(), [&](const Salient_point& p) {
      return p.shape == kind.shape || (kind.shape == Salient_shape::TUBE && is_tube(p));
    });
    if(number > 0)
      y = draw_kind(canvas, x, y, symbol_of(kind.shape),
                    counted(std::size_t(number), kind.one, kind.many));
  }
  return y;
}

void draw_legend(Canvas& canvas, int x, int y, const std::vector<Salient_point>& points,
                 bool has_holes, Salient_style style)
{
  const double largest = largest_intensity(points);
  std::array<Colour, 65> by_sphericity, by_intensity;
  for(std::size_t i = 0; i < by_sphericity.size(); ++i) {
    const double place = double(i) / double(by_sphericity.size() - 1);
    by_sphericity[i] = colour_from_blue_to_red(place);
    by_intensity[i] = dimmed(ink, std::sqrt(place));
  }
  if(style == Salient_style::FITS)
    y = draw_kinds(canvas, x, y, points);
  else
    y = draw_kind(canvas, x, y, symbol_of(Salient_shape::OTHER),
                  counted(points.size(), "point", "points") + ", half the scale");
  y += 8;
  if(!points.empty()) {
    draw_gradient(canvas, x, y, "sphericity", "0", "1", by_sphericity);
    draw_gradient(canvas, x, y + 52, "intensity", "0", to_text(largest, 3), by_intensity);
    y += 112;
  }
  if(has_holes)
    draw_legend_of_holes(canvas, x, y);
}

} // namespace

void write_salient_picture(const std::string& file, const Picture_source& surface,
                           const std::vector<Salient_point>& points,
                           const std::vector<Segment>& holes, Salient_style style)
{
  const double largest = largest_intensity(points);
  Body_picture picture{surface, {}, holes, legend_width, legend_height, {}, {}};
  for(const Salient_point& point : points)
    picture.marks += box_of(point, style);
  picture.draw_marks = [&](Canvas& page, const Camera& camera) {
    for(const std::size_t p : order_of_drawing(points))
      draw_point(page, camera, points[p], paint_of(points[p], largest, style), style);
  };
  picture.draw_legend = [&](Canvas& canvas, int x, int y) {
    draw_legend(canvas, x, y, points, !holes.empty(), style);
  };
  write_body_picture(file, picture);
}

} // namespace mapt
