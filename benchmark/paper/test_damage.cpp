// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What happens to surfaces, and how maps are compared, against what is known beforehand.

#include "damage.h"
#include "map_comparison.h"
#include "shapes.h"

#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace {

using namespace Paper;
using Triangle = Soup::Triangle;

constexpr double pi = 3.14159265358979323846;

/// the faces of a soup that are not in what is left of it, which must be in the same order.
std::vector<Triangle> removed(const Soup& soup, const Soup& rest)
{
  std::vector<Triangle> faces;
  auto next = rest.triangles.begin();
  for(const Triangle& t : soup.triangles)
    if(next != rest.triangles.end() && *next == t)
      ++next;
    else
      faces.push_back(t);
  EXPECT_EQ(next, rest.triangles.end());
  return faces;
}

bool share_an_edge(const Triangle& a, const Triangle& b)
{
  return 2 == std::count_if(a.begin(), a.end(), [&](std::uint32_t v) {
           return std::find(b.begin(), b.end(), v) != b.end();
         });
}

/// the number of parts of which some faces consist, over their edges.
std::size_t number_of_parts(std::vector<Triangle> faces)
{
  std::size_t parts = 0;
  while(!faces.empty()) {
    ++parts;
    std::vector<Triangle> part{faces.back()};
    faces.pop_back();
    for(std::size_t next = 0; next < part.size(); ++next) {
      const Triangle face = part[next];
      const auto others = std::partition(
          faces.begin(), faces.end(), [&](const Triangle& t) { return !share_an_edge(face, t); });
      part.insert(part.end(), others, faces.end());
      faces.erase(others, faces.end());
    }
  }
  return parts;
}

TEST(Shapes, have_the_areas_and_edges_that_they_should)
{
  EXPECT_NEAR(area(icosphere(5)), 4 * pi, 0.01);
  EXPECT_EQ(icosphere(3).triangles.size(), 20u * 64);
  EXPECT_EQ(icosphere(3).points.size(), 10u * 64 + 2);
  const Soup b = box({4, 3, 2}, 0.5);
  EXPECT_NEAR(area(b), 0.25 * 2 * (12 + 8 + 6), 1e-12);
  const AP::Triangle_surface surface = AP::surface_from_triangle_soup(b.points, b.triangles);
  EXPECT_TRUE(AP::internal::is_closed(surface));
  EXPECT_EQ(AP::interior(surface, AP::grid_around(CGAL::Bbox_3(0.1, 0.1, 0.1, 1.9, 1.4, 0.9), 0.1))
                .region.number_of_voxels(),
            19u * 14 * 9);
  EXPECT_NEAR(mean_edge_length(icosphere(0)), 1 / std::sin(2 * pi / 5), 1e-12);
}

TEST(Shapes, bumps_are_as_high_as_they_should_be)
{
  const Bumps bumps{200, 0.5};
  const auto [soup, radius] = bumpy_sphere(bumps, 5);
  double highest = 0, lowest = 2;
  for(const Point_3& p : soup.points) {
    const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
    highest = std::max(highest, r);
    lowest = std::min(lowest, r);
  }
  EXPECT_NEAR(highest, radius * (1 + 0.5 * bumps.width()), 0.02 * bumps.width());
  EXPECT_NEAR(lowest, radius, 1e-12);
  // Bumps that do not overlap would have the mean height of half an ellipsoid, 2/3, on the part n w²/4.
  EXPECT_NEAR(1 / radius, 1 + 2. / 3 * 0.5 * bumps.width() * 200 * std::pow(bumps.width(), 2) / 4,
              0.1 * bumps.width());
}

TEST(Removed_faces, are_as_many_as_asked_for)
{
  const Soup soup = icosphere(2);
  for(double fraction : {0., 0.1, 0.3333, 0.5, 0.8, 1.}) {
    const auto number = std::size_t(std::lround(fraction * 320));
    EXPECT_EQ(removed(soup, remove_random_faces(soup, fraction, 1)).size(), number);
    EXPECT_EQ(removed(soup, remove_holes(soup, fraction, 3, 1)).size(), number);
  }
}

TEST(Removed_faces, are_each_as_likely_as_another)
{
  const Soup soup = icosphere(1);
  std::vector<int> times(soup.triangles.size(), 0);
  constexpr int seeds = 2000;
  for(int seed = 0; seed < seeds; ++seed)
    for(const Triangle& t : removed(soup, remove_random_faces(soup, 0.25, std::uint64_t(seed))))
      ++times[std::size_t(std::find(soup.triangles.begin(), soup.triangles.end(), t) -
                          soup.triangles.begin())];
  const double deviation = std::sqrt(seeds * 0.25 * 0.75);
  for(int n : times)
    EXPECT_NEAR(n, 0.25 * seeds, 5 * deviation);
}

TEST(Removed_faces, depend_on_the_seed_only)
{
  const Soup soup = icosphere(2);
  EXPECT_EQ(remove_random_faces(soup, 0.5, 7).triangles,
            remove_random_faces(soup, 0.5, 7).triangles);
  EXPECT_NE(remove_random_faces(soup, 0.5, 7).triangles,
            remove_random_faces(soup, 0.5, 8).triangles);
  EXPECT_EQ(remove_holes(soup, 0.5, 2, 7).triangles, remove_holes(soup, 0.5, 2, 7).triangles);
  EXPECT_NE(remove_holes(soup, 0.5, 2, 7).triangles, remove_holes(soup, 0.5, 2, 8).triangles);
}

TEST(Removed_faces, refuse_what_is_no_fraction)
{
  EXPECT_THROW(remove_random_faces(icosphere(0), 1.1, 1), std::invalid_argument);
  EXPECT_THROW(remove_holes(icosphere(0), -0.1, 1, 1), std::invalid_argument);
  EXPECT_THROW(remove_holes(icosphere(0), 0.5, 0, 1), std::invalid_argument);
}

TEST(Holes, hang_together)
{
  const Soup soup = icosphere(3);
  for(std::uint64_t seed = 0; seed < 5; ++seed) {
    EXPECT_EQ(number_of_parts(removed(soup, remove_holes(soup, 0.3, 1, seed))), 1u);
    const std::size_t parts = number_of_parts(removed(soup, remove_holes(soup, 0.05, 4, seed)));
    EXPECT_GE(parts, 1u);
    EXPECT_LE(parts, 4u);
  }
  EXPECT_GT(number_of_parts(removed(soup, remove_random_faces(soup, 0.3, 1))), 50u);
}

TEST(Holes, go_on_elsewhere_when_a_part_is_eaten_up)
{
  Soup two = icosphere(0);
  const auto points = std::uint32_t(two.points.size());
  for(const Point_3& p : icosphere(0).points)
    two.points.push_back(p + Vector_3(3, 0, 0));
  for(const Triangle& t : icosphere(0).triangles)
    two.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
  EXPECT_EQ(remove_holes(two, 0.75, 1, 1).triangles.size(), 10u);
}

TEST(Noise, is_normal_and_as_large_as_asked_for)
{
  const Soup soup = icosphere(5), noisy = add_noise(soup, 0.2, 1);
  const double unit = 0.2 * mean_edge_length(soup);
  double number = 0, sum = 0, squares = 0, fourths = 0;
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(int axis = 0; axis < 3; ++axis) {
      const double x = (noisy.points[i][axis] - soup.points[i][axis]) / unit;
      number += 1;
      sum += x;
      squares += x * x;
      fourths += x * x * x * x;
    }
  // Five standard deviations of the sample.
  EXPECT_NEAR(sum / number, 0, 5 / std::sqrt(number));
  EXPECT_NEAR(squares / number, 1, 5 * std::sqrt(2 / number));
  EXPECT_NEAR(fourths / number, 3, 5 * std::sqrt(96 / number));
  EXPECT_EQ(noisy.triangles, soup.triangles);
  EXPECT_EQ(add_noise(soup, 0, 1).points, soup.points);
}

/// a cube of voxels without a layer in the middle, which has storage nevertheless.
std::shared_ptr<const AP::Row_spans> region_with_a_gap()
{
  return std::make_shared<const AP::Row_spans>(
      AP::Grid_3(Point_3(0, 0, 0), 0.5, {41, 21, 21}),
      [](std::size_t, std::vector<AP::Row_spans::Run>& runs) {
        runs.push_back({0, 20});
        runs.push_back({21, 41});
      });
}

TEST(Comparison, of_a_map_with_its_multiples)
{
  const auto region = region_with_a_gap();
  Random random(1);
  std::vector<float> map(region->storage_size());
  for(float& value : map)
    value = float(random.uniform());
  std::vector<float> twice = map, opposite = map;
  for(std::size_t i = 0; i < map.size(); ++i) {
    twice[i] = 2 * map[i];
    opposite[i] = 1 - map[i];
  }
  EXPECT_NEAR(compare(*region, map, map).correlation, 1, 1e-12);
  EXPECT_EQ(compare(*region, map, map).relative_rms, 0);
  EXPECT_NEAR(compare(*region, map, twice).correlation, 1, 1e-12);
  EXPECT_NEAR(compare(*region, map, twice).relative_rms, 1, 1e-12);
  EXPECT_NEAR(compare(*region, map, twice, 0.5).relative_rms, 0, 1e-12);
  EXPECT_NEAR(compare(*region, map, opposite).correlation, -1, 1e-6);
  EXPECT_NEAR(compare(*region, map, std::vector<float>(map.size(), 1.f)).correlation, 0, 1e-9);
}

TEST(Comparison, counts_only_voxels_of_the_region)
{
  const auto region = region_with_a_gap();
  const std::vector<float> map(region->storage_size(), 1.f);
  std::vector<float> other = map;
  other[region->index(20, 3, 3)] = 1000;
  EXPECT_EQ(compare(*region, map, other).relative_rms, 0);
}

TEST(Comparison, of_regions)
{
  const AP::Row_spans all(region_with_a_gap()->grid());
  const Region_agreement same = compare(all, all), less = compare(all, *region_with_a_gap()),
                         more = compare(*region_with_a_gap(), all);
  EXPECT_EQ(same.found, 1);
  EXPECT_EQ(same.wrong, 0);
  EXPECT_NEAR(less.found, 40. / 41, 1e-12);
  EXPECT_EQ(less.wrong, 0);
  EXPECT_EQ(more.found, 1);
  EXPECT_NEAR(more.wrong, 1. / 41, 1e-12);
}

/// a joint map of two scales, of the larger of which `value(i, j, k)` is the map.
template <class Value>
AP::Joint_map map_of(Value&& value)
{
  const auto region = std::make_shared<const AP::Row_spans>(region_with_a_gap()->grid());
  AP::Joint_map map(region, {{1, 0.5}, {2, 1}});
  std::vector<float> values(region->storage_size());
  const auto& size = region->grid().size();
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j)
      for(int i = 0; i < size[0]; ++i)
        values[region->index(i, j, k)] = float(value(i, j, k));
  map.consume(1, map.scales()[1], 0, values.data(), values.size());
  return map;
}

double bump(double x, double y, double z)
{
  return std::exp(-(x * x + y * y + z * z) / 20);
}

TEST(Maxima, of_a_map_stay_where_they_are)
{
  const AP::Joint_map map = map_of([](int i, int j, int k) {
    return bump(i - 10, j - 10, k - 10) + 0.5 * bump(i - 30, j - 10, k - 10);
  });
  const std::vector<Maximum_change> changes = compare_maxima(map, map, 10);
  ASSERT_EQ(changes.size(), 2u);
  for(const Maximum_change& c : changes) {
    EXPECT_FALSE(c.is_lost);
    EXPECT_EQ(c.displacement, 0);
    EXPECT_EQ(c.across, 0);
    EXPECT_EQ(c.score_ratio, 1);
    EXPECT_EQ(c.clean_value_there, 1);
  }
}

TEST(Maxima, of_a_ball_are_displaced_in_full)
{
  const auto clean = map_of([](int i, int j, int k) { return bump(i - 20, j - 10, k - 10); });
  const auto other = map_of([](int i, int j, int k) { return 0.5 * bump(i - 22, j - 11, k - 12); });
  const std::vector<Maximum_change> changes = compare_maxima(clean, other, 10);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_FALSE(changes[0].is_lost);
  EXPECT_NEAR(changes[0].displacement, 3, 1e-12);
  EXPECT_NEAR(changes[0].across, 3, 1e-12);
  EXPECT_NEAR(changes[0].score_ratio, 0.5, 1e-6);
  EXPECT_NEAR(changes[0].clean_value_there, std::exp(-9 / 20.), 1e-6);
}

TEST(Maxima, of_a_tube_slide_along_its_axis)
{
  const auto tube = [](double middle, double height) {
    return map_of([=](int i, int j, int k) {
      return bump(0, j - height, k - 10) * (1 - 1e-4 * std::abs(i - middle));
    });
  };
  const std::vector<Maximum_change> slid = compare_maxima(tube(20, 10), tube(24, 10), 1);
  EXPECT_NEAR(slid.at(0).displacement, 4, 1e-12);
  EXPECT_NEAR(slid[0].across, 0, 1e-6);
  EXPECT_NEAR(slid[0].clean_value_there, 1 - 4e-4, 1e-6);
  const std::vector<Maximum_change> moved = compare_maxima(tube(20, 10), tube(24, 13), 1);
  EXPECT_NEAR(moved.at(0).displacement, 5, 1e-12);
  EXPECT_NEAR(moved[0].across, 3, 1e-6);
}

TEST(Maxima, between_plates_slide_in_two_directions)
{
  const auto plates = [](double x, double y, double z) {
    return map_of([=](int i, int j, int k) {
      return bump(0, 0, k - z) * (1 - 1e-4 * (std::abs(i - x) + std::abs(j - y)));
    });
  };
  const std::vector<Maximum_change> moved =
      compare_maxima(plates(20, 10, 10), plates(22, 12, 11), 1);
  EXPECT_NEAR(moved.at(0).displacement, 3, 1e-12);
  EXPECT_NEAR(moved[0].across, 1, 1e-6);
}

TEST(Maxima, are_lost_if_there_are_none_near)
{
  const auto two = map_of([](int i, int j, int k) {
    return bump(i - 10, j - 10, k - 10) + 0.5 * bump(i - 30, j - 10, k - 10);
  });
  const auto one = map_of([](int i, int j, int k) { return bump(i - 10, j - 10, k - 10); });
  const std::vector<Maximum_change> changes = compare_maxima(two, one, 10);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_FALSE(changes[0].is_lost);
  EXPECT_TRUE(changes[1].is_lost);
}

} // namespace
