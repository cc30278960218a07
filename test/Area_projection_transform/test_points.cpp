// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that become surfels.

#include "shapes.h"

#include <CGAL/Area_projection_transform/parameters.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
namespace P = CGAL::Area_projection::parameters;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::pi;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

using Point_with_normal = std::pair<Epick::Point_3, Epick::Vector_3>;
using Points = std::vector<Point_with_normal>;

auto maps_of_pairs()
{
  return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
      .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>());
}

TEST(Points, become_surfels_one_by_one)
{
  const Points points{{{1, 2, 3}, {0, 0, 5}}, {{4, 5, 6}, {3, 4, 0}}};
  const boost::static_property_map<double> areas(0.25);
  const AP::Surfels surfels =
      AP::surfels_from_points(points, P::combine(maps_of_pairs(), P::area_map(areas)));
  ASSERT_EQ(surfels.size(), 2u);
  EXPECT_EQ(surfels.positions[1], Point_3(4, 5, 6));
  EXPECT_EQ(surfels.normals[0], Vector_3(0, 0, 1));
  EXPECT_NEAR(surfels.normals[1] * Vector_3(0.6, 0.8, 0), 1, 1e-15);
  EXPECT_EQ(surfels.areas, (std::vector<double>{0.25, 0.25}));
  EXPECT_EQ(surfels.sources, (std::vector<std::uint32_t>{0, 1}));
}

/// points of a sphere of radius 1 that are independent and uniform.
Points random_sphere(int number, std::uint64_t seed)
{
  shapes::Random random(seed);
  Points points;
  for(int n = 0; n < number; ++n) {
    const Vector_3 d = random.direction();
    points.emplace_back(Epick::Point_3(d.x(), d.y(), d.z()), Epick::Vector_3(d.x(), d.y(), d.z()));
  }
  return points;
}

TEST(Points, of_a_sphere_read_one_at_its_centre)
{
  const int number = 10000;
  Points points = random_sphere(number, 67);
  const boost::static_property_map<double> areas(4 * pi / number);
  const AP::Constant_scale_space<AP::Surfels> with_areas(
      AP::surfels_from_points(points, P::combine(P::area_map(areas), maps_of_pairs())));
  const AP::Constant_scale_space<AP::Surfels> without_areas(
      AP::surfels_from_points(points, maps_of_pairs()));
  const auto mapt = [](const auto& surface) {
    return AP::Kd_tree_evaluator(surface, 1, Side::INSIDE, 0.1)(Point_3(0, 0, 0), 0.5) / (4 * pi);
  };
  EXPECT_NEAR(mapt(with_areas), 1, 1e-12);
  EXPECT_NEAR(mapt(without_areas), 1, 4 * pi / number);
}

// Areas of zero are allowed: such points are there, but count for nothing.
TEST(Points, without_area_change_nothing)
{
  const Points points = random_sphere(500, 68);
  const boost::static_property_map<double> one(1.);
  AP::Surfels surfels =
      AP::surfels_from_points(points, P::combine(maps_of_pairs(), P::area_map(one)));
  for(std::size_t i = 0; i < points.size(); ++i)
    surfels.areas[i] = i % 5 ? 0. : 1.;
  const AP::Constant_scale_space<AP::Surfels> surface(surfels);
  EXPECT_EQ(surface.area(1), 100);
  EXPECT_EQ(AP::Kd_tree_evaluator(surface, 1, Side::INSIDE, 0.1)(Point_3(0, 0, 0), 0.5), 100);
}

TEST(Points, name_the_element_that_is_wrong)
{
  const boost::static_property_map<double> one(1.), negative(-2.);
  const auto of = [&](const Points& points, const auto& areas) {
    return shapes::complaint(
        [&] { AP::surfels_from_points(points, P::combine(maps_of_pairs(), P::area_map(areas))); });
  };
  EXPECT_EQ(of({{{0, 0, 0}, {0, 0, 1}}, {{0, 0, INFINITY}, {0, 0, 1}}}, one),
            "point 1 is not finite");
  EXPECT_EQ(of({{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 1e76}, {0, 0, 1}}}, one),
            "point 1 has a coordinate beyond 1e75: rescale the shape");
  EXPECT_EQ(of({{{0, 0, 0}, {0, 0, 0}}}, one),
            "point 0 has no normal: must be a finite vector other than zero");
  EXPECT_EQ(of({{{0, 0, 0}, {0, NAN, 1}}}, one),
            "point 0 has no normal: must be a finite vector other than zero");
  EXPECT_EQ(of({{{0, 0, 0}, {0, 0, 1}}}, negative),
            "point 0 has the area -2: must be finite and not negative");
}

} // namespace
