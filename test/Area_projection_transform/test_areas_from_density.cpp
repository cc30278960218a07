// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The areas that points stand for: the cells of the points tile the surface.

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Vector_3;
using namespace clouds;
using shapes::pi;

// The cells of the points tile the sphere, as Voronoi cells do; each is laid out in a plane, which
// changes it by the order of its angular size squared, 4π/n.
TEST(Areas_from_density, sum_to_that_of_a_sphere)
{
  for(const int number : {200, 1000, 10000})
    EXPECT_NEAR(sphere(number, 65).area() / (4 * pi), 1, 4 * pi / number) << number;
}

// Counted in two caps beyond the place where the density jumps. Their rims cut through cells, which
// count as a whole or not at all: each is wrong by about a third of itself.
TEST(Areas_from_density, are_right_on_both_sides_of_a_jump_of_the_density)
{
  shapes::Random random(66);
  const int number = 20000;
  const Cloud cloud =
      sphere_without(number, 67, [&](const Vector_3& d) { return d.z() < 0 && random() > 0.1; });
  const double height = 0.3, cap = 2 * pi * (1 - height);
  const double rim = 2 * pi * std::sqrt(1 - height * height);
  for(const double side : {-1., 1.}) {
    const double cell = 2 * pi / (number * (side > 0 ? 10. : 1.) / 11);
    const double error = cell / 3 * std::sqrt(rim / std::sqrt(cell));
    EXPECT_NEAR(cloud.area_where([&](const Point_3& p) { return side * p.z() > height; }), cap,
                4 * error)
        << side;
    EXPECT_LT(4 * error, 0.012 * cap);
  }
  EXPECT_NEAR(cloud.area() / (4 * pi), 1, 4 * pi / (2 * number / 11.)); // as if all were sparse
}

// Noise along the normals does not move the projections.
TEST(Areas_from_density, do_not_feel_noise_along_the_normals)
{
  shapes::Random random(68);
  const int number = 10000;
  const double spacing = std::sqrt(4 * pi / number);
  Cloud cloud = sphere(number, 69);
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
    cloud.points[i] += random(-0.5, 0.5) * spacing * cloud.normals[i];
  EXPECT_NEAR(cloud.area() / (4 * pi), 1, 0.002);
}

// The area of a cell is that of the parallelogram of the lattice, whichever it is; also where the
// lines of a scanner lie far apart.
TEST(Areas_from_density, are_exact_within_lattices)
{
  const int n = 30;
  for(const Vector_3& b : {Vector_3(0, 1, 0), Vector_3(0.5, std::sqrt(0.75), 0),
                           Vector_3(0.3, 1.7, 0), Vector_3(0, 20, 0)}) {
    const std::vector<double> areas = lattice(n, Vector_3(1, 0, 0), b).areas();
    for(int i = 12; i < n - 12; ++i)
      for(int j = 4; j < n - 4; ++j)
        ASSERT_NEAR(areas[std::size_t(i * n + j)] / b.y(), 1, 1e-12) << i << " " << j;
  }
}

// Where the points end, half a cell more or less is a matter of opinion: the cells at the border
// are 4√n of n.
TEST(Areas_from_density, of_a_square_sum_to_its_own)
{
  const int number = 10000;
  const double half_of_border = 2 / std::sqrt(double(number));
  const Cloud random = square(number, 70, 5, 1);
  EXPECT_NEAR(random.area(), 1, half_of_border);
  const double cell = 1. / number, rim = 4 * 0.8;
  EXPECT_NEAR(random.area_where([](const Point_3& p) {
    return std::abs(p.x() - 0.5) < 0.4 && std::abs(p.y() - 0.5) < 0.4;
  }),
              0.64, 4 * cell / 3 * std::sqrt(rim / std::sqrt(cell)));
  const Cloud regular = lattice(100, Vector_3(0.01, 0, 0), Vector_3(0, 0.01, 0));
  EXPECT_NEAR(regular.area(), 1, half_of_border);
}

TEST(Areas_from_density, keep_the_sides_of_a_thin_plate_apart)
{
  const int number = 5000;
  for(const double spacings : {0., 0.01, 1.}) {
    const double height = spacings / std::sqrt(double(number));
    const Cloud plate = joined(square(number, 71, height, 1), square(number, 72, 0, -1));
    EXPECT_NEAR(plate.area(), 2, 4 / std::sqrt(double(number))) << spacings;
  }
  const int n = 20;
  Cloud sheet = lattice(n, Vector_3(1, 0, 0), Vector_3(0, 1, 0)); // two sides, at the same places
  for(std::size_t i = 0; i < std::size_t(n * n); ++i)
    sheet.push_back(sheet.points[i], Vector_3(0, 0, -1));
  const std::vector<double> areas = sheet.areas();
  const std::size_t middle = n * n / 2 + n / 2;
  EXPECT_NEAR(areas[middle], 1, 1e-12);
  EXPECT_NEAR(areas[middle + n * n], 1, 1e-12);
}

TEST(Areas_from_density, of_outliers_are_those_of_a_point_of_the_surface)
{
  Cloud cloud = sphere(2000, 73);
  const std::vector<double> alone = cloud.areas();
  const double largest = *std::max_element(alone.begin(), alone.end());
  const std::vector<Vector_3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}};
  const std::vector<Point_3> places{{0, 0, 1e6}, {0, 0, 50}, {-30, 7, 0}};
  for(std::size_t i = 0; i < places.size(); ++i)
    cloud.push_back(places[i], normals[i]);
  const std::vector<double> areas = cloud.areas();
  for(std::size_t i = 0; i < areas.size(); ++i)
    if(i < alone.size()) {
      EXPECT_EQ(areas[i], alone[i]);
    } else {
      EXPECT_LE(areas[i], largest);
    }
}

// Scanners return zeros where they see nothing: a hundred thousand copies of one point must neither
// take long nor change the area of the others.
TEST(Areas_from_density, are_shared_by_copies)
{
  Cloud cloud = lattice(20, Vector_3(1, 0, 0), Vector_3(0, 1, 0));
  const std::vector<double> alone = cloud.areas();
  shapes::Random random(74);
  const std::size_t place = 64;
  for(int i = 0; i < 100000; ++i)
    cloud.push_back(cloud.points[place], Vector_3(0, 0, random(1, 2)));
  const std::vector<double> areas = cloud.areas();
  for(std::size_t i = 0; i < alone.size(); ++i)
    if(i != place) {
      EXPECT_EQ(areas[i], alone[i]);
    }
  for(std::size_t i = alone.size() + 1; i < areas.size(); ++i)
    ASSERT_EQ(areas[i], areas[alone.size()]);
}

TEST(Areas_from_density, follow_similarities)
{
  shapes::Random random(75);
  const Cloud cloud = joined(sphere(500, 76), square(300, 77, 2, 1));
  const std::vector<double> areas = cloud.areas();
  const shapes::Rotation rotation{random.direction(), 1.3};
  const double factor = 1e-70;
  Cloud moved;
  for(std::size_t i = 0; i < areas.size(); ++i)
    moved.push_back(Point_3(0, 0, factor) + factor * (rotation(cloud.points[i]) - CGAL::ORIGIN),
                    7 * (rotation(CGAL::ORIGIN + cloud.normals[i]) - CGAL::ORIGIN));
  const std::vector<double> moved_areas = moved.areas();
  for(std::size_t i = 0; i < areas.size(); ++i)
    ASSERT_NEAR(moved_areas[i] / (factor * factor * areas[i]), 1, 1e-6) << i;
}

TEST(Areas_from_density, have_the_same_bits_in_any_order_and_number_of_threads)
{
  const Cloud cloud = joined(sphere(1000, 78), rubble(500, 79));
  const std::vector<double> areas = cloud.areas();
  EXPECT_EQ(AP::areas_from_density<CGAL::Parallel_if_available_tag>(cloud.points, cloud.normals),
            areas);
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  shapes::Random random(80);
  random.shuffle(order);
  Cloud shuffled;
  for(const std::size_t i : order)
    shuffled.push_back(cloud.points[i], cloud.normals[i]);
  const std::vector<double> shuffled_areas = shuffled.areas();
  for(std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(shuffled_areas[i], areas[order[i]]);
}

TEST(Areas_from_density, are_positive_for_any_points)
{
  for(int n = 2; n < 300; ++n) {
    Cloud cloud = rubble(n, std::uint64_t(n));
    cloud.push_back(Point_3(-1, 0, 0), Vector_3(0, 0, 1)); // so that there are two
    for(const unsigned k : {3u, 24u})
      for(const double area : AP::areas_from_density(cloud.points, cloud.normals, k)) {
        ASSERT_TRUE(std::isfinite(area)) << n;
        ASSERT_GT(area, 0) << n;
      }
  }
  Cloud line;
  for(int i = 0; i < 30; ++i)
    line.push_back(Point_3(i, 2 * i, 3 * i), Vector_3(0, 0, 1));
  for(const double area : line.areas())
    EXPECT_TRUE(area > 0 && std::isfinite(area));
}

// Squares of their distances are zero.
TEST(Areas_from_density, are_finite_for_points_that_can_hardly_be_told_apart)
{
  Cloud cloud;
  shapes::Random random(99);
  for(int i = 0; i < 40; ++i)
    cloud.push_back(CGAL::ORIGIN + random(0, 1e-170) * random.direction(), random.direction());
  for(int i = 0; i < 2; ++i) {
    for(const double area : cloud.areas())
      EXPECT_TRUE(area >= 0 && std::isfinite(area));
    cloud.push_back(Point_3(1, 0, 0), Vector_3(0, 0, 1));
  }
}

TEST(Areas_from_density, name_what_is_wrong)
{
  const auto of = [](const std::vector<Point_3>& points, const std::vector<Vector_3>& normals,
                     unsigned k) {
    return shapes::complaint([&] { AP::areas_from_density(points, normals, k); });
  };
  const Vector_3 up(0, 0, 1);
  EXPECT_EQ(of({{0, 0, 0}, {1, 0, 0}}, {up, up}, 2), "k is 2: must be at least 3");
  EXPECT_EQ(of({{0, 0, 0}, {1, 0, 0}}, {up}, 3),
            "normals has 1 elements: must have one for each of 2 points");
  EXPECT_EQ(of({{0, 0, 0}, {NAN, 0, 0}}, {up, up}, 3), "point 1 is not finite");
  EXPECT_EQ(of({{0, 0, 0}, {1, 0, 0}}, {up, {0, 0, 0}}, 3),
            "point 1 has no normal: must be a finite vector other than zero");
  EXPECT_EQ(of({{0, 0, 0}, {1, 0, 0}}, {{NAN, 0, 1}, up}, 3),
            "point 0 has no normal: must be a finite vector other than zero");
  EXPECT_EQ(of({{1, 0, 0}, {1, 0, 0}}, {up, -up}, 3),
            "points has 1 different positions: an estimate of areas needs at least 2");
  EXPECT_EQ(of({}, {}, 3),
            "points has 0 different positions: an estimate of areas needs at least 2");
}

} // namespace
