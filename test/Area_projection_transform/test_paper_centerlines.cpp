// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The lines of the paper, in regions that are made up, and in tubes whose axis is known.

#include "scale_maps.h"

#include <CGAL/Area_projection_transform/centerlines/paper_centerlines.h>
#include <CGAL/Area_projection_transform/surfels_from_points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace scale_maps;
using AP::Centerline;
using AP::Paper_centerline_options;
using AP::Paper_tracing_options;
using AP::Vector_3;
using AP::Vesselness_map;
using Region = std::shared_ptr<const Row_spans>;

double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// ---------------------------------------------------------------- regions that are made up

/// a joint map and a vesselness by formulas.
struct Made_up
{
  Region region;
  std::vector<AP::Scale> scales{{2, 1}, {3, 1.5}};
  std::function<double(const Voxel&)> value = [](const Voxel&) { return 1.; };
  std::function<std::size_t(const Voxel&)> scale = [](const Voxel&) { return 0; };
  std::function<double(const Voxel&)> vesselness;
  std::function<Vector_3(const Voxel&)> direction = [](const Voxel&) { return Vector_3(1, 0, 0); };

  AP::Joint_map joint_map() const
  {
    AP::Joint_map map(region, scales);
    for(std::size_t k = 0; k < scales.size(); ++k) {
      const std::vector<float> values =
          map_of(*region, [&](const Voxel& v) { return scale(v) == k ? value(v) : 0; });
      map.consume(k, scales[k], 0, values.data(), values.size());
    }
    return map;
  }

  std::vector<Centerline> lines(const Paper_tracing_options& options = {}) const
  {
    Vesselness_map map{region, map_of(*region, vesselness), {}, {}};
    map.directions.resize(region->storage_size());
    map.scales.resize(region->storage_size());
    for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
      const Vector_3 d = direction(v);
      map.directions[place] = {float(d.x()), float(d.y()), float(d.z())};
    });
    return AP::paper_centerlines(joint_map(), map, options);
  }
};

bool is_within(int low, int i, int high)
{
  return low <= i && i <= high;
}

TEST(Paper_line_tracer, goes_from_end_to_end_of_a_bar)
{
  Made_up bar;
  bar.region = whole_region(30);
  bar.scale = [](const Voxel& v) { return v[0] < 12 ? 0 : 1; };
  bar.value = [](const Voxel& v) { return v[0] == 10 && v[1] == 7 && v[2] == 9 ? 2 : 1; };
  bar.vesselness = [](const Voxel& v) {
    const bool is_in = is_within(3, v[0], 26) && is_within(5, v[1], 9) && is_within(7, v[2], 11);
    return !is_in ? 0.3 : v[1] == 7 && v[2] == 9 ? 0.9 : 0.6;
  };
  const std::vector<Centerline> lines = bar.lines();
  ASSERT_EQ(lines.size(), 1u);
  const Centerline& line = lines[0];
  ASSERT_EQ(line.radii.size(), line.points.size());
  // From a corner at one end to one at the other.
  const Point_3 a = line.points.front(), b = line.points.back();
  EXPECT_EQ(std::min(a.x(), b.x()), 3);
  EXPECT_EQ(std::max(a.x(), b.x()), 26);
  for(std::size_t i = 0; i < line.points.size(); ++i) {
    const Point_3& p = line.points[i];
    EXPECT_TRUE(p.y() >= 5 && p.y() <= 9 && p.z() >= 7 && p.z() <= 11);
    EXPECT_EQ(line.radii[i], std::floor(p.x() + 0.5) < 12 ? 2 : 3);
    if(is_within(9, int(p.x()), 20)) { // where it is faster
      EXPECT_NEAR(p.y(), 7, 0.5);
      EXPECT_NEAR(p.z(), 9, 0.5);
    }
  }
}

TEST(Paper_line_tracer, stops_where_the_direction_jumps_but_not_where_it_turns)
{
  for(const double turn : {0.3, 1.0}) { // from voxel to voxel, along x, in one step or in many
    Made_up bar;
    bar.region = whole_region(24);
    bar.vesselness = [](const Voxel& v) {
      return is_within(10, v[1], 12) && is_within(10, v[2], 12) ? 0.7 : 0;
    };
    bar.direction = [turn](const Voxel& v) {
      const double angle = turn < 0.5 ? turn * v[0] : v[0] < 12 ? 0 : turn;
      return Vector_3(std::cos(angle), std::sin(angle), 0);
    };
    EXPECT_EQ(bar.lines().size(), turn < 0.5 ? 1u : 2u); // cos 0.3 = 0.955, cos 1 = 0.54
    Paper_tracing_options strict;
    strict.continuity = 0.96;
    EXPECT_EQ(bar.lines(strict).size(), turn < 0.5 ? 0u : 2u); // of one layer of voxels each
  }
}

TEST(Paper_line_tracer, does_not_mind_the_sign_of_directions)
{
  Made_up bar;
  bar.region = whole_region(24);
  bar.vesselness = [](const Voxel& v) { return v[1] == 11 && v[2] == 11 ? 0.7 : 0; };
  bar.direction = [](const Voxel& v) { return Vector_3(v[0] % 2 ? 1 : -1, 0, 0); };
  ASSERT_EQ(bar.lines().size(), 1u);
  EXPECT_NEAR(bar.lines()[0].length(), 23, 1e-9);
}

TEST(Paper_line_tracer, makes_one_line_of_a_region_and_more_if_it_repeats)
{
  // A ladder of two bars and a rung in the middle.
  Made_up ladder;
  ladder.region = whole_region(40);
  ladder.vesselness = [](const Voxel& v) {
    const bool is_bar = is_within(9, v[1], 11) || is_within(25, v[1], 27);
    const bool is_rung = is_within(9, v[1], 27) && is_within(18, v[0], 20);
    return is_within(19, v[2], 21) && (is_bar || is_rung) ? 0.7 : 0;
  };
  Paper_tracing_options options;
  options.least_length = 5;
  EXPECT_EQ(ladder.lines(options).size(), 1u);
  options.repeat = true;
  const std::vector<Centerline> lines = ladder.lines(options);
  EXPECT_GE(lines.size(), 2u);
  // Each bar, from end to end, has a line near each of its voxels.
  for(int y : {10, 26})
    for(int x = 3; x <= 36; ++x) {
      double nearest = 1e9;
      for(const Centerline& line : lines)
        for(const Point_3& p : line.points)
          nearest = std::min(nearest, distance(p, Point_3(x, y, 20)));
      EXPECT_LE(nearest, 3.5) << x << " " << y; // the radius of the map, and half of the bar
    }
}

TEST(Paper_line_tracer, leaves_out_what_is_short_or_not_there)
{
  Made_up nothing;
  nothing.region = ragged_region({20, 20, 20}, 2);
  nothing.vesselness = [](const Voxel&) { return 0.4; };
  EXPECT_TRUE(nothing.lines().empty());
  Made_up bar;
  bar.region = whole_region(20);
  bar.vesselness = [](const Voxel& v) {
    return is_within(4, v[0], 8) && v[1] == 10 && v[2] == 10 ? 0.7 : 0;
  };
  EXPECT_EQ(bar.lines().size(), 1u); // 4 long, with a radius of 2
  Paper_tracing_options longer;
  longer.least_length = 2.1;
  EXPECT_TRUE(bar.lines(longer).empty());
  bar.vesselness = [](const Voxel& v) { return v == Voxel{3, 3, 3} ? 1 : 0; };
  longer.least_length = 0;
  longer.repeat = true;
  EXPECT_TRUE(bar.lines(longer).empty()) << "a point is no line";
}

TEST(Paper_line_tracer, refuses_options_out_of_range)
{
  Made_up bar;
  bar.region = whole_region(3);
  bar.vesselness = [](const Voxel&) { return 0; };
  const auto complaint = [&](auto change) {
    Paper_tracing_options options;
    change(options);
    return shapes::complaint([&] { bar.lines(options); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([](auto&) {}), "");
  for(const double bad : {0., 1.1, nan})
    EXPECT_NE(complaint([&](auto& o) { o.threshold = bad; }), "");
  for(const double bad : {-0.1, 1.1, nan}) {
    EXPECT_NE(complaint([&](auto& o) { o.continuity = bad; }), "");
  }
  EXPECT_NE(complaint([&](auto& o) { o.least_length = -1; }), "");
  const Vesselness_map other{whole_region(4), std::vector<float>(64), {}, {}};
  EXPECT_NE(shapes::complaint([&] { AP::paper_centerlines(bar.joint_map(), other, {}); }), "");
}

// ---------------------------------------------------------------- tubes

using Tag = CGAL::Parallel_if_available_tag;

std::vector<Centerline> lines_of(const shapes::Soup& soup,
                                 const Paper_centerline_options& options = {})
{
  return AP::paper_centerlines<Tag>(shapes::surface_of(soup), options);
}

double voxel_size_of(const shapes::Soup& soup)
{
  return AP::default_voxel_size(shapes::surface_of(soup).bbox());
}

double mean(const std::vector<double>& values)
{
  double sum = 0;
  for(const double value : values)
    sum += value / double(values.size());
  return sum;
}

/// \brief a tube of radius 1 and length 16 along a slanted axis, and that axis.
struct Slanted_tube
{
  shapes::Rotation rotation{Vector_3(0.48, 0.6, 0.64), 0.9};
  shapes::Soup soup = shapes::moved(shapes::cylinder(32, 1, 16, true, 40), rotation);
  Vector_3 axis = rotation(Point_3(0, 0, 1)) - CGAL::ORIGIN;

  double offset(const Point_3& p) const
  {
    return std::sqrt(CGAL::cross_product(p - CGAL::ORIGIN, axis).squared_length());
  }

  /// checks that a line follows the axis, and ends near the ends, no farther from them than `missing`.
  void expect_line(const Centerline& line, double largest_offset, double missing) const
  {
    double low = 0, high = 0;
    for(const Point_3& p : line.points) {
      const double along = (p - CGAL::ORIGIN) * axis;
      low = std::min(low, along);
      high = std::max(high, along);
      if(std::abs(along) < 6) {
        EXPECT_LE(offset(p), largest_offset);
      }
    }
    EXPECT_LE(low, -8 + missing);
    EXPECT_GE(high, 8 - missing);
  }
};

TEST(Paper_centerlines, of_a_tube_is_its_axis_but_for_the_ends)
{
  const Slanted_tube tube;
  const double diagonal = std::sqrt(3.) * voxel_size_of(tube.soup);
  for(const bool scans : {true, false})
    for(const auto directions : {AP::Line_directions::HESSIAN, AP::Line_directions::VOTERS}) {
      Paper_centerline_options options;
      options.scan_scales = scans;
      options.directions = directions;
      const std::vector<Centerline> lines = lines_of(tube.soup, options);
      ASSERT_GE(lines.size(), 1u);
      // Along the rim of a lid, normals of the lid and of the tube have an axis of their own.
      if(directions == AP::Line_directions::HESSIAN) {
        EXPECT_EQ(lines.size(), 1u);
      }
      tube.expect_line(lines[0], diagonal, 1.5);
      // The map of a tube is largest at 0.845 of its radius; radii of the map are a quarter apart.
      EXPECT_NEAR(std::log(mean(lines[0].radii) / 0.845), 0, std::log(1.25));
    }
}

TEST(Paper_centerlines, does_not_lose_a_tube_with_half_of_its_faces)
{
  const Slanted_tube tube;
  const double diagonal = std::sqrt(3.) * voxel_size_of(tube.soup);
  for(const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<Centerline> lines = lines_of(shapes::thinned(tube.soup, 0.5, seed));
    ASSERT_GE(lines.size(), 1u);
    tube.expect_line(lines[0], 2 * diagonal, 2.5);
  }
}

TEST(Paper_centerlines, of_a_bent_tube_is_inside_of_it_near_its_axis)
{
  const shapes::Soup bend = shapes::torus_arc(5, 1, 2, 80, 32);
  const std::vector<Centerline> lines = lines_of(bend);
  ASSERT_EQ(lines.size(), 1u);
  double first = 2, last = 0;
  for(const Point_3& p : lines[0].points) {
    const double angle = std::atan2(p.y(), p.x());
    first = std::min(first, angle);
    last = std::max(last, angle);
    // Paths cut corners, where the vesselness is flat.
    EXPECT_LT(std::hypot(std::hypot(p.x(), p.y()) - 5, p.z()), 0.5);
  }
  EXPECT_LT(first, 0.4);
  EXPECT_GT(last, 1.6);
}

TEST(Paper_centerlines, finds_no_line_in_a_sphere)
{
  Paper_centerline_options options;
  options.voxel_size = 0.05;
  EXPECT_TRUE(lines_of(shapes::icosphere(4), options).empty());
}

TEST(Paper_centerlines, follows_units_and_has_the_same_bits_with_any_number_of_threads)
{
  const shapes::Soup blob =
      shapes::joined(shapes::torus_arc(5, 1, 2, 40, 20),
                     shapes::translated(shapes::cylinder(20, 0.5, 9, true), {0, 1, 0}));
  Paper_centerline_options options;
  options.voxel_size = 0.25;
  options.directions = AP::Line_directions::VOTERS;
  options.tracing.repeat = true;
  const auto surface = shapes::surface_of(blob);
  const std::vector<Centerline> expected =
      AP::paper_centerlines<CGAL::Sequential_tag>(surface, options);
  EXPECT_GE(expected.size(), 2u);
  for(const int threads : {1, 3})
    with_threads(threads, [&] {
      const std::vector<Centerline> lines = AP::paper_centerlines<Tag>(surface, options);
      ASSERT_EQ(lines.size(), expected.size());
      for(std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_EQ(lines[i].points, expected[i].points);
        EXPECT_EQ(lines[i].radii, expected[i].radii);
      }
    });
  options.voxel_size = 1024 * 0.25;
  const std::vector<Centerline> scaled = lines_of(shapes::scaled(blob, 1024), options);
  ASSERT_EQ(scaled.size(), expected.size());
  for(std::size_t i = 0; i < scaled.size(); ++i) {
    ASSERT_EQ(scaled[i].points.size(), expected[i].points.size());
    for(std::size_t p = 0; p < scaled[i].points.size(); ++p)
      // Areas are rounded by their places.
      EXPECT_LT(distance(CGAL::ORIGIN + (scaled[i].points[p] - CGAL::ORIGIN) / 1024,
                         expected[i].points[p]),
                1e-5);
  }
}

TEST(Paper_centerlines, takes_points_and_the_outside)
{
  const Slanted_tube tube;
  const double diagonal = std::sqrt(3.) * voxel_size_of(tube.soup);
  AP::Surfels points;
  shapes::surface_of(tube.soup).for_each_batch(
      0.1, [&](const AP::Surfels& batch) { points.append(batch); });
  const std::vector<Centerline> of_points = AP::paper_centerlines<Tag>(points);
  ASSERT_GE(of_points.size(), 1u);
  tube.expect_line(of_points[0], diagonal, 1.5);
  Paper_centerline_options options;
  options.side = AP::Side::OUTSIDE;
  options.voxel_size = 2 * voxel_size_of(tube.soup);
  const std::vector<Centerline> bore = lines_of(shapes::flipped(tube.soup), options);
  ASSERT_GE(bore.size(), 1u);
  tube.expect_line(bore[0], 2 * diagonal, 1.5); // of larger voxels
}

TEST(Paper_centerlines, stops_when_it_is_told_to_and_refuses_what_it_cannot_use)
{
  const auto surface = shapes::surface_of(shapes::cylinder(12, 1, 6, true));
  EXPECT_TRUE(AP::paper_centerlines(surface, {},
                                    CGAL::parameters::callback(
                                        std::function<bool(double)>([](double) { return false; })))
                  .empty());
  const auto complaint = [&](auto change) {
    Paper_centerline_options options;
    change(options);
    return shapes::complaint([&] { AP::paper_centerlines(surface, options); });
  };
  EXPECT_NE(shapes::complaint([] { AP::paper_centerlines(AP::Triangle_surface()); }), "");
  EXPECT_NE(complaint([](auto& o) { o.voxel_size = -1; }), "");
  EXPECT_NE(complaint([](auto& o) { o.radii = {1, 0.5}; }), "");
  EXPECT_NE(complaint([](auto& o) { o.sigma_ratio = 1; }), "");
  EXPECT_NE(complaint([](auto& o) { o.vesselness.structure = 0; }), "");
  EXPECT_NE(complaint([](auto& o) { o.tracing.threshold = 0; }), "");
}

} // namespace
