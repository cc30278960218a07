// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Medial balls: of shapes whose medial axis is known, their weights, and what is selected of them.

#include "shapes.h"

#include <CGAL/Area_projection_transform/IO/medial_balls_PLY.h>
#include <CGAL/Area_projection_transform/medial_balls.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numeric>
#include <set>

namespace {

using namespace shapes;
using AP::Medial_ball;
using AP::Medial_ball_options;
using AP::Medial_weight;
using Parallel = CGAL::Parallel_if_available_tag;

double quantile(std::vector<double> values, double part)
{
  const auto place = values.begin() + std::ptrdiff_t(part * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double length(const Vector_3& v)
{
  return std::sqrt(v.squared_length());
}

std::vector<std::size_t> all_of(const std::vector<Medial_ball>& balls)
{
  return AP::select_by_weight(balls, Medial_weight::RADIUS, 0);
}

TEST(Medial_balls, of_points_on_a_sphere_are_the_sphere)
{
  const auto balls = AP::medial_balls<Parallel>(fibonacci_sphere(3000));
  ASSERT_EQ(balls.size(), 3000u);
  for(const Medial_ball& ball : balls) {
    // The ball that touches at p, with the normal of the sphere, and passes through any other point is the sphere.
    EXPECT_NEAR(ball.radius, 1, 1e-9);
    EXPECT_LT(length(ball.center - CGAL::ORIGIN), 1e-9);
    EXPECT_NEAR(ball.refitted_radius, 1, 1e-9);
    // All of the area votes; what the steps of thinning leave is less than one step, (0.16 r)² of 4π.
    EXPECT_NEAR(ball.mapt, 1, 0.0021);
    // The mean squared distance from the centre, which is the centroid but for some steps.
    EXPECT_NEAR(ball.spread, 1, 0.005);
    // Contacts are 0.16 radii apart: the cap that none is in has no more than 0.16 / √2.
    EXPECT_NEAR(ball.lambda, 1, 0.0064);
    EXPECT_GT(ball.angle, 180 - 9.2);
  }
  EXPECT_EQ(AP::covered_part(balls, {0}, fibonacci_sphere(3000), 1e-6), 1);
}

TEST(Medial_balls, of_a_spherical_mesh_are_the_sphere)
{
  const auto balls = AP::medial_balls<Parallel>(surface_of(icosphere(4)));
  std::vector<double> centers, radii;
  for(const Medial_ball& ball : balls) {
    centers.push_back(length(ball.center - CGAL::ORIGIN));
    radii.push_back(std::abs(ball.radius - 1));
    EXPECT_LT(length(ball.refitted_center - CGAL::ORIGIN), 0.001);
    EXPECT_NEAR(ball.mapt, 1, 0.01);
  }
  EXPECT_EQ(balls.size(), 5120u);
  EXPECT_LT(quantile(centers, 0.95), 0.01);
  EXPECT_LT(quantile(radii, 0.95), 0.01);
}

TEST(Medial_balls, of_a_capped_cylinder_are_on_its_axis_and_cones)
{
  // Radius 1, z from -3 to 3: the axis for |z| < 2, and cones of 45 degrees from its ends to the rims.
  const auto balls = AP::medial_balls<Parallel>(surface_of(cylinder(64, 1, 6, true, 60)));
  std::vector<double> off_axis, radii, mapt;
  for(const Medial_ball& ball : balls) {
    const double rho = std::hypot(ball.center.x(), ball.center.y());
    const double height = 3 - std::abs(ball.center.z());
    if(ball.radius > 0.2) { // a few edges: there the rim is a chain of facets
      off_axis.push_back(std::min(std::hypot(rho, std::max(1 - height, 0.)),
                                  std::abs(1 - rho - height) / std::sqrt(2.)) /
                         ball.radius);
      radii.push_back(std::abs(ball.radius - std::min(1 - rho, height)) / ball.radius);
    }
    if(std::abs(ball.refitted_center.z()) < 1.2) {
      // All voters of the kernel's half-length c R are there: MAPT is c.
      mapt.push_back(std::abs(ball.mapt - 0.5));
      EXPECT_NEAR(ball.spread, std::sqrt(1 + 0.25 / 3), 0.03); // of a ring of length 2 c R
      EXPECT_NEAR(ball.lambda, 1, 0.02);
    }
  }
  ASSERT_GT(mapt.size(), 1000u);
  EXPECT_LT(quantile(off_axis, 0.95), 0.01);
  EXPECT_LT(quantile(radii, 0.95), 0.01);
  EXPECT_LT(quantile(mapt, 0.95), 0.05); // rims of the thinned samples
}

TEST(Medial_balls, of_a_torus_are_on_its_ring)
{
  const auto balls = AP::medial_balls<Parallel>(surface_of(torus(1, 0.3, 160, 48)));
  std::vector<double> centers, radii;
  for(const Medial_ball& ball : balls) {
    centers.push_back(
        std::hypot(std::hypot(ball.center.x(), ball.center.y()) - 1, ball.center.z()));
    radii.push_back(std::abs(ball.radius - 0.3));
  }
  EXPECT_LT(quantile(centers, 0.95), 0.01 * 0.3);
  EXPECT_LT(quantile(radii, 0.95), 0.01 * 0.3);
}

TEST(Medial_balls, of_a_box_are_as_large_as_the_distance_from_its_faces)
{
  for(const Soup& soup :
      {fine_box(Vector_3(8, 8, 2), 0.2), box(Point_3(0, 0, 0), Point_3(8, 8, 2))}) {
    const auto balls = AP::medial_balls<Parallel>(surface_of(soup));
    std::vector<double> errors, walls;
    for(const Medial_ball& ball : balls) {
      std::array<double, 3> d{std::min(ball.center.x(), 8 - ball.center.x()),
                              std::min(ball.center.y(), 8 - ball.center.y()),
                              std::min(ball.center.z(), 2 - ball.center.z())};
      std::sort(d.begin(), d.end());
      if(ball.radius > 0.5)
        errors.push_back(std::abs(ball.radius - d[0]) / ball.radius);
      if(d[1] > 2) { // away from the four narrow faces
        EXPECT_NEAR(ball.radius, 1, 0.02);
        EXPECT_NEAR(ball.mapt, 0.125, 0.015);
        EXPECT_GT(ball.angle, 165);
      }
    }
    ASSERT_GT(errors.size(), 500u);
    EXPECT_LT(quantile(errors, 0.95), 0.02);
  }
}

TEST(Medial_balls, between_walls_have_half_of_their_distance)
{
  Medial_ball_options options;
  options.spacing = 0.1;
  for(const double thickness : {0.3, 1.}) {
    const auto balls = AP::medial_balls(surface_of(slab(4, thickness)), options);
    ASSERT_GT(balls.size(), 2000u);
    for(const Medial_ball& ball : balls) {
      // The sample across is aside by no more than about the spacing.
      EXPECT_GE(ball.radius, thickness / 2 * (1 - 1e-12));
      EXPECT_LE(ball.radius, thickness / 2 * (1 + 0.01 / (thickness * thickness)));
      EXPECT_LE(ball.lambda, ball.radius);
      EXPECT_GE(ball.lambda, thickness / 2 * (1 - 1e-9));
      // Normals are all the same but for the sign, but voters of both walls tell where the middle is.
      EXPECT_NEAR(ball.refitted_radius, thickness / 2, 1e-9);
    }
  }
}

TEST(Medial_balls, of_the_outside_are_those_of_the_inside_of_the_surface_turned_over)
{
  const Soup hollow = flipped(icosphere(3));
  Medial_ball_options inside, outside;
  outside.side = AP::Side::OUTSIDE;
  // One sample for each face: where larger ones are cut depends on the order of their corners.
  inside.spacing = outside.spacing = 1;
  const auto expected = AP::medial_balls(surface_of(icosphere(3)), inside);
  const auto balls = AP::medial_balls(surface_of(hollow), outside);
  ASSERT_EQ(balls.size(), expected.size());
  for(std::size_t i = 0; i < balls.size(); ++i)
    EXPECT_NEAR(balls[i].radius, expected[i].radius, 1e-6);
  // Outside of a convex shape there is no ball at all.
  EXPECT_TRUE(AP::medial_balls(surface_of(icosphere(3)), outside).empty());
}

TEST(Medial_balls, are_empty_but_for_what_they_see_at_less_than_the_stop_angle)
{
  const AP::Triangle_surface hand = surface_of(bundled_mesh("hand.obj"));
  const Medial_ball_options options;
  const AP::internal::Medial_samples samples(hand, options);
  const auto balls = AP::medial_balls<Parallel>(hand, options);
  ASSERT_GT(balls.size(), samples.size() / 2);
  std::vector<double> depths;
  for(std::size_t b = 0; b < balls.size(); b += 10) {
    double nearest = std::numeric_limits<double>::max();
    for(const auto& p : samples.positions)
      nearest = std::min(nearest, (p - AP::internal::to_eigen(balls[b].center)).norm());
    depths.push_back(1 - nearest / balls[b].radius);
  }
  // A sample that is seen at the angle θ is within by at most 1 - cos(θ/2), and one between those that are looked
  // at, 0.1 radii apart, by about (0.1 / 2)² / 2 more if the surface is smooth.
  const double most = 1 - std::cos(10 * pi / 180);
  EXPECT_LT(quantile(depths, 0.95), most + 0.002);
  EXPECT_LT(quantile(depths, 1), 0.1);
}

TEST(Medial_balls, stand_noise_when_they_are_refitted)
{
  Medial_ball_options options;
  options.stop_angle = 45;
  // Edges are 0.07 long.
  const auto balls =
      AP::medial_balls<Parallel>(surface_of(displaced(icosphere(4), 0.006, 1)), options);
  std::vector<double> raw, refitted;
  for(const Medial_ball& ball : balls) {
    raw.push_back(length(ball.center - CGAL::ORIGIN));
    refitted.push_back(length(ball.refitted_center - CGAL::ORIGIN));
  }
  // Thousands of voters, each off by 0.006 or so, and their normals by 0.1: the mean of them by a hundredth of that.
  EXPECT_LT(quantile(refitted, 0.95), 0.01);
  EXPECT_LT(10 * quantile(refitted, 0.5), quantile(raw, 0.5));
}

// A sample stands for (0.16 R)² of area, which is 0.002 of the sphere. Of those on the rim of what votes, which is hardly
// longer than 2π R and has 40 of them, each counts by half of itself too much or too little, by chance: by 2 √40 · 0.001 in
// 95 %, and by 40 · 0.001 at most. The rest of the tolerance is for smooth normals instead of those of the facets.
TEST(Medial_balls, have_the_transform_of_the_exact_evaluator)
{
  const AP::Triangle_surface surface = surface_of(blob(4, 3));
  const AP::Constant_scale_space scale_space(surface);
  const auto balls = AP::medial_balls<Parallel>(surface);
  std::vector<double> errors;
  for(std::size_t b = 0; b < balls.size(); b += balls.size() / 100) {
    const Medial_ball& ball = balls[b];
    const AP::Scale scale{ball.refitted_radius, 0.5 * ball.refitted_radius};
    const AP::Exact_evaluator exact(scale_space, scale.radius, AP::Side::INSIDE);
    errors.push_back(
        std::abs(ball.mapt - exact(ball.refitted_center, scale.sigma) * scale.normalization()));
  }
  EXPECT_LT(quantile(errors, 0.95), 0.02);
  EXPECT_LT(quantile(errors, 1), 0.05);
}

TEST(Medial_balls, belong_to_the_scale_axis_up_to_the_factor_at_which_one_covers_them)
{
  const auto balls = AP::medial_balls<Parallel>(surface_of(blob(3, 5)));
  const auto is_swallowed = [&](const Medial_ball& ball, double s) {
    return std::any_of(balls.begin(), balls.end(), [&](const Medial_ball& other) {
      return other.radius > ball.radius &&
             length(other.center - ball.center) <= s * (other.radius - ball.radius);
    });
  };
  for(std::size_t b = 0; b < balls.size(); b += 20) {
    const double s = balls[b].scale_axis;
    if(std::isfinite(s)) {
      EXPECT_TRUE(is_swallowed(balls[b], s * (1 + 1e-9)));
    }
    EXPECT_FALSE(is_swallowed(balls[b], std::isfinite(s) ? s * (1 - 1e-9) : 1e9));
  }
  // The largest one.
  EXPECT_TRUE(std::any_of(balls.begin(), balls.end(),
                          [](const Medial_ball& b) { return std::isinf(b.scale_axis); }));
}

TEST(Medial_balls, follow_the_surface)
{
  const Soup soup = blob(4, 7);
  const Vector_3 shift(30, -10, 5);
  const Rotation turn{Vector_3(2. / 3, 1. / 3, 2. / 3), 1.1};
  const auto balls = AP::medial_balls<Parallel>(surface_of(soup));
  const auto larger = AP::medial_balls<Parallel>(surface_of(scaled(soup, 4)));
  const auto turned = AP::medial_balls<Parallel>(
      surface_of(moved(soup, [&](const Point_3& p) { return turn(p) + shift; })));
  ASSERT_EQ(balls.size(), larger.size());
  ASSERT_EQ(balls.size(), turned.size());
  for(std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_NEAR(larger[i].radius, 4 * balls[i].radius, 1e-9);
    EXPECT_NEAR(larger[i].mapt, balls[i].mapt, 1e-9);
    EXPECT_NEAR(larger[i].spread, 4 * balls[i].spread, 1e-9);
    EXPECT_NEAR(larger[i].lambda, 4 * balls[i].lambda, 1e-6);
    EXPECT_NEAR(larger[i].angle, balls[i].angle, 1e-6);
    // Coordinates around 30 are rounded to 4e-15, what is computed of them grows that by the inverse of angles.
    EXPECT_LT(length(turned[i].center - (turn(balls[i].center) + shift)), 1e-9);
    EXPECT_LT(length(turned[i].refitted_center - (turn(balls[i].refitted_center) + shift)), 1e-9);
    EXPECT_NEAR(turned[i].mapt, balls[i].mapt, 1e-9);
    EXPECT_NEAR(turned[i].spread, balls[i].spread, 1e-9);
    EXPECT_NEAR(turned[i].lambda, balls[i].lambda, 1e-6);
    EXPECT_NEAR(turned[i].angle, balls[i].angle, 1e-6);
  }
}

TEST(Medial_balls, are_the_same_for_any_number_of_threads_and_any_kind_of_mesh)
{
  const Soup soup = bundled_mesh("scorpion_low.obj");
  const auto expected = AP::medial_balls<CGAL::Sequential_tag>(surface_of(soup));
  const auto expect_same = [&](const std::vector<Medial_ball>& balls) {
    ASSERT_EQ(balls.size(), expected.size());
    for(std::size_t i = 0; i < balls.size(); ++i) {
      const Medial_ball &a = balls[i], &b = expected[i];
      ASSERT_TRUE(a.center == b.center && a.radius == b.radius && a.mapt == b.mapt &&
                  a.spread == b.spread && a.lambda == b.lambda && a.angle == b.angle &&
                  a.scale_axis == b.scale_axis && a.refitted_center == b.refitted_center &&
                  a.source == b.source && a.contact_source == b.contact_source)
          << i;
    }
  };
  expect_same(AP::medial_balls<Parallel>(surface_of(soup)));
  const Soup closed = icosphere(3);
  const auto of_soup = AP::medial_balls(surface_of(closed));
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const auto of_mesh = AP::medial_balls(mesh_of<Mesh>(closed));
  const auto of_polyhedron =
      AP::medial_balls(mesh_of<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>(closed));
  EXPECT_EQ(of_mesh.size(), of_soup.size());
  EXPECT_EQ(of_polyhedron.size(), of_soup.size());
}

TEST(Medial_balls, see_the_surface_that_single_faces_are_missing_of)
{
  // All of the area votes, at the centre: what is missing is missing from MAPT, unless others stand for it.
  const Soup sphere = icosphere(4);
  for(const double share : {0.7, 0.5, 0.3}) {
    const AP::Triangle_surface holed = surface_of(thinned(sphere, share, 7));
    Medial_ball_options options;
    std::vector<double> compensated, raw;
    for(const Medial_ball& ball : AP::medial_balls<Parallel>(holed, options))
      compensated.push_back(ball.mapt);
    options.compensate = false;
    for(const Medial_ball& ball : AP::medial_balls<Parallel>(holed, options))
      raw.push_back(ball.mapt);
    const double left = holed.total_area() / (4 * pi);
    EXPECT_NEAR(left, share, 0.03);
    EXPECT_NEAR(quantile(raw, 0.5), left, 0.01);
    // The faces that keep their areas are not those whose cells would be smaller.
    EXPECT_NEAR(quantile(compensated, 0.5), 1, 0.02) << share;
  }
}

TEST(Medial_balls, do_not_guess_what_was_in_a_large_hole)
{
  const Soup half = without_faces(icosphere(4), [](const Point_3& p) { return p.z() > 0; });
  const AP::Triangle_surface surface = surface_of(half);
  const double left = surface.total_area() / (4 * pi);
  // Cells go beyond the rim by no more than the radius of a disk as large as a face of 4π / 5120: 0.028.
  std::vector<double> mapt;
  for(const Medial_ball& ball : AP::medial_balls<Parallel>(surface))
    mapt.push_back(ball.mapt);
  EXPECT_GT(quantile(mapt, 0.5), left - 0.005);
  EXPECT_LT(quantile(mapt, 0.5), left + 0.028 / 2);
}

TEST(Medial_balls, of_closed_surfaces_have_nothing_to_compensate)
{
  Medial_ball_options options;
  const AP::Triangle_surface closed = surface_of(unmerged(blob(3, 1)));
  const auto balls = AP::medial_balls(closed, options);
  options.compensate = false;
  const auto raw = AP::medial_balls(closed, options);
  ASSERT_EQ(balls.size(), raw.size());
  for(std::size_t i = 0; i < balls.size(); ++i)
    EXPECT_EQ(balls[i].mapt, raw[i].mapt);
}

TEST(Medial_balls, of_nothing_are_none)
{
  EXPECT_TRUE(AP::medial_balls(AP::Triangle_surface()).empty());
  EXPECT_TRUE(AP::medial_balls(AP::Surfels()).empty());
  EXPECT_TRUE(AP::medial_balls(
                  surface_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)}, {{0, 1, 2}}}))
                  .empty());
  AP::Surfels same;
  for(std::uint32_t i = 0; i < 10; ++i)
    same.push_back(Point_3(1, 2, 3), Vector_3(0, 0, i % 2 == 0 ? 1 : -1), i < 9 ? 1 : 0, i);
  EXPECT_TRUE(AP::medial_balls(same).empty());
  // A sheet that is meshed on both sides, without any thickness.
  for(const Medial_ball& ball : AP::medial_balls(surface_of(slab(1, 0))))
    EXPECT_TRUE(std::isfinite(ball.radius) && ball.radius > 0);
}

TEST(Medial_balls, say_what_is_wrong)
{
  const AP::Triangle_surface surface = surface_of(icosphere(1));
  const auto with = [&](auto change) {
    Medial_ball_options options;
    change(options);
    return complaint([&] { AP::medial_balls(surface, options); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(with([](auto& o) { o.spacing = 0; }).find("spacing"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.stop_angle = 0; }).find("stop_angle"), std::string::npos);
  EXPECT_NE(with([&](auto& o) { o.crease_angle = nan; }).find("crease_angle"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.sigma_ratio = 1; }).find("sigma_ratio"), std::string::npos);
  const auto of = [&](const Point_3& p, const Vector_3& n, double area) {
    AP::Surfels surfels;
    surfels.push_back(p, n, area, 0);
    return complaint([&] { AP::medial_balls(surfels); });
  };
  EXPECT_NE(of(Point_3(nan, 0, 0), Vector_3(1, 0, 0), 1).find("positions[0]"), std::string::npos);
  EXPECT_NE(of(Point_3(0, 0, 0), Vector_3(2, 0, 0), 1).find("normals[0]"), std::string::npos);
  EXPECT_NE(of(Point_3(0, 0, 0), Vector_3(1, 0, 0), -1).find("areas[0]"), std::string::npos);
  EXPECT_NE(complaint([&] { AP::select_covering({}, surface, 0); }).find("tolerance"),
            std::string::npos);
  EXPECT_NE(complaint([&] { AP::select_random({}, 1, 0, -1); }).find("suppression"),
            std::string::npos);
  EXPECT_NE(complaint([&] { AP::IO::medial_balls_PLY({}, {0}); }).find("kept"), std::string::npos);
}

// A surface of a few needles needs no more samples than one of 8000 faces, six for each at most.
TEST(Medial_balls, of_long_thin_things_are_not_more_than_of_others)
{
  for(const double width : {1., 1e-3, 1e-7}) {
    const auto balls = AP::medial_balls<Parallel>(
        surface_of(shapes::moved(shapes::cylinder(4, 1, 1, true, 1), [=](const Point_3& p) {
          return Point_3(width * p.x(), width * p.y(), 1000 * p.z());
        })));
    EXPECT_LT(balls.size(), 6u * 8000u * 2u)
        << width; // the estimate of pieces is good to a factor of two
  }
}

// Places on the surface are bounded, too: a vertex far away made 30 million of 20 000.
// The spikes have next to no area and most of the samples: large balls must not look at all of them.
TEST(Thinned_samples, are_few_for_large_balls_when_a_vertex_is_far_away)
{
  for(const double far : {1e3, 1e6, 1e9}) {
    Soup sphere = icosphere(3);
    sphere.points[100] = Point_3(far, 0, 0);
    const AP::internal::Medial_samples samples(surface_of(sphere), {});
    const AP::internal::Thinned_samples thinned(samples);
    EXPECT_LT(thinned.at(far).size(), 100u);
    for(double spacing = far; spacing > 1e-3; spacing /= 2) {
      const std::vector<double>& areas = thinned.at(spacing).areas;
      EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.) /
                      std::accumulate(samples.areas.begin(), samples.areas.end(), 0.),
                  1, 1e-12);
    }
    // The sphere is told apart in the midst of it.
    EXPECT_GT(thinned.at(0.1).size(), 500u);
  }
}

TEST(Selected_balls, are_asked_for_no_more_places_on_long_thin_things)
{
  for(const double far : {1e3, 1e9}) {
    Soup soup = icosphere(2);
    soup.points[0] = CGAL::ORIGIN + far * (soup.points[0] - CGAL::ORIGIN);
    const AP::internal::Covered_surface places(surface_of(soup), 20000, 0.01);
    EXPECT_LT(places.size(), 2u * (6u * 20000u + soup.triangles.size())) << far;
    EXPECT_NEAR(places.total_area() / surface_of(soup).total_area(), 1, 1e-9);
  }
}

TEST(Medial_balls, tell_their_progress_and_stop_when_they_are_told_to)
{
  const AP::Triangle_surface hand = surface_of(bundled_mesh("hand.obj"));
  double last = 0;
  const auto all = AP::medial_balls<Parallel>(
      hand, {}, CGAL::parameters::callback(std::function<bool(double)>([&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
      })));
  EXPECT_NEAR(last, 1, 1e-9);
  const auto some = AP::medial_balls(
      hand, {},
      CGAL::parameters::callback(std::function<bool(double)>([](double) { return false; })));
  EXPECT_FALSE(some.empty());
  EXPECT_LE(some.size(), 256u); // one block of samples
  EXPECT_GT(all.size(), 10 * some.size());
}

TEST(Selected_balls, are_apart_and_the_strongest)
{
  const auto balls = AP::medial_balls<Parallel>(surface_of(bundled_mesh("hand.obj")));
  const auto expect_apart = [&](const std::vector<std::size_t>& selected) {
    for(std::size_t i = 0; i < selected.size(); ++i)
      for(std::size_t j = 0; j < i; ++j) {
        const Medial_ball &a = balls[selected[i]], &b = balls[selected[j]];
        EXPECT_GE(length(a.center - b.center), 0.6 * std::min(a.radius, b.radius) * (1 - 1e-12));
      }
  };
  const auto strongest = AP::select_strongest(balls, Medial_weight::RADIAL_MAPT, 50);
  ASSERT_EQ(strongest.size(), 50u);
  expect_apart(strongest);
  for(std::size_t i = 1; i < strongest.size(); ++i)
    EXPECT_GE(AP::weight_of(balls[strongest[i - 1]], Medial_weight::RADIAL_MAPT),
              AP::weight_of(balls[strongest[i]], Medial_weight::RADIAL_MAPT));
  const auto random = AP::select_random(balls, 50, 3);
  expect_apart(random);
  EXPECT_EQ(random, AP::select_random(balls, 50, 3));
  EXPECT_NE(random, AP::select_random(balls, 50, 4));
}

TEST(Selected_balls, that_cover_leave_nothing_and_are_few)
{
  const AP::Triangle_surface hand = surface_of(bundled_mesh("hand.obj"));
  const CGAL::Bbox_3 box = hand.bbox();
  const double tolerance = 0.005 * length(Vector_3(box.xmax() - box.xmin(), box.ymax() - box.ymin(),
                                                   box.zmax() - box.zmin()));
  const auto balls = AP::medial_balls<Parallel>(hand);
  const auto covering = AP::select_covering(balls, hand, tolerance);
  EXPECT_LT(covering.size(), balls.size() / 10);
  const double most = AP::covered_part(balls, all_of(balls), hand, tolerance);
  EXPECT_GT(most, 0.99);
  // Another sampling of the surface than that which was covered.
  EXPECT_GT(AP::covered_part(balls, covering, hand, tolerance), most - 0.01);
  // With 50 balls: coverage grows with their number, and whoever covers greedily is ahead.
  const std::vector<std::size_t> fifty(covering.begin(), covering.begin() + 50);
  EXPECT_EQ(fifty, AP::select_covering(balls, hand, tolerance, 50));
  const double part = AP::covered_part(balls, fifty, hand, tolerance);
  for(const Medial_weight weight :
      {Medial_weight::IMPORTANCE, Medial_weight::MAPT, Medial_weight::RADIAL_MAPT,
       Medial_weight::LAMBDA, Medial_weight::SCALE_AXIS, Medial_weight::RADIUS})
    EXPECT_GT(part,
              AP::covered_part(balls, AP::select_strongest(balls, weight, 50), hand, tolerance));
}

TEST(Selected_balls, by_importance_leave_out_a_bump)
{
  // A sphere with a bump of a tenth of its size, of the same curvature everywhere but there.
  const Soup bumpy = moved(icosphere(5), [](const Point_3& p) {
    const double distance = length(p - Point_3(1, 0, 0));
    return p + 0.05 * std::exp(-50 * distance * distance) * (p - CGAL::ORIGIN);
  });
  const auto balls = AP::medial_balls<Parallel>(surface_of(bumpy));
  double farthest = 0;
  for(const Medial_ball& ball : balls)
    farthest = std::max(farthest, length(ball.refitted_center - CGAL::ORIGIN));
  EXPECT_GT(farthest, 0.5); // a branch to the bump
  // The ball of the branch at the distance d from the centre has the radius 1 - d, and the voters of the sphere are those
  // that land within half of that: a cap of the half-angle θ with 2 d sin(θ/2) = (1 - d) / 2. Its spread is the root of
  // 1 - cos⁴(θ/2), which is 0.8 at d = 0.283.
  const auto kept = AP::select_by_weight(balls, Medial_weight::IMPORTANCE, 0.8);
  EXPECT_GT(kept.size(), balls.size() / 2);
  for(const std::size_t i : kept)
    EXPECT_LT(length(balls[i].refitted_center - CGAL::ORIGIN), 0.32);
}

TEST(Medial_balls_file, has_a_vertex_for_each_ball)
{
  const auto balls = AP::medial_balls(surface_of(icosphere(1)));
  ASSERT_GT(balls.size(), 10u);
  const auto elements = AP::IO::medial_balls_PLY(balls, {0, 3});
  ASSERT_EQ(elements.size(), 1u);
  EXPECT_EQ(elements[0].size(), balls.size());
  std::vector<std::string> names;
  for(const auto& property : elements[0].properties())
    names.push_back(property.name);
  names.resize(9);
  EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "z", "radius", "mapt", "lambda", "angle",
                                             "scale_axis", "kept"}));
  EXPECT_EQ(AP::IO::medial_balls_PLY(balls, {0, 3}, true)[0].size(), 2u);
}

} // namespace
