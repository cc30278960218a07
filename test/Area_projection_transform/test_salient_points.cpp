// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Salient points: shapes whose centres, axes and radii are known. Vertices lie on them to the last bits, so there is
// nothing that could make a fit less exact than rounding.

#include "shapes.h"

#include <CGAL/Area_projection_transform/salient_points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Salient_point;
using AP::Salient_point_options;
using AP::Salient_shape;
using AP::Side;
using AP::Vector_3;
using shapes::cylinder;
using shapes::icosphere;
using shapes::joined;
using shapes::pi;
using shapes::Soup;
using shapes::surface_of;

constexpr double exact = 1e-9; // rounding, times some thousand

std::vector<Salient_point> found_in(const Soup& soup, const Salient_point_options& options = {})
{
  return AP::salient_points(surface_of(soup), options);
}

Salient_point_options on_the(Side side)
{
  Salient_point_options options;
  options.side = side;
  return options;
}

double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(squared_distance(p, q));
}

double length(const Vector_3& v)
{
  return std::sqrt(v.squared_length());
}

/// a sphere, to the last bits.
void expect_sphere(const Salient_point& p, const Point_3& center, double radius)
{
  EXPECT_EQ(p.shape, Salient_shape::SPHERE);
  EXPECT_LT(distance(p.position, center), exact * radius);
  EXPECT_NEAR(p.radius, radius, exact * radius);
  EXPECT_LE(p.radius_low, radius);
  EXPECT_GE(p.radius_high, radius);
  EXPECT_LE(p.radius_high - p.radius_low, 1e-5 * radius);
  EXPECT_EQ(length(p.axis), 0);
}

/// a tube around the `z` axis, to the last bits; it need not be all there.
void expect_tube(const Salient_point& p, double radius)
{
  EXPECT_EQ(p.shape, Salient_shape::TUBE);
  EXPECT_NEAR(std::abs(p.axis.z()), 1, exact);
  EXPECT_NEAR(std::hypot(p.position.x(), p.position.y()), 0, exact * radius);
  EXPECT_NEAR(p.radius, radius, exact * radius);
  EXPECT_LE(p.radius_low, radius);
  EXPECT_GE(p.radius_high, radius);
  EXPECT_EQ(p.slope, 0);
  EXPECT_EQ(length(p.curvature), 0);
}

TEST(Salient_spheres, are_exact)
{
  const Point_3 center(1, -2, 3);
  const auto points = found_in(icosphere(3, center, 0.5));
  ASSERT_EQ(points.size(), 1u);
  const Salient_point& p = points.front();
  expect_sphere(p, center, 0.5);
  EXPECT_GT(p.observed_fraction, 0.97); // faces cover a little less than the sphere
  EXPECT_LE(p.observed_fraction, 1);
  EXPECT_FALSE(p.is_seen_from_one_side);
  EXPECT_GT(p.sphericity, 0.95);
  EXPECT_TRUE(std::isnan(p.length));
}

// The transform over 4πR² is largest at R0/(1+c), where it is (1+c)² for σ = c R: there the whole sphere is in the
// ball. The faces are up to 1 % nearer, and their area 1 % less.
TEST(Salient_spheres, have_the_intensity_of_the_closed_form)
{
  const auto points = found_in(icosphere(3));
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].scale, 2. / 3, 0.02 * 2 / 3);
  EXPECT_NEAR(points[0].intensity, 2.25, 0.04 * 2.25);
}

TEST(Salient_spheres, may_have_eighty_faces)
{
  const auto points = found_in(icosphere(1));
  ASSERT_EQ(points.size(), 1u);
  expect_sphere(points[0], Point_3(0, 0, 0), 1);
}

TEST(Salient_spheres, are_exact_with_half_of_the_faces)
{
  const auto points = found_in(shapes::thinned(icosphere(3), 0.5, 1));
  ASSERT_EQ(points.size(), 1u);
  expect_sphere(points[0], Point_3(0, 0, 0), 1);
  EXPECT_NEAR(points[0].observed_fraction, 0.5, 0.1);
}

TEST(Salient_spheres, are_exact_with_one_face_in_five_turned_over)
{
  Soup soup = icosphere(3);
  shapes::Random random(2);
  for(shapes::Triangle& t : soup.triangles)
    if(random() < 0.2)
      std::swap(t[1], t[2]);
  const auto points = found_in(soup);
  ASSERT_EQ(points.size(), 1u);
  expect_sphere(points[0], Point_3(0, 0, 0), 1);
}

TEST(Salient_spheres, may_be_half_a_sphere)
{
  const auto points = found_in(shapes::hemisphere(12));
  ASSERT_EQ(points.size(), 1u);
  expect_sphere(points[0], Point_3(0, 0, 0), 1);
  EXPECT_TRUE(points[0].is_seen_from_one_side);
  EXPECT_NEAR(points[0].observed_fraction, 0.5, 0.05);
}

TEST(Salient_spheres, may_touch)
{
  const auto points = found_in(joined(icosphere(3), icosphere(3, Point_3(1.5, 0, 0), 0.5)));
  ASSERT_EQ(points.size(), 2u);
  for(const Salient_point& p : points)
    p.radius > 0.7 ? expect_sphere(p, Point_3(0, 0, 0), 1)
                   : expect_sphere(p, Point_3(1.5, 0, 0), 0.5);
}

// A ball with a cavity: its surface faces into the cavity, whose centre is outside of it.
TEST(Salient_spheres, may_be_cavities)
{
  const Point_3 center(0.3, 0, 0);
  const Soup soup = joined(icosphere(4, Point_3(0, 0, 0), 1.5), flipped(icosphere(3, center, 0.5)));
  const auto inside = found_in(soup), outside = found_in(soup, on_the(Side::OUTSIDE));
  ASSERT_EQ(inside.size(), 1u);
  expect_sphere(inside[0], Point_3(0, 0, 0), 1.5);
  ASSERT_EQ(outside.size(), 1u);
  expect_sphere(outside[0], center, 0.5);
}

// Displacements of variance s² in each direction move points away from the centre by s²/r in the mean: 0.16 %, which
// is three standard errors of the mean of all seeds. It is corrected for.
TEST(Salient_spheres, are_right_in_the_mean_and_within_their_intervals)
{
  const int seeds = 10;
  double sum = 0, squares = 0;
  int covered = 0;
  for(int seed = 0; seed < seeds; ++seed) {
    const auto points = found_in(shapes::displaced(icosphere(3), 0.07, std::uint64_t(seed)));
    ASSERT_EQ(points.size(), 1u) << seed;
    ASSERT_EQ(points[0].shape, Salient_shape::SPHERE);
    const double error = points[0].radius - 1;
    sum += error;
    squares += error * error;
    covered += points[0].radius_low < 1 && points[0].radius_high > 1 ? 1 : 0;
    EXPECT_NEAR(points[0].residual, 0.07 / std::sqrt(3.), 0.3 * 0.07 / std::sqrt(3.));
  }
  const double mean = sum / seeds;
  const double deviation = std::sqrt((squares - seeds * mean * mean) / (seeds - 1));
  EXPECT_LT(std::abs(mean), 3 * deviation / std::sqrt(double(seeds)));
  EXPECT_LT(deviation, 3 * 0.04 / std::sqrt(642.)); // 642 vertices
  EXPECT_GE(covered, 7);                            // of 10, with a probability of 99.9 %
}

TEST(Salient_tubes, are_exact)
{
  const auto points = found_in(cylinder(32, 0.4, 3, true, 24));
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0],
              0.4 / std::cos(pi / 32)); // the faces touch the cylinder, the vertices lie outside
  EXPECT_NEAR(points[0].length, 3, 0.5);
  EXPECT_FALSE(points[0].is_seen_from_one_side);
  EXPECT_GT(points[0].observed_fraction, 0.8);
  EXPECT_LT(points[0].sphericity, 0.7);
}

TEST(Salient_tubes, may_be_open)
{
  const auto points = found_in(cylinder(32, 0.4, 3, false, 24));
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0], 0.4 / std::cos(pi / 32));
}

Soup half_a_tube()
{
  const auto is_behind = [](const Point_3& p) { return p.y() < 0; };
  return shapes::without_faces(cylinder(32, 0.4, 3, false, 24), is_behind);
}

TEST(Salient_tubes, may_be_half_a_tube)
{
  Salient_point_options options;
  options.largest_radius = 0.5;
  const auto points = found_in(half_a_tube(), options);
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0], 0.4 / std::cos(pi / 32));
  EXPECT_TRUE(points[0].is_seen_from_one_side);
  EXPECT_NEAR(points[0].observed_fraction, 0.5, 0.1);
}

// A box around half a tube is half as high as the whole one: the radius is its shortest side.
TEST(Salient_tubes, may_be_half_a_tube_of_which_nothing_is_known)
{
  const auto points = found_in(half_a_tube());
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0], 0.4 / std::cos(pi / 32));
}

// Facets that run from one end to the other, as engineers draw them: the vertices are at the ends.
TEST(Salient_tubes, may_be_made_of_long_facets)
{
  for(const bool is_closed : {false, true}) {
    const auto points = found_in(cylinder(32, 0.4, 3, is_closed, 1));
    ASSERT_EQ(points.size(), 1u);
    expect_tube(points[0], 0.4 / std::cos(pi / 32));
  }
}

// A prism of eight sides stands for the cylinder through its edges.
TEST(Salient_tubes, may_have_eight_sides)
{
  const auto points = found_in(cylinder(8, 0.4, 3, true, 1));
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0], 0.4 / std::cos(pi / 8));
}

/// a box with a hole from bottom to top, around the `z` axis.
Soup bored_box()
{
  const Soup box =
      shapes::translated(shapes::fine_box(Vector_3(2, 2, 3), 0.1), Vector_3(-1, -1, 0));
  const auto is_open = [](const Point_3& p) { return std::hypot(p.x(), p.y()) < 0.4; };
  const Soup bore = shapes::translated(cylinder(32, 0.4, 3, false, 24), Vector_3(0, 0, 1.5));
  return joined(shapes::without_faces(box, is_open), flipped(bore));
}

TEST(Salient_tubes, may_be_bores)
{
  const auto points = found_in(bored_box(), on_the(Side::OUTSIDE));
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0], 0.4 / std::cos(pi / 32));
  EXPECT_TRUE(found_in(bored_box()).empty());
}

TEST(Salient_tubes, with_a_hole_in_the_middle_are_one_tube)
{
  const auto is_hole = [](const Point_3& p) { return std::abs(p.z()) < 0.4; };
  const auto points = found_in(shapes::without_faces(cylinder(32, 0.5, 8, false, 64), is_hole));
  ASSERT_EQ(points.size(), 1u);
  expect_tube(points[0], 0.5 / std::cos(pi / 32));
  EXPECT_GT(points[0].length, 7);
  EXPECT_LT(std::abs(points[0].position.z()), 0.5);
}

// Two tubes of one axis, 4 apart: that is ten radii.
TEST(Salient_tubes, are_thinned_out_along_a_line)
{
  const Soup soup =
      joined(cylinder(32, 0.4, 3, false, 24),
             shapes::translated(cylinder(32, 0.4, 2, false, 16), Vector_3(0, 0, 6.5)));
  ASSERT_EQ(found_in(soup).size(), 2u);
  Salient_point_options options;
  options.tube_spacing = 5;
  EXPECT_EQ(found_in(soup, options).size(), 2u);
  options.tube_spacing = 20;
  const auto points = found_in(soup, options);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_LT(std::abs(points[0].position.z()), 1); // the longer one
}

// The mean over many seeds, as for spheres: a tube has half of the bias, s²/(2r).
TEST(Salient_tubes, are_right_in_the_mean_and_within_their_intervals)
{
  const int seeds = 8;
  const double truth = 1 / std::cos(pi / 32);
  double sum = 0, squares = 0;
  int covered = 0;
  for(int seed = 0; seed < seeds; ++seed) {
    const Soup soup = shapes::displaced(cylinder(32, 1, 5, false, 25), 0.1, std::uint64_t(seed));
    const auto points = found_in(soup);
    ASSERT_EQ(points.size(), 1u) << seed;
    ASSERT_EQ(points[0].shape, Salient_shape::TUBE) << seed;
    const double error = points[0].radius - truth;
    sum += error;
    squares += error * error;
    covered += points[0].radius_low < truth && points[0].radius_high > truth ? 1 : 0;
  }
  const double mean = sum / seeds;
  const double deviation = std::sqrt((squares - seeds * mean * mean) / (seeds - 1));
  EXPECT_LT(std::abs(mean), 3 * deviation / std::sqrt(double(seeds)));
  EXPECT_GE(covered, 5); // of 8, with a probability of 99.96 %
}

// Points of a tube of radius 1 displaced by d out or in, and by d to one side or the other, each of the four as often:
// their mean distance from the axis is 1 + d²/2 but for d⁴, and there is no chance in it.
TEST(Salient_tubes, are_corrected_for_what_displacements_add_to_the_radius)
{
  constexpr double d = 0.05;
  constexpr int n = 32;
  AP::Surfels points;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const double a = 2 * pi * i / n;
      const Vector_3 out(std::cos(a), std::sin(a), 0), aside(-std::sin(a), std::cos(a), 0);
      const Vector_3 p = (1 + (i % 2 ? d : -d)) * out + (j % 2 ? d : -d) * aside;
      points.push_back(Point_3(p.x(), p.y(), 5. * j / n), out, 10 * pi / (n * n),
                       std::uint32_t(points.size()));
    }
  const auto found = AP::salient_points(points);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].shape, Salient_shape::TUBE);
  EXPECT_NEAR(found[0].radius, 1, 0.1 * d * d / 2);
}

// The vertices of the cone are at 1 − z/4 from the axis.
TEST(Salient_cones, have_a_slope)
{
  const auto is_apex = [](const Point_3& p) { return p.z() > 3; };
  const auto points = found_in(shapes::without_faces(shapes::cone(48, 1, 4, 40), is_apex));
  ASSERT_EQ(points.size(), 1u);
  const Salient_point& p = points[0];
  EXPECT_EQ(p.shape, Salient_shape::CONE);
  EXPECT_NEAR(std::abs(p.axis.z()), 1, exact);
  EXPECT_NEAR(std::hypot(p.position.x(), p.position.y()), 0, exact);
  EXPECT_NEAR(p.slope * p.axis.z(), -0.25, exact);
  EXPECT_NEAR(p.radius, 1 - p.position.z() / 4, exact);
}

/// a tube around a circle of radius 3 about the `z` axis.
void expect_bend(const Salient_point& p, double radius)
{
  EXPECT_EQ(p.shape, Salient_shape::TUBE);
  const double ring = std::hypot(p.position.x(), p.position.y());
  EXPECT_NEAR(ring, 3, 1e-6);
  EXPECT_NEAR(p.position.z(), 0, 1e-6);
  EXPECT_NEAR(p.radius, radius, 1e-6);
  const Vector_3 inward = Vector_3(-p.position.x(), -p.position.y(), 0) / ring;
  EXPECT_NEAR(length(p.curvature - inward / 3), 0, 1e-6);
  EXPECT_NEAR(std::abs(p.axis * CGAL::cross_product(inward, Vector_3(0, 0, 1))), 1, 1e-6);
}

TEST(Salient_bends, have_the_curvature_of_their_axis)
{
  const auto points = found_in(shapes::torus_arc(3, 0.5, 2, 48, 32));
  ASSERT_EQ(points.size(), 1u);
  expect_bend(points[0], 0.5);
  EXPECT_NEAR(points[0].length, 6, 0.6);
}

TEST(Salient_bends, that_are_closed_are_one_tube)
{
  const auto points = found_in(shapes::torus(3, 0.5, 96, 24));
  ASSERT_EQ(points.size(), 1u);
  expect_bend(points[0], 0.5);
}

TEST(Salient_ellipsoids, are_no_spheres)
{
  for(const double stretch : {1.8, 1 / 1.8}) {
    const Point_3 center(1, 2, 3);
    const Soup soup = shapes::translated(
        shapes::moved(icosphere(4),
                      [&](const Point_3& p) { return Point_3(p.x(), p.y(), stretch * p.z()); }),
        center - CGAL::ORIGIN);
    const auto points = found_in(soup);
    ASSERT_EQ(points.size(), 1u) << stretch;
    EXPECT_EQ(points[0].shape, Salient_shape::OTHER);
    EXPECT_LT(distance(points[0].position, center), 1e-6);
    EXPECT_NEAR(points[0].radius, std::cbrt(stretch), 1e-6); // of a ball of the same volume
    EXPECT_NEAR(std::abs(points[0].axis.z()), stretch > 1 ? 1 : 0, 1e-6); // the longest
  }
}

TEST(Salient_points, are_the_strongest_first)
{
  const Soup soup =
      joined(shapes::translated(cylinder(32, 0.4, 3, true, 24), Vector_3(5, 0, 0)),
             joined(icosphere(3), shapes::translated(shapes::hemisphere(12), Vector_3(0, 4, 0))));
  const auto points = found_in(soup);
  ASSERT_EQ(points.size(), 3u);
  expect_sphere(points[0], Point_3(0, 0, 0), 1);
  expect_sphere(points[1], Point_3(0, 4, 0), 1);
  EXPECT_EQ(points[2].shape, Salient_shape::TUBE);
  EXPECT_NEAR(points[1].intensity, 0.5 * points[0].intensity, 0.1);
}

/// that there is nothing in boxes whose faces are cut into squares, on either side.
void expect_nothing_in_boxes(const std::vector<double>& edges)
{
  for(const Vector_3& size :
      {Vector_3(1, 1, 1), Vector_3(1, 1, 0.1), Vector_3(3, 2, 1), Vector_3(4, 1, 1)})
    for(const double edge : edges)
      for(const Side side : {Side::INSIDE, Side::OUTSIDE})
        for(const Salient_point& p : found_in(shapes::fine_box(size, edge), on_the(side)))
          ADD_FAILURE() << "a shape of kind " << int(p.shape) << " and radius " << p.radius
                        << " in a box of " << size << " in squares of " << edge;
}

// What is flat is not round.
TEST(Salient_points, are_not_found_in_what_is_flat)
{
  expect_nothing_in_boxes({10, 0.1}); // 10: one square a side
  EXPECT_TRUE(found_in(shapes::box(Point_3(0, 0, 0), Point_3(1, 2, 3))).empty());
  EXPECT_TRUE(found_in(shapes::plane_patch(2, 0, 30)).empty());
  EXPECT_TRUE(found_in(shapes::slab(2, 0.3)).empty());
}

// The corners and edges of few squares are as near to a sphere or a tube as noise would be; but there is no noise.
TEST(Salient_points, are_not_found_in_what_is_flat_and_coarse)
{
  expect_nothing_in_boxes({0.5, 0.3, 0.25, 0.2});
}

// A ball full of other surface is none. Cubes with half edges up to 0.34 are within 0.6 of the middle. One has 2.8 of area,
// which is 0.22 for each of the sphere around it, and less than 0.3; with one of 0.28 in it, 4.7, which is 0.37.
TEST(Salient_spheres, are_not_full_of_other_surface)
{
  const auto cube = [](double half) {
    return shapes::translated(shapes::fine_box(Vector_3(2 * half, 2 * half, 2 * half), half / 4),
                              Vector_3(-half, -half, -half));
  };
  const Soup around_one = joined(icosphere(3), cube(0.34));
  const auto points = found_in(around_one);
  ASSERT_EQ(points.size(), 1u);
  expect_sphere(points[0], Point_3(0, 0, 0), 1);
  EXPECT_TRUE(found_in(joined(around_one, cube(0.28))).empty());
}

} // namespace
