// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The normals of points that have none: estimated, and turned outward.

#include "clouds.h"

#include <CGAL/Area_projection_transform/internal/Signed_sets.h>
#include <CGAL/Area_projection_transform/normals_from_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/property_map.h>

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
using AP::Vector_3;
using namespace clouds;
using shapes::pi;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

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

} // namespace
