// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds for any surface at any parameters, tried on random ones with all defects that meshes have.
//
// Some tens of cases each; more if the environment says so: AREA_PROJECTION_TRANSFORM_CASES, and
// AREA_PROJECTION_TRANSFORM_SEED for others (scripts/property-tests). A failure names the seed of its case.

#include "random_surface.h"

#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstdlib>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::pi;
using shapes::Random;
using shapes::Soup;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise)
{
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// a surface and a scale that suits it: extents are of the order of 1.
struct Case
{
  Soup soup;
  AP::Scale scale;
  Side side;
  Random random;

  explicit Case(std::uint64_t seed) : random(seed)
  {
    soup = shapes::random_surface(random);
    const double radius = random(0.05, 1);
    scale = {radius, radius * random(0.1, 0.95)};
    side = random() < 0.5 ? Side::INSIDE : Side::OUTSIDE;
  }

  AP::Exact_evaluator exact(const Soup& of) const
  {
    return AP::Exact_evaluator(shapes::scale_space_of(of), scale.radius, side);
  }

  /// a point near the projected surface, so that there is something to be found: one of a face, moved.
  Point_3 place()
  {
    const auto& t = soup.triangles[std::size_t(random(0, double(soup.triangles.size())))];
    const Point_3 centroid =
        CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    return centroid + random(0, 1.5) * scale.radius * random.direction();
  }
};

/// calls `test(case)` for each case; `share` of them where one takes longer.
template <class Test>
void for_each_case(double share, const Test& test)
{
  const std::uint64_t seed = from_environment("AREA_PROJECTION_TRANSFORM_SEED", 1);
  const double cases = double(from_environment("AREA_PROJECTION_TRANSFORM_CASES", 200));
  for(std::uint64_t i = 0; i < std::uint64_t(std::ceil(share * cases)); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    Case of_seed(seed + i);
    test(of_seed);
    if(testing::Test::HasFatalFailure())
      return;
  }
}

/// expects a value to lie between those of a smaller and a larger ball, as it must if places are known only up to
/// `rim`; areas up to `tolerance`.
void expect_between(const AP::Exact_evaluator& exact, const Point_3& x, double sigma, double rim,
                    double tolerance, double value)
{
  ASSERT_GE(value, exact(x, std::max(sigma - rim, 0.)) - tolerance) << x;
  ASSERT_LE(value, exact(x, sigma + rim) + tolerance) << x;
}

TEST(Properties, values_are_the_sum_of_the_voters_and_at_most_all_area)
{
  for_each_case(1, [](Case& c) {
    const AP::Triangle_surface surface = shapes::surface_of(c.soup);
    const double area = surface.total_area();
    EXPECT_NEAR(area, c.soup.area(), 1e-12 * area);
    const AP::Exact_evaluator exact = c.exact(c.soup);
    const double distance = AP::internal::signed_distance(c.side, c.scale.radius);
    for(int i = 0; i < 20; ++i) {
      const Point_3 x = c.place();
      double of_voters = 0;
      for(std::size_t t = 0; t < surface.size(); ++t) {
        const double fraction = AP::internal::projected_triangle(surface, t, distance)
                                    .fraction_within(x, c.scale.sigma);
        ASSERT_GE(fraction, 0);
        ASSERT_LE(fraction, 1 + 1e-12);
        of_voters += fraction * surface.areas[t];
      }
      const double value = exact(x, c.scale.sigma);
      ASSERT_NEAR(value, of_voters, 1e-12 * area); // two orders of some hundred terms
      ASSERT_GE(value, 0);
      ASSERT_GE(exact(x, 1.5 * c.scale.sigma), value - 1e-12 * area);
    }
    EXPECT_NEAR(exact(Point_3(0, 0, 0), 100), area, 1e-12 * area);
  });
}

// Samples of a face share its area. All that is projected into a grid with room on all sides is found there: each
// surfel in as many voxels as its ball has lattice points, and that number n is known from the cubes around them, which
// hold and are held by balls: 4π/3 (σ/h - √3/2)³ <= n <= 4π/3 (σ/h + √3/2)³.
TEST(Properties, area_is_conserved)
{
  for_each_case(0.5, [](Case& c) {
    const auto surface = shapes::scale_space_of(c.soup);
    const double area = surface.source().total_area();
    const AP::Surfels samples = AP::sample_surfels(surface.source(), c.scale.sigma);
    EXPECT_NEAR(samples.total_area(), area, double(samples.size()) * 0x1p-52 * area); // rounding

    const double voxel = c.scale.sigma / c.random(1.5, 3);
    const AP::Grid_3 grid = AP::grid_around(surface.bbox(), std::max(voxel, 0.08),
                                            c.scale.radius + c.scale.sigma + 2 * voxel);
    const AP::Row_spans region(grid);
    AP::Exact_grid_projector projector(region);
    const auto map = shapes::areas_on_grid(projector, surface, region, c.scale, c.side);
    double sum = 0;
    for(const float value : map) {
      ASSERT_GE(value, 0);
      ASSERT_LE(value, area * (1 + 1e-6));
      sum += double(value);
    }
    const double ratio = c.scale.sigma / grid.spacing(), half_cube = std::sqrt(3.) / 2;
    EXPECT_GE(sum, 4 * pi / 3 * std::pow(std::max(ratio - half_cube, 0.), 3) * area * (1 - 1e-4));
    EXPECT_LE(sum, 4 * pi / 3 * std::pow(ratio + half_cube, 3) * area * (1 + 1e-4));
  });
}

// Rounding moves points by some 1e-15 of what they are away from the origin.
TEST(Properties, values_follow_a_similarity)
{
  for_each_case(1, [](Case& c) {
    const double factor = std::exp(c.random(-5, 5));
    const shapes::Rotation rotation{c.random.direction(), c.random(0, 2 * pi)};
    const Vector_3 shift = 10 * factor * c.random.direction();
    const auto similarity = [&](const Point_3& p) {
      return CGAL::ORIGIN + factor * (rotation(p) - CGAL::ORIGIN) + shift;
    };
    const AP::Exact_evaluator before = c.exact(c.soup);
    const AP::Exact_evaluator after(shapes::scale_space_of(shapes::moved(c.soup, similarity)),
                                    factor * c.scale.radius, c.side);
    for(int i = 0; i < 20; ++i) {
      const Point_3 x = c.place();
      expect_between(before, x, c.scale.sigma, 1e-10, 1e-9 * c.soup.area(),
                     after(similarity(x), factor * c.scale.sigma) / (factor * factor));
    }
  });
}

// No point of a piece is farther from its centroid than 2/√3 of the spacing: two thirds of a median are at most
// √(2 (b² + c²)) / 3, and the squares of the edges sum to at most 6 spacings squared (`largest_variance()`).
TEST(Properties, samples_come_as_close_as_their_spacing_says)
{
  for_each_case(0.5, [](Case& c) {
    const auto surface = shapes::scale_space_of(c.soup);
    const AP::Exact_evaluator exact = c.exact(c.soup);
    const double spacing = std::max(0.1 * c.scale.sigma, 0.01);
    const double rim = 2 / std::sqrt(3.) * spacing;
    const AP::Kd_tree_evaluator tree(surface, c.scale.radius, c.side, spacing);
    const AP::Sampled_evaluator cells(surface, c.scale.radius, c.side, spacing);
    for(int i = 0; i < 10; ++i) {
      const Point_3 x = c.place();
      for(const double value : {tree(x, c.scale.sigma), cells(x, c.scale.sigma)})
        expect_between(exact, x, c.scale.sigma, rim, 1e-9 * c.soup.area(), value);
    }
  });
}

// The exact grid knows places up to some 1e-6 of the grid and rounds each triangle to 2^-30 of all area; of a triangle
// that the rim cuts, it errs by less than 1e-4. A piece of the other one is a fuzzy spot that reaches two spacings far.
TEST(Properties, grids_have_what_the_tree_has)
{
  for_each_case(0.25, [](Case& c) {
    const auto surface = shapes::scale_space_of(c.soup);
    const AP::Exact_evaluator exact = c.exact(c.soup);
    const double voxel = std::max(c.scale.sigma / 3, 0.1), ratio = 0.1;
    const AP::Row_spans region(AP::grid_around(surface.bbox(), voxel));
    const auto of_triangles =
        shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, c.scale, c.side);
    const auto of_pieces =
        shapes::areas_on_grid(AP::Grid_projector(region, AP::Ball_kernel_3().nested_balls(), ratio),
                              surface, region, c.scale, c.side);
    const double area = c.soup.area(), rounding = double(c.soup.triangles.size()) * 0x1p-30 * area;
    std::size_t number = 0;
    shapes::for_each_voxel(region, [&](const Point_3& x, std::size_t place) {
      if(number++ % 11 != 0)
        return;
      expect_between(exact, x, c.scale.sigma, 1e-4 * voxel, rounding + 1e-6 * area,
                     of_triangles[place]);
      expect_between(exact, x, c.scale.sigma, 2 * ratio * c.scale.sigma, 1e-4 * area,
                     of_pieces[place]);
    });
  });
}

#ifdef CGAL_LINKED_WITH_TBB
template <class Function>
void with_threads(int number, const Function& function)
{
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(number));
  tbb::task_arena(number).execute(function);
}

TEST(Properties, threads_and_the_order_of_faces_do_not_change_a_bit)
{
  using Surface = AP::Constant_scale_space<AP::Triangle_surface>;
  for_each_case(0.2, [](Case& c) {
    const auto joint_map = [&](auto tag, const Soup& soup) {
      const std::vector<AP::Scale> scales = AP::proportional_scales(
          {0.3 * c.scale.radius, 0.6 * c.scale.radius, c.scale.radius}, 0.5);
      AP::Map_session<Surface, decltype(tag)> session(shapes::scale_space_of(soup), 0.1,
                                                      c.scale.radius);
      const AP::Joint_map map = session.joint_map(scales, c.side);
      return std::make_pair(map.values(), map.scale_indices());
    };
    const auto expected = joint_map(CGAL::Sequential_tag(), c.soup);
    EXPECT_EQ(joint_map(CGAL::Sequential_tag(), shapes::shuffled(c.soup, 5)), expected);
    for(const int threads : {1, 2, 3, 8})
      with_threads(threads, [&] {
        ASSERT_EQ(joint_map(CGAL::Parallel_tag(), c.soup), expected) << threads << " threads";
      });
  });
}
#endif

} // namespace
