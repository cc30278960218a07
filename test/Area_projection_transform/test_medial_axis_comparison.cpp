// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The comparison of medial axes: measures of balls and lines for which they are known in closed form.

#include "balls_at.h"
#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_axis_comparison.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace {

using namespace shapes;
using AP::Medial_axes;
using AP::Medial_axes_options;
using AP::Medial_measures;
using AP::Medial_representation;
using Parallel = CGAL::Parallel_if_available_tag;

/// lines through points, each joined to the next.
Medial_representation polyline(const std::vector<Point_3>& points)
{
  Medial_representation result = balls_at(points, std::vector<double>(points.size(), 0.1));
  for(std::uint32_t i = 1; i < points.size(); ++i)
    result.edges.push_back({i - 1, i});
  return result;
}

const Medial_representation& axis_of(const Medial_axes& axes, const std::string& name)
{
  for(const Medial_representation& axis : axes.axes)
    if(axis.name == name)
      return axis;
  throw std::runtime_error("no axis is called " + name);
}

TEST(Spread_of_values, is_that_of_the_numbers)
{
  std::vector<double> numbers;
  for(int i = 100; i >= 0; --i)
    numbers.push_back(i);
  const AP::Spread_of_values spread = AP::spread_of(numbers);
  EXPECT_EQ(spread.mean, 50);
  EXPECT_EQ(spread.median, 50);
  EXPECT_EQ(spread.quantile_95, 95);
  EXPECT_EQ(spread.largest, 100);
  EXPECT_TRUE(std::isnan(AP::spread_of({}).largest));
}

TEST(Spread_of_values, counts_by_weights)
{
  // As if the 1 were there three times and the 7 not at all.
  const AP::Spread_of_values spread =
      AP::spread_of({5, 1, 2, 7, std::nan("")}, {0.5, 1.5, 0.5, 0, 1});
  EXPECT_NEAR(spread.mean, (3 * 1 + 2 + 5) / 5., 1e-15);
  EXPECT_EQ(spread.median, 1);
  EXPECT_EQ(spread.quantile_95, 5);
  EXPECT_EQ(spread.largest, 5);
  EXPECT_TRUE(std::isnan(AP::spread_of({1}, {0}).mean));
}

TEST(Axis_distances, tell_one_way_from_the_other)
{
  // The first lies at the height 0.3 above the left half of the second.
  const auto half = polyline({{0, 0.3, 0}, {0.2, 0.3, 0}, {1, 0.3, 0}});
  const auto whole = polyline({{0, 0, 0}, {2, 0, 0}});
  const double spacing = 0.001;
  const AP::Axis_distances distances = AP::axis_distances(half, whole, spacing);
  // Samples across are aside by at most half of the spacing, which adds its square over 2 · 0.3.
  EXPECT_NEAR(distances.there.largest, 0.3, 1e-6);
  EXPECT_NEAR(distances.there.mean, 0.3, 1e-6);
  EXPECT_NEAR(distances.back.largest, std::sqrt(1 + 0.09), spacing);
  // At the distance t beyond the end of the first it is √(t² + h²), and h before that.
  const double h = 0.3, root = std::sqrt(1 + h * h);
  const double beyond = 0.5 * (root + h * h * std::log((1 + root) / h)); // the integral of that
  EXPECT_NEAR(distances.back.mean, 0.5 * (h + beyond), 2 * spacing);
  EXPECT_NEAR(distances.back.quantile_95, std::sqrt(0.9 * 0.9 + h * h), 2 * spacing);
  EXPECT_EQ(distances.hausdorff(), distances.back.largest);
}

TEST(Axis_distances, know_what_is_between_vertices)
{
  Medial_representation sheet = balls_at({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {1, 1, 1});
  const auto above_the_middle = balls_at({{1, 1, 0.5}}, {1});
  EXPECT_NEAR(AP::axis_distances(above_the_middle, sheet, 0.05).there.largest, std::sqrt(2.25),
              1e-9);
  sheet.triangles = {{0, 1, 2}};
  EXPECT_NEAR(AP::axis_distances(above_the_middle, sheet, 0.05).there.largest, 0.5, 0.01);
  // No place of the triangle is farther from a sample than the spacing, and none of them is outside.
  const auto samples = AP::axis_samples(sheet, 0.1);
  for(double x = 0; x <= 3; x += 0.07)
    for(double y = 0; y <= 3 - x; y += 0.07)
      EXPECT_LT(AP::distances_from({Point_3(x, y, 0)}, samples).largest, 0.1);
  for(const Point_3& p : samples)
    EXPECT_TRUE(p.x() >= 0 && p.y() >= 0 && p.x() + p.y() <= 3 + 1e-12 && p.z() == 0);
}

TEST(Axis_distances, are_infinite_from_nothing)
{
  const auto something = balls_at({{0, 0, 0}}, {1});
  EXPECT_TRUE(std::isinf(AP::axis_distances(something, {}, 1).there.largest));
  EXPECT_TRUE(std::isnan(AP::axis_distances(something, {}, 1).back.largest));
}

TEST(Axis_distances, in_a_matrix_are_the_same)
{
  const std::vector<Medial_representation> axes{polyline({{0, 0, 0}, {1, 0, 0}}),
                                                polyline({{0, 1, 0}, {2, 0, 0}}),
                                                balls_at({{1, 1, 1}}, {1})};
  const auto matrix = AP::axis_distance_matrix<Parallel>(axes, 0.1);
  for(std::size_t i = 0; i < axes.size(); ++i)
    for(std::size_t j = 0; j < axes.size(); ++j) {
      const AP::Axis_distances expected = AP::axis_distances(axes[i], axes[j], 0.1);
      EXPECT_EQ(matrix[i][j].largest, expected.there.largest);
      EXPECT_EQ(matrix[i][j].mean, expected.there.mean);
      EXPECT_EQ(matrix[j][i].quantile_95, expected.back.quantile_95);
    }
}

TEST(Coverage, of_a_sphere_is_the_cap_within_the_ball)
{
  const AP::Triangle_surface sphere = surface_of(icosphere(5));
  // The ball at the height h reaches the angle θ on the unit sphere where 1 + h² - 2 h cos θ = (r + tolerance)².
  for(const double h : {0.3, 0.6})
    for(const double reach : {0.8, 1., 1.2}) {
      const double tolerance = 0.01;
      const double cosine = (1 + h * h - reach * reach) / (2 * h);
      const auto ball = balls_at({{0, 0, h}}, {reach - tolerance});
      // Of 20 000 places those along the rim, some hundreds, count wholly or not, and facets are 0.001 deeper.
      EXPECT_NEAR(AP::covered_part(ball, sphere, tolerance), (1 - cosine) / 2, 0.004);
    }
  EXPECT_EQ(AP::covered_part(balls_at({{0, 0, 0}}, {1}), sphere, 0.01), 1);
  EXPECT_EQ(AP::covered_part(balls_at({{0, 0, 0}}, {0.9}), sphere, 0.01), 0);
  EXPECT_EQ(AP::covered_part(Medial_representation(), sphere, 0.01), 0);
}

TEST(Medial_representation, names_balls_that_there_are)
{
  EXPECT_NE(complaint([] {
              AP::medial_representation("axis", std::vector<AP::Medial_ball>(2), {2});
            }).find("selected"),
            std::string::npos);
}

TEST(Medial_judge, measures_radii_and_centres)
{
  const AP::Triangle_surface sphere = surface_of(icosphere(5));
  const AP::Medial_judge<AP::Triangle_surface> judge(sphere, balls_at({{0, 0, 0}}, {1}), 0.01);
  const Medial_measures right = judge.measure(balls_at({{0, 0, 0}}, {1}));
  EXPECT_LT(right.radius_error.largest, 0.001); // facets
  EXPECT_EQ(right.off_centre.largest, 0);
  EXPECT_EQ(right.coverage, 1);
  EXPECT_NEAR(*right.volume.overlap(), 1, 0.005);
  EXPECT_EQ(right.reconstruction.missing.largest, 0);
  EXPECT_LT(right.reconstruction.protrusion->largest, 0.002);
  // Moved by 0.4, and as large as the sphere: 0.6 from the surface.
  const Medial_measures wrong = judge.measure<Parallel>(balls_at({{0, 0.4, 0}}, {1}));
  EXPECT_NEAR(wrong.radius_error.largest, 0.4, 0.001);
  EXPECT_NEAR(wrong.off_centre.median, 0.4, 0.001);
  EXPECT_NE(
      complaint([&] { AP::Medial_judge<AP::Triangle_surface>(sphere, {}, 0); }).find("tolerance"),
      std::string::npos);
}

TEST(Skeleton_representation, counts_pieces_and_loops)
{
  AP::Centerline_graph graph(7);
  for(std::size_t v = 0; v < 7; ++v) {
    graph[v].point = Point_3(double(v), 0, 0);
    graph[v].radius = double(v);
  }
  for(const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}, {2, 3}, {4, 5}})
    add_edge(std::size_t(a), std::size_t(b), graph); // a triangle with a tail, a pair, one alone
  const Medial_representation axis = AP::medial_representation("lines", graph);
  EXPECT_TRUE(*axis.topology == (AP::Betti_numbers{3, 1, 0}));
  EXPECT_EQ(axis.edges.size(), 5u);
  EXPECT_EQ(axis.radii[6], 6);
  EXPECT_EQ(axis.centers[6], Point_3(6, 0, 0));
}

TEST(Mean_curvature_skeleton, is_in_the_middle)
{
  const AP::Triangle_surface tube = surface_of(cylinder(24, 1, 12, true, 60));
  const Medial_representation skeleton = AP::mean_curvature_skeleton(tube);
  EXPECT_TRUE(*skeleton.topology == (AP::Betti_numbers{1, 0, 0}));
  for(std::size_t i = 0; i < skeleton.size(); ++i)
    if(std::abs(skeleton.centers[i].z()) < 4) {
      EXPECT_LT(std::hypot(skeleton.centers[i].x(), skeleton.centers[i].y()), 0.1);
      EXPECT_NEAR(skeleton.radii[i], 1, 0.1);
    }
  const auto ring = AP::mean_curvature_skeleton(surface_of(torus(1, 0.3, 60, 20)));
  EXPECT_TRUE(*ring.topology == (AP::Betti_numbers{1, 1, 0}));
}

TEST(Mean_curvature_skeleton, says_why_there_is_none)
{
  const auto expect = [](const AP::Triangle_surface& surface, const std::string& reason) {
    EXPECT_NE(AP::skeleton_obstacle(surface).find(reason), std::string::npos)
        << AP::skeleton_obstacle(surface);
    EXPECT_NE(complaint([&] { AP::mean_curvature_skeleton(surface); }).find(reason),
              std::string::npos);
  };
  expect(AP::Triangle_surface(), "no faces");
  expect(surface_of(cylinder(12, 1, 2, false)), "24 edges have one face only");
  expect(surface_of(joined(icosphere(1), icosphere(1, Point_3(9, 0, 0)))), "2 parts");
  expect(surface_of(joined(icosphere(2), flipped(icosphere(1, Point_3(0, 0, 0), 0.2)))), "2 parts");
  expect(surface_of(flipped(icosphere(1))), "inward");
  Soup one_over = icosphere(1);
  std::swap(one_over.triangles[0][0], one_over.triangles[0][1]);
  expect(surface_of(one_over), "turned over");
  Soup fin = icosphere(1);
  fin.points.emplace_back(3, 0, 0);
  const Triangle t = fin.triangles[0];
  for(int i = 0; i < 3; ++i) // a tetrahedron on a face that is still there
    fin.triangles.push_back(
        {t[std::size_t(i)], t[std::size_t((i + 1) % 3)], std::uint32_t(fin.points.size() - 1)});
  expect(surface_of(fin), "more than two faces");
  // An edge of a tetrahedron is cut in its middle on one side only, which a face without area makes up for.
  const Soup flat{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
                  {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}}};
  expect(surface_of(flat), "faces without area");
  // A closed mesh of the fewest faces is none of these.
  const Soup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                         {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  EXPECT_EQ(AP::skeleton_obstacle(surface_of(tetrahedron)), "");
  EXPECT_GT(AP::mean_curvature_skeleton(surface_of(tetrahedron)).size(), 0u);
  EXPECT_NE(complaint([] { AP::mean_curvature_skeleton(AP::Surfels()); }).find("mesh"),
            std::string::npos);
}

TEST(Medial_axes, of_a_torus_are_rings)
{
  const AP::Triangle_surface surface = surface_of(torus(1, 0.3, 80, 24));
  const Medial_axes axes = AP::medial_axes<Parallel>(surface);
  EXPECT_TRUE(axes.left_out.empty());
  std::vector<std::string> names;
  const auto& unpruned = axis_of(axes, "unpruned");
  const AP::Medial_judge<AP::Triangle_surface> judge(surface, unpruned, axes.tolerance);
  for(const Medial_representation& axis : axes.axes) {
    names.push_back(axis.name);
    EXPECT_TRUE(*axis.topology == (AP::Betti_numbers{1, 1, 0})) << axis.name;
    // All of them follow the ring of radius 1 up to a part of the tube's radius.
    for(const Point_3& p : axis.centers)
      EXPECT_LT(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()), 0.1 * 0.3) << axis.name;
    if(axis.name != "random") { // which has no more balls that are apart
      EXPECT_GE(judge.measure<Parallel>(axis).coverage, 0.9 - 1e-9) << axis.name;
    }
    EXPECT_GT(axis.seconds, 0);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"unpruned", "mapt", "mapt_refitted", "lambda", "scale_axis",
                                      "random", "covering", "centerlines", "skeleton"}));
  EXPECT_LT(axis_of(axes, "covering").size(), axis_of(axes, "mapt").size());
}

TEST(Medial_axes, have_as_many_balls_as_are_asked_for)
{
  Medial_axes_options options;
  options.number = 20;
  options.do_skeleton = false;
  const Medial_axes axes = AP::medial_axes<Parallel>(surface_of(bundled_mesh("hand.obj")), options);
  for(const std::string name : {"mapt", "lambda", "scale_axis", "random", "covering"})
    EXPECT_EQ(axis_of(axes, name).size(), 20u);
  EXPECT_EQ(complaint([&] { axis_of(axes, "unpruned"); }), "");
  EXPECT_TRUE(axes.left_out.empty()); // what was not asked for is not missed
}

TEST(Medial_axes, of_balls_that_there_are_are_the_same)
{
  const AP::Triangle_surface surface = surface_of(torus(1, 0.3, 40, 16));
  Medial_axes_options options;
  options.do_skeleton = false;
  const Medial_axes found = AP::medial_axes(surface, options);
  const Medial_axes given =
      AP::medial_axes(surface, AP::medial_balls(surface, options.balls), 1000, options);
  ASSERT_EQ(found.axes.size(), given.axes.size());
  for(std::size_t i = 0; i < found.axes.size(); ++i) {
    EXPECT_EQ(found.axes[i].centers, given.axes[i].centers);
    EXPECT_EQ(given.axes[i].seconds >= 1000, given.axes[i].name != "centerlines");
  }
}

TEST(Medial_axes, are_made_until_the_callback_answers_no)
{
  const AP::Triangle_surface surface = surface_of(torus(1, 0.3, 40, 16));
  Medial_axes_options options;
  options.do_skeleton = false;
  const std::vector<AP::Medial_ball> balls = AP::medial_balls(surface, options.balls);
  // There are seven selections of balls; the eighth question comes while centrelines are looked for, which are left out.
  for(const std::size_t most : {1u, 2u, 7u, 8u}) {
    std::size_t calls = 0;
    const std::function<bool(double)> callback = [&](double) { return ++calls < most; };
    const Medial_axes axes =
        AP::medial_axes(surface, balls, 0, options, CGAL::parameters::callback(callback));
    EXPECT_EQ(axes.axes.size(), std::min<std::size_t>(most, 7));
    EXPECT_TRUE(axes.left_out.empty());
    EXPECT_EQ(calls, most);
  }
  // Who always says yes changes nothing, and is told of all of the work.
  std::vector<double> fractions{0};
  const std::function<bool(double)> callback = [&](double fraction) {
    EXPECT_GE(fraction, fractions.back());
    fractions.push_back(fraction);
    return true;
  };
  const Medial_axes all = AP::medial_axes(surface, options, CGAL::parameters::callback(callback));
  EXPECT_NEAR(fractions.back(), 1, 1e-12);
  ASSERT_EQ(all.axes.size(), 8u);
  EXPECT_EQ(all.axes.back().centers, AP::medial_axes(surface, options).axes.back().centers);
}

TEST(Medial_axes, leave_out_what_cannot_be_made)
{
  const Medial_axes open = AP::medial_axes(surface_of(cylinder(16, 1, 6, false, 20)));
  ASSERT_EQ(open.left_out.size(), 1u);
  EXPECT_EQ(open.left_out[0].first, "skeleton");
  EXPECT_NE(open.left_out[0].second.find("open"), std::string::npos);
  const Medial_axes sphere = AP::medial_axes(surface_of(icosphere(2)));
  ASSERT_EQ(sphere.left_out.size(), 1u);
  EXPECT_EQ(sphere.left_out[0].first, "centerlines");
  const Medial_axes points =
      AP::medial_axes(AP::sample_surfels(surface_of(cylinder(16, 1, 6, true, 20)), 0.3));
  ASSERT_EQ(points.left_out.size(), 1u);
  EXPECT_NE(points.left_out[0].second.find("points"), std::string::npos);
  EXPECT_TRUE(AP::medial_axes(AP::Triangle_surface()).axes.empty());
}

TEST(Medial_axes, say_what_is_wrong)
{
  const AP::Triangle_surface surface = surface_of(icosphere(1));
  const auto with = [&](auto change) {
    Medial_axes_options options;
    change(options);
    return complaint([&] { AP::medial_axes(surface, options); });
  };
  EXPECT_NE(with([](auto& o) { o.coverage = 1.1; }).find("coverage"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.tolerance = 0; }).find("tolerance"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.balls.spacing = -1; }).find("spacing"), std::string::npos);
  EXPECT_NE(complaint([] { AP::axis_samples({}, 0); }).find("spacing"), std::string::npos);
}

} // namespace
