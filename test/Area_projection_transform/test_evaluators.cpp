// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The transform at points: the exact one against the closed forms of simple shapes, the sampled one
// against the exact one and against a plain sum.

#include "shapes.h"

#include <CGAL/Area_projection_transform/at_points.h>
#include <CGAL/Area_projection_transform/internal/triangle_disk.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>

#include <gtest/gtest.h>

#include <complex>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::pi;
using shapes::Soup;

constexpr double c = 0.5; // σ/R

double mapt(const Soup& soup, const Point_3& x, double radius, Side side = Side::INSIDE)
{
  const AP::Scale scale{radius, c * radius};
  return AP::Exact_evaluator(shapes::scale_space_of(soup), radius, side)(x, scale.sigma) *
         scale.normalization();
}

/// \brief the same sum over all triangles, without a tree and without what the library knows of
/// projected triangles.
double sum_over_triangles(const Soup& soup, const Point_3& x, double radius, double sigma)
{
  double sum = 0;
  for(const shapes::Triangle& t : soup.triangles) {
    const Point_3 &p = soup.points[t[0]], &q = soup.points[t[1]], &r = soup.points[t[2]];
    const Vector_3 n = CGAL::unit_normal(p, q, r);
    const Vector_3 e = (q - p) / std::sqrt((q - p).squared_length());
    const Vector_3 f = CGAL::cross_product(n, e);
    const double height = (p - radius * n - x) * n;
    if(std::abs(height) >= sigma)
      continue;
    std::array<std::complex<double>, 3> corners;
    for(std::size_t i = 0; i < 3; ++i) {
      const Vector_3 v = soup.points[t[i]] - x;
      corners[i] = {v * e, v * f};
    }
    sum += AP::internal::triangle_disk_area(corners, std::sqrt(sigma * sigma - height * height),
                                            std::sqrt(CGAL::squared_area(p, q, r)));
  }
  return sum;
}

// ---------------------------------------------------------------- the ladder of reference values

// The faces stay flat, so nothing is approximated.
TEST(Ladder, a_plane_reads_a_quarter_of_the_squared_ratio)
{
  for(const double radius : {0.3, 1., 2.5})
    EXPECT_NEAR(mapt(shapes::plane_patch(10, 0), Point_3(0.1, 0.2, -radius), radius), c * c / 4,
                1e-12);
}

TEST(Ladder, the_middle_of_a_slab_reads_half_the_squared_ratio)
{
  for(const double radius : {0.3, 1., 2.5})
    EXPECT_NEAR(mapt(shapes::slab(10, 2 * radius), Point_3(0.1, 0.2, 0), radius), c * c / 2, 1e-12);
}

// A face of an n-sided prism lands on a strip as wide as the face, 2 tan(π/n) R, about the axis. Both
// that and its larger area change the value by a multiple of (π/n)², 2.5e-4 for 200 sides.
TEST(Ladder, the_axis_of_a_cylinder_reads_the_ratio)
{
  const Soup cylinder = shapes::cylinder(200, 1, 12, false);
  for(const double z : {-3., 0., 2.345})
    EXPECT_NEAR(mapt(cylinder, Point_3(0, 0, z), 1), c, 0.005 * c);
}

// The mesh has 0.06 % less area than the sphere.
TEST(Ladder, the_centre_of_a_sphere_reads_one)
{
  const Point_3 center(3, -2, 1);
  EXPECT_NEAR(mapt(shapes::icosphere(5, center, 2), center, 2), 1, 0.005);
}

TEST(Ladder, the_centre_of_a_hemisphere_reads_a_half)
{
  EXPECT_NEAR(mapt(shapes::hemisphere(40), Point_3(0, 0, 0), 1), 0.5, 0.005 * 0.5);
}

// All of the surface lands within a face's width of the centre: what is left is the area of the mesh.
TEST(Ladder, the_centre_of_an_icosphere_holds_the_area_of_the_mesh)
{
  for(const int level : {2, 3, 4}) {
    const Point_3 center(0.3, 0.1, -0.7);
    const Soup sphere = shapes::icosphere(level, center, 1.7);
    const AP::Exact_evaluator evaluator(shapes::scale_space_of(sphere), 1.7, Side::INSIDE);
    EXPECT_NEAR(evaluator(center, c * 1.7) / sphere.area(), 1, 1e-8);
  }
}

// ---------------------------------------------------------------- off the matched radius

TEST(Off_radius, the_centre_of_a_sphere_reads_the_squared_ratio_of_the_radii)
{
  const Soup sphere = shapes::icosphere(5);
  // The faces lie up to 0.0004 inside of the sphere: radii at the very ends of the range are left out.
  for(const double radius : {0.668, 0.8, 1., 1.25, 1.6, 1.995})
    EXPECT_NEAR(mapt(sphere, Point_3(0, 0, 0), radius), 1 / (radius * radius),
                0.005 / (radius * radius))
        << radius;
  for(const double radius : {0.5, 0.66, 2.01, 3.})
    EXPECT_EQ(mapt(sphere, Point_3(0, 0, 0), radius), 0) << radius;
}

TEST(Off_radius, the_axis_of_a_cylinder_reads_the_length_of_a_chord)
{
  const Soup cylinder = shapes::cylinder(400, 1, 12, false);
  for(const double radius : {0.69, 0.75, 0.845, 1., 1.3, 1.7, 1.9}) {
    const double t = 1 / radius, expected = t * std::sqrt(c * c - (t - 1) * (t - 1));
    EXPECT_NEAR(mapt(cylinder, Point_3(0, 0, 0), radius), expected, 0.005 * expected) << radius;
  }
  for(const double radius : {0.6, 0.66, 2.01, 2.5})
    EXPECT_EQ(mapt(cylinder, Point_3(0, 0, 0), radius), 0) << radius;
}

// Beside the plane at the distance d, the ball meets the parallel plane in a disk of radius
// sqrt(σ² - (d - R)²).
TEST(Off_radius, the_neighbourhood_of_a_plane_reads_a_disk)
{
  const Soup plane = shapes::plane_patch(20, 0);
  for(const double depth : {0.4, 0.55, 0.9, 1., 1.2, 1.45, 1.6}) {
    const double squared = c * c - (depth - 1) * (depth - 1);
    EXPECT_NEAR(mapt(plane, Point_3(0.3, 0, -depth), 1), std::max(squared, 0.) / 4, 1e-12) << depth;
  }
}

// ---------------------------------------------------------------- sides

TEST(Sides, a_plane_is_projected_against_its_normal_inside_and_along_it_outside)
{
  const Soup plane = shapes::plane_patch(10, 0); // facing up
  EXPECT_NEAR(mapt(plane, Point_3(0, 0, -1), 1, Side::INSIDE), c * c / 4, 1e-12);
  EXPECT_NEAR(mapt(plane, Point_3(0, 0, 1), 1, Side::OUTSIDE), c * c / 4, 1e-12);
  EXPECT_EQ(mapt(plane, Point_3(0, 0, 1), 1, Side::INSIDE), 0);
  EXPECT_EQ(mapt(plane, Point_3(0, 0, -1), 1, Side::OUTSIDE), 0);
}

TEST(Sides, the_outside_is_the_inside_of_the_flipped_surface)
{
  const Soup blob = shapes::blob(3, 11);
  const AP::Exact_evaluator outside(shapes::scale_space_of(blob), 0.4, Side::OUTSIDE);
  const AP::Exact_evaluator inside(shapes::scale_space_of(shapes::flipped(blob)), 0.4,
                                   Side::INSIDE);
  shapes::Random random(1);
  for(int n = 0; n < 200; ++n) {
    const Point_3 x = CGAL::ORIGIN + 1.4 * random.direction();
    EXPECT_NEAR(outside(x, 0.2), inside(x, 0.2), 1e-12);
  }
}

// ---------------------------------------------------------------- the exact evaluator by itself

TEST(Exact_evaluator, agrees_with_the_sum_over_all_triangles)
{
  shapes::Random random(2);
  for(const Soup& soup : {shapes::blob(3, 1), shapes::torus(1, 0.4, 40, 20), shapes::cone(50, 1, 2),
                          shapes::box(Point_3(-1, -1, -1), Point_3(1, 1, 1))}) {
    const double area = soup.area();
    for(const double radius : {0.2, 0.5, 1.1}) {
      const AP::Exact_evaluator evaluator(shapes::scale_space_of(soup), radius, Side::INSIDE);
      for(int n = 0; n < 100; ++n) {
        const Point_3 x = random.point_in(CGAL::Bbox_3(-1.3, -1.3, -1.3, 1.3, 1.3, 1.3));
        const double sigma = random(0.05, 0.9) * radius;
        const double value = evaluator(x, sigma);
        ASSERT_NEAR(value, sum_over_triangles(soup, x, radius, sigma), 1e-12 * area);
        for(const auto set : AP::internal::available_instruction_sets()) {
          AP::internal::chosen_instruction_set() = set;
          ASSERT_EQ(evaluator(x, sigma), value) << AP::internal::name(set);
        }
      }
      EXPECT_NEAR(evaluator(Point_3(0, 0, 0), 100), area, 1e-12 * area); // everything at once
      EXPECT_EQ(evaluator(Point_3(50, 0, 0), 1), 0);
    }
  }
}

// Trees of one level and of several, with nodes that are not full.
TEST(Exact_evaluator, agrees_with_the_sum_over_all_triangles_for_any_number_of_them)
{
  shapes::Random random(3);
  Soup blob = shapes::blob(3, 1);
  for(const std::size_t size : {1280, 1000, 513, 512, 511, 65, 64, 63, 9, 8, 7, 1}) {
    blob.triangles.resize(size);
    const AP::Exact_evaluator evaluator(shapes::scale_space_of(blob), 0.5, Side::INSIDE);
    for(int n = 0; n < 30; ++n) {
      const Point_3 x = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
      const double sigma = random(0.05, 0.9);
      ASSERT_NEAR(evaluator(x, sigma), sum_over_triangles(blob, x, 0.5, sigma), 1e-12) << size;
    }
    EXPECT_NEAR(evaluator(Point_3(0, 0, 0), 100), blob.area(), 1e-12);
  }
}

// A place is rounded to 1e-16 of its distance: that moves the rim of the ball, which crosses a triangle over a
// length of at most its longest edge.
TEST(Exact_evaluator, knows_what_the_rim_of_a_ball_cuts_that_is_much_larger_than_the_surface)
{
  shapes::Random random(4);
  const Soup blob = shapes::blob(3, 1);
  const AP::Triangle_surface surface = shapes::surface_of(blob);
  const AP::Exact_evaluator evaluator(shapes::scale_space_of(blob), 0.5, Side::INSIDE);
  double edges = 0;
  for(std::size_t t = 0; t < surface.size(); ++t)
    edges += AP::internal::projected_triangle(surface, t, 0).longest_edge();
  for(const double far : {1e2, 1e4, 1e6, 1e8})
    for(int n = 0; n < 30; ++n) {
      const Point_3 x = CGAL::ORIGIN + far * random.direction();
      const double sigma = far + random(-1, 1);
      ASSERT_NEAR(evaluator(x, sigma), sum_over_triangles(blob, x, 0.5, sigma),
                  1e-15 * far * edges);
    }
}

// Seen from 2^40 times its size, a triangle is within a ball or not: the corners round to what may be any shape.
TEST(Flat_triangle, is_a_point_from_very_far_away)
{
  const AP::internal::Flat_triangle triangle({0, 0, 0}, {1, 0.2, -0.1}, {-0.3, 0.8, 0.4});
  for(const double far : {1e13, 1e88, 1e150})
    for(const Vector_3& direction :
        {Vector_3(1, 1, 1), Vector_3(0.3, -0.2, 0.9), triangle.x_axis}) {
      const double length = std::sqrt(direction.squared_length());
      const Point_3 center = CGAL::ORIGIN - far / length * direction;
      EXPECT_EQ(triangle.fraction_within(center, 0.8 * far), 0) << far;
      EXPECT_EQ(triangle.fraction_within(center, 1.2 * far), 1) << far;
      EXPECT_EQ(triangle.fraction_within(center, 1e-3), 0) << far;
    }
  EXPECT_EQ(triangle.fraction_within({0.1, 0.1, 0}, 1e150), 1);
}

TEST(Exact_evaluator, a_mixture_of_balls_is_the_weighted_sum_over_the_balls)
{
  const AP::Exact_evaluator evaluator(shapes::scale_space_of(shapes::blob(3, 4)), 0.5,
                                      Side::INSIDE);
  const std::vector<AP::Nested_ball> kernel{{1., 0.25}, {0.6, 0.35}, {0.3, 0.4}};
  shapes::Random random(5);
  for(int n = 0; n < 50; ++n) {
    const Point_3 x = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
    EXPECT_NEAR(evaluator(x, 0.3, kernel),
                0.25 * evaluator(x, 0.3) + 0.35 * evaluator(x, 0.18) + 0.4 * evaluator(x, 0.09),
                1e-12);
  }
}

// A plane at the distance R fills each shell of the ball by the area of a ring, so the kernel reads
// 2π ∫ k(r/σ) r dr = πσ² ∫ k(√u) du. For 1 - u that is half the disk; a stack of m balls of equal
// weight has its rims where the profile has the values (j + 1/2)/m, which is exact for a line in u.
TEST(Kernels, the_epanechnikov_kernel_reads_half_of_a_plane)
{
  const AP::Exact_evaluator evaluator(shapes::scale_space_of(shapes::plane_patch(10, 0)), 1,
                                      Side::INSIDE);
  for(const unsigned number : {1u, 2u, 8u, 50u}) {
    const AP::Epanechnikov_kernel_3 kernel{number};
    EXPECT_NEAR(evaluator(Point_3(0, 0, -1), 0.5, kernel.nested_balls()), pi * 0.25 / 2, 1e-12);
  }
}

// The lowered Gaussian: with f = exp(-k²/2), ∫ (exp(-k² u/2) - f) / (1 - f) du over [0, 1] is
// 2/k² - f/(1 - f). The balls are the midpoint rule for the inverse profile, whose slope changes by
// nearly 2/(k² f) over [0, 1]: it errs by 1/24 of that over m², 4/m² of the integral.
TEST(Kernels, the_gaussian_kernel_reads_its_integral_on_a_plane)
{
  const AP::Exact_evaluator evaluator(shapes::scale_space_of(shapes::plane_patch(10, 0)), 1,
                                      Side::INSIDE);
  const double floor = std::exp(-4.5), expected = pi * 0.25 * (2. / 9 - floor / (1 - floor));
  double previous_error = 1;
  for(const unsigned number : {4u, 8u, 16u, 32u}) {
    const AP::Gaussian_kernel_3 kernel{3., number};
    const double error =
        std::abs(evaluator(Point_3(0, 0, -1), 0.5, kernel.nested_balls()) - expected) / expected;
    EXPECT_LT(error, 4. / (number * number));
    EXPECT_LT(error, previous_error);
    previous_error = error;
  }
}

// ---------------------------------------------------------------- similarity

struct Probe
{
  Point_3 x;
  double radius, sigma;
};

std::vector<Probe> probes()
{
  shapes::Random random(6);
  std::vector<Probe> result;
  for(int n = 0; n < 60; ++n) {
    const Point_3 x = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
    const double radius = n % 3 == 0 ? 0.3 : n % 3 == 1 ? 0.6 : 1.;
    result.push_back({x, radius, random(0.2, 0.8) * radius});
  }
  return result;
}

/// expects that `soup` moved by `move`, which multiplies lengths by `factor`, reads the same.
template <class Move>
void expect_similar(const Soup& soup, Move move, double factor, double tolerance)
{
  const double area = soup.area();
  const auto original = shapes::scale_space_of(soup);
  const auto image = shapes::scale_space_of(shapes::moved(soup, move));
  double sum = 0;
  for(const Probe& probe : probes()) {
    const AP::Exact_evaluator before(original, probe.radius, Side::INSIDE);
    const AP::Exact_evaluator after(image, factor * probe.radius, Side::INSIDE);
    const double value = before(probe.x, probe.sigma);
    EXPECT_NEAR(after(move(probe.x), factor * probe.sigma) / (factor * factor), value,
                tolerance * area);
    sum += value;
  }
  EXPECT_GT(sum, area / 4); // the probes see the surface
}

TEST(Similarity, scaling_multiplies_areas_by_the_squared_factor)
{
  const Soup blob = shapes::blob(3, 7);
  for(const double factor : {1000., 1e-3, 1e6})
    expect_similar(
        blob, [=](const Point_3& p) { return CGAL::ORIGIN + factor * (p - CGAL::ORIGIN); }, factor,
        1e-12);
}

TEST(Similarity, exchanging_axes_changes_nothing_but_rounding)
{
  expect_similar(
      shapes::blob(3, 7), [](const Point_3& p) { return Point_3(p.y(), p.z(), p.x()); }, 1, 1e-12);
}

TEST(Similarity, rotation_changes_nothing_but_rounding)
{
  shapes::Random random(8);
  for(int n = 0; n < 3; ++n)
    expect_similar(shapes::blob(3, 7), shapes::Rotation{random.direction(), random(0, 6)}, 1,
                   1e-11);
}

// Coordinates of 1e6 are rounded to 1e-10, and normals of faces of size 0.1 turn by 1e-9. The rim of a
// ball cuts lines of length ~10 out of the surface: 1e-8 in area.
TEST(Similarity, translation_changes_nothing_but_rounding)
{
  expect_similar(
      shapes::blob(3, 7), [](const Point_3& p) { return p + Vector_3(1e6, -2e6, 5e5); }, 1, 1e-8);
}

// ---------------------------------------------------------------- the k-d tree evaluator

/// the projected samples, as the scale space hands them out.
AP::Projected_surfels projected(const AP::Constant_scale_space<AP::Triangle_surface>& surface,
                                double radius, double spacing)
{
  AP::Projected_surfels all;
  surface.project(radius, Side::INSIDE, spacing, [&](const AP::Projected_surfels& batch) {
    for(std::size_t i = 0; i < batch.size(); ++i)
      all.push_back(batch.positions[i], batch.areas[i], batch.covariances[i]);
  });
  return all;
}

TEST(Kd_tree_evaluator, agrees_with_the_sum_over_all_projected_surfels)
{
  shapes::Random random(9);
  for(const Soup& soup : {shapes::blob(3, 2), shapes::cylinder(60, 0.5, 2, true)}) {
    const auto surface = shapes::scale_space_of(soup);
    const double area = soup.area();
    for(const double radius : {0.3, 0.7}) {
      const AP::Projected_surfels all = projected(surface, radius, 0.05);
      const AP::Kd_tree_evaluator evaluator(surface, radius, Side::INSIDE, 0.05);
      EXPECT_EQ(evaluator.number_of_surfels(), all.size());
      for(int n = 0; n < 100; ++n) {
        const Point_3 x = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
        const double sigma = random(0.1, 0.5);
        double sum = 0;
        for(std::size_t i = 0; i < all.size(); ++i)
          if(CGAL::squared_distance(x, all.positions[i]) <= sigma * sigma)
            sum += all.areas[i];
        ASSERT_NEAR(evaluator(x, sigma), sum, 1e-12 * area);
      }
    }
  }
}

// Coordinates and distances are small integers, so that nothing is rounded.
TEST(Kd_tree_evaluator, the_rim_belongs_to_the_ball)
{
  AP::Surfels surfels;
  surfels.push_back(Point_3(3, 4, 1), Vector_3(0, 0, 1), 1., 0);   // lands at distance 5
  surfels.push_back(Point_3(-5, 0, 1), Vector_3(0, 0, 1), 10., 1); // lands at distance 5
  surfels.push_back(Point_3(0, 6, 1), Vector_3(0, 0, 1), 100., 2); // lands at distance 6
  const AP::Kd_tree_evaluator evaluator(AP::Constant_scale_space<AP::Surfels>(surfels), 1,
                                        Side::INSIDE, 0.1);
  const Point_3 x(0, 0, 0);
  EXPECT_EQ(evaluator(x, 5), 11);
  EXPECT_EQ(evaluator(x, std::nextafter(5., 0.)), 0);
  EXPECT_EQ(evaluator(x, 6), 111);
}

// A surfel is in or out where a triangle is cut: halving the spacing divides the error by about
// 2^1.5 (the rim crosses fewer and smaller surfels, whose errors are independent).
TEST(Kd_tree_evaluator, comes_close_to_the_exact_value_as_the_spacing_shrinks)
{
  const auto surface = shapes::scale_space_of(shapes::blob(2, 3));
  const double radius = 0.6, sigma = 0.3;
  const AP::Exact_evaluator exact(surface, radius, Side::INSIDE);
  std::vector<Point_3> places;
  std::vector<double> expected;
  shapes::Random random(10);
  for(int n = 0; n < 400; ++n) {
    places.push_back(random.point_in(CGAL::Bbox_3(-0.7, -0.7, -0.7, 0.7, 0.7, 0.7)));
    expected.push_back(exact(places.back(), sigma));
  }
  std::vector<double> errors;
  for(const double spacing : {0.08, 0.04, 0.02, 0.01}) {
    const AP::Kd_tree_evaluator sampled(surface, radius, Side::INSIDE, spacing);
    std::vector<double> values;
    for(const Point_3& x : places)
      values.push_back(sampled(x, sigma));
    errors.push_back(shapes::relative_rms(values, expected));
  }
  EXPECT_LT(errors.back(), 0.002);
  const double order = std::log2(errors.front() / errors.back()) / 3;
  EXPECT_GT(order, 1.2);
  EXPECT_LT(order, 1.9);
}

// ---------------------------------------------------------------- many queries

TEST(Evaluate_at_points, answers_each_query_as_an_evaluator_of_its_radius_does)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 5));
  std::vector<AP::Query> queries;
  for(const Probe& probe : probes())
    queries.push_back({probe.x, {probe.radius, probe.sigma}});
  int evaluators = 0;
  const auto areas =
      AP::evaluate_at_points<CGAL::Parallel_if_available_tag>(queries, [&](const AP::Scale& scale) {
        ++evaluators;
        return AP::Exact_evaluator(surface, scale.radius, Side::INSIDE);
      });
  EXPECT_EQ(evaluators, 3); // one for each radius
  ASSERT_EQ(areas.size(), queries.size());
  for(std::size_t q = 0; q < queries.size(); ++q) {
    const AP::Scale& scale = queries[q].scale;
    EXPECT_EQ(areas[q], AP::Exact_evaluator(surface, scale.radius, Side::INSIDE)(queries[q].point,
                                                                                 scale.sigma));
  }
  const auto by_tree = AP::evaluate_at_points(queries, [&](const AP::Scale& scale) {
    return AP::Kd_tree_evaluator(surface, scale.radius, Side::INSIDE, 0.01);
  });
  EXPECT_LT(shapes::relative_rms(by_tree, areas), 0.01);
  EXPECT_TRUE(AP::evaluate_at_points({}, [&](const AP::Scale& scale) {
                return AP::Exact_evaluator(surface, scale.radius, Side::INSIDE);
              }).empty());
}

// ---------------------------------------------------------------- errors

TEST(Evaluators, name_the_argument_that_is_out_of_range)
{
  const auto surface = shapes::scale_space_of(shapes::icosphere(0));
  EXPECT_EQ(shapes::complaint([&] { AP::Exact_evaluator(surface, 0, Side::INSIDE); }),
            "radius is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { AP::Exact_evaluator(surface, NAN, Side::INSIDE); }),
            "radius is nan: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { AP::Kd_tree_evaluator(surface, -1, Side::INSIDE, 0.1); }),
            "radius is -1: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { AP::Kd_tree_evaluator(surface, 1, Side::INSIDE, 0); }),
            "spacing is 0: must be positive and finite");

  const auto exact = [&](const AP::Scale& scale) {
    return AP::Exact_evaluator(surface, scale.radius, Side::INSIDE);
  };
  const Point_3 x(0, 0, 0);
  EXPECT_EQ(shapes::complaint([&] {
              AP::evaluate_at_points({{x, {1, 1}}, {x, {-2, 1}}}, exact);
            }),
            "radius of query 1 is -2: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] {
              AP::evaluate_at_points({{x, {1, INFINITY}}}, exact);
            }),
            "sigma of query 0 is inf: must be positive and finite");
}

TEST(Evaluators, refuse_interpolated_normals_where_triangles_must_stay_flat)
{
  const Soup sphere = shapes::icosphere(1);
  const AP::Constant_scale_space surface(AP::surface_from_triangle_soup(
      sphere.points, sphere.triangles, AP::parameters::use_interpolated_normals(true)));
  EXPECT_EQ(shapes::complaint([&] { AP::Exact_evaluator(surface, 1, Side::INSIDE); }),
            "surface has interpolated normals: exact evaluation needs a constant normal on each "
            "triangle");
}

TEST(Kernels, refuse_to_be_made_of_nothing)
{
  EXPECT_EQ(shapes::complaint([] { AP::Epanechnikov_kernel_3{0}.nested_balls(); }),
            "number_of_balls is 0: must be at least 1");
  EXPECT_EQ(shapes::complaint([] {
              AP::Gaussian_kernel_3{3., 0}.nested_balls();
            }),
            "number_of_balls is 0: must be at least 1");
  EXPECT_EQ(shapes::complaint([] { AP::Gaussian_kernel_3{-1.}.nested_balls(); }),
            "cutoff is -1: must be positive");
}

TEST(Evaluators, find_nothing_where_there_is_no_surface)
{
  const AP::Constant_scale_space nothing{AP::Triangle_surface()};
  EXPECT_EQ(AP::Exact_evaluator(nothing, 1, Side::INSIDE)(Point_3(0, 0, 0), 1), 0);
  EXPECT_EQ(AP::Kd_tree_evaluator(nothing, 1, Side::INSIDE, 0.1)(Point_3(0, 0, 0), 1), 0);
}

} // namespace
