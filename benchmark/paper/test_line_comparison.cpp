// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How lines are compared, on straight lines.

#include "line_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace Paper;

Line straight(const Point_3& from, const Point_3& to, double radius, int pieces = 7)
{
  Line line;
  for(int i = 0; i <= pieces; ++i) {
    line.points.push_back(from + (double(i) / pieces) * (to - from));
    line.radii.push_back(radius);
  }
  return line;
}

TEST(Line_comparison, finds_a_line_in_itself)
{
  const Line line = straight({0, 0, 0}, {3, 4, 12}, 0.5);
  EXPECT_NEAR(length_of(line), 13, 1e-12);
  EXPECT_NEAR(mean_radius(line), 0.5, 1e-12);
  const Line_agreement same = compare_lines({line}, {line}, 0.1);
  EXPECT_NEAR(same.found, 1, 1e-12);
  EXPECT_NEAR(same.distance, 0, 1e-7);
  EXPECT_NEAR(same.radius, 1, 1e-12);
}

TEST(Line_comparison, measures_distance_and_radius_in_units_of_the_radius)
{
  const Line line = straight({0, 0, 0}, {9, 0, 0}, 0.5);
  const Line beside = straight({10, 0.2, 0}, {-1, 0.2, 0}, 0.4, 3);
  const Line far = straight({0, 5, 0}, {9, 5, 0}, 0.4);
  const Line_agreement found = compare_lines({line}, {far, beside}, 0.5);
  EXPECT_NEAR(found.found, 1, 1e-12);
  EXPECT_NEAR(found.distance, 0.4, 1e-12);
  EXPECT_NEAR(found.radius, 0.8, 1e-12);
  EXPECT_EQ(compare_lines({line}, {far, beside}, 0.39).found, 0);
  EXPECT_NEAR(compare_lines({line, far}, {beside}, 0.5).found, 0.5, 1e-12);
}

TEST(Line_comparison, finds_as_much_as_is_near)
{
  const Line line = straight({0, 0, 0}, {9, 0, 0}, 1);
  // Half a radius beyond the end counts; pieces are an eighth of it long.
  const Line_agreement found = compare_lines({line}, {straight({-5, 0, 0}, {6, 0, 0}, 1)}, 0.5);
  EXPECT_NEAR(found.found, 6.5 / 9, 0.125 / 9);
}

TEST(Line_comparison, takes_the_radius_where_it_is_nearest)
{
  Line cone = straight({0, 0, 0}, {8, 0, 0}, 1, 1);
  cone.radii = {1, 3};
  EXPECT_NEAR(mean_radius(cone), 2, 1e-12);
  const Line_agreement found = compare_lines({straight({2, 0, 0}, {6, 0, 0}, 1)}, {cone}, 0.5);
  EXPECT_NEAR(found.radius, 2, 1e-12); // from 1.5 to 2.5
}

TEST(Line_comparison, of_nothing_is_nothing)
{
  const Line line = straight({0, 0, 0}, {9, 0, 0}, 1);
  EXPECT_EQ(compare_lines({line}, {}, 1).found, 0);
  EXPECT_EQ(compare_lines({}, {line}, 1).found, 0);
  EXPECT_EQ(length_of(Line()), 0);
  EXPECT_EQ(mean_radius(Line()), 0);
  EXPECT_EQ(mean_radius({{{1, 2, 3}}, {1}}), 0);
  EXPECT_NEAR(compare_lines({line}, {{{{4, 0, 0}}, {1}}}, 1).found, 2. / 9, 0.125 / 9) << "a point";
}

} // namespace
