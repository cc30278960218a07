// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Centrelines of tubes whose axes are known, what they must not depend on, where they can be taken from, and what
// is refused or has none.

#include "shapes.h"

#include <CGAL/Area_projection_transform/centerlines.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/connected_components.hpp>

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
using shapes::pi;
using shapes::Soup;

Centerline_graph lines_of(const Soup& soup, const Centerline_options& options = {})
{
  return AP::centerlines(shapes::surface_of(soup), options);
}

/// an open tube around the z axis from 0 to `length`, all of its points on it; `radius(z)` and an elliptic section whose
/// semi-axes are `aspect` times as long along x and that much shorter along y.
template <class Radius>
Soup tube(double length, Radius radius, int sides = 32, int rows = 60, double aspect = 1)
{
  return shapes::welded(shapes::lattice_patch(sides, rows, [=](int i, int j) {
    const double a = 2 * pi * (i % sides) / sides, z = length * j / rows, r = radius(z);
    return Point_3(aspect * r * std::cos(a), r / aspect * std::sin(a), z);
  }));
}

Soup round_tube(double length, double radius = 1)
{
  return tube(length, [=](double) { return radius; });
}

std::size_t number_of_leaves(const Centerline_graph& graph)
{
  std::size_t leaves = 0;
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    leaves += degree(v, graph) == 1 ? 1 : 0;
  return leaves;
}

std::size_t number_of_parts(const Centerline_graph& graph)
{
  std::vector<int> part(num_vertices(graph));
  return part.empty() ? 0 : std::size_t(boost::connected_components(graph, part.data()));
}

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

/// three tubes that come from the same place, at an angle to each other, without what of each is inside another.
Soup three_tubes(double angle = 2 * pi / 3)
{
  Soup all;
  for(int k = 0; k < 3; ++k)
    all = shapes::joined(all, shapes::moved(round_tube(8), [=](const Point_3& p) {
                           const double a = angle * k, c = std::cos(a), s = std::sin(a);
                           return Point_3(c * p.z() - s * p.x(), s * p.z() + c * p.x(), p.y());
                         }));
  return shapes::without_faces(all, [=](const Point_3& c) {
    int inside = 0;
    for(int k = 0; k < 3; ++k) {
      const double a = angle * k, along = std::cos(a) * c.x() + std::sin(a) * c.y();
      const double across = std::cos(a) * c.y() - std::sin(a) * c.x();
      inside += along > 0 && std::hypot(across, c.z()) < 0.98 ? 1 : 0;
    }
    return inside > 0;
  });
}

TEST(Centerlines, meet_where_tubes_do)
{
  const Centerline_graph graph = lines_of(three_tubes());
  EXPECT_EQ(AP::branches(graph).size(), 3u);
  EXPECT_EQ(number_of_leaves(graph), 3u);
  EXPECT_EQ(number_of_parts(graph), 1u);
  const std::vector<std::size_t> nodes = AP::nodes(graph);
  ASSERT_EQ(nodes.size(), 4u);
  for(const std::size_t node : nodes) {
    const double from_center = std::sqrt((graph[node].point - Point_3(0, 0, 0)).squared_length());
    EXPECT_NEAR(from_center, degree(node, graph) == 3 ? 0 : 8, 0.05);
  }
}

// At 45 degrees two tubes are one up to 2.4 radii from where their axes meet, so that 0.2 in their direction, which is
// that of tubes open to one side, are half a radius there.
TEST(Centerlines, meet_at_small_angles)
{
  const Centerline_graph graph = lines_of(three_tubes(pi / 4));
  EXPECT_EQ(number_of_leaves(graph), 3u);
  EXPECT_EQ(number_of_parts(graph), 1u);
  std::size_t branching = 0;
  for(const std::size_t node : AP::nodes(graph))
    if(degree(node, graph) > 2) {
      ++branching;
      EXPECT_LT(std::sqrt((graph[node].point - Point_3(0, 0, 0)).squared_length()), 0.5);
    }
  EXPECT_EQ(branching, 1u);
}

/// a straight line along x of 16 radii, and a bow over its middle, half of an ellipse with these semi-axes.
AP::internal::Draft_graph line_and_bow(double along, double across)
{
  constexpr int pieces = 160;
  const auto vertex_at = [](double x, double y, Centerline_origin origin) {
    Centerline_vertex vertex;
    vertex.point = Point_3(x, y, 0);
    vertex.radius = 1;
    vertex.origin = origin;
    return vertex;
  };
  AP::internal::Draft_line line;
  for(int i = 0; i <= pieces; ++i)
    line.vertices.push_back(vertex_at(16. * i / pieces - 8, 0, Centerline_origin::FITTED));
  AP::internal::Draft_graph graph({line});
  const auto at = [&](double x) {
    return AP::internal::Draft_graph::Index(std::lround((x + 8) / 16 * pieces));
  };
  AP::internal::Draft_graph::Index last = at(-along);
  for(int i = 1; i < pieces; ++i) {
    const double a = pi * i / pieces;
    const auto next = graph.add(
        vertex_at(-along * std::cos(a), across * std::sin(a), Centerline_origin::BRIDGED));
    graph.connect(last, next);
    last = next;
  }
  graph.connect(last, at(along));
  return graph;
}

// Around a hole the bow would be two radii from the line at least.
TEST(Centerlines, have_no_loop_without_a_hole)
{
  const auto has_loop = [](double along, double across) {
    AP::internal::Draft_graph graph = line_and_bow(along, across);
    AP::internal::drop_narrow_loops(graph);
    std::size_t branching = 0, leaves = 0;
    for(AP::internal::Draft_graph::Index v = 0; v < graph.vertices.size(); ++v) {
      branching += graph.degree(v) > 2 ? 1 : 0;
      leaves += graph.degree(v) == 1 ? 1 : 0;
    }
    EXPECT_EQ(leaves, 2u); // those of the straight line
    EXPECT_TRUE(branching == 0 || branching == 2);
    return branching > 0;
  };
  EXPECT_FALSE(has_loop(1, 1));
  EXPECT_FALSE(has_loop(5, 1)); // however long
  EXPECT_TRUE(has_loop(3, 3));
  EXPECT_TRUE(has_loop(6, 2.5));
}

/// two tubes with round ends that go up at an acute angle to each other, their lower ends fused in a narrow place.
Soup knee(double angle)
{
  constexpr double length = 9; // from the centre of one end to that of the other
  constexpr double from_middle = 0.85;
  const Soup straight = tube(length + 2, [](double z) {
    const double beyond = std::max({1 - z, z - 1 - length, 0.});
    return std::sqrt(std::max(1 - beyond * beyond, 0.));
  });
  const auto direction = [=](double side) {
    return Vector_3(side * std::sin(angle / 2), 0, std::cos(angle / 2));
  };
  Soup both;
  for(const double side : {-1., 1.}) {
    const Vector_3 up = direction(side), other = direction(-side), start(side * from_middle, 0, 0);
    const Soup turned = shapes::moved(straight, [=](const Point_3& p) {
      const Vector_3 across(up.z(), 0, -up.x());
      return CGAL::ORIGIN + start + p.x() * across + Vector_3(0, p.y(), 0) + (p.z() - 1) * up;
    });
    both = shapes::joined(both, shapes::without_faces(turned, [=](const Point_3& c) {
                            const Vector_3 way = c - CGAL::ORIGIN + start;
                            const double along = std::clamp(way * other, 0., length);
                            return (way - along * other).squared_length() < 0.97;
                          }));
  }
  return both;
}

// Beyond the knee, along each of its tubes, there is air: the end looks as that of a finger.
TEST(Centerlines, turn_back_in_a_knee)
{
  for(const double degrees : {40., 60., 90.}) {
    const Centerline_graph graph = lines_of(knee(degrees * pi / 180));
    EXPECT_EQ(number_of_parts(graph), 1u) << degrees;
    EXPECT_EQ(number_of_leaves(graph), 2u) << degrees;
  }
}

TEST(Centerlines, of_separate_tubes_need_not_be_joined)
{
  Centerline_options options;
  options.do_join = false;
  EXPECT_EQ(number_of_parts(lines_of(three_tubes(), options)), 3u);
}

TEST(Centerlines, branches_share_out_the_edges)
{
  for(const Soup& soup : {three_tubes(), shapes::torus(4, 1, 60, 24)}) {
    const Centerline_graph graph = lines_of(soup);
    std::size_t edges = 0;
    for(std::size_t b = 0; b < AP::branches(graph).size(); ++b) {
      const std::vector<std::size_t>& chain = AP::branches(graph)[b].vertices;
      double length = 0;
      for(std::size_t i = 1; i < chain.size(); ++i) {
        const auto [e, is_there] = edge(chain[i - 1], chain[i], graph);
        ASSERT_TRUE(is_there);
        EXPECT_EQ(graph[e].branch, b);
        length +=
            std::sqrt(CGAL::squared_distance(graph[chain[i - 1]].point, graph[chain[i]].point));
        ++edges;
      }
      EXPECT_NEAR(length, AP::branches(graph)[b].length, 1e-9);
    }
    EXPECT_EQ(edges, num_edges(graph));
  }
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
  // A needle as long as the rest is wide, a million times; and a scale at the end of doubles.
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
