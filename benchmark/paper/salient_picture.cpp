// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_picture.h"

#include "canvas.h"

#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace Paper {

namespace {

constexpr mapt::Colour ground{18, 18, 22}, silhouette{70, 70, 78};
constexpr int margin = 20, longest_side = 600;

/// a view of space on a part of the canvas.
class View
{
public:
  View(int right, int up, const CGAL::Bbox_3& box, double pixels_per_length, int x)
      : m_right(right), m_up(up), m_box(box), m_scale(pixels_per_length), m_x(x)
  {}

  int width() const { return int(std::ceil(m_scale * (m_box.max(m_right) - m_box.min(m_right)))); }
  int height() const { return int(std::ceil(m_scale * (m_box.max(m_up) - m_box.min(m_up)))); }

  void draw_point(mapt::Canvas& canvas, const Point_3& p, const mapt::Colour& colour) const
  {
    const auto [x, y] = place(p);
    canvas.fill(int(std::floor(x)), int(std::floor(y)), 1, 1, colour);
  }

  void draw_disk(mapt::Canvas& canvas, const Point_3& centre, double radius,
                 const mapt::Colour& colour) const
  {
    const auto [x, y] = place(centre);
    const double r = std::max(m_scale * radius, 1.5);
    for(int row = int(std::floor(y - r)); row <= int(std::ceil(y + r)); ++row) {
      const double rest = r * r - (row + 0.5 - y) * (row + 0.5 - y);
      if(rest <= 0)
        continue;
      const int first = int(std::lround(x - std::sqrt(rest)));
      canvas.fill(first, row, int(std::lround(x + std::sqrt(rest))) - first, 1, colour);
    }
  }

private:
  std::array<double, 2> place(const Point_3& p) const
  {
    return {m_x + m_scale * (p[m_right] - m_box.min(m_right)),
            margin + m_scale * (m_box.max(m_up) - p[m_up])};
  }

  int m_right, m_up;
  CGAL::Bbox_3 m_box;
  double m_scale;
  int m_x;
};

mapt::Colour colour_of(const AP::Salient_point& p)
{
  const double brightness = 0.4 + 0.6 * std::min(p.intensity, 1.);
  // Along an endless tube the sphericity is a little less than a half.
  const double round = std::isnan(p.sphericity) ? 0. : std::clamp(2 * p.sphericity - 1, 0., 1.);
  const auto channel = [&](double of_round, double of_long) {
    return std::uint8_t(255 * brightness * (round * of_round + (1 - round) * of_long));
  };
  return {channel(1, 0.3), channel(0.25, 0.55), channel(0.2, 1)};
}

} // namespace

void write_picture_of_points(const Options& options, const std::string& name, const Soup& soup,
                             const std::vector<AP::Salient_point>& points)
{
  if(options.pictures.empty())
    return;
  const AP::Triangle_surface surface = AP::surface_from_triangle_soup(soup.points, soup.triangles);
  const CGAL::Bbox_3 box = surface.bbox();
  const double scale = longest_side / std::max({box.x_span(), box.y_span(), box.z_span()});
  const View front(0, 1, box, scale, margin);
  const View side(2, 1, box, scale, 2 * margin + front.width());
  mapt::Canvas canvas(3 * margin + front.width() + side.width(), 2 * margin + front.height(),
                      ground);
  surface.for_each_batch(0.7 / scale, [&](const AP::Surfels& batch) {
    for(const Point_3& p : batch.positions)
      for(const View* view : {&front, &side})
        view->draw_point(canvas, p, silhouette);
  });
  for(auto p = points.rbegin(); p != points.rend(); ++p)
    for(const View* view : {&front, &side})
      view->draw_disk(canvas, p->position, 0.5 * p->scale, colour_of(*p));
  std::filesystem::create_directories(options.pictures);
  std::string file = name;
  std::replace(file.begin(), file.end(), ' ', '_');
  canvas.write_PNG(options.pictures + "/" + file);
}

} // namespace Paper
