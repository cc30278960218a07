// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "picture.h"

#include "canvas.h"
#include "text.h"
#include "views.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapt {

namespace {

using namespace palette;

// The pixels of one view, one for each line of voxels.
class Panel
{
public:
  Panel(const View& view, const AP::Grid_3& grid)
      : m_view(view)
      , m_width(grid.size()[view.right])
      , m_height(grid.size()[view.up])
      , m_values(std::size_t(m_width) * std::size_t(m_height), 0.f)
      , m_is_covered(m_values.size(), false)
  {}

  void add_value(const std::array<int, 3>& voxel, float value)
  {
    float& largest = m_values[index(voxel)];
    largest = std::max(largest, value);
  }

  void cover(const std::array<int, 3>& voxel) { m_is_covered[index(voxel)] = true; }

  void draw(Canvas& canvas, const Frame& frame, double largest) const
  {
    const int factor = frame.width / m_width;
    for(int v = 0; v < m_height; ++v)
      for(int u = 0; u < m_width; ++u) {
        const std::size_t i = std::size_t(u) + std::size_t(m_width) * std::size_t(v);
        Colour colour = colour_of(largest > 0 ? m_values[i] / largest : 0.);
        const Colour& behind = m_is_covered[i] ? silhouette : ground;
        for(std::size_t c = 0; c < colour.size(); ++c)
          colour[c] = std::max(colour[c], behind[c]);
        canvas.fill(frame.x + factor * u, frame.bottom() - factor * (v + 1), factor, factor,
                    colour);
      }
  }

private:
  std::size_t index(const std::array<int, 3>& voxel) const
  {
    return std::size_t(voxel[m_view.right]) + std::size_t(m_width) * std::size_t(voxel[m_view.up]);
  }

  View m_view;
  int m_width;
  int m_height;
  std::vector<float> m_values;
  std::vector<bool> m_is_covered;
};

void add_values(const AP::Joint_map& map, std::vector<Panel>& panels)
{
  const AP::Grid_3& grid = map.grid();
  for(int k = 0; k < grid.size()[2]; ++k)
    for(int j = 0; j < grid.size()[1]; ++j) {
      const AP::Row_spans::Hull& hull = map.region().hull(grid.row(j, k));
      for(int i = hull.first; i < hull.last; ++i)
        for(Panel& panel : panels)
          panel.add_value({i, j, k}, map.values()[hull.offset + std::size_t(i - hull.first)]);
    }
}

// The outline of a closed surface is that of its interior.
void add_silhouette(const Picture_source& surface, const AP::Grid_3& grid,
                    std::vector<Panel>& panels)
{
  const auto cover = [&](const AP::Surfels& batch) {
    for(const AP::Point_3& p : batch.positions) {
      const AP::Vector_3 c = grid.lattice_coordinates(p);
      std::array<int, 3> voxel;
      for(int axis = 0; axis < 3; ++axis)
        voxel[axis] = int(std::clamp(c[axis] + 0.5, 0., grid.size()[axis] - 1.));
      for(Panel& panel : panels)
        panel.cover(voxel);
    }
  };
  std::visit([&](const auto* source) { source->for_each_batch(0.5 * grid.spacing(), cover); },
             surface);
}

void draw_colour_bar(Canvas& canvas, int x, int y, int height, double largest)
{
  constexpr int width = 16;
  for(int row = 0; row < height; ++row)
    canvas.fill(x, y + height - 1 - row, width, 1, colour_of((row + 0.5) / height));
  if(!(largest > 0))
    return;
  const double power = std::pow(10., std::floor(std::log10(largest)));
  const double relative = largest / power;
  const double step = power * (relative < 2 ? 0.5 : relative < 5 ? 1 : 2);
  for(int tick = 0; tick * step <= largest; ++tick) {
    const int up = int(std::lround((height - 1) * tick * step / largest));
    canvas.fill(x + width, y + height - 1 - up, 6, 2, ink);
    canvas.write(x + width + 10, y + height - 7 - up, to_text(tick * step, 3), font_size, ink);
  }
}

} // namespace

void write_picture(const std::string& file, const AP::Joint_map& map, const Picture_source& surface)
{
  const AP::Grid_3& grid = map.grid();
  std::vector<Panel> panels;
  for(const View& view : views)
    panels.emplace_back(view, grid);
  add_values(map, panels);
  add_silhouette(surface, grid, panels);
  const float largest =
      map.values().empty() ? 0.f : *std::max_element(map.values().begin(), map.values().end());

  constexpr int wanted = 400, bar = 110, smallest_bar = 120;
  std::array<int, 3> size = grid.size();
  const int factor = std::max(wanted / *std::max_element(size.begin(), size.end()), 1);
  for(int& pixels : size)
    pixels *= factor;
  const std::array<Frame, 3> frames = arrange(size);
  const int first_y = frames[0].y, bar_x = frames[1].right() + 3 * margin;
  const int height = std::max(frames[2].bottom(), first_y + smallest_bar);
  Canvas canvas(bar_x + bar, height + margin + 8, ground);
  for(std::size_t i = 0; i < panels.size(); ++i) {
    panels[i].draw(canvas, frames[i], largest);
    draw_axes(canvas, views[i], frames[i]);
  }
  draw_colour_bar(canvas, bar_x, first_y, height - first_y, largest);
  canvas.write_PNG(file);
}

} // namespace mapt
