// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Salient points: what they must not depend on, where they can be taken from, and what they refuse.

#include "shapes.h"

#include <CGAL/Area_projection_transform/salient_points.h>
#include <CGAL/Area_projection_transform/surfels_from_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Salient_point;
using AP::Salient_point_options;
using AP::Salient_shape;
using AP::Vector_3;
using shapes::complaint;
using shapes::cylinder;
using shapes::icosphere;
using shapes::joined;
using shapes::Soup;
using shapes::surface_of;
using Points = std::vector<Salient_point>;

/// a sphere, a tube across it, a bend, and half a sphere with noise: no two alike.
Soup scene()
{
  const auto across = [](const Point_3& p) { return Point_3(p.z() + 4, p.x(), p.y()); };
  const Soup noisy = shapes::displaced(shapes::hemisphere(9), 0.02, 1);
  Soup soup = joined(icosphere(2), shapes::moved(cylinder(24, 0.4, 3, true, 12), across));
  soup =
      joined(soup, shapes::translated(shapes::torus_arc(3, 0.5, 1.5, 24, 16), Vector_3(0, 0, 4)));
  return joined(soup, shapes::translated(noisy, Vector_3(-3, 0, 0)));
}

Points found_in(const Soup& soup, const Salient_point_options& options = {})
{
  return AP::salient_points(surface_of(soup), options);
}

/// what is found in the scene: many tests compare with it.
const Points& points_of_scene()
{
  static const Points points = found_in(scene());
  return points;
}

bool same(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool same(const Vector_3& a, const Vector_3& b)
{
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

/// \brief that `b` is `a`, `factor` times as large, to the last bit.
void expect_same(const Points& a, const Points& b, double factor = 1)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i) {
    const Salient_point &p = a[i], &q = b[i];
    EXPECT_EQ(p.shape, q.shape);
    EXPECT_TRUE(same(factor * (p.position - CGAL::ORIGIN), q.position - CGAL::ORIGIN));
    EXPECT_TRUE(same(p.axis, q.axis) && same(p.curvature, factor * q.curvature));
    EXPECT_EQ(p.slope, q.slope);
    EXPECT_EQ(p.is_seen_from_one_side, q.is_seen_from_one_side);
    EXPECT_EQ(p.voters, q.voters);
    for(const auto length :
        {&Salient_point::scale, &Salient_point::radius, &Salient_point::radius_low,
         &Salient_point::radius_high, &Salient_point::residual, &Salient_point::length})
      EXPECT_TRUE(same(factor * (p.*length), q.*length)) << factor * (p.*length) - q.*length;
    for(const auto number :
        {&Salient_point::intensity, &Salient_point::sphericity, &Salient_point::observed_fraction})
      EXPECT_TRUE(same(p.*number, q.*number)) << p.*number - q.*number;
    EXPECT_TRUE(same(p.inertia.blobness, q.inertia.blobness) &&
                same(p.inertia.flatness, q.inertia.flatness) &&
                same(p.inertia.vesselness, q.inertia.vesselness));
  }
}

/// the nearest of the points that are of the same shape.
const Salient_point* nearest(const Points& points, const Point_3& place, Salient_shape shape)
{
  const Salient_point* best = nullptr;
  for(const Salient_point& p : points)
    if(p.shape == shape &&
       (!best || squared_distance(p.position, place) < squared_distance(best->position, place)))
      best = &p;
  return best;
}

/// \brief that `b` is `a`, `factor` times as large and moved by `move`, to 1e-6 of the radius. Where along a tube
/// its middle is depends on cells, which do not move with it; so do voters at rims.
template <class Move>
void expect_moved(const Points& a, const Points& b, double factor, Move move)
{
  ASSERT_EQ(a.size(), b.size());
  for(const Salient_point& p : a) {
    const Salient_point* q = nearest(b, move(p.position), p.shape);
    ASSERT_TRUE(q);
    const double radius = factor * p.radius;
    EXPECT_NEAR(q->radius, radius, 1e-6 * radius);
    EXPECT_EQ(q->is_seen_from_one_side, p.is_seen_from_one_side);
    if(p.shape == Salient_shape::SPHERE) {
      EXPECT_LT(std::sqrt(squared_distance(q->position, move(p.position))), 1e-6 * radius);
      EXPECT_NEAR(q->intensity, p.intensity, 0.01 * p.intensity); // the patches are cut elsewhere
    } else
      EXPECT_LT(std::sqrt(squared_distance(q->position, move(p.position))), 0.5 * radius);
    EXPECT_NEAR(std::sqrt(q->curvature.squared_length()) * factor,
                std::sqrt(p.curvature.squared_length()), 1e-6 / p.radius);
  }
}

TEST(Salient_points, of_the_scene_are_what_it_is_made_of)
{
  const Points& points = points_of_scene();
  const auto number = [&](Salient_shape shape) {
    return std::count_if(points.begin(), points.end(),
                         [&](const Salient_point& p) { return p.shape == shape; });
  };
  EXPECT_EQ(points.size(), 4u);
  EXPECT_EQ(number(Salient_shape::SPHERE), 2);
  EXPECT_EQ(number(Salient_shape::TUBE), 2);
}

// Nothing is compared with a length but lengths, so that a power of two changes exponents only.
TEST(Salient_points, of_what_is_twice_as_large_are_the_same_bits)
{
  const Points& points = points_of_scene();
  for(const double factor : {2., 0x1p-20, 0x1p20})
    expect_same(points, found_in(shapes::scaled(scene(), factor)), factor);
}

TEST(Salient_points, are_the_same_in_all_units)
{
  const Points& points = points_of_scene();
  for(const double factor : {1e-6, 0.3, 1e6})
    expect_moved(points, found_in(shapes::scaled(scene(), factor)), factor,
                 [&](const Point_3& p) { return CGAL::ORIGIN + factor * (p - CGAL::ORIGIN); });
}

TEST(Salient_points, move_with_the_surface)
{
  const Points& points = points_of_scene();
  const shapes::Rotation turn{shapes::Random(5).direction(), 0.8};
  expect_moved(points, found_in(shapes::moved(scene(), turn)), 1, turn);
  const Vector_3 shift(10, -20, 30.3);
  expect_moved(points, found_in(shapes::translated(scene(), shift)), 1,
               [&](const Point_3& p) { return p + shift; });
}

// A small thing far from the origin: what is left of 1e-16 after 1e5.
TEST(Salient_points, do_not_need_the_origin)
{
  const Vector_3 shift(1e5, 1e5, -1e5);
  const Points points = found_in(shapes::translated(icosphere(3), shift));
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].radius, 1, 1e-9);
  EXPECT_LT(std::sqrt(squared_distance(points[0].position, CGAL::ORIGIN + shift)), 1e-9);
}

TEST(Salient_points, do_not_depend_on_the_order_of_faces_and_points)
{
  const auto still = [](const Point_3& p) { return p; };
  expect_moved(points_of_scene(), found_in(shapes::shuffled(scene(), 7)), 1, still);
}

TEST(Salient_points, are_the_same_bits_for_any_number_of_threads)
{
  const AP::Triangle_surface surface = surface_of(scene());
  const Points sequential = AP::salient_points<CGAL::Sequential_tag>(surface);
  expect_same(sequential, AP::salient_points<CGAL::Parallel_if_available_tag>(surface));
#ifdef CGAL_LINKED_WITH_TBB
  for(const std::size_t threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    expect_same(sequential, AP::salient_points<CGAL::Parallel_tag>(surface));
  }
#endif
}

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cartesian = CGAL::Simple_cartesian<double>;

template <class Mesh>
class Salient_meshes : public testing::Test
{};

using Meshes = testing::Types<CGAL::Surface_mesh<Epick::Point_3>,
                              CGAL::Surface_mesh<Cartesian::Point_3>, CGAL::Polyhedron_3<Epick>,
                              CGAL::Polyhedron_3<Cartesian, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Salient_meshes, Meshes, );

TYPED_TEST(Salient_meshes, have_the_points_of_their_triangles)
{
  const Soup soup =
      joined(icosphere(2), shapes::translated(cylinder(24, 0.4, 3, false, 12), Vector_3(4, 0, 0)));
  const TypeParam mesh = shapes::mesh_of<TypeParam>(soup);
  const Points points = AP::salient_points(mesh);
  ASSERT_EQ(points.size(), 2u);
  expect_same(points, AP::salient_points(AP::surface_from_mesh(mesh)));
  Salient_point_options outside;
  outside.side = AP::Side::OUTSIDE;
  EXPECT_TRUE(AP::salient_points<CGAL::Parallel_if_available_tag>(mesh, outside).empty());
}

TYPED_TEST(Salient_meshes, may_have_their_points_elsewhere)
{
  using Vertex = typename boost::graph_traits<TypeParam>::vertex_descriptor;
  const TypeParam mesh = shapes::mesh_of<TypeParam>(icosphere(2));
  const auto map = get(CGAL::vertex_point, mesh);
  const auto doubled = boost::make_function_property_map<Vertex>([map](Vertex v) {
    const auto& p = get(map, v);
    return Point_3(2 * CGAL::to_double(p.x()), 2 * CGAL::to_double(p.y()),
                   2 * CGAL::to_double(p.z()));
  });
  const auto parameters = CGAL::parameters::vertex_point_map(doubled);
  expect_same(AP::salient_points(mesh), AP::salient_points(mesh, {}, parameters), 2);
}

TEST(Salient_points, of_unmerged_triangles_are_those_of_the_mesh)
{
  const auto still = [](const Point_3& p) { return p; };
  expect_moved(points_of_scene(), found_in(shapes::unmerged(scene())), 1, still);
}

// The points of a sphere, and its normals there.
TEST(Salient_points, may_be_found_among_points_with_normals)
{
  const Soup soup = icosphere(3, Point_3(1, 2, 3), 0.5);
  AP::Surfels surfels;
  for(std::uint32_t i = 0; i < soup.points.size(); ++i)
    surfels.push_back(soup.points[i], 2 * (soup.points[i] - Point_3(1, 2, 3)),
                      shapes::pi / double(soup.points.size()), 1000 + i);
  const Points points = AP::salient_points(surfels);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].shape, Salient_shape::SPHERE);
  EXPECT_NEAR(points[0].radius, 0.5, 1e-9);
  EXPECT_EQ(points[0].voters, surfels.sources);
  Salient_point_options outside;
  outside.side = AP::Side::OUTSIDE;
  EXPECT_TRUE(AP::salient_points(surfels, outside).empty());
}

TEST(Salient_voters, are_of_one_point_each_and_ascend)
{
  std::vector<std::uint32_t> all;
  for(const Salient_point& p : points_of_scene()) {
    EXPECT_TRUE(std::is_sorted(p.voters.begin(), p.voters.end()));
    EXPECT_FALSE(p.voters.empty());
    all.insert(all.end(), p.voters.begin(), p.voters.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
  EXPECT_LT(all.back(), scene().triangles.size());
}

TEST(Salient_voters, of_a_sphere_are_its_faces)
{
  const Soup soup = joined(icosphere(3), icosphere(2, Point_3(4, 0, 0), 0.5));
  const Points points = found_in(soup);
  ASSERT_EQ(points.size(), 2u);
  for(const Salient_point& p : points) {
    const bool is_first = p.radius > 0.7;
    std::vector<std::uint32_t> expected(is_first ? 1280 : 320);
    std::iota(expected.begin(), expected.end(), is_first ? 0 : 1280);
    EXPECT_EQ(p.voters, expected);
  }
}

// A face without area comes first: the others keep their places in the input.
TEST(Salient_voters, are_counted_in_the_input)
{
  Soup soup = icosphere(2);
  soup.triangles.insert(soup.triangles.begin(), {0, 0, 1});
  const Points points = found_in(soup);
  ASSERT_EQ(points.size(), 1u);
  ASSERT_EQ(points[0].voters.size(), 320u);
  EXPECT_EQ(points[0].voters.front(), 1u);
  EXPECT_EQ(points[0].voters.back(), 320u);
}

TEST(Salient_voters, do_not_include_faces_that_are_turned_over)
{
  Soup soup = icosphere(3);
  std::vector<std::uint32_t> expected;
  for(std::uint32_t t = 0; t < soup.triangles.size(); ++t)
    if(t % 7 == 0)
      std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    else
      expected.push_back(t);
  const Points points = found_in(soup);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].voters, expected);
}

// A threshold takes points away, and does not change the others.
TEST(Salient_points, above_a_threshold_are_the_first_ones)
{
  const Points& all = points_of_scene();
  for(const double threshold : {AP::salient_thresholds::paper, AP::salient_thresholds::tube,
                                AP::salient_thresholds::sphere}) {
    Salient_point_options options;
    options.threshold = threshold;
    const auto end = std::find_if(all.begin(), all.end(),
                                  [&](const Salient_point& p) { return p.intensity < threshold; });
    expect_same(Points(all.begin(), end), found_in(scene(), options));
  }
}

TEST(Salient_points, keep_to_the_range_of_radii)
{
  const Soup soup = joined(icosphere(3), icosphere(3, Point_3(3, 0, 0), 0.3));
  ASSERT_EQ(found_in(soup).size(), 2u);
  Salient_point_options options;
  options.smallest_radius = 0.8;
  options.largest_radius = 1.2;
  Points points = found_in(soup, options);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].radius, 1, 1e-9);
  options.smallest_radius = 0.25;
  options.largest_radius = 0.35;
  points = found_in(soup, options);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].radius, 0.3, 1e-9);
}

// A shape that is far too large or too small is not found by way of those radii that are near it.
TEST(Salient_points, have_radii_of_the_range)
{
  Salient_point_options options;
  options.largest_radius = 0.6;
  EXPECT_TRUE(found_in(icosphere(3), options).empty());
  options.largest_radius.reset();
  options.smallest_radius = 1.5;
  EXPECT_TRUE(found_in(icosphere(3), options).empty());
}

TEST(Salient_points, tell_their_progress)
{
  std::vector<double> told;
  const std::function<bool(double)> callback = [&](double fraction) {
    told.push_back(fraction);
    return true;
  };
  const auto points =
      AP::salient_points(surface_of(scene()), {}, CGAL::parameters::callback(callback));
  EXPECT_EQ(points.size(), points_of_scene().size());
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.front(), 0);
  EXPECT_LE(told.back(), 1);
}

TEST(Salient_points, stop_when_they_are_told_to)
{
  int calls = 0;
  const std::function<bool(double)> refuse = [&](double) {
    ++calls;
    return false;
  };
  EXPECT_TRUE(
      AP::salient_points(surface_of(scene()), {}, CGAL::parameters::callback(refuse)).empty());
  EXPECT_EQ(calls, 1);
}

TEST(Salient_points, refuse_choices_that_make_no_sense)
{
  const auto complaint_of = [](auto change) {
    Salient_point_options options;
    change(options);
    const std::string of_surface =
        complaint([&] { AP::salient_points(AP::Triangle_surface(), options); });
    EXPECT_EQ(complaint([&] { AP::salient_points(AP::Surfels(), options); }), of_surface);
    return of_surface;
  };
  const auto expect_named = [](const std::string& text, const std::string& name) {
    EXPECT_EQ(text.rfind(name + " is ", 0), 0u) << text;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double bad : {0., -1., nan, infinity}) {
    expect_named(complaint_of([&](auto& o) { o.smallest_radius = bad; }), "smallest_radius");
    expect_named(complaint_of([&](auto& o) { o.largest_radius = bad; }), "largest_radius");
    expect_named(complaint_of([&](auto& o) { o.tube_spacing = bad; }), "tube_spacing");
  }
  for(const double bad : {-1e-9, -infinity, nan})
    expect_named(complaint_of([&](auto& o) { o.threshold = bad; }), "threshold");
  const std::string order = complaint_of([](auto& o) {
    o.smallest_radius = 2;
    o.largest_radius = 1;
  });
  expect_named(order, "smallest_radius");
  EXPECT_NE(order.find("largest_radius"), std::string::npos);
  EXPECT_EQ(complaint_of([](auto& o) { o.smallest_radius = o.largest_radius = 1; }), "");
}

TEST(Salient_points, of_next_to_nothing_are_none)
{
  EXPECT_TRUE(AP::salient_points(AP::Triangle_surface()).empty());
  EXPECT_TRUE(AP::salient_points(AP::Surfels()).empty());
  const std::vector<Point_3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_TRUE(found_in({corners, {{0, 2, 1}}}).empty());
  EXPECT_TRUE(found_in({corners, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}).empty());
  EXPECT_TRUE(found_in({corners, {{0, 0, 1}, {1, 1, 1}, {0, 1, 0}}}).empty()); // without area
  AP::Surfels one;
  one.push_back(Point_3(0, 0, 0), Vector_3(0, 0, 1), 1, 0);
  EXPECT_TRUE(AP::salient_points(one).empty());
  one.areas[0] = 0;
  EXPECT_TRUE(AP::salient_points(one).empty());
}

// Needles, faces that are there twice, and points that no face uses do not matter.
TEST(Salient_points, do_not_mind_what_is_degenerate)
{
  Soup soup = icosphere(3);
  soup.points.push_back(Point_3(1e6, 0, 0));
  for(std::uint32_t t = 0; t < 40; ++t) {
    const shapes::Triangle triangle = soup.triangles[t];
    soup.triangles.push_back(triangle);
    soup.triangles.push_back({triangle[0], triangle[1], triangle[1]});
  }
  const Points points = found_in(soup);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].shape, Salient_shape::SPHERE);
  EXPECT_NEAR(points[0].radius, 1, 1e-9);
}

} // namespace
