// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Fast marching, against distances and travel times in closed form, and the paths of its fronts.

#include "scale_maps.h"

#include <CGAL/Area_projection_transform/fast_marching.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace scale_maps;
using AP::Marching_options;
using AP::Marching_path;
using AP::Marching_source;
using AP::Travel_times;
using AP::Vector_3;
using Region = std::shared_ptr<const Row_spans>;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<float> constant(const Region& region, float speed = 1)
{
  return std::vector<float>(region->storage_size(), speed);
}

/// the cube from -1 to 1 with `2n + 1` voxels along each side.
Region cube(int n)
{
  const int size = 2 * n + 1;
  return std::make_shared<const Row_spans>(
      AP::Grid_3(Point_3(-1, -1, -1), 1. / n, std::array<int, 3>{size, size, size}));
}

Point_3 point_of(const Region& region, const Voxel& v)
{
  return region->grid().point(v[0], v[1], v[2]);
}

double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

/// the largest difference between times and a function of places.
double largest_error(const Travel_times& times,
                     const std::function<double(const Point_3&)>& expected)
{
  const Region region(std::shared_ptr<void>(), &times.region());
  double error = 0;
  for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
    error = std::max(error, std::abs(times.times()[place] - expected(point_of(region, v))));
  });
  return error;
}

// ---------------------------------------------------------------- times

TEST(Fast_marching, is_never_less_than_the_distance_nor_more_than_theory_allows)
{
  // Differences against the wind of a convex function are less than its slope, so the distance is a subsolution
  // of the scheme. Its residual is h/2 Σ |n_a| (1 - n_a²) / r for the direction n: at most 0.58 h / r, which
  // sums to 0.58 h log(r/h) along a ray. At the first diagonal voxel the scheme is off by 0.55 h.
  for(const int n : {8, 16, 32}) {
    const Region region = cube(n);
    const double h = region->grid().spacing();
    const Travel_times times = AP::fast_marching(region, constant(region), {{{n, n, n}}});
    for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
      const double t = times.times()[place], r = distance(point_of(region, v), Point_3(0, 0, 0));
      ASSERT_GE(t, r - 1e-12);
      if(r > 0) {
        ASSERT_LE(t, r + h * (0.58 * std::log(std::max(r / h, 1.)) + 0.55));
      }
      if((v[0] == n) + (v[1] == n) + (v[2] == n) >= 2) {
        ASSERT_NEAR(t, r, 1e-12) << "along the axes";
      }
    });
  }
}

TEST(Fast_marching, converges_as_h_log_h)
{
  const auto error = [](int n) {
    const Region region = cube(n);
    return largest_error(AP::fast_marching(region, constant(region), {{{n, n, n}}}),
                         [](const Point_3& p) { return distance(p, Point_3(0, 0, 0)); });
  };
  double coarse = error(8);
  for(const int n : {16, 32}) {
    const double fine = error(n);
    EXPECT_LT(fine / coarse, 1.1 * std::log(2. * n) / (2 * std::log(1. * n)));
    coarse = fine;
  }
}

/// all voxels within a distance of 0.3 from the middle, with their times.
std::vector<Marching_source> ball(const Region& region,
                                  const std::function<double(const Point_3&)>& time)
{
  std::vector<Marching_source> sources;
  for_each_voxel(*region, [&](const Voxel& v, std::size_t) {
    const Point_3 p = point_of(region, v);
    if(distance(p, Point_3(0, 0, 0)) <= 0.3)
      sources.push_back({v, time(p)});
  });
  return sources;
}

/// \brief times from the middle where the speed is `1 + g·x`: rays are arcs of circles.
///
/// The travel time is arcosh(1 + g² d² / 2 F(0) F(x)) / g.
struct Linear_speed
{
  Vector_3 slope = Vector_3(0.3, -0.15, 0.2);

  double speed(const Point_3& p) const { return 1 + slope * (p - CGAL::ORIGIN); }
  double time(const Point_3& p) const
  {
    const double squared_slope = slope.squared_length();
    return std::acosh(1 + 0.5 * squared_slope * CGAL::squared_distance(p, Point_3(0, 0, 0)) /
                              speed(p)) /
           std::sqrt(squared_slope);
  }
  std::vector<float> speeds(const Region& region) const
  {
    return map_of(*region, [&](const Voxel& v) { return speed(point_of(region, v)); });
  }
};

TEST(Fast_marching, finds_the_times_of_a_linear_speed)
{
  const Linear_speed linear;
  const auto time = [&](const Point_3& p) { return linear.time(p); };
  std::array<double, 2> finest{};
  for(const bool is_second_order : {false, true}) {
    Marching_options options;
    options.is_second_order = is_second_order;
    double& error = finest[is_second_order];
    error = infinity;
    for(const int n : {10, 20, 40}) {
      const Region region = cube(n);
      const double coarser = error;
      error = largest_error(
          AP::fast_marching(region, linear.speeds(region), ball(region, time), options), time);
      // A half and a quarter in the limit; the ball has three voxels for its radius at first.
      EXPECT_LT(error, coarser * (is_second_order ? 0.36 : 0.6));
    }
  }
  EXPECT_LT(finest[1], finest[0] / 5);
}

TEST(Fast_marching, of_the_second_order_is_exact_on_planes_and_parabolas_of_one_axis)
{
  // T = x + x²/2 has the slope 1 + x; differences of the second order know it exactly.
  const int n = 40;
  const Region region = std::make_shared<const Row_spans>(
      AP::Grid_3(Point_3(0, 0, 0), 0.1, std::array<int, 3>{n, 5, 5}));
  const std::vector<float> speeds =
      map_of(*region, [&](const Voxel& v) { return 1 / (1 + 0.1 * v[0]); });
  const auto time = [](const Point_3& p) { return p.x() + 0.5 * p.x() * p.x(); };
  std::vector<Marching_source> sources;
  for(int i = 0; i < 2; ++i)
    for(int j = 0; j < 5; ++j)
      for(int k = 0; k < 5; ++k)
        sources.push_back({{i, j, k}, time(point_of(region, {i, j, k}))});
  Marching_options options;
  options.is_second_order = true;
  // Speeds are floats: 6e-8 of each of the times between voxels, which sum to 12.
  EXPECT_LT(largest_error(AP::fast_marching(region, speeds, sources, options), time), 1e-6);
}

/// of each axis, of either side, the times of the voxel next to another one and of that behind it; infinite for walls.
using Sources_around = std::array<std::array<std::array<double, 2>, 2>, 3>;

/// the time of a voxel of slowness 1 between sources.
double time_between(const Sources_around& times, bool is_second_order)
{
  const Region region = whole_region(5);
  std::vector<float> speeds = constant(region, 0);
  speeds[region->index(2, 2, 2)] = 1;
  std::vector<Marching_source> sources;
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const int side : {0, 1})
      for(const int behind : {0, 1}) {
        Voxel voxel{2, 2, 2};
        voxel[axis] += (2 * side - 1) * (1 + behind);
        const double time = times[axis][std::size_t(side)][std::size_t(behind)];
        if(time < infinity) {
          sources.push_back({voxel, time});
          speeds[region->index(voxel[0], voxel[1], voxel[2])] = 1;
        }
      }
  Marching_options options;
  options.is_second_order = is_second_order;
  return AP::fast_marching(region, speeds, sources, options).time(2, 2, 2);
}

/// the same by bisection: the differences against the wind, which only rise with the time, have 1 as the sum of their squares.
double expected_time_between(const Sources_around& times, bool is_second_order)
{
  double low = 0, high = 10;
  for(int i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    double sum = 0;
    for(const auto& sides : times) {
      const auto [near, far] = std::min(sides[0], sides[1]);
      const double rise =
          is_second_order && far <= near ? 0.5 * (3 * t - 4 * near + far) : t - near;
      sum += std::pow(std::max(rise, 0.), 2);
    }
    (sum < 1 ? low : high) = t;
  }
  return low;
}

// Of each axis the earlier side counts, if it is earlier than the voxel itself; and what is behind it only if times rise
// towards the voxel, or it belongs to another front. It does not matter what is done last.
TEST(Fast_marching, solves_the_equation_of_godunov_at_a_voxel)
{
  shapes::Random random(1);
  for(int repetition = 0; repetition < 50; ++repetition) {
    // Up to 0.1 all are earlier than the voxel, which comes 2/3 / √3 later than the first, or more.
    for(const auto& [latest, is_second_order] : {std::pair(1.5, false), {0.1, true}}) {
      Sources_around times;
      for(auto& sides : times)
        for(auto& side : sides)
          for(double& time : side)
            time = random(0, latest);
      EXPECT_NEAR(time_between(times, is_second_order),
                  expected_time_between(times, is_second_order), 1e-12);
    }
  }
}

// With what comes along y, whose slope is 0.9, the second order would be done at 0.6904: before what it comes from.
TEST(Fast_marching, of_the_second_order_does_not_come_from_what_is_later)
{
  constexpr std::array<double, 2> wall{infinity, infinity};
  const Sources_around times{{{{{0, -0.3}, wall}}, {{{0.7, -0.2}, wall}}, {{wall, wall}}}};
  EXPECT_NEAR(time_between(times, true), 0.1 + 2. / 3, 1e-12); // along x alone
}

TEST(Fast_marching, goes_round_walls)
{
  // A wall at i = 10 with a gap at its end: the shortest way turns at the gap.
  const Region region = whole_region(21);
  const std::vector<float> speeds =
      map_of(*region, [](const Voxel& v) { return v[0] == 10 && v[1] != 20 ? 0. : 1.; });
  const Travel_times times = AP::fast_marching(region, speeds, {{{0, 0, 10}}});
  EXPECT_EQ(times.time(10, 5, 5), infinity);
  const Point_3 start(0, 0, 10), gap(10, 20, 10);
  const double way = distance(start, gap) + distance(gap, Point_3(20, 0, 10));
  EXPECT_GE(times.time(20, 0, 10), way - 1);
  EXPECT_LE(times.time(20, 0, 10), way + 2 * (0.58 * std::log(22.) + 0.55));
  const Marching_path path = AP::marching_path(times, {20, 0, 10});
  ASSERT_TRUE(path.is_reached());
  double length = 0;
  for(std::size_t i = 1; i < path.points.size(); ++i) {
    length += distance(path.points[i - 1], path.points[i]);
    const Point_3& p = path.points[i];
    EXPECT_FALSE(std::abs(p.x() - 10) < 0.5 && p.y() < 18.5) << "in the wall";
  }
  EXPECT_NEAR(length, way, 0.05 * way);
}

TEST(Fast_marching, leaves_what_it_does_not_reach_at_infinity)
{
  // Two blocks that touch along an edge: fronts pass through sides only.
  const AP::Grid_3 grid(Point_3(0, 0, 0), 1, std::array<int, 3>{10, 10, 4});
  const Region region = std::make_shared<const Row_spans>(
      grid, [](std::size_t row, std::vector<Row_spans::Run>& runs) {
        if(row % 10 < 5)
          runs.push_back({0, 5});
        else
          runs.push_back({5, 10});
      });
  const Travel_times times = AP::fast_marching(region, constant(region), {{{0, 0, 0}}});
  for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
    EXPECT_EQ(times.times()[place] < infinity, v[0] < 5);
    EXPECT_EQ(AP::marching_path(times, v).is_reached(), v[0] < 5);
  });
  EXPECT_EQ(times.time(-1, 0, 0), infinity);
  EXPECT_EQ(times.time(7, 2, 0), infinity) << "not in the region";
  const Marching_path path = AP::marching_path(times, {7, 7, 1});
  EXPECT_TRUE(path.points.empty());
  EXPECT_EQ(path.time, infinity);
  EXPECT_FALSE(AP::marching_path(times, {100, 7, 1}).is_reached());
  EXPECT_EQ(times.last_voxel(), (Voxel{4, 4, 3}));
}

TEST(Fast_marching, stops_at_its_target)
{
  const Region region = cube(12);
  const Travel_times all = AP::fast_marching(region, constant(region), {{{12, 12, 12}}});
  Marching_options options;
  options.target = Voxel{18, 9, 12};
  const Travel_times some = AP::fast_marching(region, constant(region), {{{12, 12, 12}}}, options);
  const double end = all.time(18, 9, 12);
  EXPECT_EQ(some.time(18, 9, 12), end);
  for(std::size_t i = 0; i < all.times().size(); ++i) {
    if(all.times()[i] < end) {
      EXPECT_EQ(some.times()[i], all.times()[i]);
    }
    if(all.times()[i] > end) {
      EXPECT_EQ(some.times()[i], infinity);
    }
  }
  const Marching_path path = AP::marching_path(some, *options.target);
  EXPECT_EQ(path.points.front(), Point_3(0, 0, 0));
  EXPECT_EQ(path.points.back(), point_of(region, *options.target));
}

TEST(Fast_marching, gives_some_sources_a_lead)
{
  const Region region = whole_region(21);
  const Travel_times times =
      AP::fast_marching(region, constant(region, 2), {{{0, 10, 10}, 1}, {{20, 10, 10}, -2}});
  // Along the line between them: 1 + x / 2 and -2 + (20 - x) / 2 meet at x = 7.
  for(int i = 0; i <= 20; ++i)
    EXPECT_NEAR(times.time(i, 10, 10), std::min(1 + 0.5 * i, -2 + 0.5 * (20 - i)), 1e-12);
}

TEST(Fast_marching, leaves_sources_their_times)
{
  const Region region = whole_region(9);
  const Travel_times times =
      AP::fast_marching(region, constant(region), {{{4, 4, 4}, 0}, {{5, 4, 4}, 7}, {{5, 4, 4}, 9}});
  EXPECT_EQ(times.time(5, 4, 4), 7);
  EXPECT_LT(times.time(6, 4, 4), 4) << "from the other, round about";
  EXPECT_EQ(AP::marching_path(times, {8, 4, 4}).points.front(), Point_3(4, 4, 4));
}

TEST(Fast_marching, refuses_what_it_cannot_march_on)
{
  const Region region = ragged_region({9, 8, 7}, 3);
  Voxel inside{}, outside{-1, 0, 0};
  for_each_voxel(*region, [&](const Voxel& v, std::size_t) { inside = v; });
  const auto complaint = [&](const std::vector<float>& speeds,
                             const std::vector<Marching_source>& sources,
                             const Marching_options& options = {}) {
    return shapes::complaint([&] { AP::fast_marching(region, speeds, sources, options); });
  };
  const std::vector<float> good = constant(region);
  EXPECT_EQ(complaint(good, {{inside}}), "");
  EXPECT_NE(complaint(good, {}), "");
  EXPECT_NE(complaint(good, {{outside}}), "");
  EXPECT_NE(complaint(good, {{inside, infinity}}), "");
  EXPECT_NE(complaint(constant(region, 0), {{inside}}), "");
  EXPECT_NE(complaint({1.f}, {{inside}}), "");
  for(const float bad : {-1.f, float(infinity), std::numeric_limits<float>::quiet_NaN()})
    EXPECT_NE(complaint(constant(region, bad), {{inside}}), "");
  Marching_options options;
  options.target = outside;
  EXPECT_NE(complaint(good, {{inside}}, options), "");
}

// ---------------------------------------------------------------- paths

TEST(Marching_path, follows_the_arcs_of_a_linear_speed)
{
  // The ray through two points is an arc of a circle about a point where the speed is zero.
  const Linear_speed linear;
  const int n = 40;
  const Region region = cube(n);
  const Travel_times times = AP::fast_marching(region, linear.speeds(region), {{{n, n, n}}});
  for(const Voxel& target : {Voxel{2 * n, 0, n}, Voxel{0, 2 * n, 2 * n}, Voxel{n, 2, 2 * n}}) {
    const Point_3 end = point_of(region, target);
    const Marching_path path = AP::marching_path(times, target);
    ASSERT_TRUE(path.is_reached());
    EXPECT_EQ(path.points.front(), Point_3(0, 0, 0));
    EXPECT_EQ(path.points.back(), end);
    // The centre: at speed zero, in the plane of the ray and the slope, as far from both ends.
    const Vector_3 u = linear.slope / linear.slope.squared_length();
    const Vector_3 d = end - CGAL::ORIGIN;
    const Vector_3 w = d - (d * linear.slope) * u;
    const double s = (0.5 * d.squared_length() + u * d) / (w * d);
    const Point_3 centre = CGAL::ORIGIN - u + s * w;
    const double radius = distance(centre, Point_3(0, 0, 0));
    ASSERT_NEAR(distance(centre, end), radius, 1e-9);
    for(const Point_3& p : path.points)
      EXPECT_NEAR(distance(centre, p), radius, 0.04) << "less than two voxels";
  }
}

/// checks what every path has.
void expect_path(const Region& region, const Travel_times& times, const Voxel& target)
{
  const Marching_path path = AP::marching_path(times, target);
  ASSERT_EQ(path.is_reached(), times.time(target[0], target[1], target[2]) < infinity);
  if(!path.is_reached())
    return;
  EXPECT_EQ(path.points.back(), point_of(region, target));
  double last = -infinity;
  for(std::size_t i = 0; i < path.points.size(); ++i) {
    const Point_3& p = path.points[i];
    if(i > 0) {
      EXPECT_LE(distance(path.points[i - 1], p), std::sqrt(3.) * region->grid().spacing() + 1e-9);
    }
    // The nearest voxel of all is one that was reached.
    const Vector_3 c = region->grid().lattice_coordinates(p);
    const double t = times.time(int(std::floor(c.x() + 0.5)), int(std::floor(c.y() + 0.5)),
                                int(std::floor(c.z() + 0.5)));
    EXPECT_LT(t, infinity);
    if(i == 0)
      last = t;
  }
  EXPECT_EQ(last, 0) << "begins at the source";
}

TEST(Marching_path, ends_at_the_source_whatever_the_region_and_the_speeds)
{
  for(std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Region region = ragged_region({23, 19, 11}, seed);
    shapes::Random random(seed);
    // Walls, and speeds that differ by up to twelve orders of magnitude.
    const double orders = seed % 2 ? 12 : 1;
    const std::vector<float> speeds = map_of(*region, [&](const Voxel&) {
      return random() < 0.15 ? 0. : std::pow(10., orders * random(-0.5, 0.5));
    });
    Voxel source{};
    for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
      if(speeds[place] > 0 && random() < 0.02)
        source = v;
    });
    Marching_options options;
    options.is_second_order = seed > 3;
    const Travel_times times = AP::fast_marching(region, speeds, {{source}}, options);
    for_each_voxel(*region, [&](const Voxel& v, std::size_t) { expect_path(region, times, v); });
  }
}

TEST(Marching_path, does_not_slip_through_where_voxels_share_an_edge)
{
  // Two quadrants that touch in an edge, and a way round from one to the other.
  const Region region = std::make_shared<const Row_spans>(
      AP::Grid_3(Point_3(0, 0, 0), 1, std::array<int, 3>{20, 20, 2}));
  const std::vector<float> speeds = map_of(*region, [](const Voxel& v) {
    const bool is_quadrant = (v[0] < 10) == (v[1] < 10);
    return is_quadrant || v[0] == 0 || v[1] >= 18 ? 1. : 0.;
  });
  const Travel_times times = AP::fast_marching(region, speeds, {{{5, 5, 0}}});
  for(const Voxel& target : {Voxel{10, 10, 0}, Voxel{10, 10, 1}, Voxel{12, 11, 1}}) {
    const Marching_path path = AP::marching_path(times, target);
    EXPECT_EQ(path.points.front(), Point_3(5, 5, 0));
    double highest = 0;
    for(const Point_3& p : path.points)
      highest = std::max(highest, p.y());
    EXPECT_GT(highest, 17);
  }
}

TEST(Marching_path, goes_straight_along_a_thin_slanted_region)
{
  // A staircase of voxels, two wide: the path is to be a line, not stairs.
  const int n = 30;
  const Region region = std::make_shared<const Row_spans>(
      AP::Grid_3(Point_3(0, 0, 0), 1, std::array<int, 3>{n, n, 1}));
  const std::vector<float> speeds =
      map_of(*region, [](const Voxel& v) { return v[0] == v[1] || v[0] == v[1] + 1 ? 1. : 0.; });
  const Marching_path path =
      AP::marching_path(AP::fast_marching(region, speeds, {{{0, 0, 0}}}), {n - 1, n - 1, 0});
  double length = 0;
  for(std::size_t i = 1; i < path.points.size(); ++i)
    length += distance(path.points[i - 1], path.points[i]);
  EXPECT_LT(length, 1.05 * std::sqrt(2.) * (n - 1)); // stairs have 1.41
}

TEST(Marching_path, on_a_line_of_voxels_is_the_line)
{
  const Region region = std::make_shared<const Row_spans>(
      AP::Grid_3(Point_3(0, 0, 0), 1, std::array<int, 3>{9, 1, 1}));
  const Travel_times times = AP::fast_marching(region, constant(region), {{{0, 0, 0}}});
  const Marching_path path = AP::marching_path(times, {8, 0, 0});
  EXPECT_EQ(path.time, 8);
  for(std::size_t i = 0; i < path.points.size(); ++i) {
    EXPECT_EQ(path.points[i].y(), 0);
    if(i > 0) {
      EXPECT_GT(path.points[i].x(), path.points[i - 1].x());
    }
  }
  const Marching_path nowhere = AP::marching_path(times, {0, 0, 0});
  EXPECT_EQ(nowhere.points, (std::vector<Point_3>{{0, 0, 0}}));
  EXPECT_EQ(nowhere.time, 0);
}

} // namespace
