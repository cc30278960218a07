// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The transform on grids: against the evaluators, which know nothing of grids, and against what must
// be conserved.

#include "values_at_voxels.h"

#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::pi;
using shapes::Soup;

// ---------------------------------------------------------------- grid and k-d tree

/// \brief expects the grid to hold at each voxel what the k-d tree finds at its centre, for surfels that
/// are points: too far apart to be merged at the sampling ratio that is asked for.
///
/// Both sum the same surfels. The share of a point drops from 1 to 0 within `1.5e-5 σ` of the rim, as
/// patches_impl.h has it, and the grid computes distances with floats, which are 1e-6 voxels apart
/// near 10 voxels; so a surfel that close to the rim may count in part for the grid. For the rest the
/// sums differ by rounding: of each area to a multiple of at most 2^-29 of all area, and of the
/// result to a float.
void expect_grid_equals_kd_tree(const Soup& soup, const AP::Scale& scale, double voxel,
                                const std::vector<AP::Nested_ball>& kernel)
{
  const AP::Constant_scale_space surface(
      AP::sample_surfels(shapes::surface_of(soup), 0.15 * scale.sigma));
  const AP::Row_spans region(AP::grid_around(surface.bbox(), voxel, 0.37 * voxel));
  const double no_merging = 1e-4;
  const auto on_grid =
      shapes::areas_on_grid(AP::Grid_projector(region, kernel, no_merging), surface, region, scale);
  const AP::Kd_tree_evaluator tree(surface, scale.radius, Side::INSIDE, no_merging * scale.sigma);
  ASSERT_EQ(tree.number_of_surfels(), surface.source().size());
  const double rounding = double(tree.number_of_surfels() * kernel.size()) * 0x1p-29;
  const double rim = 3e-5 * scale.sigma + 2e-6 * voxel;

  const std::vector<double> at_points = shapes::values_at_voxels(tree, region, scale.sigma, kernel);
  shapes::for_each_voxel(region, [&](const Point_3& x, std::size_t place) {
    double surely_in = 0, possibly_in = 0;
    for(const AP::Nested_ball& ball : kernel) {
      surely_in += ball.weight * tree(x, ball.relative_radius * scale.sigma - rim);
      possibly_in += ball.weight * tree(x, ball.relative_radius * scale.sigma + rim);
    }
    const double tolerance = rounding * surface.area(scale.radius) + 1e-7 * possibly_in;
    ASSERT_GE(on_grid[place], surely_in - tolerance) << x;
    ASSERT_LE(on_grid[place], possibly_in + tolerance) << x;
  });
  // A surfel on the rim is one of some hundred in its ball, and such voxels are one in some hundred.
  EXPECT_LT(shapes::relative_rms(on_grid, at_points), 1e-3);
}

TEST(Grid_projector, equals_the_kd_tree_at_every_voxel_for_every_kernel)
{
  const Soup blob = shapes::blob(3, 21);
  for(const auto& kernel :
      {AP::Ball_kernel_3().nested_balls(), AP::Epanechnikov_kernel_3{4}.nested_balls(),
       AP::Gaussian_kernel_3{3., 4}.nested_balls()})
    for(const AP::Scale& scale : {AP::Scale{0.3, 0.15}, AP::Scale{0.6, 0.3}, AP::Scale{0.9, 0.5}})
      expect_grid_equals_kd_tree(blob, scale, 0.15, kernel);
}

TEST(Grid_projector, has_the_same_bits_for_every_instruction_set)
{
  using namespace AP::internal;
  const auto surface = shapes::scale_space_of(shapes::blob(3, 35));
  const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.05, 0.1));
  for(const double sigma : {0.004, 0.1, 0.45, 1.3}) // from far below a voxel to many lanes
    for(const auto& kernel :
        {AP::Ball_kernel_3().nested_balls(), AP::Gaussian_kernel_3{3., 3}.nested_balls()}) {
      std::vector<std::vector<float>> maps;
      for(const Instruction_set set : available_instruction_sets()) {
        chosen_instruction_set() = set;
        maps.push_back(shapes::areas_on_grid(AP::Grid_projector(region, kernel, 0.8), surface,
                                             region, {0.5, sigma}));
        EXPECT_EQ(maps.back(), maps.front()) << name(set) << ", sigma " << sigma;
      }
      chosen_instruction_set() = available_instruction_sets().back();
    }
}

TEST(Grid_projector, equals_the_kd_tree_for_small_and_for_large_balls)
{
  const Soup torus = shapes::torus(1, 0.4, 40, 20);
  const auto ball = AP::Ball_kernel_3().nested_balls();
  for(const double sigma : {0.05, 0.1, 0.2, 0.8})
    expect_grid_equals_kd_tree(torus, {0.35, sigma}, 0.1, ball);
}

// ---------------------------------------------------------------- grid and exact

struct Of_bundled_mesh : public ::testing::TestWithParam<std::string>
{};

// Two samplings at every scale that the descriptor of the paper uses: voxels of 1/50 of the longest
// side, R = 2, …, 9 voxels, over the interior.
TEST_P(Of_bundled_mesh, the_grid_comes_close_to_the_exact_map)
{
  const auto surface = shapes::scale_space_of(shapes::bundled_mesh(GetParam()));
  const CGAL::Bbox_3 box = surface.bbox();
  const double voxel = std::max({box.x_span(), box.y_span(), box.z_span()}) / 50;
  const AP::Row_spans region = AP::interior(surface.source(), AP::grid_around(box, voxel)).region;
  const auto ball = AP::Ball_kernel_3().nested_balls();
  for(int k = 2; k <= 9; ++k) {
    const AP::Scale scale{k * voxel, 0.5 * k * voxel};
    const auto exact =
        shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, scale);
    const auto error = [&](double sampling_ratio) {
      return shapes::relative_rms(
          shapes::areas_on_grid(AP::Grid_projector(region, ball, sampling_ratio), surface, region,
                                scale),
          exact);
    };
    const double of_default = error(AP::Grid_projector::default_sampling_ratio);
    const double of_half = error(0.5 * AP::Grid_projector::default_sampling_ratio);
    RecordProperty("percent_at_" + std::to_string(k), std::to_string(100 * of_default));
    RecordProperty("percent_of_half_at_" + std::to_string(k), std::to_string(100 * of_half));
    EXPECT_LE(of_default, 0.01) << "R = " << k << " voxels";
    EXPECT_LE(of_half, 0.0025) << "R = " << k << " voxels";
  }
}

INSTANTIATE_TEST_SUITE_P(All, Of_bundled_mesh,
                         ::testing::Values("hand.obj", "human_woman.obj", "scorpion_low.obj"),
                         [](const auto& mesh) {
                           return mesh.param.substr(0, mesh.param.find('.'));
                         });

// Surfels that land beside the grid still count where their balls reach into it.
TEST(Grid_projector, a_part_of_a_grid_holds_the_same_values_as_the_whole)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 26));
  const AP::Grid_3 whole = AP::grid_around(surface.bbox(), 0.1, 0.5);
  const std::array<int, 3> first{9, 11, 10};
  const AP::Grid_3 part(whole.point(first[0], first[1], first[2]), 0.1, {7, 5, 6});
  const AP::Row_spans whole_region(whole), part_region(part);
  for(const AP::Scale& scale : {AP::Scale{0.4, 0.12}, AP::Scale{0.5, 0.4}}) {
    const auto expected =
        shapes::areas_on_grid(AP::Grid_projector(whole_region), surface, whole_region, scale);
    const auto areas =
        shapes::areas_on_grid(AP::Grid_projector(part_region), surface, part_region, scale);
    std::vector<double> cut;
    for(int k = 0; k < 6; ++k)
      for(int j = 0; j < 5; ++j)
        for(int i = 0; i < 7; ++i)
          cut.push_back(expected[whole_region.index(first[0] + i, first[1] + j, first[2] + k)]);
    // The places between the voxels are rounded relative to another origin: a few surfels on rims.
    EXPECT_LT(shapes::relative_rms(areas, cut), 1e-3);
  }
}

// The largest balls hold whole rows in full: what they add must end with the hull of a row, wherever that
// lies in the ball.
TEST(Grid_projector, a_region_holds_the_same_values_as_the_whole_grid)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 27));
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.04);
  const AP::Row_spans everything(grid), inside = AP::interior(surface.source(), grid).region;
  for(const AP::Scale& scale : {AP::Scale{0.5, 0.25}, AP::Scale{0.2, 0.9}, AP::Scale{1.2, 1.9}}) {
    const auto all =
        shapes::areas_on_grid(AP::Grid_projector(everything), surface, everything, scale);
    const auto some = shapes::areas_on_grid(AP::Grid_projector(inside), surface, inside, scale);
    for(int k = 0; k < grid.size()[2]; ++k)
      for(int j = 0; j < grid.size()[1]; ++j)
        for(int i = 0; i < grid.size()[0]; ++i)
          if(inside.contains(i, j, k)) {
            ASSERT_EQ(some[inside.index(i, j, k)], all[everything.index(i, j, k)])
                << "sigma " << scale.sigma;
          }
  }
}

// ---------------------------------------------------------------- the algorithm of the paper

TEST(Paper_grid_projector, equals_votes_of_nearest_voxels_and_sums_over_balls_of_voxels)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 28));
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.15);
  const AP::Row_spans region(grid);
  for(const AP::Scale& scale : {AP::Scale{0.3, 0.15}, AP::Scale{0.7, 0.35}, AP::Scale{0.5, 0.5}}) {
    struct Vote
    {
      int i, j, k;
      double area;
    };
    std::vector<Vote> votes;
    surface.project(scale.radius, Side::INSIDE, grid.spacing(),
                    [&](const AP::Projected_surfels& batch) {
                      for(std::size_t s = 0; s < batch.size(); ++s) {
                        const Vector_3 v = grid.lattice_coordinates(batch.positions[s]);
                        votes.push_back({int(std::floor(v.x() + 0.5)), int(std::floor(v.y() + 0.5)),
                                         int(std::floor(v.z() + 0.5)), batch.areas[s]});
                      }
                    });
    const auto areas =
        shapes::areas_on_grid(AP::Paper_grid_projector(region), surface, region, scale);
    const double squared = std::pow(scale.sigma / grid.spacing(), 2) + 1e-9;
    for(int k = 0; k < grid.size()[2]; ++k)
      for(int j = 0; j < grid.size()[1]; ++j)
        for(int i = 0; i < grid.size()[0]; ++i) {
          double sum = 0;
          for(const Vote& v : votes)
            if((v.i - i) * (v.i - i) + (v.j - j) * (v.j - j) + (v.k - k) * (v.k - k) <= squared)
              sum += v.area;
          // Sums of thousands of floats.
          ASSERT_NEAR(areas[region.index(i, j, k)], sum, 1e-5 * (1 + sum));
        }
  }
}

TEST(Paper_grid_projector, is_farther_from_the_exact_map_than_the_default_projector)
{
  const auto surface = shapes::scale_space_of(shapes::icosphere(4, Point_3(0.01, 0.02, 0.03), 1));
  const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.1));
  for(const AP::Scale& scale : {AP::Scale{0.4, 0.2}, AP::Scale{0.6, 0.3}}) {
    const auto exact =
        shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, scale);
    const double of_paper = shapes::relative_rms(
        shapes::areas_on_grid(AP::Paper_grid_projector(region), surface, region, scale), exact);
    const double of_default = shapes::relative_rms(
        shapes::areas_on_grid(AP::Grid_projector(region), surface, region, scale), exact);
    EXPECT_GT(of_paper, 7 * of_default);
  }
}

// ---------------------------------------------------------------- order and similarity

/// a closed sheet without thickness: each face has another one behind it, at the same place.
Soup doubled_sheet()
{
  const Soup patch = shapes::lattice_patch(12, 9, [](int i, int j) {
    const double u = i / 6. - 1, v = j / 5. - 0.9;
    return Point_3(u, v, 0.3 * u * v + 0.1 * u * u);
  });
  return shapes::joined(patch, shapes::flipped(patch));
}

TEST(Same_bits, the_order_of_faces_and_points_does_not_matter)
{
  for(const Soup& soup : {shapes::blob(4, 29), shapes::torus(1, 0.4, 40, 20), doubled_sheet()}) {
    const auto surface = shapes::scale_space_of(soup);
    const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.07, 0.3));
    for(const AP::Scale& scale : {AP::Scale{0.2, 0.1}, AP::Scale{0.4, 0.2}}) {
      const auto expected =
          shapes::areas_on_grid(AP::Grid_projector(region), surface, region, scale);
      const auto expected_exact =
          shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, scale);
      for(const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto other = shapes::scale_space_of(shapes::shuffled(soup, seed));
        EXPECT_EQ(shapes::areas_on_grid(AP::Grid_projector(region), other, region, scale),
                  expected);
        EXPECT_EQ(shapes::areas_on_grid(AP::Exact_grid_projector(region), other, region, scale),
                  expected_exact);
      }
    }
  }
}

/// the map of a moved shape on the grid around it.
template <class Projector>
std::vector<float> map_of(const Soup& soup, double unit)
{
  const auto surface = shapes::scale_space_of(soup);
  const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.08 * unit));
  return shapes::areas_on_grid(Projector(region), surface, region, {0.5 * unit, 0.25 * unit});
}

// A grid follows its shape, so only rounding can differ: a few surfels on the rims of balls.
TEST(Similarity, scaled_and_translated_maps_are_the_same)
{
  const Soup blob = shapes::blob(3, 30);
  const auto expected = map_of<AP::Grid_projector>(blob, 1);
  auto scaled = map_of<AP::Grid_projector>(shapes::scaled(blob, 1000), 1000);
  for(float& value : scaled)
    value /= 1e6f;
  ASSERT_EQ(scaled.size(), expected.size());
  EXPECT_LT(shapes::relative_rms(scaled, expected), 1e-3);
  const auto translated =
      map_of<AP::Grid_projector>(shapes::translated(blob, Vector_3(1024, -4096, 512)), 1);
  ASSERT_EQ(translated.size(), expected.size());
  EXPECT_LT(shapes::relative_rms(translated, expected), 1e-3);
}

/// the root of the mean square of a map, which a rotation keeps.
double rms(const std::vector<float>& values)
{
  double sum = 0;
  for(const float value : values)
    sum += double(value) * double(value);
  return std::sqrt(sum);
}

TEST(Similarity, exchanging_axes_exchanges_the_axes_of_the_exact_map)
{
  const Soup blob = shapes::blob(3, 31);
  const Soup turned =
      shapes::moved(blob, [](const Point_3& p) { return Point_3(p.y(), p.z(), p.x()); });
  const AP::Scale scale{0.5, 0.25};
  const auto surface = shapes::scale_space_of(blob), other = shapes::scale_space_of(turned);
  const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.08));
  const AP::Row_spans other_region(AP::grid_around(other.bbox(), 0.08));
  const auto exact =
      shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, scale);
  const auto turned_exact =
      shapes::areas_on_grid(AP::Exact_grid_projector(other_region), other, other_region, scale);
  const auto grid = shapes::areas_on_grid(AP::Grid_projector(region), surface, region, scale);
  const auto turned_grid =
      shapes::areas_on_grid(AP::Grid_projector(other_region), other, other_region, scale);
  const auto& size = region.grid().size();
  std::vector<double> back_exact(exact.size()), back_grid(exact.size());
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j)
      for(int i = 0; i < size[0]; ++i) {
        back_exact[region.index(i, j, k)] = turned_exact[other_region.index(j, k, i)];
        back_grid[region.index(i, j, k)] = turned_grid[other_region.index(j, k, i)];
      }
  // Rounding to integers and floats for the one, another choice of samples for the other.
  EXPECT_LT(shapes::relative_rms(back_exact, exact), 1e-6);
  EXPECT_LT(shapes::relative_rms(back_grid, grid), 2 * 0.015);
  EXPECT_NE(exact, turned_exact); // the blob has no such symmetry itself
}

// The sum of squares over the voxels is a Riemann sum of a map that is smooth at the scale σ of three
// voxels, over all of it: the places of the voxels hardly matter.
TEST(Similarity, rotation_keeps_the_mean_square_of_the_map)
{
  const Soup blob = shapes::blob(3, 32);
  const double expected = rms(map_of<AP::Grid_projector>(blob, 1));
  shapes::Random random(33);
  for(int n = 0; n < 3; ++n) {
    const Soup rotated = shapes::moved(blob, shapes::Rotation{random.direction(), random(0, 6)});
    EXPECT_NEAR(rms(map_of<AP::Grid_projector>(rotated, 1)) / expected, 1, 0.02);
  }
}

// ---------------------------------------------------------------- errors and limits

// A shape that is moved by 10^188 has corners 10^172 apart, and variances that are not finite.
TEST(Patch_maker, takes_what_rounding_spreads_for_a_point)
{
  using AP::internal::Patch;
  const AP::internal::Patch_maker maker(AP::Grid_3(Point_3(0, 0, 0), 1, {10, 10, 10}), 2);
  const std::array<double, 3> in_grid{3.25, 4, 5}, far_away{-2e188, 4, 5};
  Patch point;
  ASSERT_TRUE(maker.make(in_grid, AP::Covariance_3(), point));
  for(const double variance : {4., 1e200, std::numeric_limits<double>::infinity()}) {
    AP::Covariance_3 covariance;
    covariance.xx = covariance.yy = covariance.zz = variance;
    Patch patch;
    EXPECT_FALSE(maker.make(far_away, covariance, patch));
    ASSERT_TRUE(maker.make(in_grid, covariance, patch));
    EXPECT_EQ(patch.i, 3);
    EXPECT_EQ(patch.reach, point.reach);
    EXPECT_EQ(patch.full, point.full);
    EXPECT_EQ(patch.quarter, point.quarter);
  }
}

TEST(Grid_projectors, refuse_what_they_cannot_do)
{
  const AP::Row_spans region(AP::Grid_3(Point_3(0, 0, 0), 0.1, {4, 4, 4}));
  EXPECT_EQ(shapes::complaint(
                [&] { AP::Grid_projector(region, AP::Ball_kernel_3().nested_balls(), 0.); }),
            "sampling_ratio is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint(
                [&] { AP::Grid_projector(region, AP::Ball_kernel_3().nested_balls(), 1.5); }),
            "sampling_ratio is 1.5: must be at most 1");
  const Soup sphere = shapes::icosphere(1);
  const AP::Constant_scale_space surface(AP::surface_from_triangle_soup(
      sphere.points, sphere.triangles, AP::parameters::use_interpolated_normals(true)));
  EXPECT_EQ(
      shapes::complaint([&] {
        AP::Exact_grid_projector(region).project(surface, {1, 0.5}, Side::INSIDE, shapes::Never());
      }),
      "surface has interpolated normals: exact evaluation needs a constant normal on each "
      "triangle");
}

TEST(Grid_projectors, find_nothing_where_there_is_no_surface)
{
  const AP::Constant_scale_space nothing{AP::Triangle_surface()};
  const AP::Row_spans region(AP::Grid_3(Point_3(0, 0, 0), 0.1, {4, 5, 6}));
  const std::vector<float> zeros(4 * 5 * 6, 0.f);
  const AP::Scale scale{0.3, 0.15};
  EXPECT_EQ(shapes::areas_on_grid(AP::Grid_projector(region), nothing, region, scale), zeros);
  EXPECT_EQ(shapes::areas_on_grid(AP::Exact_grid_projector(region), nothing, region, scale), zeros);
  EXPECT_EQ(shapes::areas_on_grid(AP::Paper_grid_projector(region), nothing, region, scale), zeros);
}

// A projector is used for one scale after the other: nothing of a scale may be left for the next.
TEST(Grid_projectors, start_afresh_at_every_scale)
{
  const auto surface = shapes::scale_space_of(shapes::blob(3, 34));
  const AP::Row_spans region(AP::grid_around(surface.bbox(), 0.1));
  const std::vector<AP::Scale> scales{{0.9, 0.45}, {0.2, 0.1}, {0.6, 0.3}, {0.6, 0.3}};
  const auto expect_afresh = [&](auto make_projector) {
    auto projector = make_projector();
    for(const AP::Scale& scale : scales)
      EXPECT_EQ(shapes::areas_on_grid(projector, surface, region, scale),
                shapes::areas_on_grid(make_projector(), surface, region, scale));
  };
  expect_afresh([&] { return AP::Grid_projector(region); });
  expect_afresh([&] { return AP::Exact_grid_projector(region); });
  expect_afresh([&] { return AP::Paper_grid_projector(region); });
}

} // namespace
