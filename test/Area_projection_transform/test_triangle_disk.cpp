// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The area of a triangle within a disk, on which all exact evaluation rests: the scalar function against
// quadrature, and the kernel against the scalar function.

#include "shapes.h"

#include <CGAL/Area_projection_transform/internal/triangle_disk.h>

#define CGAL_AREA_PROJECTION_KERNEL "test_triangle_disk_impl.h"
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <complex>

namespace {

using shapes::pi;
using Complex = std::complex<double>;
using Corners = std::array<Complex, 3>;

double area_of(const Corners& c)
{
  return 0.5 * std::imag(std::conj(c[1] - c[0]) * (c[2] - c[0]));
}

double within_disk(const Corners& corners, double radius)
{
  return CGAL::Area_projection::internal::triangle_disk_area(corners, radius, area_of(corners));
}

struct Case
{
  Corners corners;
  double radius;
};

Corners translated(const Corners& c, Complex by)
{
  return {c[0] + by, c[1] + by, c[2] + by};
}

/// the length of the part of the horizontal line at height `y` within the triangle and the disk.
double chord(const Corners& corners, double radius, double y)
{
  double low = radius, high = -radius;
  for(int i = 0; i < 3; ++i) {
    const Complex p = corners[std::size_t(i)], q = corners[std::size_t((i + 1) % 3)];
    if((p.imag() < y) == (q.imag() < y))
      continue;
    const double t = (y - p.imag()) / (q.imag() - p.imag());
    const double x = p.real() + t * (q.real() - p.real());
    low = std::min(low, x);
    high = std::max(high, x);
  }
  const double half = std::sqrt(std::max(radius * radius - y * y, 0.));
  return std::max(std::min(high, half) - std::max(low, -half), 0.);
}

/// \brief the same area by adaptive quadrature of the chords over their height.
///
/// With `y = radius sin(angle)` the integrand has no vertical tangents. It is smooth but for kinks at
/// the heights of the corners and of the points where edges cross the circle: it is cut there.
double by_quadrature(const Corners& corners, double radius)
{
  std::vector<double> angles{-pi / 2, pi / 2};
  const auto cut_at = [&](double y) {
    if(std::abs(y) < radius)
      angles.push_back(std::asin(y / radius));
  };
  for(int i = 0; i < 3; ++i) {
    const Complex p = corners[std::size_t(i)], d = corners[std::size_t((i + 1) % 3)] - p;
    cut_at(p.imag());
    const double middle = -std::real(std::conj(p) * d) / std::norm(d);
    const double squared = (radius * radius - std::norm(p + middle * d)) / std::norm(d);
    if(squared > 0)
      for(const double t : {middle - std::sqrt(squared), middle + std::sqrt(squared)})
        cut_at(p.imag() + t * d.imag());
  }
  std::sort(angles.begin(), angles.end());
  double sum = 0;
  for(std::size_t i = 0; i + 1 < angles.size(); ++i)
    if(angles[i] < angles[i + 1])
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [&](double angle) {
            return radius * std::cos(angle) * chord(corners, radius, radius * std::sin(angle));
          },
          angles[i], angles[i + 1], 5, 1e-12);
  return sum;
}

Corners random_triangle(shapes::Random& random, double extent)
{
  Corners corners;
  for(Complex& p : corners) {
    const double x = random(-extent, extent);
    p = {x, random(-extent, extent)};
  }
  if(area_of(corners) < 0)
    std::swap(corners[1], corners[2]);
  return corners;
}

// The pieces are analytic, and the sum of a few of them is rounded a few times. Between the heights
// of two corners that nearly agree, a rounded height still finds the edge up to 1e-16 times its slope.
constexpr double tolerance = 1e-11;

TEST(Triangle_disk, agrees_with_adaptive_quadrature_on_random_triangles)
{
  shapes::Random random(1);
  int partial = 0;
  for(int n = 0; n < 3000; ++n) {
    const Corners corners = random_triangle(random, n % 2 ? 1.5 : 4.);
    const double area = within_disk(corners, 1.);
    ASSERT_NEAR(area, by_quadrature(corners, 1.), tolerance) << "triangle " << n;
    partial += area > 1e-3 && area < area_of(corners) - 1e-3 && area < pi - 1e-3;
  }
  EXPECT_GT(partial, 1000); // most of them are the cases that matter
}

TEST(Triangle_disk, agrees_with_adaptive_quadrature_on_slivers)
{
  shapes::Random random(2);
  for(int n = 0; n < 1000; ++n) {
    Corners corners = random_triangle(random, 2.);
    // The third corner comes to lie close to the line through the others.
    const double t = random(-0.5, 1.5), height = std::pow(10., -random(1, 9));
    const Complex along = corners[1] - corners[0];
    corners[2] = corners[0] + t * along + height * Complex(0, 1) * along;
    ASSERT_NEAR(within_disk(corners, 1.), by_quadrature(corners, 1.), tolerance)
        << "triangle " << n << " of height " << height;
  }
}

TEST(Triangle_disk, a_disk_within_the_triangle_counts_fully)
{
  const Corners corners{Complex(-10, -5), Complex(10, -5), Complex(0, 15)};
  for(const double radius : {1e-9, 1e-3, 1., 4.})
    EXPECT_NEAR(within_disk(corners, radius), pi * radius * radius, 1e-14 * radius * radius);
}

TEST(Triangle_disk, a_triangle_within_the_disk_counts_fully)
{
  shapes::Random random(3);
  for(int n = 0; n < 1000; ++n) {
    const Corners corners = random_triangle(random, 0.7); // corners within 0.99
    ASSERT_NEAR(within_disk(corners, 1.), area_of(corners), 1e-15);
  }
}

TEST(Triangle_disk, nothing_is_common_to_what_is_apart)
{
  shapes::Random random(4);
  for(int n = 0; n < 1000; ++n) {
    const Corners corners =
        translated(random_triangle(random, 1.), std::polar(2.5, random(0, 2 * pi)));
    ASSERT_EQ(within_disk(corners, 1.), 0.); // the corners are more than 2.5 - sqrt(2) away
  }
}

TEST(Triangle_disk, tangent_edges_neither_add_nor_remove)
{
  // An equilateral triangle with its incircle; turned, so that the touching points are rounded.
  for(int n = 0; n < 360; ++n) {
    Corners corners;
    for(int i = 0; i < 3; ++i)
      corners[std::size_t(i)] = std::polar(2., n * pi / 180 + 2 * pi * i / 3);
    ASSERT_NEAR(within_disk(corners, 1.), pi, 1e-7) << n; // a cut by 1e-16 costs (1e-16)^(3/4)
    // A triangle on the other side of such an edge.
    const Corners outside{corners[1], corners[0], -2.5 * corners[2]};
    ASSERT_NEAR(within_disk(outside, 1.), 0, 1e-7) << n;
  }
}

TEST(Triangle_disk, a_corner_at_the_centre_cuts_a_sector)
{
  for(int n = 1; n < 180; ++n) {
    const double angle = n * pi / 180;
    // The far corners are outside of the disk, and so is the edge between them.
    const double reach = 2. / std::cos(angle / 2);
    const Corners corners{Complex(0, 0), Complex(reach, 0), std::polar(reach, angle)};
    ASSERT_NEAR(within_disk(corners, 1.), angle / 2, 1e-14) << n;
  }
}

TEST(Triangle_disk, an_edge_through_the_centre_leaves_half)
{
  const Corners corners{Complex(-5, 0), Complex(5, 0), Complex(0, 9)};
  EXPECT_NEAR(within_disk(corners, 1.), pi / 2, 1e-14);
}

// Two triangles share out a convex quadrilateral: their parts add up to its part.
TEST(Triangle_disk, the_parts_of_a_cut_triangle_add_up)
{
  shapes::Random random(5);
  for(int n = 0; n < 2000; ++n) {
    const Corners corners = random_triangle(random, 3.);
    const double t = random();
    const Complex cut = corners[1] + t * (corners[2] - corners[1]);
    const double parts = within_disk({corners[0], corners[1], cut}, 1.) +
                         within_disk({corners[0], cut, corners[2]}, 1.);
    ASSERT_NEAR(parts, within_disk(corners, 1.), 1e-12) << n;
  }
}

// Moving the triangle by δ changes the area by at most the length of the boundary times δ: here δ is
// the rounding of the coordinates. Jumps would show as errors of order 1.
TEST(Triangle_disk, is_continuous_where_corners_and_edges_touch_the_circle)
{
  for(int n = 0; n < 72; ++n) {
    const Complex rim = std::polar(1., n * pi / 36), tangent = rim * Complex(0, 1);
    const std::vector<Corners> touching{
        {rim, 2. * rim - tangent, 2. * rim + tangent},                 // a corner, from outside
        {rim, -0.1 * rim + 0.2 * tangent, -0.1 * rim - 0.2 * tangent}, // a corner, from inside
        {rim - tangent, 2. * rim, rim + tangent},                      // an edge, from outside
        {rim + tangent, -3. * rim, rim - tangent},                     // an edge, from inside
    };
    for(Corners corners : touching) {
      if(area_of(corners) < 0)
        std::swap(corners[1], corners[2]);
      const double expected = by_quadrature(corners, 1.);
      for(const double delta : {0., 1e-16, -1e-16, 1e-15, -1e-15, 1e-12, -1e-12})
        ASSERT_NEAR(within_disk(translated(corners, delta * rim), 1.), expected, 1e-7)
            << n << ' ' << delta;
    }
  }
}

TEST(Triangle_disk, scales_with_the_square_of_the_length)
{
  shapes::Random random(6);
  for(int n = 0; n < 500; ++n) {
    const Corners corners = random_triangle(random, 2.);
    const double area = within_disk(corners, 1.);
    for(const double factor : {1e-6, 1e6}) {
      const Corners larger{factor * corners[0], factor * corners[1], factor * corners[2]};
      ASSERT_NEAR(within_disk(larger, factor) / (factor * factor), area, 1e-12);
    }
  }
}

// The limits of radius zero and infinity.
TEST(Triangle_disk, grows_with_the_radius_from_nothing_to_the_triangle)
{
  shapes::Random random(7);
  for(int n = 0; n < 200; ++n) {
    const Corners corners = random_triangle(random, 1.);
    double before = 0;
    for(double radius = 1e-6; radius < 1e6; radius *= 1.3) {
      const double area = within_disk(corners, radius);
      ASSERT_GE(area, before - 1e-13);
      ASSERT_LE(area, std::min(area_of(corners), (1 + 1e-15) * pi * radius * radius));
      before = area;
    }
    ASSERT_NEAR(before, area_of(corners), 1e-15);
  }
}

/// the same by the formula of Green in fifty digits, of which differences of huge sectors may lose thirty.
double in_fifty_digits(const Corners& corners, double radius)
{
  using Number = boost::multiprecision::cpp_bin_float_50;
  using Point = std::array<Number, 2>;
  const auto cross = [](const Point& u, const Point& v) {
    return Number(u[0] * v[1] - u[1] * v[0]);
  };
  const auto dot = [](const Point& u, const Point& v) { return Number(u[0] * v[0] + u[1] * v[1]); };
  const Number squared_radius = Number(radius) * radius;
  const auto sector = [&](const Point& u, const Point& v) {
    return Number(squared_radius * atan2(cross(u, v), dot(u, v)));
  };
  Number doubled = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const Complex &from = corners[i], &to = corners[(i + 1) % 3];
    const Point p{from.real(), from.imag()}, q{to.real(), to.imag()};
    const Point d{q[0] - p[0], q[1] - p[1]};
    const Number a = dot(d, d), b = dot(p, d), c = dot(p, p) - squared_radius;
    const Number discriminant = b * b - a * c;
    const Number root = sqrt(discriminant > 0 ? discriminant : Number(0));
    const Number enter = std::max<Number>((-b - root) / a, 0);
    const Number leave = std::min<Number>((-b + root) / a, 1);
    if(!(enter < leave)) {
      doubled += sector(p, q);
      continue;
    }
    const Point in{p[0] + enter * d[0], p[1] + enter * d[1]};
    const Point out{p[0] + leave * d[0], p[1] + leave * d[1]};
    doubled += sector(p, in) + cross(in, out) + sector(out, q);
  }
  return double(doubled / 2);
}

/// triangles about a unit wide at the rim of a disk that may be much larger.
std::vector<Case> cases_at_the_rim(double radius)
{
  shapes::Random random(11);
  std::vector<Case> cases;
  while(cases.size() < 1600) {
    const Corners corners = random_triangle(random, 1.);
    if(area_of(corners) > 0.01)
      cases.push_back(
          {translated(corners, std::polar(radius + random(-1, 1), random(0, 2 * pi))), radius});
  }
  return cases;
}

// Where a rim of this radius passes is rounded, to 1e-16 of it, and it crosses at most two edges.
TEST(Triangle_disk, errs_by_roundings_of_the_radius_times_the_longest_edge)
{
  for(const double radius : {1e1, 1e3, 1e6, 1e9, 1e11})
    for(const auto& [corners, r] : cases_at_the_rim(radius))
      ASSERT_NEAR(within_disk(corners, r), in_fifty_digits(corners, r), 2e-15 * radius) << radius;
}

// ---------------------------------------------------------------- the kernel

/// sixteen triangles and disks as the kernel wants them.
template <class Number>
struct Seen_triangles
{
  static constexpr int size = 16;
  Number length[3][16], cosine[3][16], sine[3][16];
  Number start[3][16], end[3][16], height[3][16];
  Number squared_radius[16];

  void set(std::size_t lane, const Corners& corners, double radius)
  {
    const auto edge = [&](std::size_t i) { return corners[(i + 1) % 3] - corners[i % 3]; };
    for(std::size_t i = 0; i < 3; ++i) {
      const double l = std::abs(edge(i)), next = std::abs(edge(i + 1));
      const Complex along = edge(i) / l, from = std::conj(along) * corners[i];
      length[i][lane] = Number(l);
      cosine[i][lane] = Number(std::real(std::conj(edge(i)) * edge(i + 1)) / (l * next));
      sine[i][lane] = Number(2 * area_of(corners) / (l * next));
      start[i][lane] = Number(from.real());
      end[i][lane] = Number(from.real() + l);
      height[i][lane] = Number(-from.imag());
    }
    squared_radius[lane] = Number(radius * radius);
  }
};

struct Way_along
{
  template <class Number>
  static void areas(const Seen_triangles<Number>& triangles, Number* areas)
  {
    CGAL_AREA_PROJECTION_DISPATCHED(areas_along_the_edges, triangles, areas);
  }
};

struct Way_between
{
  template <class Number>
  static void areas(const Seen_triangles<Number>& triangles, Number* areas)
  {
    CGAL_AREA_PROJECTION_DISPATCHED(areas_between_the_ends, triangles, areas);
  }
};

/// \brief the largest error of the kernel over all instruction sets, which must give the same bits.
/// \pre the number of cases is a multiple of 16
template <class Number, class Way>
double largest_error(const std::vector<Case>& cases)
{
  using namespace CGAL::Area_projection::internal;
  double largest = 0;
  for(std::size_t first = 0; first < cases.size(); first += 16) {
    Seen_triangles<Number> triangles;
    for(std::size_t lane = 0; lane < 16; ++lane)
      triangles.set(lane, cases[first + lane].corners, cases[first + lane].radius);
    std::array<Number, 16> areas, others;
    Way::areas(triangles, areas.data());
    for(const Instruction_set set : available_instruction_sets()) {
      chosen_instruction_set() = set;
      Way::areas(triangles, others.data());
      EXPECT_EQ(others, areas) << name(set);
    }
    for(std::size_t lane = 0; lane < 16; ++lane) {
      const auto& [corners, radius] = cases[first + lane];
      largest =
          std::max(largest, std::abs(0.5 * double(areas[lane]) -
                                     std::min(within_disk(corners, radius), pi * radius * radius)));
    }
  }
  return largest;
}

/// triangles of a given extent, not thinner than a hundredth of it, whose boundary is near the circle or not.
std::vector<Case> random_cases(double extent, std::uint64_t seed)
{
  shapes::Random random(seed);
  std::vector<Case> cases;
  while(cases.size() < 16000) {
    const double radius = cases.size() % 2 ? 1 : random(0.05, 1);
    const Corners corners = random_triangle(random, extent);
    const double distance = random(std::max(radius - extent, 0.), radius + extent);
    if(area_of(corners) > 0.01 * extent * extent)
      cases.push_back({translated(corners, std::polar(distance, random(0, 2 * pi))), radius});
  }
  return cases;
}

// What is rounded, to 6e-8 for floats, are lengths of about the radius, which move edges or the circle.
// That changes the area by the length of the boundary within the disk times the distance.
TEST(Triangle_disk_kernel, errs_by_a_few_roundings_of_triangles_of_any_size)
{
  for(const double extent : {1e-3, 0.03, 0.1, 0.3, 1.}) {
    const auto cases = random_cases(extent, 8);
    EXPECT_LT((largest_error<float, Way_along>(cases)), 6e-7 * extent) << extent;
    EXPECT_LT((largest_error<double, Way_along>(cases)), 2e-12 * extent) << extent;
  }
  for(const double extent : {0.3, 1., 3., 10., 100., 1000.}) {
    const auto cases = random_cases(extent, 9);
    EXPECT_LT((largest_error<float, Way_between>(cases)), 8e-7) << extent;
    EXPECT_LT((largest_error<double, Way_between>(cases)), 1e-14 * (1 + extent)) << extent;
  }
}

TEST(Triangle_disk_kernel, errs_by_roundings_of_the_radius_times_the_longest_edge)
{
  for(const double radius : {1e3, 1e6, 1e9, 1e11})
    EXPECT_LT((largest_error<double, Way_along>(cases_at_the_rim(radius))), 4e-15 * radius)
        << radius;
}

TEST(Triangle_disk_kernel, knows_slivers)
{
  shapes::Random random(10);
  std::vector<Case> cases;
  while(cases.size() < 16000) {
    Corners corners = random_triangle(random, 1.);
    const Complex along = corners[1] - corners[0];
    const double t = random(-0.5, 1.5);
    corners[2] = corners[0] + (t + std::pow(10., -random(1, 9)) * Complex(0, 1)) * along;
    cases.push_back({corners, 1});
  }
  EXPECT_LT((largest_error<float, Way_along>(cases)), 1e-6);
  EXPECT_LT((largest_error<float, Way_between>(cases)), 1e-6);
  EXPECT_LT((largest_error<double, Way_between>(cases)), 1e-14);
}

/// triangles that touch the circle, hold the disk or are held by it, with their corners and edges at its
/// centre or not, exactly or up to rounding.
std::vector<Case> special_cases()
{
  std::vector<Case> cases;
  for(int n = 0; n < 720; ++n) {
    const Complex rim = std::polar(1., n * pi / 36), tangent = rim * Complex(0, 1);
    const double tiny = n < 72 ? 0 : std::pow(10., -double(n / 72) - 6);
    const std::vector<Corners> special{
        {rim, 2. * rim - tangent, 2. * rim + tangent},                 // a corner, from outside
        {rim, -0.1 * rim + 0.2 * tangent, -0.1 * rim - 0.2 * tangent}, // a corner, from inside
        {rim - tangent, 2. * rim, rim + tangent},                      // an edge, from outside
        {rim + tangent, -3. * rim, rim - tangent},                     // an edge, from inside
        {Complex(), rim, tangent},                                     // a corner at the centre
        {Complex(), 0.3 * rim, 0.5 * tangent},
        {Complex(), 3. * rim, 2. * tangent},
        {-rim, rim, 0.5 * tangent}, // an edge through the centre
        {-2. * rim, 3. * rim, 4. * tangent},
        {-3. * rim - 2. * tangent, 3. * rim - 2. * tangent, 5. * tangent}, // around the disk
        {0.3 * rim, 0.3 * tangent, -0.3 * rim},                            // within the disk
        {3. * rim - tangent, 3. * rim, 2. * rim},                          // apart
    };
    for(const Corners& corners : special)
      cases.push_back({translated(corners, tiny * (rim + 0.3 * tangent)), 1});
  }
  return cases;
}

TEST(Triangle_disk_kernel, knows_what_touches_and_what_holds)
{
  const auto cases = special_cases();
  EXPECT_LT((largest_error<float, Way_along>(cases)), 3e-6);
  EXPECT_LT((largest_error<float, Way_between>(cases)), 1e-6);
  // The scalar function cuts off by 1e-16 what touches, which costs up to 1e-12.
  EXPECT_LT((largest_error<double, Way_along>(cases)), 1e-11);
  EXPECT_LT((largest_error<double, Way_between>(cases)), 1e-11);
}

TEST(Triangle_disk_kernel, gives_nothing_to_what_is_apart_and_a_full_disk_to_what_holds_it)
{
  Seen_triangles<double> triangles;
  for(std::size_t lane = 0; lane < 16; ++lane) {
    const Complex turn = std::polar(1., double(lane));
    if(lane % 2)
      triangles.set(lane, {1.5 * turn, 3. * turn, turn * Complex(2, 1)}, 1);
    else
      triangles.set(lane, {turn * Complex(-8, -5), turn * Complex(9, -5), turn * Complex(0, 9)}, 2);
  }
  std::array<double, 16> areas;
  for(const bool is_along : {true, false}) {
    is_along ? Way_along::areas(triangles, areas.data())
             : Way_between::areas(triangles, areas.data());
    for(std::size_t lane = 0; lane < 16; ++lane)
      if(lane % 2)
        EXPECT_EQ(areas[lane], 0);
      else
        EXPECT_NEAR(areas[lane], 2 * pi * 4, 1e-14);
  }
}

} // namespace
