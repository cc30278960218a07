// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The medial axis as the limit that the paper defines (section 4.2): more than one patch is projected into the kernel.

#include "shapes.h"

#include <CGAL/Area_projection_transform/medial_balls/projected_patches.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>

namespace {

using namespace shapes;
using AP::Projected_patches;

/// points at most so far apart, with the exact normals of the shape.
constexpr double spacing = 0.01;

struct Shape
{
  AP::Surfels points;
  std::function<double(const Point_3&)> distance;      ///< from the surface, positive inside
  std::function<double(const Point_3&)> from_the_axis; ///< the distance of a place inside
  Vector_3 half_size;
};

void add(AP::Surfels& points, const Point_3& p, const Vector_3& n)
{
  points.push_back(p, n, spacing * spacing, std::uint32_t(points.size()));
}

Shape unit_sphere()
{
  Shape sphere;
  sphere.points = fibonacci_sphere(std::size_t(4 * pi / (spacing * spacing)));
  sphere.from_the_axis = [](const Point_3& p) {
    return std::sqrt((p - CGAL::ORIGIN).squared_length());
  };
  sphere.distance = [off = sphere.from_the_axis](const Point_3& p) { return 1 - off(p); };
  sphere.half_size = Vector_3(1, 1, 1);
  return sphere;
}

/// around the ring of radius 1 in z = 0.
Shape ring(double radius)
{
  Shape torus;
  const double along = std::ceil(2 * pi * (1 + radius) / spacing),
               around = std::ceil(2 * pi * radius / spacing);
  for(double i = 0; i < along; ++i)
    for(double j = 0; j < around; ++j) {
      const double a = 2 * pi * i / along, b = 2 * pi * j / around;
      const Vector_3 out(std::cos(a), std::sin(a), 0);
      const Vector_3 n = std::cos(b) * out + std::sin(b) * Vector_3(0, 0, 1);
      add(torus.points, CGAL::ORIGIN + out + radius * n, n);
    }
  torus.from_the_axis = [](const Point_3& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z());
  };
  torus.distance = [radius, off = torus.from_the_axis](const Point_3& p) {
    return radius - off(p);
  };
  torus.half_size = Vector_3(1 + radius, 1 + radius, radius);
  return torus;
}

/// 2 x 2 x 1 around the origin.
Shape flat_box()
{
  Shape box;
  const std::array<double, 3> half{1, 1, 0.5};
  for(int axis = 0; axis < 3; ++axis)
    for(const double side : {-1., 1.}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for(double i = -half[u] + spacing / 2; i < half[u]; i += spacing)
        for(double j = -half[v] + spacing / 2; j < half[v]; j += spacing) {
          std::array<double, 3> p, n{0, 0, 0};
          p[axis] = side * half[axis];
          n[axis] = side;
          p[u] = i;
          p[v] = j;
          add(box.points, Point_3(p[0], p[1], p[2]), Vector_3(n[0], n[1], n[2]));
        }
    }
  const auto distances = [](const Point_3& p) { // from the three pairs of walls, ascending
    std::array<double, 3> d{1 - std::abs(p.x()), 1 - std::abs(p.y()), 0.5 - std::abs(p.z())};
    std::sort(d.begin(), d.end());
    return d;
  };
  box.distance = [distances](const Point_3& p) { return distances(p)[0]; };
  box.from_the_axis = [distances](const Point_3& p) { // the middle, and where two walls are as near
    const auto d = distances(p);
    return std::min(std::abs(p.z()), (d[1] - d[0]) / std::sqrt(2.));
  };
  box.half_size = Vector_3(1, 1, 0.5);
  return box;
}

/// radius 1, z from -3 to 3.
Shape capped_cylinder()
{
  Shape tube;
  const double around = std::ceil(2 * pi / spacing);
  for(double i = 0; i < around; ++i)
    for(double z = -3 + spacing / 2; z < 3; z += spacing) {
      const Vector_3 n(std::cos(2 * pi * i / around), std::sin(2 * pi * i / around), 0);
      add(tube.points, Point_3(n.x(), n.y(), z), n);
    }
  for(const double side : {-1., 1.})
    for(double x = -1 + spacing / 2; x < 1; x += spacing)
      for(double y = -1 + spacing / 2; y < 1; y += spacing)
        if(x * x + y * y < 1)
          add(tube.points, Point_3(x, y, 3 * side), Vector_3(0, 0, side));
  tube.distance = [](const Point_3& p) {
    return std::min(1 - std::hypot(p.x(), p.y()), 3 - std::abs(p.z()));
  };
  tube.from_the_axis = [](const Point_3& p) { // the line, and cones of 45 degrees to the rims
    const double rho = std::hypot(p.x(), p.y()), height = 3 - std::abs(p.z());
    return std::min(std::hypot(rho, std::max(1 - height, 0.)),
                    std::abs(1 - rho - height) / std::sqrt(2.));
  };
  tube.half_size = Vector_3(1, 1, 3);
  return tube;
}

/// `number` places by chance that are inside, at least 0.3 from the surface and a quarter of that from the axis.
std::vector<Point_3> places_off_axis(const Shape& shape, std::size_t number)
{
  std::mt19937 generator(1);
  const auto random = [&generator] { return generator() / 2147483648. - 1; };
  std::vector<Point_3> places;
  while(places.size() < number) {
    const double x = random(), y = random(), z = random();
    const Point_3 p(x * shape.half_size.x(), y * shape.half_size.y(), z * shape.half_size.z());
    const double radius = shape.distance(p);
    if(radius > 0.3 && shape.from_the_axis(p) > radius / 4)
      places.push_back(p);
  }
  return places;
}

/// the share of places with more than one patch at their distance from the surface.
double share_of_several(const Shape& shape, const Projected_patches& patches,
                        const std::vector<Point_3>& places, double sigma_ratio)
{
  std::size_t several = 0;
  for(const Point_3& p : places) {
    const double radius = shape.distance(p);
    const std::size_t number = patches(p, radius, sigma_ratio * radius);
    EXPECT_GE(number, 1u) << "the nearest point votes, and samples are nearer than sigma";
    several += number > 1;
  }
  return double(several) / double(places.size());
}

void expect_limit_off_axis(const Shape& shape)
{
  const Projected_patches patches(shape.points);
  const std::vector<Point_3> places = places_off_axis(shape, 150);
  double before = 1;
  for(const double sigma_ratio : {0.2, 0.1, 0.05, 0.025}) {
    const double share = share_of_several(shape, patches, places, sigma_ratio);
    EXPECT_LE(share, before);
    before = share;
  }
  // A patch is 2σ / (1 - κR) across; here 1 - κR is at least 1/5, as for a sphere, so that it is one if 2σ * 5 is
  // less than 2√(σR): σ < R / 25.
  EXPECT_EQ(before, 0);
}

TEST(Projected_patches, are_one_off_the_axis_in_the_limit)
{
  expect_limit_off_axis(unit_sphere());
  expect_limit_off_axis(capped_cylinder());
  expect_limit_off_axis(ring(0.5));
  expect_limit_off_axis(flat_box());
}

TEST(Projected_patches, are_several_on_the_axis)
{
  const Projected_patches of_sphere(unit_sphere().points), of_torus(ring(0.5).points),
      of_box(flat_box().points), of_cylinder(capped_cylinder().points);
  for(const double c : {0.1, 0.05, 0.025}) {
    // Caps of the radius √(σR), half of what patches are apart by, do not overlap: no more than 4πR² / (π σR). Those twice
    // as wide cover: no fewer than a quarter of that.
    EXPECT_LE(of_sphere(Point_3(0, 0, 0), 1, c), std::size_t(4 / c * 1.1));
    EXPECT_GE(of_sphere(Point_3(0, 0, 0), 1, c), std::size_t(1 / c));
    // On a ring of the length 2πR, and twice σ wide.
    EXPECT_GE(of_torus(Point_3(1, 0, 0), 0.5, c * 0.5), std::size_t(pi / (2 * std::sqrt(c))));
    EXPECT_EQ(of_box(Point_3(0.1, 0.2, 0), 0.5, c * 0.5), 2u);        // the middle
    EXPECT_EQ(of_box(Point_3(0.6, 0, 0.1), 0.4, c * 0.4), 2u);        // x = 1 and z = 1/2
    EXPECT_EQ(of_box(Point_3(0.65, 0.65, 0.15), 0.35, c * 0.35), 3u); // three walls
    EXPECT_GE(of_cylinder(Point_3(0, 0, 1), 1, c), std::size_t(pi / (2 * std::sqrt(c))));
    EXPECT_EQ(of_cylinder(Point_3(0.5, 0, 2.5), 0.5, c * 0.5), 2u); // on a cone
  }
}

TEST(Projected_patches, are_several_at_other_radii_where_balls_are_not_empty)
{
  // In the box, in its lower quarter, but between the narrow walls x = -1 and 1: a ball of radius 1 touches both, and the
  // walls above and below are within it. That is the symmetry set, not the axis.
  const Projected_patches of_box(flat_box().points);
  const Point_3 p(0, 0.3, -0.25);
  for(const double c : {0.2, 0.1, 0.05}) {
    EXPECT_EQ(of_box(p, 0.25, c * 0.25), 1u); // the wall below
    EXPECT_EQ(of_box(p, 1, c), 2u);
  }
}

TEST(Projected_patches, tell_inside_from_outside)
{
  const AP::Surfels sphere = unit_sphere().points;
  const Projected_patches outside(sphere, AP::Side::OUTSIDE);
  EXPECT_EQ(outside(Point_3(0, 0, 0), 1, 0.1), 0u);
  EXPECT_EQ(outside(Point_3(0, 0, 1.5), 0.5, 0.05), 1u);
}

TEST(Projected_patches, need_a_radius_and_sigma)
{
  const Projected_patches patches((AP::Surfels()));
  EXPECT_EQ(patches(Point_3(0, 0, 0), 1, 0.1), 0u);
  EXPECT_THROW(patches(Point_3(0, 0, 0), 0, 0.1), std::invalid_argument);
  EXPECT_THROW(patches(Point_3(0, 0, 0), 1, -1), std::invalid_argument);
}

} // namespace
