// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points in cells: numbers of cells, and what is near a place.

#include "shapes.h"

#include <CGAL/Area_projection_transform/internal/Cell_list.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace {

namespace in = CGAL::Area_projection::internal;
using shapes::Random;
using Vector = Eigen::Vector3d;

/// a place in the cube [-size, size]^3
Vector place(Random& random, double size)
{
  return Vector{random(-size, size), random(-size, size), random(-size, size)};
}

TEST(Cell_index, numbers_cells_in_the_order_in_which_they_come)
{
  using in::Cell_index;
  Cell_index index(0);
  std::map<std::tuple<int, int, int>, std::uint32_t> expected;
  Random random(16);
  for(int i = 0; i < 5000; ++i) {
    const auto coordinate = [&] { return int(random(-10, 10)); };
    const std::array<std::int32_t, 3> cell{coordinate(), coordinate(), coordinate()};
    const auto number = expected.emplace(std::tuple(cell[0], cell[1], cell[2]), expected.size());
    EXPECT_EQ(index.insert(Cell_index::key(cell)), number.first->second);
  }
  EXPECT_EQ(index.size(), expected.size());
  for(const auto& [cell, number] : expected) {
    const auto [x, y, z] = cell;
    EXPECT_EQ(index.find(Cell_index::key({x, y, z})), number);
    EXPECT_EQ(index.find(Cell_index::key({x, y, z}, 3)), Cell_index::none);
  }
  EXPECT_EQ(index.find(Cell_index::key({100, 0, 0})), Cell_index::none);
}

TEST(Cell_index, tells_all_cells_of_its_range_apart)
{
  using in::Cell_index;
  const std::int32_t first = -(1 << 19), last = (1 << 19) - 1;
  std::vector<std::uint64_t> keys;
  for(const std::int32_t x : {first, -1, 0, 1, last})
    for(const std::int32_t y : {first, -1, 0, 1, last})
      for(const std::int32_t z : {first, -1, 0, 1, last})
        for(const unsigned label : {0u, 7u})
          keys.push_back(Cell_index::key({x, y, z}, label));
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

std::vector<std::size_t> found_in_ball(const in::Cell_list& cells,
                                       const std::vector<Vector>& points, const Vector& center,
                                       double radius)
{
  std::vector<std::size_t> found;
  cells.for_each_in_ball(center, radius, [&](std::size_t i, double squared) {
    EXPECT_EQ(squared, (points[i] - center).squaredNorm());
    found.push_back(i);
  });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Cell_list, finds_what_is_in_a_ball)
{
  Random random(17);
  std::vector<Vector> points;
  for(int i = 0; i < 700; ++i)
    points.push_back(place(random, i % 3 == 0 ? 0.1 : 2));
  points.push_back(points.front()); // one twice
  for(const double size : {1e-4, 0.3, 10.}) {
    const in::Cell_list cells(points, size);
    for(int i = 0; i < 60; ++i) {
      const Vector center = i % 2 ? place(random, 3) : points[std::size_t(i)];
      const double radius = i % 5 == 0 ? 0 : std::min(random(0, 2), 300 * size);
      std::vector<std::size_t> expected;
      for(std::size_t k = 0; k < points.size(); ++k)
        if((points[k] - center).squaredNorm() <= radius * radius)
          expected.push_back(k);
      EXPECT_EQ(found_in_ball(cells, points, center, radius), expected);
    }
    EXPECT_EQ(found_in_ball(cells, points, Vector::Zero(), 1e30).size(), points.size());
    EXPECT_TRUE(found_in_ball(cells, points, Vector(1e9, -1e9, 1e9), 1).empty());
  }
}

// A size that comes from an area may be 0.
TEST(Cell_list, whose_cells_have_no_size_has_one)
{
  const std::vector<Vector> points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1e6, 0, 0}};
  const in::Cell_list cells(points, 0);
  EXPECT_EQ(found_in_ball(cells, points, Vector::Zero(), 1), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(found_in_ball(cells, points, Vector::Zero(), 0), (std::vector<std::size_t>{0, 1}));
  std::size_t pairs = 0;
  cells.for_each_pair(0, [&](std::size_t, std::size_t, double) { ++pairs; });
  EXPECT_EQ(pairs, 6u); // two points with each other and themselves, and two with themselves
}

TEST(Cell_list, of_nothing_has_nothing)
{
  const std::vector<Vector> none;
  EXPECT_TRUE(found_in_ball(in::Cell_list(none, 1), none, Vector::Zero(), 5).empty());
  EXPECT_TRUE(found_in_ball(in::Cell_list(), none, Vector::Zero(), 5).empty());
  in::Cell_list(none, 1).for_each_pair(1, [](std::size_t, std::size_t, double) { FAIL(); });
}

// Coordinates of cells are kept with 20 bits: what is 2^20 cells apart shares a list, and is told apart by distances, even
// by a ball that reaches over both.
TEST(Cell_list, finds_points_that_are_very_far_away)
{
  const double size = 1e-3, period = 0x1p20 * size;
  const std::vector<Vector> points = {{0, 0, 0},      {period, 0, 0},   {-3 * period, 0, 0},
                                      {1e12, 0, 0},   {1e12 + 1, 0, 0}, {-1e12, 3, 0},
                                      {0, period, 0}, {-1e75, 1e75, 0}};
  const in::Cell_list cells(points, size);
  for(const double radius : {0., 0.4 * size, 2., 0.9 * period, 1.1 * period, 3.5 * period, 1e13})
    for(const Vector& center : points) {
      std::vector<std::size_t> expected;
      for(std::size_t k = 0; k < points.size(); ++k)
        if((points[k] - center).squaredNorm() <= radius * radius)
          expected.push_back(k);
      EXPECT_EQ(found_in_ball(cells, points, center, radius), expected) << radius;
    }
  std::size_t pairs = 0;
  cells.for_each_pair(size, [&pairs](std::size_t i, std::size_t j, double) { pairs += i == j; });
  EXPECT_EQ(pairs, points.size());
}

TEST(Cell_list, finds_all_pairs)
{
  Random random(18);
  std::vector<Vector> points;
  for(int i = 0; i < 300; ++i)
    points.push_back(place(random, 1));
  for(const double radius : {0.1, 0.3}) {
    std::vector<std::tuple<std::size_t, std::size_t>> expected, found;
    for(std::size_t i = 0; i < points.size(); ++i)
      for(std::size_t j = 0; j < points.size(); ++j)
        if((points[i] - points[j]).squaredNorm() <= radius * radius)
          expected.emplace_back(i, j);
    std::vector<std::size_t> firsts;
    in::Cell_list(points, 0.3).for_each_pair(radius, [&](std::size_t i, std::size_t j, double) {
      found.emplace_back(i, j);
      if(firsts.empty() || firsts.back() != i)
        firsts.push_back(i);
    });
    EXPECT_EQ(firsts.size(), points.size()); // one after the other
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

} // namespace
