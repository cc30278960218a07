// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Centrelines of tubes whose axes are known, what they must not depend on, where they can be taken from, and what
// is refused or has none.

#include "tubes.h"

#include <CGAL/Area_projection_transform/centerlines.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Centerline_graph;
using AP::Centerline_options;
using AP::Centerline_origin;
using AP::Centerline_vertex;
using AP::Point_3;
using AP::Vector_3;
using shapes::lines_of;
using shapes::number_of_leaves;
using shapes::number_of_parts;
using shapes::pi;
using shapes::round_tube;
using shapes::Soup;
using shapes::three_tubes;
using shapes::tube;

/// what `function(vertex)` is at most.
template <class Function>
double largest(const Centerline_graph& graph, Function function)
{
  double result = 0;
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    result = std::max(result, function(graph[v]));
  return result;
}

double from_z_axis(const Centerline_vertex& vertex)
{
  return std::hypot(vertex.point.x(), vertex.point.y());
}

TEST(Centerlines, follow_a_straight_tube_exactly)
{
  const Soup soup = round_tube(10);
  const Centerline_graph graph = lines_of(soup);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  const AP::Centerline_branch& branch = AP::branches(graph)[0];
  EXPECT_FALSE(branch.is_closed());
  // The vertices lie on a cylinder, so that the fit has no residual; the ends are at the rims.
  EXPECT_LT(largest(graph, from_z_axis), 1e-6);
  EXPECT_NEAR(branch.length, 10, 1e-6);
  // Pieces of faces, which are inside by up to 1 - cos(π/32), count 2 % where there are any.
  EXPECT_NEAR(branch.mean_radius, 1, 2e-4);
  EXPECT_EQ(branch.voters.size(), soup.triangles.size());
  EXPECT_NEAR(branch.score, 1, 0.25);
}

TEST(Centerlines, end_however_thin_a_tube_is_asked_for)
{
  Centerline_options options;
  options.smallest_radius = std::numeric_limits<double>::denorm_min();
  const Centerline_graph graph = lines_of(round_tube(10), options);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_NEAR(AP::branches(graph)[0].length, 10, 1e-6);
}

TEST(Centerlines, measure_the_section_of_a_tube)
{
  const Centerline_graph graph = lines_of(round_tube(12));
  int middle = 0;
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    const Centerline_vertex& vertex = graph[v];
    if(vertex.origin != Centerline_origin::FITTED || std::abs(vertex.point.z() - 6) > 3)
      continue;
    ++middle;
    EXPECT_NEAR(std::abs(vertex.tangent.z()), 1, 1e-9);
    EXPECT_LE(vertex.radius_low, vertex.radius);
    EXPECT_GE(vertex.radius_high, vertex.radius);
    EXPECT_NEAR(vertex.coverage, 1, 1e-9);
    EXPECT_NEAR(vertex.area, pi, 0.002 * pi);
    EXPECT_NEAR(vertex.perimeter, 2 * pi, 0.002 * pi);
    EXPECT_NEAR(vertex.inscribed_radius, 1, 0.002);
    // The ladder: 1/2 on the axis of a tube. Half an edge more or less at each end of a window of length 1 is 0.1.
    EXPECT_NEAR(vertex.mapt, 0.5, 0.1);
  }
  EXPECT_GT(middle, 20);
}

TEST(Centerlines, of_a_torus_are_one_closed_curve)
{
  const Centerline_graph graph = lines_of(shapes::torus(4, 1, 120, 32));
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  const AP::Centerline_branch& branch = AP::branches(graph)[0];
  EXPECT_TRUE(branch.is_closed());
  EXPECT_EQ(number_of_leaves(graph), 0u);
  EXPECT_EQ(num_edges(graph), num_vertices(graph));
  EXPECT_LT(largest(graph,
                    [](const Centerline_vertex& v) {
                      return std::hypot(from_z_axis(v) - 4, v.point.z());
                    }),
            0.005);
  // Chords of 0.12 are shorter than their arcs by 1 - sinc(0.015).
  EXPECT_NEAR(branch.length, 8 * pi, 0.005 * pi);
}

TEST(Centerlines, have_the_radius_of_a_cone)
{
  const auto radius = [](double z) { return 1.5 - z / 8; };
  const Centerline_graph graph = lines_of(tube(8, radius));
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_LT(largest(graph, from_z_axis), 0.002);
  EXPECT_LT(largest(graph,
                    [&](const Centerline_vertex& v) {
                      return v.origin == Centerline_origin::FITTED
                                 ? std::abs(v.radius - radius(v.point.z()))
                                 : 0;
                    }),
            0.002);
}

TEST(Centerlines, have_the_sections_of_elliptic_tubes)
{
  const double aspect = std::sqrt(2.); // axes of 2 : 1 and the area π
  const Centerline_graph graph = lines_of(tube(
      10, [](double) { return 1.; }, 48, 80, aspect));
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_LT(largest(graph, from_z_axis), 0.005);
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    const Centerline_vertex& vertex = graph[v];
    if(vertex.origin != Centerline_origin::FITTED)
      continue;
    EXPECT_NEAR(vertex.radius, 1, 0.003);
    EXPECT_NEAR(vertex.area, pi, 0.01 * pi);
    EXPECT_NEAR(vertex.inscribed_radius, 1 / aspect, 0.01);
    // Ramanujan's formula for the perimeter, with h = 1/9.
    const double h = 1. / 9, a = aspect + 1 / aspect;
    EXPECT_NEAR(vertex.perimeter, pi * a * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))), 0.02);
  }
}

// Three lobes of height h = 0.06, which no ellipse has: the perimeter is 2π (1 + 9 h²/4) and the area π (1 + h²/2), but for
// h⁴. Means over sectors of 15 degrees take 2.5 % off the lobes.
TEST(Centerlines, have_the_sections_of_tubes_with_lobes)
{
  constexpr double height = 0.06;
  const Soup soup = shapes::moved(round_tube(10), [](const Point_3& p) {
    const double r = 1 + height * std::cos(3 * std::atan2(p.y(), p.x()));
    return Point_3(r * p.x(), r * p.y(), p.z());
  });
  const Centerline_graph graph = lines_of(soup);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  int middle = 0;
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    const Centerline_vertex& vertex = graph[v];
    if(vertex.origin != Centerline_origin::FITTED || std::abs(vertex.point.z() - 5) > 3)
      continue;
    ++middle;
    EXPECT_NEAR(vertex.radius, 1, 0.003);
    EXPECT_NEAR(vertex.inscribed_radius, 1 - height, 0.1 * height);
    EXPECT_NEAR(vertex.perimeter / (2 * pi), 1 + 2.25 * height * height, 0.002);
    EXPECT_NEAR(vertex.area / pi, 1 + 0.5 * height * height, 0.005);
  }
  EXPECT_GT(middle, 20);
}

TEST(Centerlines, do_not_mind_that_half_of_the_faces_are_missing)
{
  // The vertices that are left lie on the tube as before.
  const Centerline_graph graph = lines_of(shapes::thinned(round_tube(10), 0.5, 3));
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_LT(largest(graph, from_z_axis), 0.002);
  EXPECT_NEAR(AP::branches(graph)[0].length, 10, 0.3);
  EXPECT_NEAR(AP::branches(graph)[0].mean_radius, 1, 0.002);
}

TEST(Centerlines, do_not_mind_holes)
{
  const Soup soup = shapes::without_faces(round_tube(12), [](const Point_3& c) {
    return (c.x() > 0 && std::abs(c.z() - 4) < 1.5) || (c.y() < -0.5 && std::abs(c.z() - 8) < 1);
  });
  const Centerline_graph graph = lines_of(soup);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_LT(largest(graph, from_z_axis), 0.002);
  EXPECT_NEAR(AP::branches(graph)[0].length, 12, 1e-3);
  double least = 1;
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    if(std::abs(graph[v].point.z() - 4) < 0.5)
      least = std::min(least, graph[v].coverage);
  EXPECT_LT(least, 0.7); // half of the circumference, and half of a face at each side
}

TEST(Centerlines, of_tubes_that_touch_are_two)
{
  const Soup pair =
      shapes::joined(round_tube(10), shapes::translated(round_tube(10), Vector_3(2, 0, 1)));
  const Centerline_graph graph = lines_of(pair);
  EXPECT_EQ(AP::branches(graph).size(), 2u);
  EXPECT_EQ(number_of_parts(graph), 2u);
  EXPECT_LT(largest(graph,
                    [](const Centerline_vertex& v) {
                      return std::min(from_z_axis(v), std::hypot(v.point.x() - 2, v.point.y()));
                    }),
            0.002);
  // Each face belongs to its own tube.
  const std::size_t half = pair.triangles.size() / 2;
  std::set<std::int32_t> first, second;
  const std::vector<std::int32_t> of_face =
      AP::branch_of_each(graph, shapes::surface_of(pair).sources);
  for(std::size_t f = 0; f < of_face.size(); ++f)
    (f < half ? first : second).insert(of_face[f]);
  EXPECT_EQ(first.size(), 1u);
  EXPECT_EQ(second.size(), 1u);
  EXPECT_NE(first, second);
}

TEST(Centerlines, extend_to_the_cap_unless_told_not_to)
{
  const Soup closed = shapes::cylinder(32, 1, 10, true, 50);
  EXPECT_NEAR(AP::branches(lines_of(closed)).at(0).length, 10, 0.02);
  Centerline_options options;
  options.do_extend = false;
  EXPECT_LT(AP::branches(lines_of(closed, options)).at(0).length, 9.95);
}

std::vector<double> sorted_lengths(const Centerline_graph& graph)
{
  std::vector<double> lengths;
  for(const AP::Centerline_branch& branch : AP::branches(graph))
    lengths.push_back(branch.length);
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

// Nothing depends on the axes but the rounding of sums: the rotated coordinates differ by 1e-16, fits by 1e-10, and of a body
// no threshold is that near. Tubes of a lattice have ties, which rounding decides.
TEST(Centerlines, follow_rotations_and_units)
{
  const shapes::Rotation turn{Vector_3(2. / 3, 1. / 3, 2. / 3), 0.7};
  for(const auto& [soup, tolerance] :
      {std::pair(three_tubes(), 1e-3), std::pair(shapes::bundled_mesh("scorpion_low.obj"), 1e-6)}) {
    const std::vector<double> lengths = sorted_lengths(lines_of(soup));
    for(const double unit : {1e-3, 1e4}) {
      const auto move = [unit, turn](const Point_3& p) {
        return CGAL::ORIGIN + unit * ((turn(p) - CGAL::ORIGIN) + Vector_3(3, -5, 1));
      };
      const std::vector<double> others = sorted_lengths(lines_of(shapes::moved(soup, move)));
      ASSERT_EQ(others.size(), lengths.size());
      for(std::size_t b = 0; b < lengths.size(); ++b)
        EXPECT_NEAR(others[b] / unit, lengths[b], tolerance * lengths[b]);
    }
  }
}

bool are_same(const Centerline_graph& a, const Centerline_graph& b)
{
  if(num_vertices(a) != num_vertices(b) || num_edges(a) != num_edges(b))
    return false;
  for(std::size_t v = 0; v < num_vertices(a); ++v)
    if(a[v].point != b[v].point || std::memcmp(&a[v].radius, &b[v].radius, sizeof(double)) != 0 ||
       std::memcmp(&a[v].mapt, &b[v].mapt, sizeof(double)) != 0)
      return false;
  for(std::size_t i = 0; i < AP::branches(a).size(); ++i)
    if(AP::branches(a)[i].vertices != AP::branches(b)[i].vertices ||
       AP::branches(a)[i].voters != AP::branches(b)[i].voters)
      return false;
  return true;
}

TEST(Centerlines, are_the_same_bits_for_any_number_of_threads)
{
  const AP::Triangle_surface surface =
      shapes::surface_of(shapes::displaced(three_tubes(), 0.02, 5));
  EXPECT_TRUE(are_same(AP::centerlines<CGAL::Sequential_tag>(surface),
                       AP::centerlines<CGAL::Parallel_if_available_tag>(surface)));
}

TEST(Centerlines, of_meshes_are_those_of_their_triangles)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const Soup soup = round_tube(8);
  const double length = AP::branches(lines_of(soup)).at(0).length;
  EXPECT_NEAR(
      AP::branches(AP::centerlines(shapes::mesh_of<CGAL::Surface_mesh<Kernel::Point_3>>(soup)))
          .at(0)
          .length,
      length, 1e-9);
  EXPECT_NEAR(
      AP::branches(AP::centerlines(shapes::mesh_of<CGAL::Polyhedron_3<Kernel>>(soup))).at(0).length,
      length, 1e-9);
}

TEST(Centerlines, of_points_with_normals)
{
  shapes::Random random(4);
  AP::Surfels points;
  const int number = 3000;
  for(int i = 0; i < number; ++i) {
    const double a = random(0, 2 * pi);
    const Vector_3 n(std::cos(a), std::sin(a), 0);
    points.push_back(Point_3(n.x(), n.y(), random(0, 10)), n, 20 * pi / number, std::uint32_t(i));
  }
  const Centerline_graph graph = AP::centerlines(points);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_LT(largest(graph, from_z_axis), 0.002);
  EXPECT_NEAR(AP::branches(graph)[0].length, 10, 0.2);
  EXPECT_GT(AP::branches(graph)[0].voters.size(), std::size_t(0.95 * number));
}

// Places 1.5 apart share no point that has a weight, so that their errors are independent. Of 144 true radii, 137 ± 3 are
// in intervals of 95 %, and 97 ± 6 in the inner halves of them.
TEST(Centerlines, have_the_radius_in_their_intervals_as_often_as_they_say)
{
  constexpr int number = 6000;
  int all = 0, in_interval = 0, in_half = 0;
  for(std::uint64_t seed = 0; seed < 12; ++seed) {
    shapes::Random random(seed);
    AP::Surfels points;
    for(int i = 0; i < number; ++i) {
      const double a = random(0, 2 * pi), r = 1 + random(-0.05, 0.05);
      const Vector_3 n(std::cos(a), std::sin(a), 0);
      points.push_back(Point_3(r * n.x(), r * n.y(), random(0, 20)), n, 40 * pi / number,
                       std::uint32_t(i));
    }
    const Centerline_graph graph = AP::centerlines(points);
    ASSERT_EQ(AP::branches(graph).size(), 1u);
    double last = 0;
    for(const std::size_t v : AP::branches(graph)[0].vertices) {
      const double z = graph[v].point.z();
      if(graph[v].origin != Centerline_origin::FITTED || std::abs(z - last) < 1.5 ||
         std::abs(z - 10) > 8.5)
        continue;
      last = z;
      const double error = std::abs(graph[v].radius - 1);
      const double half = 0.5 * (graph[v].radius_high - graph[v].radius_low);
      ++all;
      in_interval += error < half ? 1 : 0;
      in_half += error < 0.5 * half ? 1 : 0;
    }
  }
  EXPECT_GE(all, 120);
  EXPECT_GT(in_interval, 0.87 * all);
  EXPECT_LT(in_half, 0.83 * all);
}

TEST(Centerlines, turn_around_what_faces_inward)
{
  const Soup closed = shapes::cylinder(32, 1, 10, true, 50);
  const Centerline_graph graph = lines_of(shapes::flipped(closed));
  EXPECT_TRUE(graph[boost::graph_bundle].is_turned_over);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_FALSE(lines_of(closed)[boost::graph_bundle].is_turned_over);
}

TEST(Centerlines, of_bores_are_outside)
{
  // A pipe: the wall inside faces the axis.
  const Soup pipe = shapes::joined(round_tube(10, 2), shapes::flipped(round_tube(10, 1)));
  Centerline_options options;
  options.side = AP::Side::OUTSIDE;
  const Centerline_graph graph = lines_of(pipe, options);
  ASSERT_EQ(AP::branches(graph).size(), 1u);
  EXPECT_NEAR(AP::branches(graph)[0].mean_radius, 1, 0.002);
}

TEST(Centerlines, of_what_is_no_tube_are_none)
{
  EXPECT_EQ(num_vertices(lines_of(shapes::icosphere(4))), 0u);
  // A box may be taken for a short prism.
  EXPECT_LE(AP::branches(lines_of(shapes::fine_box(Vector_3(1, 1.2, 0.9), 0.1))).size(), 1u);
  EXPECT_EQ(num_vertices(lines_of(shapes::plane_patch(1, 0, 20))), 0u);
  EXPECT_EQ(num_vertices(lines_of(Soup())), 0u);
  EXPECT_EQ(num_vertices(AP::centerlines(AP::Surfels())), 0u);
}

TEST(Centerlines, survive_junk)
{
  shapes::Random random(9);
  const CGAL::Bbox_3 box(0, 0, 0, 1, 1, 1);
  for(const std::size_t number : {1u, 2u, 3u, 10u, 300u}) {
    Soup soup;
    for(std::uint32_t i = 0; i < number; ++i) {
      for(int k = 0; k < 3; ++k)
        soup.points.push_back(random.point_in(box));
      soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    EXPECT_NO_THROW(lines_of(soup)) << number;
  }
  // A needle as long as the rest is wide, a million times; and sizes beyond those of floats.
  Soup needle = round_tube(5);
  needle.points.push_back(Point_3(1e6, 0, 0));
  needle.triangles.push_back({0, 1, std::uint32_t(needle.points.size() - 1)});
  EXPECT_NO_THROW(lines_of(needle));
  EXPECT_NO_THROW(lines_of(shapes::scaled(round_tube(5), 1e-160)));
  EXPECT_NO_THROW(lines_of(shapes::scaled(round_tube(5), 1e73)));
}

TEST(Centerlines, tell_their_progress_and_stop_when_they_are_told_to)
{
  const AP::Triangle_surface surface = shapes::surface_of(three_tubes());
  double last = 0;
  const std::size_t all =
      AP::branches(AP::centerlines(
                       surface, {},
                       CGAL::parameters::callback(std::function<bool(double)>([&](double fraction) {
                         EXPECT_GE(fraction, last);
                         EXPECT_LE(fraction, 1);
                         last = fraction;
                         return true;
                       }))))
          .size();
  EXPECT_GT(last, 0);
  EXPECT_EQ(all, 3u);
  Centerline_options apart;
  apart.do_join = false;
  int calls = 0;
  const Centerline_graph some = AP::centerlines(
      surface, apart, CGAL::parameters::callback(std::function<bool(double)>([&](double) {
        ++calls;
        return false;
      })));
  EXPECT_EQ(calls, 1);
  EXPECT_LE(AP::branches(some).size(), 3u);
}

TEST(Centerlines, refuse_options_that_make_no_sense)
{
  const AP::Triangle_surface surface = shapes::surface_of(round_tube(5));
  const auto refuses = [&](auto set) {
    Centerline_options options;
    set(options);
    EXPECT_THROW(AP::centerlines(surface, options), std::invalid_argument);
  };
  refuses([](Centerline_options& o) { o.smallest_radius = 0; });
  refuses([](Centerline_options& o) { o.largest_radius = -1; });
  refuses(
      [](Centerline_options& o) { o.largest_radius = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](Centerline_options& o) {
    o.smallest_radius = 2;
    o.largest_radius = 1;
  });
  refuses([](Centerline_options& o) { o.least_length = 0; });
  refuses([](Centerline_options& o) { o.vertex_spacing = 0; });
}

} // namespace
