// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How balls are connected: against unions whose topology is known, and against the nerve of the balls.

#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_topology.h>
#include <CGAL/Area_projection_transform/medial_balls.h>
#include <CGAL/Area_projection_transform/medial_balls/select_connecting.h>
#include <CGAL/Area_projection_transform/medial_complex.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

namespace {

using namespace shapes;
using AP::Betti_numbers;
using AP::Medial_complex;
using Parallel = CGAL::Parallel_if_available_tag;

struct Balls
{
  std::vector<Point_3> centers;
  std::vector<double> radii;

  Medial_complex complex(double growth = 0) const
  {
    return AP::medial_complex(centers, radii, growth);
  }
};

Balls on(const std::vector<Point_3>& centers, double radius)
{
  return {centers, std::vector<double>(centers.size(), radius)};
}

Balls random_balls(std::size_t number, std::uint64_t seed)
{
  Random random(seed);
  Balls balls;
  for(std::size_t i = 0; i < number; ++i) {
    balls.centers.push_back(random.point_in(CGAL::Bbox_3(0, 0, 0, 2, 2, 2)));
    balls.radii.push_back(random(0.3, 0.8));
  }
  return balls;
}

void expect_topology(const Medial_complex& complex, const Betti_numbers& expected)
{
  EXPECT_EQ(complex.topology.components, expected.components);
  EXPECT_EQ(complex.topology.loops, expected.loops);
  EXPECT_EQ(complex.topology.cavities, expected.cavities);
  EXPECT_EQ(long(complex.vertices.size()) - long(complex.edges.size()) +
                long(complex.triangles.size()),
            expected.euler_number());
}

/// \brief whether some balls have a point in common: whether the least of the largest power of a point is not positive.
///
/// That least value is at a point which has the same power for some of them and is in the space that their centres span.
bool have_common_point(const Balls& balls, const std::vector<std::size_t>& members)
{
  using Eigen::Vector3d;
  const auto center = [&](std::size_t i) { return AP::internal::to_eigen(balls.centers[i]); };
  const auto largest_power = [&](const Vector3d& x) {
    double largest = -std::numeric_limits<double>::infinity();
    for(const std::size_t i : members)
      largest = std::max(largest, (x - center(i)).squaredNorm() - balls.radii[i] * balls.radii[i]);
    return largest;
  };
  for(unsigned subset = 1; subset < 1u << members.size(); ++subset) {
    std::vector<std::size_t> some;
    for(std::size_t k = 0; k < members.size(); ++k)
      if(subset >> k & 1)
        some.push_back(members[k]);
    Eigen::MatrixXd directions(3, some.size() - 1);
    Eigen::VectorXd halves(some.size() - 1);
    const auto square = [](double r) { return r * r; };
    for(std::size_t k = 1; k < some.size(); ++k) {
      const auto column = Eigen::Index(k - 1);
      directions.col(column) = center(some[k]) - center(some[0]);
      halves[column] = 0.5 * (directions.col(column).squaredNorm() + square(balls.radii[some[0]]) -
                              square(balls.radii[some[k]]));
    }
    Vector3d x = center(some[0]);
    if(some.size() > 1)
      x += directions *
           (directions.transpose() * directions).colPivHouseholderQr().solve(halves).eval();
    if(largest_power(x) <= 0)
      return true;
  }
  return false;
}

/// \brief the Euler number of a union, by the nerve theorem: of all sets of balls with a common point, those of an odd
/// number less those of an even number.
///
/// By Helly's theorem more than four have one if each four of them do.
long euler_number_of_nerve(const Balls& balls)
{
  const std::size_t n = balls.centers.size();
  std::vector<bool> is_in(std::size_t(1) << n, false);
  long result = 0;
  for(std::size_t set = 1; set < is_in.size(); ++set) {
    std::vector<std::size_t> members;
    for(std::size_t i = 0; i < n; ++i)
      if(set >> i & 1)
        members.push_back(i);
    if(members.size() <= 4)
      is_in[set] = have_common_point(balls, members);
    else // all of one less have one, so that all of four do
      is_in[set] = std::all_of(members.begin(), members.end(), [&](std::size_t i) {
        return bool(is_in[set & ~(std::size_t(1) << i)]);
      });
    if(is_in[set])
      result += members.size() % 2 == 1 ? 1 : -1;
  }
  return result;
}

TEST(Medial_complex, of_a_few_balls_is_what_one_sees)
{
  expect_topology(Balls{}.complex(), {0, 0, 0});
  expect_topology(on({{0, 0, 0}}, 1).complex(), {1, 0, 0});
  expect_topology(on({{0, 0, 0}, {1, 0, 0}}, 1).complex(), {1, 0, 0});
  expect_topology(on({{0, 0, 0}, {3, 0, 0}}, 1).complex(), {2, 0, 0});
  // In a ring of twelve neighbours are 0.518 apart, and those across far.
  std::vector<Point_3> ring;
  for(int i = 0; i < 12; ++i)
    ring.emplace_back(std::cos(pi * i / 6), std::sin(pi * i / 6), 0);
  expect_topology(on(ring, 0.27).complex(), {1, 1, 0});
  expect_topology(on(ring, 0.25).complex(), {12, 0, 0});
  expect_topology(on(ring, 1.1).complex(), {1, 0, 0}); // all hold the centre
  // Edges of a sphere of 320 faces are less than 0.35 long.
  expect_topology(on(icosphere(2).points, 0.3).complex(), {1, 0, 1});
}

TEST(Medial_complex, leaves_out_balls_within_others)
{
  const Balls balls{{{0, 0, 0}, {0.1, 0, 0}, {0, 0, 0}, {5, 0, 0}}, {1, 0.5, 1, 0}};
  const Medial_complex complex = balls.complex();
  EXPECT_EQ(complex.vertices,
            (std::vector<std::uint32_t>{0})); // the first of two that are the same
  expect_topology(complex, {1, 0, 0});
}

TEST(Medial_complex, has_the_largest_of_concentric_balls)
{
  for(const std::vector<double>& radii : {std::vector<double>{1, 2, 3}, {3, 2, 1}, {1, 3, 2}}) {
    Balls balls = on({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}}, 1.5);
    std::copy(radii.begin(), radii.end(), balls.radii.begin());
    const Medial_complex complex = balls.complex();
    const auto largest = std::max_element(radii.begin(), radii.end()) - radii.begin();
    EXPECT_EQ(complex.vertices, (std::vector<std::uint32_t>{std::uint32_t(largest), 3}));
    expect_topology(complex, {1, 0, 0}); // only the largest one reaches the other
  }
}

TEST(Medial_complex, joins_balls_that_touch_and_none_that_do_not)
{
  expect_topology(on({{0, 0, 0}, {2, 0, 0}}, 1).complex(), {1, 0, 0});
  expect_topology(on({{0, 0, 0}, {2 + 0x1p-51, 0, 0}}, 1).complex(), {2, 0, 0});
}

TEST(Medial_complex, has_the_euler_number_of_the_nerve)
{
  std::set<long> seen;
  for(std::uint64_t seed = 0; seed < 40; ++seed) {
    const Balls balls = random_balls(11, seed);
    const Medial_complex complex = balls.complex();
    const long expected = euler_number_of_nerve(balls);
    EXPECT_EQ(complex.topology.euler_number(), expected) << seed;
    EXPECT_EQ(long(complex.vertices.size()) - long(complex.edges.size()) +
                  long(complex.triangles.size()),
              expected)
        << seed;
    seen.insert(expected);
  }
  EXPECT_GT(seen.size(), 1u);
}

TEST(Medial_complex, is_one)
{
  const Medial_complex complex = random_balls(300, 7).complex();
  ASSERT_GT(complex.triangles.size(), 100u);
  const auto& edges = complex.edges;
  for(const auto& [a, b, c] : complex.triangles)
    for(const auto& edge : {std::array{a, b}, std::array{a, c}, std::array{b, c}})
      EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), edge));
  for(const auto& [a, b] : edges) {
    EXPECT_LT(a, b);
    for(const std::uint32_t v : {a, b})
      EXPECT_TRUE(std::binary_search(complex.vertices.begin(), complex.vertices.end(), v));
  }
}

TEST(Medial_complex, does_not_depend_on_the_order_of_balls)
{
  const Balls balls = random_balls(200, 3);
  std::vector<std::uint32_t> old_of_new(200);
  std::iota(old_of_new.begin(), old_of_new.end(), 0u);
  Random(5).shuffle(old_of_new);
  Balls shuffled;
  for(const std::uint32_t i : old_of_new) {
    shuffled.centers.push_back(balls.centers[i]);
    shuffled.radii.push_back(balls.radii[i]);
  }
  const Medial_complex a = balls.complex();
  Medial_complex b = shuffled.complex();
  EXPECT_TRUE(a.topology == b.topology);
  for(auto& triangle : b.triangles) {
    for(std::uint32_t& v : triangle)
      v = old_of_new[v];
    std::sort(triangle.begin(), triangle.end());
  }
  std::sort(b.triangles.begin(), b.triangles.end());
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Medial_complex, closes_cracks_by_growth)
{
  const Balls apart = on({{0, 0, 0}, {2.1, 0, 0}}, 1);
  expect_topology(apart.complex(0.04), {2, 0, 0});
  expect_topology(apart.complex(0.06), {1, 0, 0});
}

TEST(Medial_complex, of_all_medial_balls_has_the_topology_of_the_shape)
{
  const std::vector<std::pair<Soup, Betti_numbers>> shapes{
      {icosphere(3), {1, 0, 0}},
      {cylinder(48, 1, 6, true, 40), {1, 0, 0}},
      {torus(1, 0.3, 80, 24), {1, 1, 0}},
      {fine_box(Vector_3(8, 8, 2), 0.4), {1, 0, 0}},
      {joined(torus(1, 0.3, 80, 24), icosphere(3, Point_3(0, 0, 3))), {2, 1, 0}},
      {joined(icosphere(4), flipped(icosphere(3, Point_3(0, 0, 0), 0.5))), {1, 0, 1}},
      {bundled_mesh("hand.obj"), {1, 0, 0}},
      {bundled_mesh("human_woman.obj"), {1, 0, 0}},
      {bundled_mesh("scorpion_low.obj"), {1, 0, 0}}};
  for(const auto& [soup, expected] : shapes) {
    const AP::Triangle_surface surface = surface_of(soup);
    const auto balls = AP::medial_balls<Parallel>(surface);
    const auto all = AP::select_by_weight(balls, AP::Medial_weight::RADIUS, 0);
    const double growth = AP::crack_width(surface.total_area(), balls.size());
    expect_topology(AP::medial_complex(balls, all, growth), expected);
    const std::optional<Betti_numbers> shape = AP::shape_topology(surface);
    ASSERT_TRUE(shape);
    EXPECT_TRUE(*shape == expected);
  }
}

TEST(Medial_complex, is_the_same_in_any_unit)
{
  const Balls balls = random_balls(60, 5);
  const AP::Medial_complex expected = balls.complex(0.1);
  for(const double unit : {0x1p-500, 0x1p-100, 0x1p100, 0x1p500, 0x1p1000}) {
    Balls scaled = balls;
    for(Point_3& center : scaled.centers)
      center = Point_3(unit * center.x(), unit * center.y(), unit * center.z());
    for(double& radius : scaled.radii)
      radius *= unit;
    const AP::Medial_complex complex = scaled.complex(0.1 * unit);
    EXPECT_EQ(complex.vertices, expected.vertices);
    EXPECT_EQ(complex.edges, expected.edges);
    EXPECT_EQ(complex.triangles, expected.triangles);
  }
}

TEST(Medial_complex, says_what_is_wrong)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto of = [](const Balls& balls, double growth) {
    return complaint([&] { balls.complex(growth); });
  };
  EXPECT_NE(of({{{0, 0, 0}}, {}}, 0).find("radii"), std::string::npos);
  EXPECT_NE(of({{{0, 0, 0}, {0, nan, 0}}, {1, 1}}, 0).find("ball 1"), std::string::npos);
  EXPECT_NE(of({{{0, 0, 0}}, {nan}}, 0).find("ball 0"), std::string::npos);
  EXPECT_NE(of({{{0, 0, 0}}, {1e308}}, 1e308).find("ball 0"), std::string::npos);
  EXPECT_NE(of(on({{0, 0, 0}}, 1), -1).find("growth"), std::string::npos);
  EXPECT_NE(
      complaint([] { AP::medial_complex(std::vector<AP::Medial_ball>(2), {2}); }).find("selected"),
      std::string::npos);
}

std::vector<AP::Medial_ball> balls_of_radius_1(const std::vector<double>& places)
{
  std::vector<AP::Medial_ball> balls(places.size());
  for(std::size_t i = 0; i < places.size(); ++i) {
    balls[i].center = Point_3(places[i], 0, 0);
    balls[i].radius = 1;
  }
  return balls;
}

TEST(Select_connecting, takes_few_stepping_stones)
{
  std::vector<double> places;
  for(int i = 0; i <= 40; ++i)
    places.push_back(0.25 * i);
  const auto balls = balls_of_radius_1(places);
  // From 0 to 10 in steps of 2, at which balls touch: at 2, 4, 6, 8.
  EXPECT_EQ(AP::select_connecting(balls, {0, 40}, 0.01),
            (std::vector<std::size_t>{0, 40, 8, 16, 24, 32}));
  EXPECT_EQ(AP::select_connecting(balls, {40, 3, 0}, 0.01),
            (std::vector<std::size_t>{40, 3, 0, 11, 19, 27, 35}));
  EXPECT_EQ(AP::select_connecting(balls, {7}, 0.01), std::vector<std::size_t>{7});
  EXPECT_TRUE(AP::select_connecting(balls, {}, 0.01).empty());
  EXPECT_NE(complaint([&] { AP::select_connecting(balls, {41}); }).find("41"), std::string::npos);
}

TEST(Select_connecting, joins_what_is_joined_only)
{
  auto balls = balls_of_radius_1({0, 1, 2, 3, 100, 101, 102, 103});
  EXPECT_EQ(AP::select_connecting(balls, {0, 3, 4, 7}),
            (std::vector<std::size_t>{0, 3, 4, 7, 2, 6}));
  // One within others, which is no vertex of their complex, is where these are.
  balls.push_back(balls[1]);
  balls.back().radius = 0.5;
  EXPECT_EQ(AP::select_connecting(balls, {0, 1, 8}), (std::vector<std::size_t>{0, 1, 8}));
  EXPECT_EQ(AP::select_connecting(balls, {3, 8}), (std::vector<std::size_t>{3, 8, 2}));
}

TEST(Select_connecting, makes_one_piece_of_each_of_a_shape)
{
  const std::vector<std::pair<Soup, long>> shapes{
      {joined(torus(1, 0.3, 80, 24), icosphere(3, Point_3(0, 0, 3))), 2},
      {bundled_mesh("human_woman.obj"), 1},
      {bundled_mesh("scorpion_low.obj"), 1}};
  for(const auto& [soup, pieces] : shapes) {
    const AP::Triangle_surface surface = surface_of(soup);
    const auto balls = AP::medial_balls<Parallel>(surface);
    const double growth = AP::crack_width(surface.total_area(), balls.size());
    for(const std::size_t number : {4, 30, 120}) {
      const auto some = AP::select_random(balls, number, number);
      const auto joined = AP::select_connecting(balls, some, growth);
      EXPECT_EQ(AP::medial_complex(balls, joined, growth).topology.components, pieces);
      EXPECT_TRUE(std::equal(some.begin(), some.end(), joined.begin()));
      EXPECT_EQ(std::set<std::size_t>(joined.begin(), joined.end()).size(), joined.size());
    }
  }
}

TEST(Shape_topology, counts_pieces_handles_and_cavities)
{
  const auto expect = [](const Soup& soup, const Betti_numbers& expected) {
    const auto topology = AP::shape_topology(surface_of(soup));
    ASSERT_TRUE(topology);
    EXPECT_TRUE(*topology == expected)
        << topology->components << " " << topology->loops << " " << topology->cavities;
  };
  expect(icosphere(1), {1, 0, 0});
  expect(torus(1, 0.3, 20, 10), {1, 1, 0});
  expect(joined(icosphere(1), torus(1, 0.3, 20, 10)), {2, 1, 0});
  expect(joined(icosphere(1), flipped(icosphere(1, Point_3(0, 0, 0), 0.3))), {1, 0, 1});
  // Two tetrahedra that share a corner are two solids.
  Soup pinched;
  pinched.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  pinched.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3},
                       {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}};
  expect(pinched, {2, 0, 0});
  // A soup, each triangle with points of its own.
  Soup soup;
  for(const Triangle& t : torus(1, 0.3, 20, 10).triangles)
    for(const std::uint32_t v : t)
      soup.points.push_back(torus(1, 0.3, 20, 10).points[v]);
  for(std::uint32_t i = 0; i < soup.points.size(); i += 3)
    soup.triangles.push_back({i, i + 1, i + 2});
  expect(soup, {1, 1, 0});
}

TEST(Shape_topology, is_unknown_where_nothing_is_bounded)
{
  EXPECT_FALSE(AP::shape_topology(AP::Triangle_surface()));
  EXPECT_FALSE(AP::shape_topology(surface_of(cylinder(12, 1, 2, false))));
  EXPECT_FALSE(AP::shape_topology(surface_of(flipped(icosphere(1)))));
  Soup one_over = icosphere(1);
  std::swap(one_over.triangles[0][0], one_over.triangles[0][1]);
  EXPECT_FALSE(AP::shape_topology(surface_of(one_over)));
}

} // namespace
