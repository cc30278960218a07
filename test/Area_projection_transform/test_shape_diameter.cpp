// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shape diameters beside the diameters of medial balls, which have the same order where a shape becomes thicker.

#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_diameter.h>
#include <CGAL/Area_projection_transform/medial_balls.h>

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace shapes;

TEST(Rank_correlation, tells_orders_apart)
{
  const std::vector<double> up{1, 2, 3, 4, 5}, curved{1, 10, 100, 1000, 1e9}, down{5, 4, 3, 2, 1};
  EXPECT_DOUBLE_EQ(AP::rank_correlation(up, curved), 1);
  EXPECT_DOUBLE_EQ(AP::rank_correlation(up, down), -1);
  // 1 - 6 Σd² / (n³ - n), of the differences 1, 1, 0, 1, 1.
  EXPECT_DOUBLE_EQ(AP::rank_correlation(up, {2, 1, 3, 5, 4}), 1 - 6 * 4. / 120);
  // Equal numbers have the mean of their ranks: (-1, -1, 2) beside (-1.5, 1.5, 0) and its like.
  EXPECT_DOUBLE_EQ(AP::rank_correlation({1, 1, 2}, {1, 2, 3}), 1.5 / std::sqrt(1.5 * 2));
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(AP::rank_correlation({1, unknown, 2, 3}, {1, 9, 2, 3}), 1);
  EXPECT_TRUE(std::isnan(AP::rank_correlation({1, 1}, {1, 2})));
  EXPECT_TRUE(std::isnan(AP::rank_correlation({}, {})));
  EXPECT_THROW(AP::rank_correlation({1}, {1, 2}), std::invalid_argument);
}

// A ray that makes the angle a with the normal of a unit sphere is 2 cos a long: the mean is between those along the
// cone's rim, 1, and its axis, 2. Open or closed: half a sphere has no surface behind its rays along the normals.
TEST(Shape_diameters, of_a_sphere_are_chords)
{
  const auto diameters = AP::shape_diameters(surface_of(icosphere(3)));
  ASSERT_EQ(diameters.size(), icosphere(3).triangles.size());
  for(const double diameter : diameters) {
    EXPECT_GT(diameter, 1);
    EXPECT_LT(diameter, 2);
  }
  EXPECT_TRUE(AP::shape_diameters(AP::Triangle_surface()).empty());
  for(const double diameter : AP::shape_diameters(surface_of(plane_patch(1, 0, 3))))
    EXPECT_TRUE(std::isnan(diameter));
}

// A horn, four times as thick at one end: chords and medial balls grow with its radius. What is left of the order is
// lost at its lids, where rays go along it, one in some ten of its area.
TEST(Shape_diameters, have_the_order_of_the_balls_of_a_horn)
{
  const Soup horn = moved(cylinder(48, 1, 12, true, 48), [](const Point_3& p) {
    const double thickness = 0.625 + 0.375 * p.z() / 6;
    return Point_3(thickness * p.x(), thickness * p.y(), p.z());
  });
  const AP::Triangle_surface surface = surface_of(horn);
  const auto balls = AP::medial_balls(surface);
  std::vector<std::size_t> all(balls.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  AP::Medial_representation axis = AP::medial_representation("all", balls, all, 0);
  const auto diameters = AP::shape_diameters(surface);
  EXPECT_GT(AP::shape_diameter_correlation(axis, surface, diameters), 0.8);
  // The opposite of thick.
  for(double& radius : axis.radii)
    radius = 0.1;
  EXPECT_TRUE(std::isnan(AP::shape_diameter_correlation(axis, surface, diameters)));
  EXPECT_THROW(AP::shape_diameter_correlation(axis, surface, {1.}), std::invalid_argument);
}

} // namespace
