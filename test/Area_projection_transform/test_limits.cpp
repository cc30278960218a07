// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What lies at the border of the input: nothing, copies, places outside, parameters out of range.

#include "shapes.h"

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;

TEST(Limits, nothing_projects_to_nothing)
{
  const AP::Constant_scale_space surface{AP::Triangle_surface()};
  EXPECT_EQ(AP::Exact_evaluator(surface, 1, Side::INSIDE)(Point_3(0, 0, 0), 1), 0);
  EXPECT_EQ(AP::Kd_tree_evaluator(surface, 1, Side::INSIDE, 0.1)(Point_3(0, 0, 0), 1), 0);
  EXPECT_EQ(shapes::complaint([&] { AP::grid_around(surface.bbox(), 1); }),
            "box is empty or not finite");
}

TEST(Limits, voxels_outside_of_the_grid_have_no_storage)
{
  const auto region =
      std::make_shared<const AP::Row_spans>(AP::Grid_3(Point_3(0, 0, 0), 1, {2, 3, 4}));
  const AP::Joint_map map(region, {{1., 0.5}});
  for(const auto& [i, j, k] : {std::array{-1, 0, 0},
                               {2, 0, 0},
                               {0, -1, 0},
                               {0, 3, 0},
                               {0, 0, -1},
                               {0, 0, 4},
                               {50, 50, 50}}) {
    EXPECT_EQ(region->index(i, j, k), region->storage_size());
    EXPECT_FALSE(region->contains(i, j, k));
    EXPECT_EQ(map.value(i, j, k), 0);
    EXPECT_EQ(map.radius(i, j, k), 0);
  }
}

TEST(Limits, parameters_out_of_range_are_named)
{
  const auto surface = shapes::scale_space_of(shapes::icosphere(1));
  const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.5));
  const auto with_kernel = [&](const std::vector<AP::Nested_ball>& kernel) {
    return shapes::complaint([&] { AP::Grid_projector(region, kernel); });
  };
  EXPECT_EQ(with_kernel({{1.5, 1}}), "kernel has a ball of relative radius 1.5: must be in (0, 1]");
  EXPECT_EQ(with_kernel({{1, 0}}), "kernel has a ball of weight 0: must be positive");
  EXPECT_EQ(with_kernel({{1, 1}, {0.5, 1}}), "kernel has weights that sum to 2: must be at most 1");

  const auto with_scale = [&](const AP::Scale& scale) {
    return shapes::complaint([&] {
      AP::Joint_map map(std::make_shared<const AP::Row_spans>(region), {scale});
      AP::project_scales(
          surface, region, {scale}, Side::INSIDE, [&] { return AP::Grid_projector(region); }, map);
    });
  };
  EXPECT_EQ(with_scale({0, 1}), "radius of scales[0] is 0: must be positive and finite");
  EXPECT_EQ(with_scale({1, -1}), "sigma of scales[0] is -1: must be positive and finite");
  EXPECT_EQ(with_scale({1, 1e151}),
            "sigma of scales[0] is 1e+151: must be at most 1e150, for its square to be a number");
  EXPECT_EQ(shapes::complaint([&] { AP::sample_surfels(surface.source(), 0); }),
            "spacing is 0: must be positive and finite");
}

// Who answers "no" once everything has been delivered has stopped nothing.
TEST(Limits, an_answer_after_the_end_does_not_count)
{
  const auto surface = shapes::scale_space_of(shapes::icosphere(1));
  const auto region = std::make_shared<const AP::Row_spans>(AP::grid_around(surface.bbox(), 0.5));
  const std::vector<AP::Scale> scales{{1, 0.5}};
  AP::Joint_map map(region, scales);
  const auto summary = AP::project_scales(
      surface, *region, scales, Side::INSIDE, [&] { return AP::Grid_projector(*region); }, map,
      CGAL::parameters::callback(std::function<bool(double)>([](double p) { return p < 1; })));
  EXPECT_TRUE(summary.is_complete);
}

// A face that does not vote is still part of the surface: the interior has no hole there.
TEST(Limits, a_face_without_a_vote_stays_in_the_surface)
{
  AP::Triangle_surface surface = shapes::scale_space_of(shapes::icosphere(1)).source();
  surface.areas.assign(surface.size(), 0.);
  surface.areas[3] = 1;
  const AP::Constant_scale_space voting(surface);
  EXPECT_EQ(voting.area(1), 1);
  EXPECT_NEAR(AP::Exact_evaluator(voting, 1, Side::INSIDE)(Point_3(0, 0, 0), 0.9), 1, 1e-12);
  EXPECT_NEAR(AP::Kd_tree_evaluator(voting, 1, Side::INSIDE, 0.1)(Point_3(0, 0, 0), 0.9), 1, 1e-12);
}

} // namespace
