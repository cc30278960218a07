// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Salient points: shapes whose centres, axes and radii are known.

#include "shapes.h"

#include <CGAL/Area_projection_transform/salient_points.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Salient_point;
using AP::Salient_shape;
using shapes::cylinder;
using shapes::icosphere;
using shapes::surface_of;

// The vertices lie on the sphere to the last bits, so there is nothing that could make the fit less exact.
TEST(Salient_points, finds_a_sphere_exactly)
{
  const AP::Point_3 center(1, -2, 3);
  const auto points = AP::salient_points(surface_of(icosphere(3, center, 0.5)));
  ASSERT_EQ(points.size(), 1u);
  const Salient_point& p = points.front();
  EXPECT_EQ(p.shape, Salient_shape::SPHERE);
  EXPECT_NEAR(std::sqrt(squared_distance(p.position, center)), 0, 1e-9);
  EXPECT_NEAR(p.radius, 0.5, 1e-9);
  EXPECT_LE(p.radius_low, 0.5);
  EXPECT_GE(p.radius_high, 0.5);
  EXPECT_GT(p.observed_fraction, 0.97); // faces cover a little less than the sphere
  EXPECT_FALSE(p.is_seen_from_one_side);
  EXPECT_GT(p.sphericity, 0.95);
}

TEST(Salient_points, finds_the_axis_of_a_tube_exactly)
{
  const auto points = AP::salient_points(surface_of(cylinder(32, 0.4, 3, true, 24)));
  ASSERT_EQ(points.size(), 1u);
  const Salient_point& p = points.front();
  EXPECT_EQ(p.shape, Salient_shape::TUBE);
  EXPECT_NEAR(std::abs(p.axis.z()), 1, 1e-9);
  EXPECT_NEAR(std::hypot(p.position.x(), p.position.y()), 0, 1e-9);
  EXPECT_NEAR(p.radius, 0.4 / std::cos(shapes::pi / 32), 1e-9); // the faces touch the cylinder
  EXPECT_LT(p.sphericity, 0.7);
}

} // namespace
