// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "line_methods.h"

#include "body_view.h"
#include "canvas.h"
#include "views.h"

#include <CGAL/Area_projection_transform/centerlines/paper_centerlines.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <utility>

namespace Paper {

namespace {

double longest_side(const CGAL::Bbox_3& box)
{
  return std::max({box.x_span(), box.y_span(), box.z_span()});
}

/// twice as many voxels as for maps: lines do not lie between the voxels of thin limbs then.
std::vector<Line> paper_lines(const AP::Triangle_surface& surface, int voxels, bool repeat)
{
  AP::Paper_centerline_options options;
  options.voxel_size = longest_side(surface.bbox()) / (2 * voxels);
  options.tracing.repeat = repeat;
  std::vector<Line> lines;
  for(AP::Centerline& line :
      AP::paper_centerlines<CGAL::Parallel_if_available_tag>(surface, options))
    lines.push_back({std::move(line.points), std::move(line.radii)});
  return lines;
}

AP::Triangle_surface surface_of(const Soup& soup)
{
  return AP::surface_from_triangle_soup(soup.points, soup.triangles);
}

std::vector<mapt::Segment> segments_of(const std::vector<Line>& lines)
{
  std::vector<mapt::Segment> segments;
  for(const Line& line : lines)
    for(std::size_t i = 1; i < line.points.size(); ++i)
      segments.push_back({line.points[i - 1], line.points[i]});
  return segments;
}

} // namespace

std::vector<Line_method> line_methods(const Options& options)
{
  const int voxels = options.voxels;
  return {
      {"paper",
       [=](const AP::Triangle_surface& surface) { return paper_lines(surface, voxels, false); }},
      {"paper repeated",
       [=](const AP::Triangle_surface& surface) { return paper_lines(surface, voxels, true); }}};
}

Line_run find_lines(const Line_method& method, const Soup& soup)
{
  const AP::Triangle_surface surface = surface_of(soup);
  const auto start = std::chrono::steady_clock::now();
  std::vector<Line> lines = method.find(surface);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {std::move(lines), time.count()};
}

Measures summarise(const Line_run& run, const Soup& soup)
{
  const double unit = longest_side(surface_of(soup).bbox());
  double longest = 0, sum = 0, radius = 0;
  for(const Line& line : run.lines) {
    const double length = length_of(line);
    longest = std::max(longest, length);
    sum += length;
    radius += length * mean_radius(line);
  }
  Measures measures{
      {"lines", double(run.lines.size())}, {"length", sum / unit}, {"longest", longest / unit}};
  if(sum > 0)
    measures.emplace_back("mean radius", radius / sum / unit);
  measures.emplace_back("seconds", run.seconds);
  return measures;
}

void write_picture_of_lines(const Options& options, const std::string& name, const Soup& soup,
                            const std::vector<Line>& lines)
{
  if(options.pictures.empty())
    return;
  using namespace mapt::palette;
  constexpr int oversampling = 2; // against stairs; `draw_halved()` undoes it
  const AP::Triangle_surface surface = surface_of(soup);
  const CGAL::Bbox_3 box = surface.bbox();
  const double scale = 800 / longest_side(box);
  std::array<int, 3> size;
  for(int axis = 0; axis < 3; ++axis)
    size[std::size_t(axis)] = mapt::Camera({axis, (axis + 1) % 3}, box, scale).width();
  mapt::Canvas canvas(size[0] + size[2] + 3 * margin, size[1] + 2 * margin, ground);
  int x = margin;
  for(const mapt::View view : {mapt::views[0], mapt::views[1]}) {
    const mapt::Camera camera(view, box, oversampling * scale);
    mapt::Canvas page(camera.width(), camera.height(), ground);
    mapt::draw_body(page, camera, &surface);
    const mapt::Rasterizer nothing(camera.width(), camera.height()); // which hides no line
    mapt::draw_lines(page, camera, nothing, segments_of(lines), false);
    canvas.draw_halved(page, x, margin);
    x += size[std::size_t(view.right)] + margin;
  }
  std::filesystem::create_directories(options.pictures);
  std::string file = name;
  std::replace(file.begin(), file.end(), ' ', '_');
  canvas.write_PNG(options.pictures + "/" + file);
}

} // namespace Paper
