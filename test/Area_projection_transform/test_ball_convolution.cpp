// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums over balls of voxels against the plain definition, bit by bit.

#include "shapes.h"

#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::internal::available_instruction_sets;
using AP::internal::Ball_convolution;
using AP::internal::chosen_instruction_set;
using AP::internal::Instruction_set;
using AP::internal::largest_squared_distance;

using Balls = std::vector<Ball_convolution::Ball>;

/// a grid of integers, few of which are not zero, and whole rows and layers of which are.
class Votes
{
public:
  Votes(const std::array<int, 3>& size, double occupancy, std::uint64_t seed)
      : m_size(size), m_values(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]))
  {
    shapes::Random random(seed);
    for(int k = 0; k < size[2]; ++k)
      for(int j = 0; j < size[1]; ++j)
        for(int i = 0; i < size[0]; ++i)
          if(random(0, 1) < occupancy && k % 7 != 3 && (j + k) % 5 != 0)
            m_values[place(i, j, k)] = std::int32_t(random(0, 10000));
  }

  std::int64_t sum(int x, int y, int z, int squared_radius) const
  {
    const int r = int(std::sqrt(double(squared_radius))) + 1;
    std::int64_t sum = 0;
    for(int k = std::max(z - r, 0); k <= std::min(z + r, m_size[2] - 1); ++k)
      for(int j = std::max(y - r, 0); j <= std::min(y + r, m_size[1] - 1); ++j)
        for(int i = std::max(x - r, 0); i <= std::min(x + r, m_size[0] - 1); ++i)
          if((i - x) * (i - x) + (j - y) * (j - y) + (k - z) * (k - z) <= squared_radius)
            sum += m_values[place(i, j, k)];
    return sum;
  }

  template <class Row>
  void operator()(int layer, int first, int last, Row&& row) const
  {
    for(int j = first; j < last; ++j)
      for(int i = 0; i < m_size[0]; ++i)
        if(const std::int32_t value = m_values[place(i, j, layer)])
          row(j)[i] += value;
  }

private:
  std::size_t place(int i, int j, int k) const
  {
    return std::size_t(i) +
           std::size_t(m_size[0]) * (std::size_t(j) + std::size_t(m_size[1]) * std::size_t(k));
  }

  std::array<int, 3> m_size;
  std::vector<std::int32_t> m_values;
};

void expect_sums(const AP::Row_spans& region, const Votes& votes, const Balls& balls)
{
  std::vector<float> sums(region.storage_size(), -1.f);
  Ball_convolution convolve(region, balls);
  convolve(votes, shapes::Never(), sums.data());
  const auto& size = region.grid().size();
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j) {
      const AP::Row_spans::Hull& hull = region.hull(region.grid().row(j, k));
      for(int i = hull.first; i < hull.last; ++i) {
        volatile float expected = 0; // keeps the compiler from fusing
        for(const Ball_convolution::Ball& ball : balls) {
          volatile float weighted = ball.weight * float(votes.sum(i, j, k, ball.squared_radius));
          expected = expected + weighted;
        }
        ASSERT_EQ(sums[region.index(i, j, k)], expected) << i << ' ' << j << ' ' << k;
      }
    }
}

AP::Row_spans everything(const std::array<int, 3>& size)
{
  return AP::Row_spans(AP::Grid_3(Point_3(0, 0, 0), 1, size));
}

/// rows without voxels, with one run or two.
AP::Row_spans some_runs(const std::array<int, 3>& size, std::uint64_t seed)
{
  shapes::Random random(seed);
  return AP::Row_spans(AP::Grid_3(Point_3(0, 0, 0), 1, size),
                       [&](std::size_t row, std::vector<AP::Row_spans::Run>& runs) {
                         if(row / std::size_t(size[1]) % 4 == 2 || random(0, 1) < 0.3)
                           return;
                         const int first = int(random(0, size[0])),
                                   last = int(random(first + 1, size[0] + 1));
                         runs.push_back({first, last});
                         if(last + 3 < size[0])
                           runs.push_back({last + 2, size[0] - 1});
                       });
}

class Ball_convolution_with : public testing::TestWithParam<Instruction_set>
{
protected:
  void SetUp() override { chosen_instruction_set() = GetParam(); }
  void TearDown() override { chosen_instruction_set() = available_instruction_sets().back(); }
};

TEST_P(Ball_convolution_with, equals_the_plain_sum_for_every_radius)
{
  const AP::Row_spans region = everything({37, 41, 19});
  const Votes votes(region.grid().size(), 0.2, 1);
  for(const double radius :
      {0.01, 0.99, 1., 1.2, std::sqrt(2.), 1.5, std::sqrt(3.), 2., std::sqrt(5.), 2.5, 3.,
       std::sqrt(14.), 4.5, 5., 6., std::sqrt(50.), 8., 12.})
    expect_sums(region, votes, {{largest_squared_distance(radius), 1.f}});
}

TEST_P(Ball_convolution_with, equals_the_plain_sum_for_every_size)
{
  for(const std::array<int, 3>& size : std::vector<std::array<int, 3>>{
          {1, 1, 1}, {1, 50, 3}, {129, 1, 2}, {3, 2, 45}, {16, 33, 5}, {63, 32, 4}, {65, 70, 3}})
    for(const double occupancy : {0.01, 1.}) {
      const Votes votes(size, occupancy, 2);
      for(const int squared_radius : {1, 6, 20, 81})
        expect_sums(everything(size), votes, {{squared_radius, 1.f}});
    }
}

TEST_P(Ball_convolution_with, equals_the_plain_sum_where_a_region_asks_for_it)
{
  for(const std::array<int, 3>& size :
      std::vector<std::array<int, 3>>{{90, 40, 12}, {20, 75, 9}, {150, 7, 7}}) {
    const AP::Row_spans region = some_runs(size, 3);
    for(const double occupancy : {0., 0.002, 0.3}) {
      const Votes votes(size, occupancy, 4);
      for(const int squared_radius : {0, 2, 9, 30, 100})
        expect_sums(region, votes, {{squared_radius, 1.f}});
    }
  }
}

TEST_P(Ball_convolution_with, adds_up_the_balls_of_a_kernel)
{
  const std::array<int, 3> size{50, 36, 15};
  const Votes votes(size, 0.1, 5);
  for(const auto& kernel :
      {AP::Epanechnikov_kernel_3().nested_balls(), AP::Gaussian_kernel_3().nested_balls()})
    for(const double sigma : {0.5, 2., 4.5, 7.}) {
      const Balls balls = AP::internal::balls_of_voxels(kernel, sigma);
      expect_sums(everything(size), votes, balls);
      expect_sums(some_runs(size, 6), votes, balls);
    }
}

INSTANTIATE_TEST_SUITE_P(all, Ball_convolution_with,
                         testing::ValuesIn(available_instruction_sets()),
                         [](const auto& set) { return "set_" + std::to_string(set.index); });

TEST(Ball_of_voxels, has_the_voxels_within_its_radius)
{
  for(const double radius : {0.01, 1., std::sqrt(2.), 2.9999, 3., 0.3 / 0.1, 7.5, 12.}) {
    const int squared = largest_squared_distance(radius);
    EXPECT_LE(std::sqrt(squared), radius * (1 + 1e-12));
    EXPECT_GT(std::sqrt(squared + 1), radius);
    const AP::internal::Nested_disks disks(squared);
    std::size_t rows = 0; // of one sign of k
    for(int k = 0; k <= disks.reach(); ++k)
      for(int j = -disks.reach(); j <= disks.reach(); ++j)
        rows += j * j + k * k <= squared;
    EXPECT_EQ(disks.number_of_rows(), rows);
  }
  EXPECT_EQ(largest_squared_distance(3 * 0.1 / 0.1), 9); // just above 3
  EXPECT_EQ(largest_squared_distance(0.9 / 3 / 0.1), 9); // just below 3
  EXPECT_EQ(largest_squared_distance(std::sqrt(5.)), 5);
}

TEST(Ball_of_voxels, is_one_for_balls_of_a_kernel_with_the_same_voxels)
{
  const std::vector<AP::Nested_ball> kernel{{0.2, 0.25}, {0.9, 0.25}, {0.4, 0.25}, {1., 0.125}};
  const Balls balls = AP::internal::balls_of_voxels(kernel, 2);
  ASSERT_EQ(balls.size(), 3u);
  EXPECT_EQ(balls[0].squared_radius, 0);
  EXPECT_EQ(balls[0].weight, 0.5f);
  EXPECT_EQ(balls[1].squared_radius, 3);
  EXPECT_EQ(balls[2].squared_radius, 4);
}

// Nearest voxels and balls of voxels, as the paper says, with areas as doubles: they differ by the
// rounding of each area to a multiple of at most 2^-29 of all area, and of the sum to a float.
TEST(Paper_grid_projector, follows_the_definition_for_every_kernel_and_region)
{
  const shapes::Soup blob = shapes::blob(3, 28);
  const auto surface = shapes::scale_space_of(blob);
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.13);
  for(const AP::Row_spans& region : {AP::Row_spans(grid), some_runs(grid.size(), 7)})
    for(const auto& kernel :
        {AP::Ball_kernel_3().nested_balls(), AP::Epanechnikov_kernel_3{3}.nested_balls()})
      for(const AP::Scale& scale : {AP::Scale{0.3, 0.13}, AP::Scale{0.7, 0.35}}) {
        std::vector<std::pair<std::array<int, 3>, double>> votes;
        surface.project(
            scale.radius, Side::INSIDE, grid.spacing(), [&](const AP::Projected_surfels& batch) {
              for(std::size_t s = 0; s < batch.size(); ++s) {
                const auto c = grid.lattice_coordinates(batch.positions[s]);
                votes.push_back({{int(std::floor(c.x() + 0.5)), int(std::floor(c.y() + 0.5)),
                                  int(std::floor(c.z() + 0.5))},
                                 batch.areas[s]});
              }
            });
        const auto areas =
            shapes::areas_on_grid(AP::Paper_grid_projector(region, kernel), surface, region, scale);
        const double rounding = double(votes.size()) * 0x1p-29 * blob.area();
        shapes::for_each_voxel(region, [&](const Point_3& x, std::size_t place) {
          const auto c = grid.lattice_coordinates(x);
          double sum = 0;
          for(const auto& [voxel, area] : votes) {
            const double squared = std::pow(voxel[0] - std::round(c.x()), 2) +
                                   std::pow(voxel[1] - std::round(c.y()), 2) +
                                   std::pow(voxel[2] - std::round(c.z()), 2);
            for(const AP::Nested_ball& ball : kernel)
              if(std::sqrt(squared) <= ball.relative_radius * scale.sigma / grid.spacing() + 1e-9)
                sum += ball.weight * area;
          }
          ASSERT_NEAR(areas[place], sum, rounding + 1e-6 * sum) << x;
        });
      }
}

TEST(Paper_grid_projector, refuses_balls_that_no_memory_holds)
{
  const auto surface = shapes::scale_space_of(shapes::icosphere(1));
  const AP::Row_spans region(AP::Grid_3(Point_3(0, 0, 0), 0.1, {4, 4, 4}));
  EXPECT_EQ(
      shapes::complaint([&] {
        AP::Paper_grid_projector(region).project(surface, {1, 200}, Side::INSIDE, shapes::Never());
      }),
      "sigma is 2000 voxels: must be at most 1000");
}

} // namespace
