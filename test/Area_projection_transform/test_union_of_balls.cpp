// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Unions of balls: volume, mesh and distances that are known in closed form, and how shapes differ from them.

#include "balls_at.h"
#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_axis_comparison/Surface_distance.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/ball_volume.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/distances_from_balls.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/reconstruction_error.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_topology.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/union_of_balls_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace shapes;
using AP::Ball_volume;
using AP::Medial_representation;
using Parallel = CGAL::Parallel_if_available_tag;

/// balls along a ring, of changing radius.
Medial_representation ring_of_balls(std::size_t number)
{
  Medial_representation ring;
  for(std::size_t i = 0; i < number; ++i) {
    const double angle = 2 * pi * double(i) / double(number);
    ring.centers.emplace_back(std::cos(angle), std::sin(angle), 0.1 * std::cos(3 * angle));
    ring.radii.push_back(0.3 + 0.05 * std::sin(2 * angle));
  }
  return ring;
}

double volume_of(const AP::Triangle_surface& surface)
{
  double sum = 0;
  for(std::size_t t = 0; t < surface.size(); ++t)
    sum += CGAL::volume(Point_3(0, 0, 0), surface.corner(t, 0), surface.corner(t, 1),
                        surface.corner(t, 2));
  return sum;
}

TEST(Ball_volume, of_two_that_overlap_is_that_of_both_less_the_lens)
{
  for(const double d : {0., 0.5, 1.5, 2.5}) {
    const double lens = d < 2 ? pi * (4 + d) * (2 - d) * (2 - d) / 12 : 0;
    const Ball_volume volume =
        AP::ball_volume(balls_at({{0, 0, 0}, {d, 0, 0}}, {1, 1}), AP::Triangle_surface());
    EXPECT_NEAR(volume.balls.value, 2 * 4 * pi / 3 - lens, 5 * volume.balls.error);
    EXPECT_LT(volume.balls.error, 0.003 * volume.balls.value);
    EXPECT_FALSE(volume.solid || volume.common || volume.overlap());
  }
}

TEST(Ball_volume, knows_what_is_in_the_solid)
{
  // An eighth of a ball around the corner of a cube.
  const AP::Triangle_surface cube = surface_of(box(Point_3(0, 0, 0), Point_3(1, 1, 1)));
  const Ball_volume volume = AP::ball_volume<Parallel>(balls_at({{1, 1, 1}}, {0.5}), cube);
  const double ball = 4 * pi / 3 / 8;
  ASSERT_TRUE(volume.solid && volume.common);
  EXPECT_NEAR(volume.balls.value, ball, 5 * volume.balls.error);
  EXPECT_NEAR(volume.solid->value, 1, 5 * volume.solid->error);
  EXPECT_NEAR(volume.common->value, ball / 8, 5 * volume.common->error);
  EXPECT_LT(volume.common->error, 0.02 * ball / 8);
  EXPECT_NEAR(*volume.overlap(), ball / 8 / (1 + ball - ball / 8), 0.005);
  // A cavity is not in it.
  const Soup shell = joined(icosphere(4), flipped(icosphere(4, Point_3(0, 0, 0), 0.5)));
  const Ball_volume of_shell = AP::ball_volume(balls_at({{0, 0, 0}}, {1}), surface_of(shell));
  EXPECT_NEAR(of_shell.common->value, shell.volume(), 5 * of_shell.common->error + 1e-6);
}

TEST(Ball_volume, has_the_error_that_it_tells)
{
  const auto balls = balls_at({{0, 0, 0}, {0.9, 0.3, 0.2}}, {1, 0.7});
  const double d = std::sqrt(0.9 * 0.9 + 0.3 * 0.3 + 0.2 * 0.2), r = 0.7;
  const double lens =
      pi * (1 + r - d) * (1 + r - d) * (d * d + 2 * d * (1 + r) - 3 * (1 - r) * (1 - r)) / (12 * d);
  const double expected = 4 * pi / 3 * (1 + r * r * r) - lens;
  double squares = 0;
  constexpr int trials = 60;
  for(int seed = 0; seed < trials; ++seed) {
    const auto volume =
        AP::ball_volume(balls, AP::Triangle_surface(), std::uint64_t(seed), 16).balls;
    squares += CGAL::square((volume.value - expected) / volume.error);
  }
  // The mean of 60 squares of normal numbers is 1 with a standard deviation of √(2/60); five of these.
  EXPECT_NEAR(squares / trials, 1, 5 * std::sqrt(2. / trials));
}

TEST(Ball_volume, is_the_same_for_any_number_of_threads)
{
  const AP::Triangle_surface surface = surface_of(blob(3, 1));
  const auto balls = balls_at({{0, 0, 0}, {0.5, 0, 0}}, {0.8, 0.6});
  const auto one = AP::ball_volume<CGAL::Sequential_tag>(balls, surface, 3);
  const auto many = AP::ball_volume<Parallel>(balls, surface, 3);
  EXPECT_EQ(one.balls.value, many.balls.value);
  EXPECT_EQ(one.common->value, many.common->value);
  EXPECT_EQ(one.solid->error, many.solid->error);
}

TEST(Ball_volume, says_what_is_wrong)
{
  for(const std::size_t rows : {std::size_t(0), std::size_t(-1)})
    EXPECT_NE(complaint([&] {
                AP::ball_volume(balls_at({{0, 0, 0}}, {1}), AP::Triangle_surface(), 0, rows);
              }).find("rows"),
              std::string::npos);
}

TEST(Ball_volume, of_a_solid_is_unknown_where_lines_cannot_miss_its_edges)
{
  // At 2^53 numbers are apart by 2: each place within the cube of two steps is on an edge, or on a diagonal.
  const double far = 0x1p53;
  const AP::Triangle_surface cube =
      surface_of(box(Point_3(far, far, 0), Point_3(far + 2, far + 2, 1)));
  const Ball_volume volume = AP::ball_volume(balls_at({{far, far, 0}}, {1}), cube);
  EXPECT_FALSE(volume.solid || volume.common || volume.overlap());
}

TEST(Union_of_balls_mesh, of_a_ball_is_within_the_sagitta)
{
  for(const double cell : {0.4, 0.1, 0.03}) {
    const AP::Triangle_surface mesh =
        AP::union_of_balls_mesh(balls_at({{0.1, 0.2, 0.3}}, {1}), cell);
    EXPECT_TRUE(AP::shape_topology(mesh) == (AP::Betti_numbers{1, 0, 0}));
    EXPECT_EQ(mesh.number_of_skipped_faces, 0u);
    // Corners may be a hundredth of the diagonal of a cell off, and triangles deviate by cell² / 2r beside.
    const double off = 0.01 * std::sqrt(3.) * cell, deep = off + cell * cell / (2 * (1 - off));
    for(const Point_3& p : AP::sample_surfels(mesh, 0.3 * cell).positions) {
      const double height = std::sqrt(CGAL::squared_distance(p, Point_3(0.1, 0.2, 0.3))) - 1;
      EXPECT_LT(height, off);
      EXPECT_GT(height, -deep);
    }
    // A shell of that height, and the same of its area: it is inscribed but for the corners.
    EXPECT_NEAR(volume_of(mesh), 4 * pi / 3, 4 * pi * deep);
    EXPECT_LT(volume_of(mesh), 4 * pi / 3 * std::pow(1 + off, 3));
    EXPECT_NEAR(mesh.total_area(), 4 * pi, 2 * 4 * pi * deep);
  }
}

TEST(Union_of_balls_mesh, of_two_has_the_area_and_volume_of_their_union)
{
  for(const double d : {0.5, 1.5, 2.5}) {
    const auto balls = balls_at({{0, 0, 0}, {d, 0, 0}}, {1, 1});
    const double lens = d < 2 ? pi * (4 + d) * (2 - d) * (2 - d) / 12 : 0;
    const double cap = d < 2 ? 2 * pi * (1 - d / 2) : 0; // of each sphere, in the other
    const double crease = d < 2 ? 2 * pi * std::sqrt(1 - d * d / 4) : 0;
    for(const double cell : {0.1, 0.05}) {
      const AP::Triangle_surface mesh = AP::union_of_balls_mesh<Parallel>(balls, cell);
      const double deep = 0.02 * cell + cell * cell / 2;
      // Where the spheres meet a strip of about two cells is cut straight, with less than half of a cell² beneath it.
      EXPECT_NEAR(volume_of(mesh), 8 * pi / 3 - lens, 8 * pi * deep + 0.5 * crease * cell * cell);
      EXPECT_NEAR(mesh.total_area(), 8 * pi - 2 * cap, 16 * pi * deep + crease * cell);
      EXPECT_EQ(AP::shape_topology(mesh)->components, d < 2 ? 1 : 2);
    }
  }
}

TEST(Union_of_balls_mesh, is_a_manifold_near_the_boundary)
{
  // Balls by chance, and some that only touch, are the same, are in others, or are too small for the lattice.
  Random random(5);
  Medial_representation balls =
      balls_at({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0.1, 0, 0}, {3, 3, 3}}, {1, 1, 1, 0.2, 1e-4});
  for(int i = 0; i < 300; ++i) {
    balls.centers.push_back(random.point_in({-2, -2, -2, 2, 2, 2}));
    balls.radii.push_back(random(0.02, 0.4));
  }
  for(const double cell : {0.5, 0.13, 0.07}) {
    const AP::Triangle_surface mesh = AP::union_of_balls_mesh(balls, cell);
    EXPECT_TRUE(AP::shape_topology(mesh).has_value()); // closed, and each edge has two faces
    EXPECT_EQ(mesh.number_of_skipped_faces, 0u);
    const auto distances =
        AP::distances_from_balls(AP::sample_surfels(mesh, 0.5 * cell).positions, balls);
    for(const double distance : distances) { // inside one ball alone tells, and it may be deeper
      EXPECT_LT(distance, 1.02 * cell);
      EXPECT_GT(distance, -1.02 * cell);
    }
  }
}

TEST(Union_of_balls_mesh, is_the_same_for_any_number_of_threads)
{
  const auto one = AP::union_of_balls_mesh<CGAL::Sequential_tag>(ring_of_balls(50), 0.03);
  const auto many = AP::union_of_balls_mesh<Parallel>(ring_of_balls(50), 0.03);
  EXPECT_EQ(one.points, many.points);
  EXPECT_EQ(one.triangles, many.triangles);
  EXPECT_TRUE(AP::shape_topology(one) == (AP::Betti_numbers{1, 1, 0}));
}

TEST(Union_of_balls_mesh, says_what_is_wrong)
{
  EXPECT_TRUE(AP::union_of_balls_mesh({}, 1).empty());
  EXPECT_TRUE(AP::union_of_balls_mesh(balls_at({{0, 0, 0}}, {0}), 1).empty());
  const auto with = [](double cell) {
    return complaint([=] { AP::union_of_balls_mesh(balls_at({{0, 0, 0}}, {1}), cell); });
  };
  for(const double cell : {0., -1., std::nan(""), 1e-4})
    EXPECT_NE(with(cell).find("cell"), std::string::npos) << cell;
  EXPECT_NE(with(1e-4).find("at least"), std::string::npos);
}

TEST(Distances_from_balls, are_the_least_of_all)
{
  Random random(7);
  Medial_representation balls = ring_of_balls(300);
  for(int i = 0; i < 300; ++i) { // nearly the same, as in a sphere
    balls.centers.push_back(Point_3(3, 0, 0) + 1e-4 * random.direction());
    balls.radii.push_back(1 + 1e-5 * random());
  }
  balls.centers.emplace_back(0, 0, 0);
  balls.radii.push_back(0); // no ball at all
  std::vector<Point_3> places;
  for(int i = 0; i < 3000; ++i)
    places.push_back(i % 3 == 0 ? random.point_in({-2, -2, -2, 5, 2, 2})
                                : Point_3(3, 0, 0) + random.direction() * random(0.9, 1.1));
  const std::vector<double> distances = AP::distances_from_balls(places, balls);
  EXPECT_EQ(distances, AP::distances_from_balls<Parallel>(places, balls));
  for(std::size_t k = 0; k < places.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i + 1 < balls.size(); ++i)
      least = std::min(least, std::sqrt(CGAL::squared_distance(places[k], balls.centers[i])) -
                                  balls.radii[i]);
    EXPECT_EQ(distances[k], least);
  }
  EXPECT_TRUE(std::isinf(AP::distances_from_balls(places, {})[0]));
}

TEST(Surface_distance, is_that_from_the_triangles)
{
  const AP::Triangle_surface cube = surface_of(box(Point_3(0, 0, 0), Point_3(1, 1, 1)));
  const AP::Surface_distance<AP::Triangle_surface> distance(cube);
  EXPECT_NEAR(distance(Point_3(0.5, 0.4, 0.45)), 0.4, 1e-15);
  EXPECT_NEAR(distance(Point_3(2, 2, 0.5)), std::sqrt(2.), 1e-15);
  AP::Surfels points;
  points.push_back(Point_3(0, 0, 1), Vector_3(0, 0, 1), 1, 0);
  points.push_back(Point_3(0, 0, -1), Vector_3(0, 0, -1), 1, 1);
  EXPECT_NEAR(AP::Surface_distance<AP::Surfels>(points)(Point_3(3, 0, -3)), std::sqrt(13.), 1e-15);
}

TEST(Reconstruction_error, tells_what_is_missing_and_what_sticks_out)
{
  const AP::Triangle_surface sphere = surface_of(icosphere(5));
  // The ball of radius r at the height h: a place at the angle θ from it is √(1 + h² - 2 h cos θ) - r away, and
  // one of the ball at the angle φ is √(h² + r² + 2 h r cos φ) - 1 outside.
  const double h = 0.3, r = 0.8, spacing = 0.02;
  const auto error =
      AP::reconstruction_error<Parallel>(balls_at({{0, 0, h}}, {r}), sphere, spacing);
  double missing = 0, protrusion = 0;
  constexpr int steps = 10000;
  for(int i = 0; i < steps; ++i) { // heights are uniform, by Archimedes
    const double cosine = -1 + 2 * (i + 0.5) / steps;
    missing += std::max(std::sqrt(1 + h * h - 2 * h * cosine) - r, 0.) / steps;
    protrusion += std::max(std::sqrt(h * h + r * r + 2 * h * r * cosine) - 1, 0.) / steps;
  }
  const double facets = 0.001;
  EXPECT_NEAR(error.missing.largest, 1 + h - r, facets + 0.5 * spacing * spacing);
  EXPECT_NEAR(error.missing.mean, missing, facets);
  // 5 % of the area are below the height -0.9.
  EXPECT_NEAR(error.missing.quantile_95, std::sqrt(1 + h * h + 2 * h * 0.9) - r, spacing * h);
  ASSERT_TRUE(error.protrusion);
  const double corners = facets + 0.01 * std::sqrt(3.) * spacing;
  EXPECT_NEAR(error.protrusion->largest, h + r - 1, corners + 0.5 * spacing * spacing);
  EXPECT_NEAR(error.protrusion->mean, protrusion, corners);
  EXPECT_EQ(error.spacing, spacing);
  const auto again = AP::reconstruction_error(balls_at({{0, 0, h}}, {r}), sphere, spacing);
  EXPECT_EQ(again.missing.mean, error.missing.mean);
  EXPECT_EQ(again.protrusion->mean, error.protrusion->mean);
}

TEST(Reconstruction_error, knows_the_solid_from_its_cavity)
{
  // A shell between the radii 1 and 0.5: of a ball of radius 0.4 in the cavity all sticks out, by 0.1.
  const AP::Triangle_surface shell =
      surface_of(joined(icosphere(4), flipped(icosphere(4, Point_3(0, 0, 0), 0.5))));
  const auto error = AP::reconstruction_error(balls_at({{0, 0, 0}}, {0.4}), shell, 0.05);
  EXPECT_NEAR(error.protrusion->largest, 0.1, 0.003);
  EXPECT_NEAR(error.protrusion->median, 0.1, 0.003);
  EXPECT_NEAR(error.missing.largest, 0.6, 0.003);
  // Within the shell nothing does, also where coordinates are those of corners.
  const AP::Triangle_surface cube = surface_of(box(Point_3(-1, -1, -1), Point_3(1, 1, 1)));
  EXPECT_EQ(
      AP::reconstruction_error(balls_at({{0, 0, 0}}, {0.75}), cube, 0.125).protrusion->largest, 0);
}

TEST(Reconstruction_error, of_what_is_open_is_one_sided)
{
  const AP::Triangle_surface tube = surface_of(cylinder(24, 1, 2, false, 10));
  const auto error = AP::reconstruction_error(balls_at({{0, 0, 0}}, {1}), tube, 0.05);
  EXPECT_FALSE(error.protrusion);
  EXPECT_NEAR(error.missing.largest, std::sqrt(2.) - 1, 0.05);
  EXPECT_TRUE(std::isinf(AP::reconstruction_error({}, tube, 0.05).missing.mean));
  EXPECT_NE(complaint([&] { AP::reconstruction_error({}, tube, 0); }).find("spacing"),
            std::string::npos);
}

} // namespace
