// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Polar balls: inner vertices of the Voronoi diagram of samples as medial balls.

#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_balls.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace shapes;
using AP::Medial_ball;
using AP::Medial_ball_options;
using AP::internal::to_eigen;

Medial_ball_options polar()
{
  Medial_ball_options options;
  options.method = AP::Medial_ball_method::POLAR;
  return options;
}

double distance_from_origin(const Point_3& p)
{
  return std::sqrt((p - CGAL::ORIGIN).squared_length());
}

TEST(Polar_balls, of_points_on_a_sphere_are_the_sphere)
{
  // Whatever four of them, their ball is the sphere. The points are on it but for 2^-53; four that are as near as
  // 0.06 to each other fix a centre by the cube of that: it errs by 2^-53 / 0.06³ and some.
  const auto balls = AP::medial_balls(fibonacci_sphere(3000), polar());
  ASSERT_EQ(balls.size(), 3000u);
  for(const Medial_ball& ball : balls) {
    EXPECT_LT(distance_from_origin(ball.center), 1e-9);
    EXPECT_NEAR(ball.radius, 1, 1e-9);
    EXPECT_NEAR(ball.mapt, 1, 0.0021);
  }
}

TEST(Polar_balls, are_empty_and_pass_through_four_samples)
{
  for(const Soup& soup : {bundled_mesh("scorpion_low.obj"), fine_box(Vector_3(4, 4, 1), 0.2)}) {
    const AP::Triangle_surface surface = surface_of(soup);
    const AP::internal::Medial_samples samples(surface, polar());
    const AP::internal::Polar_balls balls(samples, samples.largest_radius());
    std::size_t number = 0;
    for(std::size_t b = 0; b < samples.size(); b += 20) {
      if(!balls[b])
        continue;
      ++number;
      double nearest = std::numeric_limits<double>::infinity();
      std::size_t touching = 0;
      for(const auto& p : samples.positions) {
        const double part = (p - balls[b]->center).norm() / balls[b]->radius;
        nearest = std::min(nearest, part);
        touching += part < 1 + 1e-8;
      }
      // What the distances of the four may differ by.
      EXPECT_GT(nearest, 1 - 1e-8);
      EXPECT_GE(touching, 4u);
    }
    EXPECT_GT(number, samples.size() / 20 * 9 / 10);
  }
}

TEST(Polar_balls, of_a_cube_are_the_ball_through_its_corners)
{
  // The corners of a cube are on one sphere, and those of each face on a circle: any four of them have cells.
  AP::Surfels points;
  for(const double x : {-1., 1.})
    for(const double y : {-1., 1.})
      for(const double z : {-1., 1.})
        points.push_back(Point_3(x, y, z), Vector_3(x, y, z) / std::sqrt(3.), 1,
                         std::uint32_t(points.size()));
  auto balls = AP::medial_balls(points, polar());
  ASSERT_EQ(balls.size(), 8u);
  for(const Medial_ball& ball : balls) {
    EXPECT_NEAR(distance_from_origin(ball.center), 0, 1e-15);
    EXPECT_NEAR(ball.radius, std::sqrt(3.), 1e-15);
    EXPECT_EQ(ball.angle, 180); // the opposite corner touches, too
  }
  // Twice the same points change nothing, but that one of two at the same place has the ball.
  for(std::size_t i = 0; i < 8; ++i)
    points.push_back(points.positions[i], points.normals[i], 1, std::uint32_t(8 + i));
  balls = AP::medial_balls(points, polar());
  ASSERT_EQ(balls.size(), 8u);
  for(std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(balls[i].source, i);
}

TEST(Polar_balls, lie_behind_all_they_touch)
{
  // The ball through the corners of a cube, but for one corner that faces the other way.
  for(std::size_t turned = 0; turned <= 8; ++turned) {
    AP::Surfels points;
    for(const double x : {-1., 1.})
      for(const double y : {-1., 1.})
        for(const double z : {-1., 1.}) {
          const double sign = points.size() == turned ? -1 : 1;
          points.push_back(Point_3(x, y, z), sign * Vector_3(x, y, z) / std::sqrt(3.), 1,
                           std::uint32_t(points.size()));
        }
    const AP::internal::Medial_samples samples(points, polar());
    const AP::internal::Polar_balls balls(samples, 2);
    std::size_t number = 0;
    for(std::size_t i = 0; i < 8; ++i)
      number += balls[i].has_value();
    // That one has none. Each other has one, unless all of its cells, which depend on how the cube is cut, have that corner.
    if(turned < 8) {
      EXPECT_FALSE(balls[turned].has_value());
      EXPECT_LT(number, 8u);
    } else
      EXPECT_EQ(number, 8u);
  }
}

TEST(Polar_balls, of_four_samples_that_are_almost_in_a_plane_are_known)
{
  // On the unit sphere about (0, 0, 1), so near to the origin that the heights, which are 1e-14 and exact but for
  // 2^-53 of themselves, are the ten millionth part of the distances.
  AP::Surfels points;
  for(const auto& [x, y] : {std::pair(1e-7, 0.), std::pair(-4e-8, 7e-8), std::pair(-5e-8, -6e-8),
                            std::pair(1e-8, 2e-8)}) {
    const double squared = x * x + y * y, z = squared / (1 + std::sqrt(1 - squared));
    points.push_back(Point_3(x, y, z), Vector_3(x, y, z - 1), 1, std::uint32_t(points.size()));
  }
  const AP::internal::Medial_samples samples(points, polar());
  const AP::internal::Polar_balls balls(samples, 2);
  for(std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(balls[i].has_value());
    EXPECT_NEAR(balls[i]->radius, 1, 1e-9);
    EXPECT_NEAR((balls[i]->center - Eigen::Vector3d(0, 0, 1)).norm(), 0, 1e-9);
  }
}

TEST(Polar_balls, of_a_box_are_in_its_middle_and_on_its_diagonals)
{
  // The samples of a wall are in a plane: most cells are flat but for rounding, or thinner.
  const auto balls = AP::medial_balls(surface_of(fine_box(Vector_3(8, 8, 2), 0.2)), polar());
  std::size_t middle = 0;
  for(const Medial_ball& ball : balls) {
    const double x = std::min(ball.center.x(), 8 - ball.center.x()),
                 y = std::min(ball.center.y(), 8 - ball.center.y());
    if(x < 1.5 || y < 1.5)
      continue;
    // The walls have the same lattice, so that the middle plane has the vertices. They see samples that are at most half
    // a diagonal of its squares off.
    EXPECT_NEAR(ball.center.z(), 1, 1e-9);
    EXPECT_GE(ball.radius, 1 - 1e-9);
    EXPECT_LE(ball.radius, std::hypot(1, 0.2 / std::sqrt(2.)));
    ++middle;
  }
  EXPECT_GT(middle, 2 * 25 * 25 * 2 * 9 / 10);
}

TEST(Polar_balls, of_a_torus_are_on_its_ring)
{
  const auto balls = AP::medial_balls(surface_of(torus(1, 0.3, 160, 48)), polar());
  ASSERT_GT(balls.size(), 15000u);
  std::vector<double> errors;
  for(const Medial_ball& ball : balls)
    errors.push_back(std::hypot(std::hypot(ball.center.x(), ball.center.y()) - 1, ball.center.z()));
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.001 * 0.3);
}

TEST(Polar_balls, are_inside_by_normals)
{
  const Soup sphere = icosphere(3);
  Medial_ball_options outside = polar();
  outside.side = AP::Side::OUTSIDE;
  outside.spacing = 1; // one sample for each face
  Medial_ball_options inside = outside;
  inside.side = AP::Side::INSIDE;
  EXPECT_EQ(AP::medial_balls(surface_of(sphere), outside).size(), 0u);
  EXPECT_EQ(AP::medial_balls(surface_of(flipped(sphere)), inside).size(), 0u);
  const auto balls = AP::medial_balls(surface_of(flipped(sphere)), outside);
  EXPECT_GT(balls.size(), sphere.triangles.size() * 9 / 10);
  for(const Medial_ball& ball : balls)
    EXPECT_LT(distance_from_origin(ball.center), 1);
}

TEST(Polar_balls, do_not_leave_through_holes)
{
  // Balls that left a tube by its open ends would have to touch it from outside.
  const auto balls = AP::medial_balls(surface_of(cylinder(64, 1, 6, false, 60)), polar());
  ASSERT_GT(balls.size(), 5000u);
  for(const Medial_ball& ball : balls) {
    EXPECT_LE(std::abs(ball.center.z()), 3);
    EXPECT_LT(std::hypot(ball.center.x(), ball.center.y()), 0.01);
    EXPECT_NEAR(ball.radius, 1, 0.01);
  }
}

TEST(Polar_balls, are_none_of_what_is_flat)
{
  EXPECT_TRUE(AP::medial_balls(surface_of(plane_patch(1, 0)), polar()).empty());
  EXPECT_TRUE(AP::medial_balls(AP::Surfels(), polar()).empty());
}

TEST(Polar_balls, do_not_depend_on_the_number_of_threads)
{
  const AP::Triangle_surface surface = surface_of(bundled_mesh("scorpion_low.obj"));
  const auto one = AP::medial_balls<CGAL::Sequential_tag>(surface, polar()),
             many = AP::medial_balls<CGAL::Parallel_if_available_tag>(surface, polar());
  ASSERT_EQ(one.size(), many.size());
  for(std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].center, many[i].center);
    EXPECT_EQ(one[i].radius, many[i].radius);
    EXPECT_EQ(one[i].contact, many[i].contact);
    EXPECT_EQ(one[i].spread, many[i].spread);
    EXPECT_EQ(one[i].scale_axis, many[i].scale_axis);
  }
}

} // namespace
