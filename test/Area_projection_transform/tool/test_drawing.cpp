// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What pictures are made of.

#include "body_view.h"
#include "marks.h"
#include "mesh_topology.h"
#include "rasterizer.h"
#include "views.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;

using mapt::Camera;
using mapt::Canvas;
using mapt::Colour;
using mapt::Page_point;
using mapt::Rasterizer;

constexpr double pi = 3.141592653589793;
constexpr Colour black{0, 0, 0};

std::size_t covered_pixels(const Rasterizer& page)
{
  std::size_t number = 0;
  for(int y = 0; y < page.height(); ++y)
    for(int x = 0; x < page.width(); ++x)
      number += page.is_covered(x, y) ? 1 : 0;
  return number;
}

// How many pixels are not black.
std::size_t marked_pixels(const Canvas& canvas)
{
  std::size_t number = 0;
  for(std::size_t i = 0; i < canvas.bytes().size(); i += 3)
    number += canvas.bytes()[i] || canvas.bytes()[i + 1] || canvas.bytes()[i + 2] ? 1 : 0;
  return number;
}

} // namespace

// The number of pixel centres in a convex figure differs from its area by less than its perimeter, in pixels
// of width 1, times the square root of 2 (the boundary crosses no more pixels), and 4.
TEST(Rasterizer, covers_the_area_of_triangles_and_disks)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(5, 95);
  for(int repeat = 0; repeat < 50; ++repeat) {
    std::array<Page_point, 3> corners;
    for(Page_point& corner : corners)
      corner = {place(random), place(random)};
    Rasterizer page(100, 100);
    page.add_triangle(corners, 1);
    const auto& [a, b, c] = corners;
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    const double perimeter = std::hypot(b.x - a.x, b.y - a.y) + std::hypot(c.x - b.x, c.y - b.y) +
                             std::hypot(a.x - c.x, a.y - c.y);
    EXPECT_NEAR(double(covered_pixels(page)), area, std::sqrt(2.) * perimeter + 4);
  }
  Rasterizer page(100, 100);
  page.add_disk({50.3, 48.6}, 40, 1);
  EXPECT_NEAR(double(covered_pixels(page)), pi * 1600, std::sqrt(2.) * 2 * pi * 40 + 4);
}

// Triangles that share edges leave no gaps: a square of two is covered in full.
TEST(Rasterizer, leaves_no_gaps_and_bears_what_is_off_the_page)
{
  Rasterizer page(20, 10);
  const Page_point a{-3, -4}, b{1e9, -4}, c{1e9, 1e9}, d{-3, 1e9};
  page.add_triangle({a, b, c}, 1);
  page.add_triangle({a, c, d}, 1);
  EXPECT_EQ(covered_pixels(page), 200u);
  Rasterizer empty(20, 10);
  empty.add_triangle({Page_point{30, 0}, Page_point{40, 0}, Page_point{30, 10}}, 1);
  empty.add_triangle({Page_point{3, 3}, Page_point{9, 9}, Page_point{6, 6}}, 1);
  empty.add_disk({-20, 5}, 10, 1);
  EXPECT_EQ(covered_pixels(empty), 0u);
}

TEST(Rasterizer, shows_what_is_nearer)
{
  // Two triangles through each other: nearness x and 10 - x, so that they swap in the middle.
  const std::array<Page_point, 3> rising{{{-20, -20, -20}, {40, -20, 40}, {-20, 40, -20}}};
  const std::array<Page_point, 3> falling{{{-20, -20, 30}, {40, -20, -30}, {-20, 40, 30}}};
  for(const bool is_rising_first : {true, false}) {
    Rasterizer page(10, 10);
    page.add_triangle(is_rising_first ? rising : falling, is_rising_first ? 1 : 2);
    page.add_triangle(is_rising_first ? falling : rising, is_rising_first ? 2 : 1);
    for(int x = 0; x < 10; ++x) {
      EXPECT_EQ(page.shade(x, 5), x < 5 ? 2 : 1);
      EXPECT_NEAR(page.nearness(x, 5), std::max(x + 0.5, 9.5 - x), 1e-5);
    }
  }
}

// To the right, upward and towards the viewer are a right-handed frame: nothing is seen in a mirror.
TEST(Camera, does_not_mirror)
{
  const CGAL::Bbox_3 box(-1, 2, 3, 0, 4, 7);
  for(const mapt::View& view : mapt::views) {
    const Camera camera(view, box, 10);
    const AP::Point_3 origin(-0.5, 3, 5);
    const Page_point o = camera(origin);
    std::array<std::array<double, 3>, 3> image;
    for(int axis = 0; axis < 3; ++axis) {
      const AP::Vector_3 step(axis == 0, axis == 1, axis == 2);
      const Page_point p = camera(origin + step);
      image[std::size_t(axis)] = {p.x - o.x, o.y - p.y, p.nearness - o.nearness};
      for(std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(image[std::size_t(axis)][i], 10 * camera.turned(step)[i], 1e-9);
    }
    const auto& [x, y, z] = image;
    const double determinant = x[0] * (y[1] * z[2] - y[2] * z[1]) -
                               x[1] * (y[0] * z[2] - y[2] * z[0]) +
                               x[2] * (y[0] * z[1] - y[1] * z[0]);
    EXPECT_NEAR(determinant, 1000, 1e-6);
    EXPECT_EQ(camera.width(), int(10 * (box.max(view.right) - box.min(view.right))));
    EXPECT_EQ(camera.height(), int(10 * (box.max(view.up) - box.min(view.up))));
  }
}

// A tube seen from the side covers a rectangle, and an ellipse at each end that has no width here; seen from
// its end, a disk.
TEST(Marks, have_the_size_of_what_they_mean)
{
  const CGAL::Bbox_3 box(-1, -1, -1, 1, 1, 1);
  const std::vector<mapt::Cross_section> sections{{{-0.5, 0, 0}, {1, 0, 0}, 0.3},
                                                  {{0.5, 0, 0}, {1, 0, 0}, 0.3}};
  const double scale = 100, rim = 8;
  for(const mapt::View& view : mapt::views) {
    const Camera camera(view, box, scale);
    Canvas canvas(camera.width(), camera.height(), black);
    draw_tube(canvas, camera, sections, {{255, 255, 255}, 1});
    const bool is_from_end = view.right != 0 && view.up != 0;
    const double area = is_from_end ? pi * 0.09 : 1 * 0.6;
    const double perimeter = is_from_end ? 2 * pi * 0.3 : 2 * 1.6;
    EXPECT_NEAR(double(marked_pixels(canvas)), area * scale * scale,
                perimeter * scale * std::sqrt(2.) + rim);
    Canvas sphere(camera.width(), camera.height(), black);
    draw_sphere(sphere, camera, {0.1, 0.2, 0.3}, 0.4, {{255, 255, 255}, 1});
    EXPECT_NEAR(double(marked_pixels(sphere)), pi * 0.16 * scale * scale,
                2 * pi * 0.4 * scale * std::sqrt(2.) + rim);
  }
}

TEST(Marks, may_be_larger_than_the_page_or_off_it)
{
  const Camera camera(mapt::views[0], CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 50);
  Canvas canvas(camera.width(), camera.height(), black);
  draw_ball(canvas, camera, {500, 0, 0}, 1, {255, 255, 255});
  draw_sphere(canvas, camera, {0, -500, 0}, 1, {{255, 255, 255}, 1});
  draw_tube(canvas, camera, {{{9, 9, 9}, {0, 1, 0}, 1}, {{9, 20, 9}, {0, 1, 0}, 0}},
            {{255, 255, 255}, 1});
  EXPECT_EQ(marked_pixels(canvas), 0u);
  draw_sphere(canvas, camera, {0, 0, 0}, 1e9, {{255, 255, 255}, 1});
  draw_ball(canvas, camera, {0, 0, 0}, 1e9, {255, 255, 255});
  EXPECT_EQ(marked_pixels(canvas), 2500u);
}

TEST(Mesh_topology, boundary_edges_are_those_of_one_triangle)
{
  // A square of two triangles that do not share their vertices, as in a soup.
  const std::vector<mapt::Point_3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                          {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<mapt::Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
  using Edge = std::array<std::uint32_t, 2>;
  const auto joined = mapt::join_equal_points(points);
  const auto edges = mapt::boundary_edges(joined, triangles);
  EXPECT_EQ(std::set<Edge>(edges.begin(), edges.end()),
            (std::set<Edge>{{0, 1}, {1, 2}, {2, 5}, {5, 0}}));
  EXPECT_EQ(edges.size(), mapt::analyse(points, joined, triangles).boundary_edges);
}
