// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums of weights in balls: the fast ones find exactly the points that CGAL's search and a plain loop find.
//
// Where it matters which points were found, weights are whole numbers, so that nothing is rounded.

#include "shapes.h"

#include <CGAL/Area_projection_transform/at_points.h>
#include <CGAL/Area_projection_transform/internal/simd/instruction_set.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using AP::internal::available_instruction_sets;
using AP::internal::chosen_instruction_set;
using AP::internal::Instruction_set;

/// hands its points out as they are, at any radius.
struct As_they_are
{
  const AP::Projected_surfels& points;

  template <class BatchSink>
  void project(double, Side, double, BatchSink&& sink) const
  {
    sink(points);
  }
};

double plain_sum(const AP::Projected_surfels& points, const Point_3& x, double sigma)
{
  double sum = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(CGAL::squared_distance(x, points.positions[i]) <= sigma * sigma)
      sum += points.areas[i];
  return sum;
}

struct Ball
{
  Point_3 center;
  double radius;
};

struct Cloud
{
  std::string name;
  AP::Projected_surfels points;
  std::vector<Ball> balls;
};

/// whole numbers, so that sums show which points were found.
double weight(shapes::Random& random)
{
  return std::floor(random(0, 1000));
}

/// balls of all sizes near points of the cloud, many with a point on the rim as far as rounding lets it.
void add_balls(Cloud& cloud, double extent, shapes::Random& random)
{
  const auto any_point = [&] {
    return cloud.points.positions[std::size_t(random(0, double(cloud.points.size())))];
  };
  for(int n = 0; n < 60; ++n) {
    const double radius = extent * std::pow(10., random(-5, 1));
    const Point_3 center = any_point() + random(0, 1.5) * radius * random.direction();
    cloud.balls.push_back({center, radius});
    const double to_point = std::sqrt(CGAL::squared_distance(center, any_point()));
    for(double rim : {to_point, std::nextafter(to_point, 0.), std::nextafter(to_point, 1e9)})
      cloud.balls.push_back({center, rim});
  }
}

Cloud random_cloud(std::size_t size, const Vector_3& offset, double extent)
{
  shapes::Random random(size);
  Cloud cloud{std::to_string(size) + " random points", {}, {}};
  const CGAL::Bbox_3 box(0, 0, 0, extent, extent, extent);
  for(std::size_t i = 0; i < size; ++i)
    cloud.points.push_back(random.point_in(box) + offset, weight(random));
  add_balls(cloud, extent, random);
  return cloud;
}

/// dense clusters far from each other, with many points in the same place.
Cloud clusters()
{
  shapes::Random random(7);
  Cloud cloud{"clusters", {}, {}};
  for(int c = 0; c < 5; ++c) {
    const Point_3 center = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
    const double size = std::pow(10., -2 * c);
    for(int i = 0; i < 400; ++i)
      cloud.points.push_back(i % 4 == 0 ? center : center + random(0, size) * random.direction(),
                             weight(random));
    for(double radius : {size / 3, size, 2 * size})
      cloud.balls.push_back({center + random(0, size) * random.direction(), radius});
  }
  add_balls(cloud, 1, random);
  return cloud;
}

Cloud plane()
{
  shapes::Random random(8);
  Cloud cloud{"plane", {}, {}};
  for(int i = 0; i < 3000; ++i)
    cloud.points.push_back(Point_3(random(-1, 1), random(-1, 1), 0.25), weight(random));
  add_balls(cloud, 1, random);
  return cloud;
}

/// around a point of a lattice many others are at the same distance, without rounding.
Cloud lattice(double spacing, const Vector_3& offset)
{
  shapes::Random random(9);
  Cloud cloud{"lattice of spacing " + std::to_string(spacing), {}, {}};
  for(int i = 0; i < 15; ++i)
    for(int j = 0; j < 15; ++j)
      for(int k = 0; k < 15; ++k)
        cloud.points.push_back(Point_3(spacing * i, spacing * j, spacing * k) + offset,
                               weight(random));
  for(int n = 0; n < 40; ++n) {
    const Point_3 center = cloud.points.positions[std::size_t(random(0, 3375))];
    for(double radius : {1., 3., 5., 7., 9., 13., 25.}) {
      cloud.balls.push_back({center, spacing * radius});
      cloud.balls.push_back({center, std::nextafter(spacing * radius, 0.)});
      cloud.balls.push_back({center, spacing * std::sqrt(radius)});
    }
  }
  return cloud;
}

const std::vector<Cloud>& clouds()
{
  static const std::vector<Cloud> all{
      random_cloud(1, Vector_3(0, 0, 0), 1),
      random_cloud(31, Vector_3(0, 0, 0), 1),
      random_cloud(33, Vector_3(0, 0, 0), 1),
      random_cloud(513, Vector_3(0, 0, 0), 1),
      random_cloud(20000, Vector_3(0, 0, 0), 1),
      random_cloud(3000, Vector_3(1e6, -2e6, 5e5), 1e-3),
      random_cloud(3000, Vector_3(0, 0, 0), 1e-9),
      random_cloud(3000, Vector_3(0, 0, 0), 1e12),
      clusters(),
      plane(),
      lattice(1, Vector_3(0, 0, 0)),
      lattice(0.125, Vector_3(1e6, 0, -1e5)),
      lattice(0.1, Vector_3(0.3, 0, 0)),
  };
  return all;
}

class Ball_sums_of_every_instruction_set : public testing::TestWithParam<Instruction_set>
{
protected:
  void SetUp() override { chosen_instruction_set() = GetParam(); }
  void TearDown() override { chosen_instruction_set() = available_instruction_sets().back(); }
};

// The search of CGAL takes a box for inside by the end that is farther from the centre, which it looks up
// with a rounding: now and then it finds a point beyond the rim by as much.
TEST_P(Ball_sums_of_every_instruction_set, find_the_points_that_a_loop_and_the_search_of_cgal_find)
{
  for(const Cloud& cloud : clouds()) {
    const AP::Sampled_evaluator sums(cloud.points);
    const AP::Kd_tree_evaluator search(As_they_are{cloud.points}, 1, Side::INSIDE, 1);
    EXPECT_EQ(sums.number_of_surfels(), cloud.points.size());
    for(const Ball& ball : cloud.balls) {
      const double found = sums(ball.center, ball.radius);
      ASSERT_EQ(found, plain_sum(cloud.points, ball.center, ball.radius)) << cloud.name;
      const double searched = search(ball.center, ball.radius);
      if(found != searched) {
        ASSERT_GT(searched, found) << cloud.name;
        ASSERT_LE(searched, plain_sum(cloud.points, ball.center, ball.radius * (1 + 1e-15)))
            << cloud.name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(all, Ball_sums_of_every_instruction_set,
                         testing::ValuesIn(available_instruction_sets()),
                         [](const auto& set) { return "set_" + std::to_string(set.index); });

// Areas of many orders of magnitude, whose sums in double depend on the order of their terms.
TEST(Ball_sums, have_the_same_bits_for_any_order_threads_and_instruction_set)
{
  shapes::Random random(11);
  std::vector<std::pair<Point_3, double>> elements;
  for(int i = 0; i < 30000; ++i)
    elements.emplace_back(CGAL::ORIGIN + random(0.9, 1) * random.direction(),
                          std::pow(10., random(-12, 0)));
  const auto sums = [&](auto tag) {
    AP::Projected_surfels points;
    for(const auto& [position, area] : elements)
      points.push_back(position, area);
    const AP::Sampled_evaluator evaluator(points, tag);
    std::vector<double> result;
    for(int i = 0; i < 50; ++i)
      result.push_back(evaluator(Point_3(0.02 * i, 0.3, 0), 0.03 * i));
    return result;
  };
  const std::vector<double> expected = sums(CGAL::Sequential_tag());
  EXPECT_GT(expected.back(), expected.front());
  for(const Instruction_set set : available_instruction_sets()) {
    chosen_instruction_set() = set;
    random.shuffle(elements);
    EXPECT_EQ(sums(CGAL::Sequential_tag()), expected) << name(set);
    EXPECT_EQ(sums(CGAL::Parallel_if_available_tag()), expected) << name(set);
  }
}

TEST(Ball_sums, of_surfels_differ_from_those_of_the_search_by_rounding_only)
{
  const shapes::Soup blob = shapes::blob(3, 5);
  const auto surface = shapes::scale_space_of(blob);
  const double area = blob.area();
  shapes::Random random(12);
  for(const double radius : {0.3, 0.7}) {
    const AP::Sampled_evaluator sums(surface, radius, Side::INSIDE, 0.02);
    const AP::Kd_tree_evaluator search(surface, radius, Side::INSIDE, 0.02);
    EXPECT_EQ(sums.number_of_surfels(), search.number_of_surfels());
    const auto kernel = AP::Epanechnikov_kernel_3().nested_balls();
    for(int n = 0; n < 100; ++n) {
      const Point_3 x = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
      const double sigma = random(0.1, 0.5);
      ASSERT_NEAR(sums(x, sigma), search(x, sigma), 1e-12 * area);
      ASSERT_NEAR(sums(x, sigma, kernel), search(x, sigma, kernel), 1e-12 * area);
    }
  }
}

TEST(Ball_sums, serve_queries_of_one_radius_and_many_sigmas)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 5));
  shapes::Random random(13);
  std::vector<AP::Query> queries;
  for(int n = 0; n < 200; ++n)
    queries.push_back({random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1)),
                       {n % 2 == 0 ? 0.3 : 0.6, random(0.05, 0.5)}});
  const auto sums =
      AP::evaluate_at_points<CGAL::Parallel_if_available_tag>(queries, [&](const AP::Scale& scale) {
        return AP::Sampled_evaluator(surface, scale.radius, Side::INSIDE, 0.02,
                                     CGAL::Parallel_if_available_tag());
      });
  const auto search = AP::evaluate_at_points(queries, [&](const AP::Scale& scale) {
    return AP::Kd_tree_evaluator(surface, scale.radius, Side::INSIDE, 0.02);
  });
  for(std::size_t q = 0; q < queries.size(); ++q)
    EXPECT_NEAR(sums[q], search[q], 1e-11);
}

// ---------------------------------------------------------------- extremes

AP::Projected_surfels two_points(double area, double other_area)
{
  AP::Projected_surfels points;
  points.push_back(Point_3(0, 0, 0), area);
  points.push_back(Point_3(1, 0, 0), other_area);
  return points;
}

TEST(Ball_sums, of_no_points_and_of_no_area_are_zero)
{
  EXPECT_EQ(AP::Sampled_evaluator(AP::Projected_surfels())(Point_3(0, 0, 0), 1), 0);
  EXPECT_EQ(AP::Sampled_evaluator(two_points(0, 0))(Point_3(0, 0, 0), 2), 0);
  const AP::Constant_scale_space nothing{AP::Triangle_surface()};
  EXPECT_EQ(AP::Sampled_evaluator(nothing, 1, Side::INSIDE, 0.1)(Point_3(0, 0, 0), 1), 0);
}

// 2^-61 of the total is what remains of an area.
TEST(Ball_sums, keep_small_areas_beside_large_ones)
{
  const double small = AP::Sampled_evaluator(two_points(1, 1e-9))(Point_3(1, 0, 0), 0.5);
  EXPECT_NEAR(small, 1e-9, 0x1p-60);
  const double none = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(AP::Sampled_evaluator(two_points(none, 3 * none))(Point_3(0, 0, 0), 1), 4 * none);
  EXPECT_EQ(AP::Sampled_evaluator(two_points(1e307, 2e307))(Point_3(0, 0, 0), 1), 3e307);
}

TEST(Ball_sums, are_defined_for_balls_that_no_square_can_hold)
{
  const AP::Sampled_evaluator evaluator(two_points(1, 2));
  EXPECT_EQ(evaluator(Point_3(0, 0, 0), 1e200), 3);
  EXPECT_EQ(evaluator(Point_3(1e200, 0, 0), 1), 0);
  EXPECT_EQ(evaluator(Point_3(0, 0, 0), 0), 1); // the centre is on the rim
  EXPECT_EQ(evaluator(Point_3(NAN, 0, 0), 1), 0);
  EXPECT_EQ(evaluator(Point_3(0, 0, 0), 1e-200), 1);
}

TEST(Ball_sums, name_what_is_out_of_range)
{
  const auto surface = shapes::scale_space_of(shapes::icosphere(0));
  EXPECT_EQ(shapes::complaint([&] { AP::Sampled_evaluator(surface, -1, Side::INSIDE, 0.1); }),
            "radius is -1: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { AP::Sampled_evaluator(surface, 1, Side::INSIDE, NAN); }),
            "spacing is nan: must be positive and finite");
  EXPECT_EQ(shapes::complaint([] { AP::Sampled_evaluator evaluator(two_points(1, -1)); }),
            "areas[1] is -1: must be finite and not negative");
  AP::Projected_surfels points;
  points.push_back(Point_3(0, INFINITY, 0), 1);
  EXPECT_EQ(shapes::complaint([&] { AP::Sampled_evaluator evaluator(points); }),
            "positions[0] is not finite");
}

} // namespace
