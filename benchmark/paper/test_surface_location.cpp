// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a place is on a surface, told by geodesic distances.

#include "shapes.h"
#include "surface_location.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace {

using namespace Paper;

constexpr double pi = 3.14159265358979323846;

double centroid_distance(const Soup& soup, std::size_t f, std::size_t g)
{
  const auto centroid = [&](std::size_t face) {
    const Soup::Triangle& t = soup.triangles[face];
    return CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  };
  return std::sqrt(CGAL::squared_distance(centroid(f), centroid(g)));
}

TEST(Surface_locations, of_a_sphere_are_those_of_its_caps)
{
  // A cap of the angle a has (1 - cos a)/2 of the area of the sphere, which is 4π. There are 320 places,
  // in rings about 0.2 apart; the faces lie inside, by 2 % of the area.
  const Surface_locations locations(icosphere(2));
  ASSERT_EQ(locations.of_faces().size(), 320u);
  for(const Distance_profile& profile : locations.of_faces())
    for(std::size_t q = 0; q < profile.size(); ++q) {
      const double angle = std::acos(1 - 2 * (double(q) + 0.5) / double(profile.size()));
      EXPECT_NEAR(profile[q], angle / std::sqrt(4 * pi), 0.2 / std::sqrt(4 * pi));
    }
}

TEST(Surface_locations, differ_by_no_more_than_the_places_are_apart)
{
  const Soup plate = box({8, 4, 1}, 0.25);
  const Surface_locations locations(plate);
  const auto& profiles = locations.of_faces();
  const double root_of_area = std::sqrt(area(plate));
  double largest = 0;
  for(std::size_t f = 0; f < profiles.size(); f += 3)
    for(std::size_t g = 0; g < profiles.size(); g += 3) {
      const double d = difference(profiles[f], profiles[g]);
      EXPECT_EQ(d, difference(profiles[g], profiles[f]));
      largest = std::max(largest, d);
      // On the same large wall the geodesic distance is no longer than the straight line.
      const auto height = [&](std::size_t face) {
        double sum = 0;
        for(std::uint32_t v : plate.triangles[face])
          sum += plate.points[v].z();
        return sum;
      };
      if(height(f) == 0 && height(g) == 0) {
        EXPECT_LE(d, centroid_distance(plate, f, g) / root_of_area + 1e-12);
      }
    }
  EXPECT_GT(largest, 0.05); // the middle is not an end
}

TEST(Surface_locations, do_not_know_sizes_and_places_of_shapes)
{
  Soup moved = box({3, 2, 1}, 1);
  const Surface_locations before(moved);
  for(Point_3& p : moved.points)
    p = Point_3(5 - 3 * p.y(), 3 * p.x(), 3 * p.z() - 7); // turned, tripled, moved
  const Surface_locations after(moved);
  for(std::size_t f = 0; f < before.of_faces().size(); ++f)
    EXPECT_NEAR(difference(before.of_faces()[f], after.of_faces()[f]), 0, 1e-9);
}

TEST(Surface_locations, of_points_are_those_of_their_voters)
{
  const Soup tube = cylinder(1, 12, 12, 12);
  const Surface_locations locations(tube);
  CGAL::Area_projection::Salient_point end, middle;
  end.position = Point_3(0, 0, 5);
  middle.position = Point_3(0, 0, 0);
  end.scale = middle.scale = 0.85;
  // From the middle nothing is farther than half of the length and half of the way around, and across half
  // of a lid; from near an end half of the surface is farther than 5 or so.
  const double root_of_area = std::sqrt(area(tube));
  EXPECT_LE(locations.of_point(middle).back() * root_of_area, 6.5 + pi + 1);
  EXPECT_GE(locations.of_point(end)[16] * root_of_area, 4);
  EXPECT_GT(difference(locations.of_point(end), locations.of_point(middle)) * root_of_area, 1);
  // Nothing lands here.
  middle.position = Point_3(0, 0, 100);
  EXPECT_GE(locations.of_point(middle)[16] * root_of_area, 4);
}

TEST(Surface_locations, complain_about_several_parts)
{
  Soup apart = icosphere(0);
  for(Point_3& p : apart.points)
    p = p + Vector_3(5, 0, 0);
  EXPECT_THROW(Surface_locations(joined(apart, icosphere(0))), std::invalid_argument);
}

} // namespace
