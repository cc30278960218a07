// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lines_picture.h"

#include "body_picture.h"
#include "canvas.h"
#include "marks.h"
#include "text.h"
#include "views.h"

#include <CGAL/Area_projection_transform/IO/centerlines_PLY.h>

#include <algorithm>
#include <cstddef>

namespace mapt {

namespace {

using namespace palette;
using AP::Centerline_branch;
using AP::Centerline_graph;
using AP::Centerline_origin;
using AP::Centerline_vertex;

constexpr int legend_width = 340, legend_height = 90;
constexpr double faint = 0.25; // how much tubes stand out

// Pieces of the tube of a branch: the vertices at which it was fitted, one for each step.
std::vector<std::vector<Cross_section>> tubes_of(const Centerline_graph& graph,
                                                 const Centerline_branch& branch)
{
  constexpr double step = 0.4; // of the radius
  std::vector<std::vector<Cross_section>> tubes;
  bool goes_on = false;
  for(std::size_t i = 0; i < branch.vertices.size(); ++i) {
    const Centerline_vertex& vertex = graph[branch.vertices[i]];
    const bool is_fitted = vertex.origin == Centerline_origin::FITTED &&
                           vertex.tangent.squared_length() > 0 && vertex.radius > 0;
    if(is_fitted && !goes_on)
      tubes.emplace_back();
    goes_on = is_fitted;
    if(!is_fitted)
      continue;
    std::vector<Cross_section>& tube = tubes.back();
    const bool is_due = tube.empty() || i + 1 == branch.vertices.size() ||
                        CGAL::squared_distance(tube.back().centre, vertex.point) >
                            CGAL::square(step * vertex.radius);
    // At a node the tangent may be that of another branch, the other way round.
    const bool is_turned = !tube.empty() && vertex.tangent * tube.back().axis < 0;
    if(is_due)
      tube.push_back({vertex.point, is_turned ? -vertex.tangent : vertex.tangent, vertex.radius});
  }
  return tubes;
}

void draw_branch(Canvas& page, const Camera& camera, const Centerline_graph& graph,
                 const Centerline_branch& branch, const Colour& colour)
{
  for(const std::vector<Cross_section>& tube : tubes_of(graph, branch))
    if(tube.size() > 1)
      draw_tube(page, camera, tube, {colour, faint});
  std::vector<AP::Point_3> points;
  for(const std::size_t v : branch.vertices)
    points.push_back(graph[v].point);
  draw_polyline(page, camera, points, colour);
}

CGAL::Bbox_3 box_of(const Centerline_graph& graph)
{
  CGAL::Bbox_3 box;
  for(const Centerline_branch& branch : AP::branches(graph))
    for(const std::size_t v : branch.vertices)
      box += graph[v].point.bbox();
  return box;
}

void draw_legend(Canvas& canvas, int x, int y, const Centerline_graph& graph, bool has_holes)
{
  const std::size_t number = AP::branches(graph).size();
  for(std::size_t b = 0; b < std::min<std::size_t>(number, 13); ++b)
    canvas.fill(x + 2 * int(b), y + 6, 2, 2, AP::IO::colour_of_branch(b));
  canvas.write(x + 42, y, counted(number, "branch", "branches"), font_size, ink);
  canvas.fill(x + 11, y + 36, 6, 6, ink);
  canvas.write(x + 42, y + 32, counted(AP::nodes(graph).size(), "node", "nodes"), font_size, ink);
  if(has_holes)
    draw_legend_of_holes(canvas, x, y + 64);
}

} // namespace

void write_lines_picture(const std::string& file, const Picture_source& surface,
                         const Centerline_graph& graph, const std::vector<Segment>& holes)
{
  Body_picture picture{surface, box_of(graph), holes, legend_width, legend_height, {}, {}};
  picture.draw_marks = [&](Canvas& page, const Camera& camera) {
    for(std::size_t b = 0; b < AP::branches(graph).size(); ++b)
      draw_branch(page, camera, graph, AP::branches(graph)[b], AP::IO::colour_of_branch(b));
    for(const std::size_t v : AP::nodes(graph))
      draw_ball(page, camera, graph[v].point, 0, ink);
  };
  picture.draw_legend = [&](Canvas& canvas, int x, int y) {
    draw_legend(canvas, x, y, graph, !holes.empty());
  };
  write_body_picture(file, picture);
}

} // namespace mapt
