// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How centrelines meet: tubes that come together, turn back in a knee or pass a hole, and the branches they are cut into.

#include "tubes.h"

#include <CGAL/Area_projection_transform/centerlines.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
using shapes::Soup;
using shapes::three_tubes;
using shapes::tube;

TEST(Centerline_joins, meet_where_tubes_do)
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
TEST(Centerline_joins, meet_at_small_angles)
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
TEST(Centerline_joins, have_no_loop_without_a_hole)
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
TEST(Centerline_joins, turn_back_in_a_knee)
{
  for(const double degrees : {40., 60., 90.}) {
    const Centerline_graph graph = lines_of(knee(degrees * pi / 180));
    EXPECT_EQ(number_of_parts(graph), 1u) << degrees;
    EXPECT_EQ(number_of_leaves(graph), 2u) << degrees;
  }
}

TEST(Centerline_joins, of_separate_tubes_need_not_be_joined)
{
  Centerline_options options;
  options.do_join = false;
  EXPECT_EQ(number_of_parts(lines_of(three_tubes(), options)), 3u);
}

TEST(Centerline_branches, share_out_the_edges)
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

} // namespace
