// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What projecting a surface keeps: its area, its mean, and the integral of the map.

#include "shapes.h"

#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::pi;
using shapes::Soup;

TEST(Conservation, projected_areas_sum_to_the_area_at_any_spacing)
{
  for(const Soup& soup : {shapes::blob(3, 23), shapes::cylinder(30, 0.5, 2, false),
                          shapes::box(Point_3(0, 0, 0), Point_3(1, 2, 3))}) {
    const auto surface = shapes::scale_space_of(soup);
    EXPECT_NEAR(surface.area(1) / soup.area(), 1, 1e-12);
    for(const double radius : {0.1, 1., 10.})
      for(const double spacing : {0.02, 0.1, 1., 100.}) {
        double sum = 0;
        surface.project(radius, Side::INSIDE, spacing, [&](const AP::Projected_surfels& batch) {
          for(const double area : batch.areas)
            sum += area;
        });
        EXPECT_NEAR(sum / soup.area(), 1, 1e-12) << radius << ' ' << spacing;
      }
  }
}

// Merging and dividing keep the mean of the parallel surface: area by area, centroid ± R normal.
TEST(Conservation, the_mean_of_the_projected_surface_is_kept_at_any_spacing)
{
  const Soup blob = shapes::blob(3, 24);
  const auto surface = shapes::scale_space_of(blob);
  for(const Side side : {Side::INSIDE, Side::OUTSIDE})
    for(const double radius : {0.1, 0.9, 10.}) {
      const double distance = side == Side::INSIDE ? -radius : radius;
      Vector_3 expected(0, 0, 0);
      for(const shapes::Triangle& t : blob.triangles) {
        const Point_3 &p = blob.points[t[0]], &q = blob.points[t[1]], &r = blob.points[t[2]];
        expected = expected + std::sqrt(CGAL::squared_area(p, q, r)) *
                                  (CGAL::centroid(p, q, r) - CGAL::ORIGIN +
                                   distance * CGAL::unit_normal(p, q, r));
      }
      for(const double spacing : {0.02, 0.1, 1., 100.}) {
        Vector_3 sum(0, 0, 0);
        surface.project(radius, side, spacing, [&](const AP::Projected_surfels& batch) {
          for(std::size_t i = 0; i < batch.size(); ++i)
            sum = sum + batch.areas[i] * (batch.positions[i] - CGAL::ORIGIN);
        });
        EXPECT_NEAR(std::sqrt((sum - expected).squared_length()), 0, 1e-11 * (1 + radius));
      }
    }
}

// "No surfel stands for more than a square of the spacing does": the number of surfels of a flat
// patch is about its area over the squared spacing, however fine or coarse the mesh is.
TEST(Conservation, the_number_of_surfels_follows_the_spacing_and_not_the_mesh)
{
  for(const int n : {1, 10, 200}) {
    const auto surface = shapes::scale_space_of(shapes::plane_patch(1, 0, n));
    const AP::Kd_tree_evaluator tree(surface, 1, Side::INSIDE, 0.05);
    EXPECT_GT(tree.number_of_surfels(), 400 / 4) << n;
    EXPECT_LT(tree.number_of_surfels(), 400 * 4) << n;
  }
  const auto sphere = shapes::scale_space_of(shapes::icosphere(4));
  EXPECT_EQ(AP::Kd_tree_evaluator(sphere, 1, Side::INSIDE, 0.2).number_of_surfels(), 1u);
}

/// the sums of the map and of the map times the position, times the volume of a voxel.
std::pair<double, Vector_3> integral(const std::vector<float>& areas, const AP::Row_spans& region)
{
  double sum = 0;
  Vector_3 moment(0, 0, 0);
  shapes::for_each_voxel(region, [&](const Point_3& x, std::size_t place) {
    sum += areas[place];
    moment = moment + double(areas[place]) * (x - CGAL::ORIGIN);
  });
  const double volume = std::pow(region.grid().spacing(), 3);
  return {volume * sum, volume * moment};
}

// Each surfel adds its area once for each lattice point in its ball, whose number is that of voxels
// in the ball's volume on average over the places of the ball between the voxels. For one place it
// varies by about the root of the number of voxels at the surface, for which 4ρ is plenty for a
// radius of ρ voxels; for n surfels at different places by 4ρ/sqrt(n). The share of a piece is right to
// third order of its size over σ: a thousandth by default, far less for the small pieces here.
TEST(Conservation, the_integral_of_a_map_is_the_area_times_the_volume_of_the_ball)
{
  const Soup blob = shapes::blob(4, 25);
  const auto surface = shapes::scale_space_of(blob);
  const double voxel = 0.05;
  for(const AP::Scale& scale : {AP::Scale{0.2, 0.1}, AP::Scale{0.5, 0.25}, AP::Scale{0.3, 0.31}})
    for(const Side side : {Side::INSIDE, Side::OUTSIDE}) {
      const AP::Row_spans region(
          AP::grid_around(surface.bbox(), voxel, scale.radius + scale.sigma + voxel));
      const double rho = scale.sigma / voxel, ball = 4 * pi / 3 * std::pow(scale.sigma, 3);
      const double surfels =
          double(AP::Kd_tree_evaluator(surface, scale.radius, side, 0.2 * scale.sigma)
                     .number_of_surfels());
      const double tolerance = 4 * rho / std::sqrt(surfels) / (4 * pi / 3 * rho * rho * rho);

      const auto kernel = AP::Ball_kernel_3().nested_balls();
      AP::Grid_projector projector(region, kernel, 0.2);
      EXPECT_EQ(projector.project(surface, scale, side, shapes::Never()), 0); // nothing outside
      const auto areas = shapes::areas_on_grid(AP::Grid_projector(region, kernel, 0.2), surface,
                                               region, scale, side);
      const auto [sum, moment] = integral(areas, region);
      EXPECT_LT(tolerance, 0.02);
      EXPECT_NEAR(sum / (blob.area() * ball), 1, tolerance);

      Vector_3 expected(0, 0, 0);
      surface.project(scale.radius, side, 0.1, [&](const AP::Projected_surfels& batch) {
        for(std::size_t i = 0; i < batch.size(); ++i)
          expected = expected + batch.areas[i] * (batch.positions[i] - CGAL::ORIGIN);
      });
      const Vector_3 shift = moment / sum - expected / blob.area();
      EXPECT_LT(std::sqrt(shift.squared_length()), tolerance);
    }
}

// Of two spheres, one lands in the grid and one beside it.
TEST(Conservation, the_area_that_lands_outside_of_the_grid_is_told)
{
  const Soup near = shapes::icosphere(3), far = shapes::icosphere(3, Point_3(10, 0, 0), 1);
  const auto surface = shapes::scale_space_of(shapes::joined(near, far));
  const AP::Row_spans region(AP::grid_around(shapes::surface_of(near).bbox(), 0.1));
  const AP::Scale scale{0.5, 0.25};
  EXPECT_NEAR(AP::Grid_projector(region).project(surface, scale, Side::INSIDE, shapes::Never()),
              far.area(), 1e-12 * far.area());
  EXPECT_NEAR(
      AP::Exact_grid_projector(region).project(surface, scale, Side::INSIDE, shapes::Never()),
      far.area(), 1e-12 * far.area());
  EXPECT_NEAR(
      AP::Paper_grid_projector(region).project(surface, scale, Side::INSIDE, shapes::Never()),
      far.area(), 1e-12 * far.area());
}

} // namespace
