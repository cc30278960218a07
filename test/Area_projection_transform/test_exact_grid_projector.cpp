// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The exact transform on grids, against the evaluator that sums triangles and knows nothing of grids.

#include "values_at_voxels.h"

#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::Soup;

/// \brief expects the exact grid to hold at each voxel what the evaluator finds at its centre, with the
/// same bits for every instruction set.
///
/// Each contribution of a triangle is rounded to the nearest multiple of at most 2^-29 of all area, by
/// at most half of that, and the sum to a float. Besides, a contribution errs by some 1e-7 of σ times the
/// longest edge: relative to the triangle, by as much as it is smaller than the ball.
void expect_grid_equals_evaluator(const Soup& soup, const AP::Row_spans& region,
                                  const AP::Scale& scale, Side side,
                                  const std::vector<AP::Nested_ball>& kernel, double relative)
{
  const auto surface = shapes::scale_space_of(soup);
  const auto map = [&] {
    return shapes::areas_on_grid(AP::Exact_grid_projector(region, kernel), surface, region, scale,
                                 side);
  };
  const auto on_grid = map();
  for(const auto set : AP::internal::available_instruction_sets()) {
    AP::internal::chosen_instruction_set() = set;
    EXPECT_EQ(map(), on_grid) << AP::internal::name(set);
  }
  const AP::Exact_evaluator evaluator(surface, scale.radius, side);
  const auto at_points = shapes::values_at_voxels(evaluator, region, scale.sigma, kernel);
  const double rounding =
      0.5 * double(soup.triangles.size() * kernel.size()) * 0x1p-29 * soup.area();
  double largest = 0, squares = 0;
  for(const double value : at_points) {
    largest = std::max(largest, value);
    squares += value * value;
  }
  for(std::size_t place = 0; place < at_points.size(); ++place)
    ASSERT_NEAR(on_grid[place], at_points[place], rounding + relative * largest);
  const double rms = std::sqrt(squares / double(at_points.size()));
  EXPECT_LT(shapes::relative_rms(on_grid, at_points), relative + rounding / rms);
}

// Three points that are on a line but for the rounding of one: on a lattice of 0.08 the edges were parallel, and nothing
// was a number. What little area there is may go to any voxel.
TEST(Exact_grid_projector, a_needle_of_no_width_does_no_harm)
{
  const Soup needle{{{-0.19487034147299256, 0.38974068294598513, 0.65915257507642799},
                     {0.097435170736496282, 0.29230551220948886, 0.65915257507642799},
                     {0.38974068294598513, 0.19487034147299256, 0.65915257507642799}},
                    {{0, 1, 2}}};
  const Soup soup = shapes::joined(shapes::icosphere(1), needle);
  const auto alone = shapes::scale_space_of(shapes::icosphere(1));
  const auto both = shapes::scale_space_of(soup);
  ASSERT_EQ(both.source().size(), alone.source().size() + 1);
  const AP::Row_spans region(AP::grid_around(both.bbox(), 0.08));
  const AP::Scale scale{0.5, 0.16};
  EXPECT_EQ(shapes::areas_on_grid(AP::Exact_grid_projector(region), both, region, scale),
            shapes::areas_on_grid(AP::Exact_grid_projector(region), alone, region, scale));
}

TEST(Exact_grid_projector, equals_the_exact_evaluator_at_every_voxel)
{
  const Soup blob = shapes::blob(3, 22);
  const AP::Row_spans region(AP::grid_around(shapes::surface_of(blob).bbox(), 0.13));
  for(const auto& kernel :
      {AP::Ball_kernel_3().nested_balls(), AP::Epanechnikov_kernel_3{3}.nested_balls()})
    for(const Side side : {Side::INSIDE, Side::OUTSIDE})
      for(const AP::Scale& scale : {AP::Scale{0.1, 0.03}, AP::Scale{0.3, 0.2}, AP::Scale{0.9, 0.5}})
        expect_grid_equals_evaluator(blob, region, scale, side, kernel, 1e-6);
}

// Faces of many voxels and of many σ are cut into tiles; corners and edges of a box land on voxels.
TEST(Exact_grid_projector, equals_the_exact_evaluator_for_faces_of_any_size)
{
  const auto ball = AP::Ball_kernel_3().nested_balls();
  const Soup box = shapes::box(Point_3(0, 0, 0), Point_3(9, 5, 4));
  const AP::Row_spans around(AP::Grid_3(Point_3(-0.5, -0.5, -0.5), 0.125, {81, 49, 41}));
  for(const double sigma : {0.05, 0.25, 1., 6.})
    expect_grid_equals_evaluator(box, around, {0.5, sigma}, Side::INSIDE, ball, 2e-6);

  const shapes::Rotation rotation{Vector_3(2. / 3, 1. / 3, 2. / 3), 1};
  const Soup plane = shapes::moved(shapes::plane_patch(30, 0, 1), rotation);
  const AP::Row_spans beside(AP::Grid_3(Point_3(-7, -8, -9), 0.25, {60, 70, 61}));
  for(const double sigma : {0.3, 2.})
    expect_grid_equals_evaluator(plane, beside, {1, sigma}, Side::OUTSIDE, ball, 2e-6);

  const Soup sphere = shapes::icosphere(5); // faces 40 times smaller than the ball
  const AP::Row_spans within(AP::Grid_3(Point_3(-0.7, -0.7, -0.7), 0.2, {8, 8, 8}));
  expect_grid_equals_evaluator(sphere, within, {0.6, 1.3}, Side::INSIDE, ball, 1e-6);
}

// Strips 500 times as long as wide, and the fans of the lids.
TEST(Exact_grid_projector, equals_the_exact_evaluator_for_slivers)
{
  const Soup cylinder = shapes::cylinder(1500, 0.5, 2, true, 1);
  const AP::Row_spans region(AP::grid_around(shapes::surface_of(cylinder).bbox(), 0.1));
  for(const double sigma : {0.06, 0.2, 0.4})
    expect_grid_equals_evaluator(cylinder, region, {0.35, sigma}, Side::INSIDE,
                                 AP::Ball_kernel_3().nested_balls(), 1e-5);
}

TEST(Exact_grid_projector, a_region_holds_the_same_values_as_the_whole_grid)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 27));
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.04);
  const AP::Row_spans everything(grid), inside = AP::interior(surface.source(), grid).region;
  for(const AP::Scale& scale : {AP::Scale{0.1, 0.05}, AP::Scale{0.5, 0.25}, AP::Scale{0.8, 0.7}}) {
    const auto all =
        shapes::areas_on_grid(AP::Exact_grid_projector(everything), surface, everything, scale);
    const auto some =
        shapes::areas_on_grid(AP::Exact_grid_projector(inside), surface, inside, scale);
    for(int k = 0; k < grid.size()[2]; ++k)
      for(int j = 0; j < grid.size()[1]; ++j)
        for(int i = 0; i < grid.size()[0]; ++i)
          if(inside.contains(i, j, k)) {
            ASSERT_EQ(some[inside.index(i, j, k)], all[everything.index(i, j, k)]);
          }
  }
}

} // namespace
