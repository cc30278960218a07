// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Heat that flows between cells, which is how normals and positions are smoothed: waves on a ring decay as known.

#include "shapes.h"

#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::internal::Heat_flow;
using shapes::pi;

Heat_flow ring(std::size_t cells, double area)
{
  Heat_flow::Links links(cells);
  for(std::size_t i = 0; i < cells; ++i)
    links.add(i, (i + 1) % cells, 1);
  return Heat_flow(std::vector<double>(cells, area), std::move(links));
}

TEST(Heat_flow, damps_waves_as_the_implicit_step_does)
{
  constexpr std::size_t cells = 60;
  const Heat_flow flow = ring(cells, 0.5);
  Heat_flow::Vectors waves(cells, 3);
  for(std::size_t i = 0; i < cells; ++i)
    for(int k = 0; k < 3; ++k)
      waves(Eigen::Index(i), k) = 1000 + std::cos(2 * pi * double((k + 1) * i) / cells);
  const Heat_flow::Vectors result = flow.diffused(waves, 7, 1e-6);
  for(int k = 0; k < 3; ++k) {
    // The eigenvalues of a ring are 2 - 2 cos(2 pi k / n), and 0 for the constant.
    const double eigenvalue = (2 - 2 * std::cos(2 * pi * (k + 1) / double(cells))) / 0.5;
    EXPECT_NEAR(result(0, k), 1000 + 1 / (1 + 7 * eigenvalue), 1e-5);
    EXPECT_NEAR(result.col(k).mean(), 1000, 1e-6);
  }
}

// A point source on a ring is the sum of all its waves, of equal size: conjugate gradients need a step for each, so that it
// is the error allowed that ends them.
TEST(Heat_flow, errs_no_more_than_is_allowed)
{
  constexpr std::size_t cells = 1000;
  constexpr double time = 300;
  const Heat_flow flow = ring(cells, 1);
  Heat_flow::Vectors point = Heat_flow::Vectors::Zero(cells, 3);
  point.row(0).setConstant(1000);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(cells);
  for(std::size_t k = 0; k < cells; ++k) {
    const double eigenvalue = 2 - 2 * std::cos(2 * pi * double(k) / cells);
    for(std::size_t i = 0; i < cells; ++i)
      expected[Eigen::Index(i)] += 1000. / cells *
                                   std::cos(2 * pi * double(k * i % cells) / cells) /
                                   (1 + time * eigenvalue);
  }
  for(const double allowed : {1., 0.1, 0.01}) {
    const Heat_flow::Vectors result = flow.diffused(point, time, allowed);
    for(int k = 0; k < 3; ++k)
      EXPECT_LT((result.col(k) - expected).norm() / std::sqrt(double(cells)), allowed);
  }
}

TEST(Heat_flow, fills_cells_without_area_from_their_neighbours_and_leaves_lone_ones)
{
  Heat_flow::Links links(4);
  links.add(0, 1, 1);
  links.add(1, 2, 1);
  const Heat_flow flow({1, 0, 1, 0}, std::move(links));
  Heat_flow::Vectors values(4, 3);
  values << 0, 1, 2, 9, 9, 9, 2, 1, 0, 5, 5, 5;
  const Heat_flow::Vectors result = flow.diffused(values, 1e-3, 1e-9);
  for(int k = 0; k < 3; ++k) {
    EXPECT_NEAR(result(1, k), 1, 1e-6);
    EXPECT_NEAR(result(3, k), 5, 1e-6);
  }
}

/// a lattice of cells with random areas, and links of random strengths: some repel, as those across
/// obtuse angles do, but no cell as much as the others hold it.
AP::internal::Linked_cells random_cells(int side)
{
  shapes::Random random(5);
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  AP::internal::Linked_cells cells;
  cells.areas.resize(side * side);
  const auto link = [&](int i, int j, double strength) {
    entries.emplace_back(i, j, -strength);
    entries.emplace_back(j, i, -strength);
    entries.emplace_back(i, i, strength);
    entries.emplace_back(j, j, strength);
  };
  for(int i = 0; i < side * side; ++i) {
    cells.areas[i] = std::pow(10, random(-6, 0));
    if(i % side > 0)
      link(i, i - 1, random(1, 100));
    if(i >= side)
      link(i, i - side, random(1, 100));
    if(i % side > 0 && i >= side)
      link(i, i - side - 1, random(-0.4, 0));
  }
  cells.conductances.resize(side * side, side * side);
  cells.conductances.setFromTriplets(entries.begin(), entries.end());
  return cells;
}

TEST(Implicit_step, is_approximated_by_a_cycle_that_is_symmetric_and_positive)
{
  constexpr int side = 40;
  const AP::internal::Cell_hierarchy cells(random_cells(side));
  ASSERT_GT(cells.levels().size(), 2u);
  shapes::Random random(6);
  using Vectors = AP::internal::Implicit_step::Vectors;
  const auto dot = [](const Vectors& a, const Vectors& b) {
    return a.col(0).cast<double>().dot(b.col(0).cast<double>());
  };
  for(const double time : {1e-3, 1., 1e4}) {
    const AP::internal::Implicit_step step(cells, time, 1);
    for(int repetition = 0; repetition < 20; ++repetition) {
      Vectors a = Vectors::Zero(side * side, 4), b = a;
      for(int i = 0; i < side * side; ++i) {
        a(i, 0) = float(random(-1, 1));
        b(i, 0) = float(random(-1, 1));
      }
      const Vectors of_a = step.approximate(a), of_b = step.approximate(b);
      EXPECT_GT(dot(a, of_a), 0);
      EXPECT_NEAR(dot(a, of_b), dot(b, of_a), 1e-4 * std::sqrt(dot(a, of_a) * dot(b, of_b)));
    }
  }
}

TEST(Cell_hierarchy, leaves_lone_cells_out_and_ends_at_stars)
{
  AP::internal::Linked_cells cells = random_cells(40);
  const Eigen::Index linked = cells.size(), all = 20 * linked;
  cells.areas.conservativeResizeLike(Eigen::VectorXd::Ones(all));
  cells.conductances.conservativeResize(all, all);
  const AP::internal::Cell_hierarchy hierarchy(std::move(cells));
  const auto& levels = hierarchy.levels();
  ASSERT_GE(levels.size(), 3u);
  EXPECT_LE(levels[1].size(), linked / 2);
  EXPECT_LE(levels.back().size(), linked / 8);
  EXPECT_NEAR(levels[1].areas.sum(), levels[0].areas.head(linked).sum(), 1e-9);

  constexpr std::size_t leaves = 1000;
  Heat_flow::Links links(leaves + 1);
  for(std::size_t i = 1; i <= leaves; ++i)
    links.add(0, i, 1);
  const Heat_flow star(std::vector<double>(leaves + 1, 1), std::move(links));
  Heat_flow::Vectors values = Heat_flow::Vectors::Zero(leaves + 1, 3);
  values.row(0).setConstant(leaves + 1);
  // (1 + t n) x0 - t n x1 = n + 1, and (1 + t) x1 - t x0 = 0.
  const double time = 10, hub = (leaves + 1) * (1 + time) / (1 + time * (leaves + 1));
  const Heat_flow::Vectors result = star.diffused(values, time, 0.01);
  EXPECT_NEAR(result(0, 0), hub, 0.05); // without coarser levels the error is underestimated
  EXPECT_NEAR(result(7, 1), hub * time / (1 + time), 0.05);
}

TEST(Heat_flow, makes_one_of_cells_of_which_none_has_an_area)
{
  Heat_flow::Links links(2);
  links.add(0, 1, 1);
  const Heat_flow flow({0, 0}, std::move(links));
  Heat_flow::Vectors values(2, 3);
  values << 0, 1, 2, 2, 1, 0;
  EXPECT_LT((flow.diffused(values, 1e4, 1e-4) - Heat_flow::Vectors::Ones(2, 3)).norm(), 0.01);
}

} // namespace
