// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What counts as found.

#include "salient_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

namespace {

using namespace Paper;

constexpr double pi = 3.14159265358979323846;

Truth sphere_of_radius_2()
{
  Truth truth;
  truth.center = Point_3(1, 2, 3);
  truth.radius = 2;
  return truth;
}

/// along z, from -4 to 4.
Truth tube_of_radius_2(double slope = 0)
{
  Truth truth;
  truth.shape = slope != 0 ? Truth_shape::CONE : Truth_shape::TUBE;
  truth.axis = Vector_3(0, 0, 1);
  truth.radius = 2;
  truth.length = 8;
  truth.slope = slope;
  return truth;
}

/// a half circle of radius 10 around (10, 0, 0), from (10, 0, -10) by (0, 0, 0) to (10, 0, 10).
Truth half_ring()
{
  Truth truth;
  truth.shape = Truth_shape::BENT_TUBE;
  truth.axis = Vector_3(0, 0, 1);
  truth.radius = 2;
  truth.length = 10 * pi;
  truth.curvature = Vector_3(0.1, 0, 0);
  return truth;
}

Truth ellipsoid(double ratio)
{
  Truth truth;
  truth.shape = Truth_shape::ELLIPSOID;
  truth.axis = Vector_3(0, 0, 1);
  truth.semi_axes = {{1, 1, ratio}};
  truth.radius = (2 + ratio) / 3;
  return truth;
}

Detection detection(Found_shape shape, const Point_3& position, double radius,
                    const Vector_3& axis = Vector_3(0, 0, 0))
{
  Detection detection;
  detection.shape = shape;
  detection.position = position;
  detection.radius = radius;
  detection.axis = axis;
  return detection;
}

Detection tube(const Point_3& position, double radius, const Vector_3& axis = Vector_3(0, 0, -3))
{
  return detection(Found_shape::TUBE, position, radius, axis);
}

Vector_3 tilted(double degrees)
{
  return {std::sin(degrees * pi / 180), 0, std::cos(degrees * pi / 180)};
}

Score score_of(const std::vector<Truth>& truths, const std::vector<Detection>& detections)
{
  Score score;
  add({{}, truths}, detections, score);
  return score;
}

TEST(Hits, of_spheres)
{
  const Truth truth = sphere_of_radius_2();
  const auto is_right = [&](Found_shape shape, double off, double radius) {
    return is_hit(detection(shape, truth.center + Vector_3(0, off, 0), radius), truth);
  };
  EXPECT_TRUE(is_right(Found_shape::SPHERE, 0, 2));
  EXPECT_TRUE(is_right(Found_shape::SPHERE, 0.29, 2));
  EXPECT_FALSE(is_right(Found_shape::SPHERE, 0.31, 2));
  EXPECT_TRUE(is_right(Found_shape::SPHERE, 0, 2.29));
  EXPECT_FALSE(is_right(Found_shape::SPHERE, 0, 2.31));
  EXPECT_FALSE(is_right(Found_shape::SPHERE, 0, 1.69));
  EXPECT_FALSE(is_right(Found_shape::SPHERE, 0, std::nan("")));
  EXPECT_FALSE(is_right(Found_shape::TUBE, 0, 2));
  EXPECT_FALSE(is_right(Found_shape::OTHER, 0, 2));
}

TEST(Hits, of_tubes)
{
  const Truth truth = tube_of_radius_2();
  EXPECT_TRUE(is_hit(tube({0, 0, 0}, 2), truth));
  EXPECT_TRUE(is_hit(detection(Found_shape::CONE, {0, 0, 0}, 2, {0, 0, 1}), truth));
  EXPECT_FALSE(is_hit(detection(Found_shape::SPHERE, {0, 0, 0}, 2), truth));
  EXPECT_TRUE(is_hit(tube({0.2, 0.2, 3.9}, 2), truth));
  EXPECT_FALSE(is_hit(tube({0.22, 0.22, 0}, 2), truth));
  EXPECT_FALSE(is_hit(tube({0, 0, -4.1}, 2), truth));
  EXPECT_TRUE(is_hit(tube({0, 0, 0}, 2, tilted(17.9)), truth));
  EXPECT_TRUE(is_hit(tube({0, 0, 0}, 2, -5 * tilted(17.9)), truth));
  EXPECT_FALSE(is_hit(tube({0, 0, 0}, 2, tilted(18.1)), truth));
  EXPECT_FALSE(is_hit(tube({0, 0, 0}, 2, {0, 0, 0}), truth));
  EXPECT_FALSE(is_hit(tube({0, 0, 0}, 2.4), truth));
}

TEST(Hits, of_cones_go_by_the_radius_where_they_are_found)
{
  const Truth truth = tube_of_radius_2(0.1);
  EXPECT_TRUE(is_hit(tube({0, 0, 3}, 2.3), truth));
  EXPECT_FALSE(is_hit(tube({0, 0, 3}, 1.9), truth));
  EXPECT_TRUE(is_hit(tube({0, 0, -3}, 1.7), truth));
  EXPECT_FALSE(is_hit(tube({0, 0, -3}, 2), truth));
}

TEST(Hits, of_bent_tubes_go_by_the_arc)
{
  const Truth truth = half_ring();
  const double a = pi / 4, z = 10 * std::sin(a), x = 10 - 10 * std::cos(a);
  EXPECT_TRUE(is_hit(tube({0, 0, 0}, 2), truth));
  EXPECT_TRUE(is_hit(tube({x, 0, z}, 2, {1, 0, 1}), truth));
  EXPECT_TRUE(is_hit(tube({x, 0, -z}, 2, {1, 0, -1}), truth));
  EXPECT_FALSE(is_hit(tube({x, 0, z}, 2, {0, 0, 1}), truth));
  EXPECT_FALSE(is_hit(tube({20, 0, 0}, 2, {0, 0, 1}), truth)); // the other half of the circle
  const Place_of_truth place = place_of(truth, {x, 1, z});
  EXPECT_NEAR(place.along, 10 * a, 1e-12);
  EXPECT_NEAR(place.distance, 1, 1e-12);
}

TEST(Hits, of_ellipsoids)
{
  EXPECT_TRUE(is_hit(detection(Found_shape::SPHERE, {0, 0, 0}, 1), ellipsoid(1.29)));
  EXPECT_FALSE(is_hit(detection(Found_shape::SPHERE, {0, 0, 0}, 1), ellipsoid(1.31)));
  EXPECT_TRUE(is_hit(detection(Found_shape::SPHERE, {0, 0, 0}, 1), ellipsoid(1 / 1.29)));
  EXPECT_FALSE(is_hit(detection(Found_shape::SPHERE, {0, 0, 0}, 1), ellipsoid(1 / 1.31)));
  for(Found_shape shape : {Found_shape::TUBE, Found_shape::CONE, Found_shape::OTHER}) {
    EXPECT_TRUE(is_hit(detection(shape, {0, 0, 0.3}, 5), ellipsoid(2)));
    EXPECT_FALSE(is_hit(detection(shape, {0, 0, 0.35}, 5), ellipsoid(2)));
  }
}

TEST(Score, of_all_that_is_right_is_1)
{
  Detection bent = tube({0, 0, 0}, 2);
  bent.curvature = Vector_3(0.1, 0, 0);
  const Score score = score_of({sphere_of_radius_2(), half_ring()},
                               {bent, detection(Found_shape::SPHERE, {1, 2, 3}, 2)});
  EXPECT_EQ(score.recall(), 1);
  EXPECT_EQ(score.precision(), 1);
  EXPECT_EQ(score.duplicates, 0u);
  EXPECT_TRUE(score.misses.empty());
  EXPECT_TRUE(score.wrong.empty());
  EXPECT_EQ(score.confusion[std::size_t(Truth_shape::SPHERE)][std::size_t(Found_shape::SPHERE)],
            1u);
  EXPECT_EQ(score.confusion[std::size_t(Truth_shape::BENT_TUBE)][std::size_t(Found_shape::TUBE)],
            1u);
  ASSERT_EQ(score.curvature_errors.size(), 1u);
  EXPECT_NEAR(score.curvature_errors[0], 0, 1e-12);
}

TEST(Score, of_nothing)
{
  EXPECT_EQ(score_of({}, {}).recall(), 1);
  EXPECT_EQ(score_of({}, {}).precision(), 1);
  const Score score = score_of({sphere_of_radius_2()}, {});
  EXPECT_EQ(score.recall(), 0);
  EXPECT_EQ(score.misses.size(), 1u);
  EXPECT_EQ(score.confusion[std::size_t(Truth_shape::SPHERE)].back(), 1u);
  EXPECT_TRUE(std::isnan(score.coverage()));
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Score, gives_an_object_to_the_nearest_and_calls_the_others_duplicates)
{
  const Score score = score_of({tube_of_radius_2()},
                               {tube({0.1, 0, -2}, 2.2), tube({0, 0, 2}, 2.1), tube({9, 0, 0}, 2)});
  EXPECT_EQ(score.hits, 1u);
  EXPECT_EQ(score.duplicates, 1u);
  EXPECT_EQ(score.wrong.size(), 2u);
  EXPECT_NEAR(score.precision(), 1. / 3, 1e-15);
  ASSERT_EQ(score.radius_errors.size(), 1u);
  EXPECT_NEAR(score.radius_errors[0], 0.05, 1e-12);
  EXPECT_NEAR(score.position_errors[0], 0, 1e-12);
}

TEST(Score, gives_each_detection_to_one_object)
{
  Truth other = tube_of_radius_2();
  other.center = Point_3(0.1, 0, 0); // so near that one detection hits both
  const Score score = score_of({tube_of_radius_2(), other}, {tube({0.01, 0, 0}, 2)});
  EXPECT_EQ(score.hits, 1u);
  EXPECT_EQ(score.misses.size(), 1u);
  EXPECT_NEAR(score.position_errors.at(0), 0.005, 1e-12);
}

TEST(Score, counts_intervals_that_hold_the_truth)
{
  Detection right = detection(Found_shape::SPHERE, {1, 2, 3}, 2.1), wrong = right;
  right.low = 1.9;
  right.high = 2.2;
  wrong.low = 2.01;
  wrong.high = 2.2;
  Score score = score_of({sphere_of_radius_2()}, {right});
  add({{}, {sphere_of_radius_2()}}, {wrong}, score);
  add({{}, {sphere_of_radius_2()}}, {detection(Found_shape::SPHERE, {1, 2, 3}, 2)}, score);
  EXPECT_EQ(score.scenes, 3u);
  EXPECT_EQ(score.intervals, 2u);
  EXPECT_EQ(score.coverage(), 0.5);
}

TEST(Score, knows_the_slope_for_either_direction_of_the_axis)
{
  Detection along = detection(Found_shape::CONE, {0, 0, 0}, 2, {0, 0, 1}), against = along;
  along.slope = 0.09;
  against.axis = -along.axis;
  against.slope = -0.09;
  for(const Detection& cone : {along, against}) {
    const Score score = score_of({tube_of_radius_2(0.1)}, {cone});
    ASSERT_EQ(score.slope_errors.size(), 1u);
    EXPECT_NEAR(score.slope_errors[0], 0.01, 1e-12);
  }
}

TEST(Score, is_evaluated_over_scenes)
{
  const std::vector<Scene> scenes = {easy_scene(1), hard_scene(1)};
  std::size_t next = 0;
  const Score score = evaluate(scenes, [&](const Soup& soup) {
    EXPECT_EQ(soup.triangles, scenes[next].soup.triangles);
    const Truth& truth = scenes[next++].truths[0];
    return std::vector<Detection>{truth.is_tubular()
                                      ? tube(truth.center, truth.radius, truth.axis)
                                      : detection(Found_shape::SPHERE, truth.center, truth.radius)};
  });
  EXPECT_EQ(score.hits, 2u);
  EXPECT_EQ(score.truths, scenes[0].truths.size() + scenes[1].truths.size());
  std::ostringstream text;
  text << score;
  EXPECT_NE(text.str().find("precision 1"), std::string::npos);
}

} // namespace
