// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The radius at which the transform is largest at a point, and how it extends around it: against closed forms, and
// against the exact transform at many radii.

#include "shapes.h"

#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/salient_points/best_scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

namespace AP = CGAL::Area_projection;
namespace in = AP::internal;
using AP::Point_3;
using AP::Side;
using shapes::cylinder;
using shapes::icosphere;
using shapes::pi;
using shapes::Soup;
using shapes::surface_of;
using Vector = Eigen::Vector3d;

in::Feature_surface features_of(const Soup& soup, Side side = Side::INSIDE)
{
  return in::Feature_surface(surface_of(soup), side);
}

/// the distance of the nearest face plane from the origin.
double inner_radius(const Soup& soup)
{
  const AP::Triangle_surface surface = surface_of(soup);
  double least = 1e300;
  for(std::size_t t = 0; t < surface.size(); ++t)
    least = std::min(least, surface.normals[t] * (surface.corner(t, 0) - CGAL::ORIGIN));
  return least;
}

// At the centre of a sphere of radius 1, all of it is projected into the ball from R = 1/(1+c) on, where the value is
// (1+c)². A patch of a polyhedron in it, whose plane is h from the centre, and which is itself at most 1 away, comes
// in between h/(1+c) and the smaller root of (1 − c²) R² − 2 h R + 1 = 0.
TEST(Best_scale, of_a_sphere_is_that_of_the_closed_form)
{
  const Soup soup = icosphere(3);
  const in::Feature_surface surface = features_of(soup);
  const double h = inner_radius(soup);
  for(const double c : {0.3, 0.5, 0.7}) {
    const double a = 1 - c * c;
    const double first = h / (1 + c), last = (h - std::sqrt(h * h - a)) / a;
    const double end = h * h > a ? last : h / a; // the largest radius at which a patch can come in
    const in::Best_scale best = in::best_scale(surface, Vector::Zero(), c, 0.3, 2);
    EXPECT_GE(best.radius, first);
    EXPECT_LE(best.radius, end);
    EXPECT_NEAR(best.radius, 1 / (1 + c), 0.03 / (1 + c)); // the bounds are not far apart
    EXPECT_GE(best.intensity, soup.area() / (4 * pi * end * end));
    EXPECT_LE(best.intensity, soup.area() / (4 * pi * first * first));
    EXPECT_NEAR(best.intensity, (1 + c) * (1 + c), 0.06 * (1 + c) * (1 + c));
  }
}

// From the other side nothing is projected to the centre.
TEST(Best_scale, is_of_one_side)
{
  const in::Feature_surface outside = features_of(icosphere(2), Side::OUTSIDE);
  EXPECT_EQ(in::best_scale(outside, Vector::Zero(), 0.5, 0.3, 2).intensity, 0);
  const in::Feature_surface cavity = features_of(flipped(icosphere(3)), Side::OUTSIDE);
  EXPECT_NEAR(in::best_scale(cavity, Vector::Zero(), 0.5, 0.3, 2).intensity, 2.25, 0.06 * 2.25);
}

// Above a plane at the height d the ball of radius c R holds a disk of the radius √(c²R² − (R − d)²): its area over
// 4πR² is (c² − (1 − d/R)²) / 4, and at most c²/4, at R = d.
TEST(Best_scale, of_a_plane_is_its_distance)
{
  const in::Feature_surface surface = features_of(shapes::plane_patch(4, 0, 60));
  const in::Best_scale best = in::best_scale(surface, Vector(0.01, 0.02, -1), 0.5, 0.5, 2);
  // Of a flat maximum the place is uncertain: a value that is 5 % less is at |1 − d/R| = c √0.05.
  EXPECT_NEAR(best.intensity, 0.0625, 0.05 * 0.0625);
  EXPECT_NEAR(best.radius, 1, 0.5 * std::sqrt(0.1));
}

/// the largest of the exact values at many radii.
in::Best_scale best_of_many(const Soup& soup, const Vector& x, double c, double smallest,
                            double largest)
{
  in::Best_scale best{smallest, 0};
  const auto surface = shapes::scale_space_of(soup);
  for(double radius = smallest; radius <= largest; radius *= 1.02) {
    const AP::Exact_evaluator area(surface, radius, Side::INSIDE);
    const double value =
        area(Point_3(x.x(), x.y(), x.z()), c * radius) * AP::Scale{radius, 0}.normalization();
    if(value > best.intensity)
      best = {radius, value};
  }
  return best;
}

// The patches are cut to s = 0.3 c times the smallest radius. A disk of radius c R has 2π c R / s of them on its
// rim, each of which is in or out by chance, by s²/√12: 4 % of its area at the smallest radius, less at
// larger ones. The largest of many values is above the mean of them by up to three times that.
TEST(Best_scale, is_that_of_the_exact_transform_at_many_radii)
{
  const Soup soup = shapes::blob(3, 3);
  const in::Feature_surface surface = features_of(soup);
  shapes::Random random(4);
  for(int i = 0; i < 4; ++i) {
    const Vector x(random(-0.4, 0.4), random(-0.4, 0.4), random(-0.4, 0.4));
    const in::Best_scale best = in::best_scale(surface, x, 0.5, 0.4, 1.2);
    const in::Best_scale exact = best_of_many(soup, x, 0.5, 0.4, 1.2);
    EXPECT_NEAR(best.intensity, exact.intensity, 0.12 * exact.intensity);
    // And what it says of its radius is so.
    const AP::Exact_evaluator area(shapes::scale_space_of(soup), best.radius, Side::INSIDE);
    const double there = area(Point_3(x.x(), x.y(), x.z()), 0.5 * best.radius) *
                         AP::Scale{best.radius, 0}.normalization();
    EXPECT_NEAR(there, exact.intensity, 0.12 * exact.intensity);
  }
}

TEST(Best_scale, stays_within_its_range)
{
  const in::Feature_surface surface = features_of(icosphere(3));
  const in::Best_scale above = in::best_scale(surface, Vector::Zero(), 0.5, 0.8, 1.2);
  EXPECT_EQ(above.radius, 0.8); // beyond the maximum the value falls like 1/R²
  EXPECT_NEAR(above.intensity, 1 / 0.64, 0.02 / 0.64);
  const in::Best_scale below = in::best_scale(surface, Vector::Zero(), 0.5, 0.1, 0.6);
  EXPECT_EQ(below.intensity, 0);
  EXPECT_EQ(in::best_scale(features_of({}), Vector::Zero(), 0.5, 0.1, 1).intensity, 0);
}

/// their values, and that they sum to 1.
void expect_descriptors(const AP::Inertia_descriptors& d, double blobness, double flatness,
                        double tolerance)
{
  EXPECT_NEAR(d.blobness, blobness, tolerance);
  EXPECT_NEAR(d.flatness, flatness, tolerance);
  EXPECT_NEAR(d.blobness + d.flatness + d.vesselness, 1, 1e-14);
}

TEST(Inertia_descriptors, are_those_of_the_closed_form)
{
  constexpr double bits = 1e-15;
  expect_descriptors(in::inertia_descriptors(Vector(1, 4, 9)), 1. / 3, 1. / 3, bits);
  expect_descriptors(in::inertia_descriptors(Vector(5, 5, 5)), 1, 0, bits);
  expect_descriptors(in::inertia_descriptors(Vector(0, 5, 5)), 0, 1, bits);
  expect_descriptors(in::inertia_descriptors(Vector(0, 0, 5)), 0, 0, bits);
  expect_descriptors(in::inertia_descriptors(Vector(-1e-20, 0, 5)), 0, 0, bits); // rounding
  expect_descriptors(in::inertia_descriptors(Vector(0, 0, 0)), 1, 0, bits);
}

// The map is that of balls around the projections, with the variance σ²/5 in each direction; projections count within
// 2σ. What patches on the rim of that add or take is a share of 1/100 of them.
TEST(Inertia, of_the_centre_of_a_sphere_is_round)
{
  const auto d = in::inertia_at(features_of(icosphere(3)), Vector::Zero(), {2. / 3, 1. / 3});
  expect_descriptors(d, 1, 0, 0.001);
}

// The projections of a tube are on its axis, 2σ to both sides: with the variance (2σ)²/3.
TEST(Inertia, of_the_axis_of_a_tube_is_long)
{
  const auto tube = features_of(cylinder(64, 1, 8, false, 80));
  const auto d = in::inertia_at(tube, Vector(0, 0, 0.03), {1, 0.5});
  expect_descriptors(d, std::sqrt(0.2 / (4. / 3 + 0.2)), 0, 0.02);
}

// Those of a plane are on a disk of radius 2σ: with the variance (2σ)²/4 along both of its directions.
TEST(Inertia, of_a_plane_is_flat)
{
  const auto plane = features_of(shapes::plane_patch(6, 0, 60));
  const auto d = in::inertia_at(plane, Vector(0.02, 0.03, -1), {1, 0.5});
  const double blobness = std::sqrt(0.2 / 1.2);
  expect_descriptors(d, blobness, 1 - blobness, 0.02);
}

TEST(Inertia, of_nothing_is_that_of_a_ball)
{
  expect_descriptors(in::inertia_at(features_of({}), Vector::Zero(), {1, 0.5}), 1, 0, 0);
  expect_descriptors(in::inertia_at(features_of(icosphere(2)), Vector(9, 9, 9), {1, 0.5}), 1, 0, 0);
}

} // namespace
