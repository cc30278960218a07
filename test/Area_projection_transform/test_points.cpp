// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What goes in as points: their areas, their normals, and the surfels that they become.

#include "shapes.h"

#include <CGAL/Area_projection_transform/areas_from_density.h>
#include <CGAL/Area_projection_transform/internal/Signed_sets.h>
#include <CGAL/Area_projection_transform/normals_from_points.h>
#include <CGAL/Area_projection_transform/parameters.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

/// points with their true normals.
struct Cloud
{
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;

  void push_back(const Point_3& point, const Vector_3& normal)
  {
    points.push_back(point);
    normals.push_back(normal);
  }

  std::vector<double> areas() const { return AP::areas_from_density(points, normals); }

  /// the sum of the areas of the points for which `is_counted(point)` holds.
  template <class Predicate>
  double area_where(Predicate is_counted) const
  {
    const std::vector<double> all = areas();
    double sum = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(is_counted(points[i]))
        sum += all[i];
    return sum;
  }

  double area() const
  {
    return area_where([](const Point_3&) { return true; });
  }
};

Cloud joined(Cloud a, const Cloud& b)
{
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  return a;
}

/// points of a sphere that are independent and uniform, but for the directions for which
/// `is_left_out(direction)` holds.
template <class Predicate>
Cloud sphere_without(int number, std::uint64_t seed, Predicate is_left_out,
                     const Point_3& center = Point_3(0, 0, 0), double radius = 1)
{
  shapes::Random random(seed);
  Cloud cloud;
  while(int(cloud.points.size()) < number) {
    const Vector_3 d = random.direction();
    if(!is_left_out(d))
      cloud.push_back(center + radius * d, d);
  }
  return cloud;
}

Cloud sphere(int number, std::uint64_t seed, const Point_3& center = Point_3(0, 0, 0),
             double radius = 1)
{
  return sphere_without(
      number, seed, [](const Vector_3&) { return false; }, center, radius);
}

/// `n` by `n` points `i*a + j*b`, facing up.
Cloud lattice(int n, const Vector_3& a, const Vector_3& b)
{
  Cloud cloud;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      cloud.push_back(CGAL::ORIGIN + i * a + j * b, Vector_3(0, 0, 1));
  return cloud;
}

/// random points of the unit square at a height, facing up or down.
Cloud square(int number, std::uint64_t seed, double height, double up)
{
  shapes::Random random(seed);
  Cloud cloud;
  for(int i = 0; i < number; ++i)
    cloud.push_back(random.point_in(CGAL::Bbox_3(0, 0, height, 1, 1, height)), Vector_3(0, 0, up));
  return cloud;
}

/// few places and normals, so that copies, lines, planes and stacks abound.
Cloud rubble(int number, std::uint64_t seed)
{
  shapes::Random random(seed);
  const int width = 1 + int(random(0, 5));
  const auto coordinate = [&] { return std::floor(random(0, width)); };
  Cloud cloud;
  while(int(cloud.points.size()) < number) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const double u = coordinate(), v = coordinate();
    cloud.push_back(Point_3(x, y, z), Vector_3(u - 1, v - 1, coordinate() + 0.5));
  }
  return cloud;
}

// ---------------------------------------------------------------- areas

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

// ---------------------------------------------------------------- normals

/// the largest angle, in radians, between estimated and true normals.
double largest_error(const AP::Estimated_normals& estimated, const Cloud& cloud)
{
  double largest = 0;
  for(std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double length = std::sqrt(estimated.normals[i].squared_length());
    EXPECT_NEAR(length, 1, 1e-12);
    const Vector_3 error = estimated.normals[i] - cloud.normals[i];
    largest = std::max(largest, 2 * std::asin(std::min(1., std::sqrt(error.squared_length()) / 2)));
  }
  EXPECT_TRUE(estimated.unoriented.empty());
  return largest;
}

// A sphere differs from its quadric by r⁴/8 at the distance r, so in slope by r³/2. The k nearest
// of n random points lie within about 2√(k/n), sometimes half as far again.
TEST(Normals_from_points, of_a_sphere_are_as_far_off_as_its_quadric)
{
  const int number = 1000;
  const double distance = 3 * std::sqrt(18. / number);
  const Cloud cloud = sphere(number, 81);
  const AP::Estimated_normals estimated = AP::normals_from_points(cloud.points);
  EXPECT_LT(largest_error(estimated, cloud), 0.5 * std::pow(distance, 3));
  EXPECT_EQ(estimated.number_of_parts, 1u);
}

TEST(Normals_from_points, of_a_plane_are_exact_and_up)
{
  const shapes::Rotation rotation{Vector_3(1, 0, 0), 1.};
  for(const Cloud& flat : {square(500, 82, 1, 1), lattice(20, {1, 0, 0}, {0, 1, 0})}) {
    EXPECT_LT(largest_error(AP::normals_from_points(flat.points), flat), 1e-6);
    Cloud tilted;
    for(const Point_3& p : flat.points)
      tilted.push_back(rotation(p), rotation(Point_3(0, 0, 1)) - CGAL::ORIGIN);
    EXPECT_LT(largest_error(AP::normals_from_points(tilted.points), tilted), 1e-6);
  }
}

// Whichever lies highest, and though two of them are nearer than three spacings.
TEST(Normals_from_points, of_each_part_point_outward)
{
  const Cloud cloud =
      joined(joined(sphere(2000, 83), sphere(2000, 84, Point_3(2.25, 0, 0))),
             joined(sphere(300, 85, Point_3(0, 5, -9), 0.5), sphere(100, 86, Point_3(9, 9, 9), 2)));
  const AP::Estimated_normals estimated = AP::normals_from_points(cloud.points);
  EXPECT_LT(largest_error(estimated, cloud), 0.2);
  EXPECT_EQ(estimated.number_of_parts, 4u);
}

TEST(Normals_from_points, of_an_open_part_point_to_its_convex_side)
{
  for(const Vector_3& d : {Vector_3(0, 0, 1), Vector_3(0, 0, -1), Vector_3(0.6, 0.8, 0)}) {
    const Cloud half = sphere_without(1000, 87, [&](const Vector_3& n) { return n * d < 0; });
    EXPECT_LT(largest_error(AP::normals_from_points(half.points), half), 0.1);
  }
}

// A ring is convex on its outer side and not on its inner one.
TEST(Normals_from_points, of_a_torus_point_outward)
{
  shapes::Random random(88);
  Cloud torus;
  for(int i = 0; i < 3000; ++i) {
    const double u = random(0, 2 * pi), v = random(0, 2 * pi);
    const Vector_3 ring(std::cos(u), std::sin(u), 0);
    const Vector_3 normal = std::cos(v) * ring + Vector_3(0, 0, std::sin(v));
    torus.push_back(CGAL::ORIGIN + 2 * ring + 0.6 * normal, normal);
  }
  EXPECT_LT(largest_error(AP::normals_from_points(torus.points), torus), 0.2);
}

// Fingers side by side: all vertices are on the right side of the faces around them.
TEST(Normals_from_points, of_a_hand_point_outward)
{
  const shapes::Soup hand = shapes::bundled_mesh("hand.obj");
  const AP::Estimated_normals estimated = AP::normals_from_points(hand.points);
  std::vector<Vector_3> sums(hand.points.size(), CGAL::NULL_VECTOR);
  for(const shapes::Triangle& t : hand.triangles)
    for(const std::uint32_t v : t)
      sums[v] = sums[v] + CGAL::cross_product(hand.points[t[1]] - hand.points[t[0]],
                                              hand.points[t[2]] - hand.points[t[0]]);
  int wrong = 0;
  for(std::size_t v = 0; v < sums.size(); ++v)
    wrong += estimated.normals[v] * sums[v] < 0 ? 1 : 0;
  EXPECT_EQ(wrong, 0);
}

TEST(Normals_from_points, follow_rotations_and_scalings)
{
  shapes::Random random(89);
  const shapes::Soup blob = shapes::blob(4, 90);
  const shapes::Rotation rotation{random.direction(), 2.};
  const std::vector<Vector_3> normals = AP::normals_from_points(blob.points).normals;
  for(const double factor : {1., 1e-70, 1e70}) {
    const shapes::Soup moved = shapes::scaled(shapes::moved(blob, rotation), factor);
    const std::vector<Vector_3> moved_normals = AP::normals_from_points(moved.points).normals;
    for(std::size_t i = 0; i < normals.size(); ++i)
      ASSERT_GT(moved_normals[i] * (rotation(CGAL::ORIGIN + normals[i]) - CGAL::ORIGIN), 0.99)
          << i << " " << factor;
  }
}

TEST(Normals_from_points, have_the_same_bits_in_any_order_and_number_of_threads)
{
  const Cloud cloud = joined(sphere(1000, 91), rubble(300, 92));
  const std::vector<Vector_3> normals = AP::normals_from_points(cloud.points).normals;
  EXPECT_EQ(AP::normals_from_points<CGAL::Parallel_if_available_tag>(cloud.points).normals,
            normals);
  std::vector<std::size_t> order(cloud.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  shapes::Random random(93);
  random.shuffle(order);
  std::vector<Point_3> shuffled;
  for(const std::size_t i : order)
    shuffled.push_back(cloud.points[i]);
  const std::vector<Vector_3> of_shuffled = AP::normals_from_points(shuffled).normals;
  for(std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(of_shuffled[i], normals[order[i]]);
}

TEST(Normals_from_points, are_null_on_a_line)
{
  std::vector<Point_3> points;
  for(int i = 0; i < 50; ++i)
    points.emplace_back(10 + 0.1 * i, 0.2 * i, 0.3 * i);
  const Cloud ball = sphere(500, 94);
  points.insert(points.end(), ball.points.begin(), ball.points.end());
  const AP::Estimated_normals estimated = AP::normals_from_points(points);
  ASSERT_EQ(estimated.unoriented.size(), 50u);
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(estimated.normals[i] == CGAL::NULL_VECTOR, i < 50);
  EXPECT_EQ(estimated.unoriented.back(), 49u);
  EXPECT_EQ(estimated.number_of_parts, 1u);
}

TEST(Normals_from_points, are_shared_by_copies_and_change_nothing_else)
{
  Cloud ball = sphere(1000, 95);
  const std::vector<Vector_3> alone = AP::normals_from_points(ball.points).normals;
  ball.points.insert(ball.points.end(), 100000, ball.points[7]);
  const std::vector<Vector_3> normals = AP::normals_from_points(ball.points).normals;
  for(std::size_t i = 0; i < normals.size(); ++i)
    ASSERT_EQ(normals[i], alone[i < alone.size() ? i : 7]);
}

TEST(Normals_from_points, are_unit_vectors_or_listed_for_any_points)
{
  for(int n = 0; n < 100; ++n) {
    Cloud cloud = joined(rubble(5 * n, std::uint64_t(n)), sphere(7, std::uint64_t(n)));
    const AP::Estimated_normals estimated = AP::normals_from_points(cloud.points);
    std::size_t null = 0;
    for(const Vector_3& normal : estimated.normals)
      if(normal == CGAL::NULL_VECTOR)
        ++null;
      else
        ASSERT_NEAR(normal.squared_length(), 1, 1e-12);
    ASSERT_EQ(null, estimated.unoriented.size());
    ASSERT_EQ(estimated.normals.size(), cloud.points.size());
  }
}

// The squares of such lengths are less than the least number, or greater than the largest.
TEST(Normals_from_points, bear_tiny_and_huge_clouds)
{
  for(const double size : {1e-300, 1e-170, 1e-155, 1e-135, 1e100, 1e139, 1e160, 1e300}) {
    Cloud cloud = sphere(100, 3);
    for(Point_3& p : cloud.points)
      p = CGAL::ORIGIN + size * (p - CGAL::ORIGIN);
    Cloud ball = sphere(100, 4);
    cloud.points.insert(cloud.points.end(), ball.points.begin(), ball.points.end());
    if(size < 1e140) {
      EXPECT_EQ(AP::normals_from_points(cloud.points).normals.size(), 200u) << size;
    } else {
      EXPECT_THROW(AP::normals_from_points(cloud.points), std::invalid_argument) << size;
    }
  }
}

TEST(Normals_from_points, takes_points_of_any_kernel)
{
  const Cloud ball = sphere(300, 96);
  std::vector<Epeck::Point_3> exact;
  std::vector<std::size_t> indices;
  for(const Point_3& p : ball.points) {
    indices.push_back(exact.size());
    exact.emplace_back(p.x(), p.y(), p.z());
  }
  const std::vector<Vector_3> expected = AP::normals_from_points(ball.points).normals;
  EXPECT_EQ(AP::normals_from_points(exact).normals, expected);
  EXPECT_EQ(AP::normals_from_points(indices, 18,
                                    CGAL::parameters::point_map(CGAL::make_property_map(exact)))
                .normals,
            expected);
}

TEST(Normals_from_points, name_what_is_wrong)
{
  std::vector<Point_3> points = sphere(7, 97).points;
  const auto of = [&](unsigned k) {
    return shapes::complaint([&] { AP::normals_from_points(points, k); });
  };
  EXPECT_EQ(of(6), "");
  EXPECT_EQ(of(5), "k is 5: must be at least 6");
  points[3] = Point_3(0, INFINITY, 0);
  EXPECT_EQ(of(18), "point 3 is not finite");
  points[3] = points[2];
  EXPECT_EQ(of(18), "points has 6 different positions: an estimate of normals needs at least 7");
}

// Against signs that are known: two members are told apart if and only if a path joins them.
TEST(Signed_sets, know_the_signs_of_what_was_joined)
{
  shapes::Random random(98);
  const std::size_t number = 200;
  std::vector<bool> is_negative(number);
  std::vector<std::size_t> group(number);
  for(std::size_t i = 0; i < number; ++i) {
    is_negative[i] = random() < 0.5;
    group[i] = i;
  }
  AP::internal::Signed_sets sets(number);
  for(int n = 0; n < 300; ++n) {
    const auto i = std::size_t(random(0, number)), j = std::size_t(random(0, number));
    sets.join(i, j, is_negative[i] != is_negative[j]);
    std::replace(group.begin(), group.end(), std::size_t(group[i]), std::size_t(group[j]));
    for(std::size_t m = 0; m < number; ++m) {
      const auto a = sets.find(i), b = sets.find(m);
      ASSERT_EQ(a.set == b.set, group[i] == group[m]);
      if(a.set == b.set) {
        ASSERT_EQ(a.is_opposite != b.is_opposite, is_negative[i] != is_negative[m]);
      }
    }
  }
}

// ---------------------------------------------------------------- surfels

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
  EXPECT_EQ(of({{{0, 0, 0}, {0, 0, 0}}}, one),
            "point 0 has no normal: must be a finite vector other than zero");
  EXPECT_EQ(of({{{0, 0, 0}, {0, NAN, 1}}}, one),
            "point 0 has no normal: must be a finite vector other than zero");
  EXPECT_EQ(of({{{0, 0, 0}, {0, 0, 1}}}, negative),
            "point 0 has the area -2.000000: must be finite and not negative");
}

} // namespace
