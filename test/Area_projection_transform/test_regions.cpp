// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lattices, regions of interest, and which voxels lie inside of a surface or near it.

#include "shapes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Vector_3;
using shapes::pi;
using shapes::Soup;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Epick::Point_3>;

double distance_to_origin(const Point_3& p)
{
  return std::sqrt((p - CGAL::ORIGIN).squared_length());
}

// ---------------------------------------------------------------- lattices

TEST(Grid_3, places_the_origin_at_the_centre_of_the_first_voxel)
{
  const AP::Grid_3 grid(Point_3(1, 2, 3), 0.5, {4, 5, 6});
  EXPECT_EQ(grid.point(0, 0, 0), Point_3(1, 2, 3));
  EXPECT_EQ(grid.point(3, 4, 5), Point_3(2.5, 4, 5.5));
  EXPECT_EQ(grid.lattice_coordinates(grid.point(3, 1, 2)), Vector_3(3, 1, 2));
  EXPECT_EQ(grid.number_of_voxels(), 120u);
  EXPECT_EQ(grid.row(3, 2), 13u);
}

TEST(Grid_3, around_a_box_is_centred_and_the_smallest_that_covers_it)
{
  shapes::Random random(51);
  for(int n = 0; n < 200; ++n) {
    const Point_3 low = random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
    const Point_3 high = low + Vector_3(random(), random(), random());
    const double spacing = random(0.01, 0.5), margin = n % 2 ? random() : 0;
    const AP::Grid_3 grid = AP::grid_around(low.bbox() + high.bbox(), spacing, margin);
    for(int axis = 0; axis < 3; ++axis) {
      const double first = grid.origin()[axis];
      const double last = first + spacing * (grid.size()[std::size_t(axis)] - 1);
      const double below = low[axis] - first, above = last - high[axis];
      ASSERT_NEAR(below, above, 1e-12);
      ASSERT_GE(below, margin - 1e-12);
      ASSERT_LT(below, margin + spacing / 2 + 1e-12);
    }
  }
}

TEST(Grid_3, names_the_argument_that_is_out_of_range)
{
  const Point_3 origin(0, 0, 0);
  EXPECT_EQ(shapes::complaint([&] {
              AP::Grid_3(origin, 0, {1, 1, 1});
            }),
            "spacing is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] {
              AP::Grid_3(origin, 1, {1, 0, 1});
            }),
            "size[1] is 0: must be at least 1");
  EXPECT_EQ(shapes::complaint([&] {
              AP::Grid_3(Point_3(0, NAN, 0), 1, {1, 1, 1});
            }),
            "origin has a coordinate that is not finite");
  const CGAL::Bbox_3 box(0, 0, 0, 1, 1, 1);
  EXPECT_EQ(shapes::complaint([&] { AP::grid_around(box, 0.1, -1); }),
            "margin is -1: must not be negative");
  EXPECT_NE(shapes::complaint([&] { AP::grid_around(box, 0); }).find("spacing is 0"),
            std::string::npos);
  EXPECT_NE(shapes::complaint([&] { AP::grid_around(box, -1); }).find("spacing is -1"),
            std::string::npos);
  EXPECT_EQ(shapes::complaint([&] { AP::grid_around(box, 1e-10); }),
            "spacing is 1e-10: too small for a box 1 wide");
}

// ---------------------------------------------------------------- row spans

TEST(Row_spans, of_a_whole_grid_hold_every_voxel_in_order)
{
  const AP::Grid_3 grid(Point_3(0, 0, 0), 1, {3, 4, 5});
  const AP::Row_spans region(grid);
  EXPECT_EQ(region.number_of_voxels(), 60u);
  EXPECT_EQ(region.storage_size(), 60u);
  std::size_t place = 0;
  shapes::for_each_voxel(region, [&](const Point_3&, std::size_t p) { EXPECT_EQ(p, place++); });
  EXPECT_EQ(region.index(-1, 0, 0), region.storage_size());
  EXPECT_EQ(region.index(3, 0, 0), region.storage_size());
}

TEST(Row_spans, keep_runs_and_store_the_hull_of_each_row)
{
  shapes::Random random(52);
  for(int n = 0; n < 20; ++n) {
    const AP::Grid_3 grid(Point_3(0, 0, 0), 1, {17, 5, 4});
    std::vector<bool> wanted(grid.number_of_voxels());
    const double density = random(0, 0.6);
    for(std::size_t v = 0; v < wanted.size(); ++v)
      wanted[v] = random() < density;
    const AP::Row_spans region(grid, [&](std::size_t row, std::vector<AP::Row_spans::Run>& runs) {
      EXPECT_TRUE(runs.empty());
      for(std::int32_t i = 0; i < 17; ++i)
        if(wanted[row * 17 + std::size_t(i)])
          runs.push_back({i, i + 1});
    });
    std::size_t voxels = 0, storage = 0;
    for(int k = 0; k < 4; ++k)
      for(int j = 0; j < 5; ++j) {
        const std::size_t row = grid.row(j, k);
        int first = 17, last = 0;
        for(int i = 0; i < 17; ++i) {
          const bool is_wanted = wanted[row * 17 + std::size_t(i)];
          ASSERT_EQ(region.contains(i, j, k), is_wanted);
          if(is_wanted) {
            first = std::min(first, i);
            last = i + 1;
            ++voxels;
          }
        }
        if(last == 0)
          first = 0;
        ASSERT_EQ(region.hull(row).first, first);
        ASSERT_EQ(region.hull(row).last, last);
        ASSERT_EQ(region.hull(row).offset, storage);
        for(int i = 0; i < 17; ++i)
          ASSERT_EQ(region.index(i, j, k), i >= first && i < last ? storage + std::size_t(i - first)
                                                                  : region.storage_size());
        storage += std::size_t(last - first);
      }
    EXPECT_EQ(region.number_of_voxels(), voxels);
    EXPECT_EQ(region.storage_size(), storage);
  }
}

// ---------------------------------------------------------------- interior

/// expects the interior to hold the voxels for which `depth` (positive inside) is more than
/// `tolerance`, and none for which it is less than minus that.
template <class Depth>
void expect_interior(const Soup& soup, double voxel, double tolerance, Depth depth)
{
  const auto surface = shapes::surface_of(soup);
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), voxel, 1.3 * voxel);
  const AP::Interior inside = AP::interior(surface, grid);
  for(int k = 0; k < grid.size()[2]; ++k)
    for(int j = 0; j < grid.size()[1]; ++j)
      for(int i = 0; i < grid.size()[0]; ++i) {
        const double d = depth(grid.point(i, j, k));
        if(std::abs(d) > tolerance) {
          ASSERT_EQ(inside.region.contains(i, j, k), d > 0) << grid.point(i, j, k);
        }
      }
  EXPECT_EQ(inside.coverage, 1);
  // Only voxels that the surface goes through can be counted wrong.
  EXPECT_NEAR(inside.volume, soup.volume(), voxel * soup.area());
  EXPECT_NEAR(inside.volume, double(inside.region.number_of_voxels()) * std::pow(voxel, 3), 1e-12);
}

// Tolerances: how far the faces lie from the smooth shape, 1 - cos(half the angle of a face).
TEST(Interior, of_smooth_shapes_is_where_their_equation_says)
{
  expect_interior(shapes::icosphere(4), 0.093, 0.003,
                  [](const Point_3& p) { return 1 - distance_to_origin(p); });
  expect_interior(shapes::torus(1, 0.4, 100, 50), 0.071, 0.003, [](const Point_3& p) {
    return 0.4 - std::hypot(std::hypot(p.x(), p.y()) - 1, p.z());
  });
  expect_interior(shapes::cylinder(100, 0.5, 2, true), 0.083, 0.0005, [](const Point_3& p) {
    return std::min(0.5 - std::hypot(p.x(), p.y()), 1 - std::abs(p.z()));
  });
  expect_interior(shapes::cone(100, 1, 1), 0.077, 0.0006, [](const Point_3& p) {
    return std::min(1 - p.z() - std::hypot(p.x(), p.y()), p.z());
  });
}

TEST(Interior, of_a_sphere_with_a_cavity_leaves_the_cavity_out)
{
  expect_interior(shapes::joined(shapes::icosphere(4),
                                 shapes::flipped(shapes::icosphere(4, Point_3(0, 0, 0), 0.5))),
                  0.061, 0.003, [](const Point_3& p) {
                    const double r = distance_to_origin(p);
                    return std::min(1 - r, r - 0.5);
                  });
}

TEST(Interior, of_several_parts_is_their_union)
{
  const Soup sphere = shapes::icosphere(4), inner = shapes::icosphere(4, Point_3(0, 0, 0), 0.5);
  const Soup beside = shapes::icosphere(4, Point_3(1.2, 0, 0), 1);
  const auto count = [](const Soup& soup) {
    const AP::Grid_3 grid(Point_3(-1.05, -1.05, -1.05), 0.0513, {70, 45, 45});
    return AP::interior(shapes::surface_of(soup), grid).region.number_of_voxels();
  };
  EXPECT_EQ(count(shapes::joined(sphere, inner)), count(sphere)); // nested
  const std::size_t both = count(shapes::joined(sphere, beside)); // overlapping
  // Two unit balls at the distance d share π (4 + d)(2 - d)²/12.
  const double shared = pi * (4 + 1.2) * 0.8 * 0.8 / 12, expected = 2 * 4 * pi / 3 - shared;
  EXPECT_NEAR(double(both) * std::pow(0.0513, 3), expected, 0.01 * expected);
}

// Lattice points on the faces, edges and corners of a box belong to it as if the lattice were moved by
// an infinitesimal distance: boxes that touch share them out.
TEST(Interior, shares_out_lattice_points_on_the_surface)
{
  const AP::Grid_3 grid(Point_3(-0.5, -0.5, -0.5), 0.25, {13, 9, 9});
  const Soup left = shapes::box(Point_3(0, 0, 0), Point_3(1, 1, 1));
  const Soup right = shapes::box(Point_3(1, 0, 0), Point_3(2, 1, 1));
  const AP::Interior of_left = AP::interior(shapes::surface_of(left), grid);
  const AP::Interior of_right = AP::interior(shapes::surface_of(right), grid);
  const AP::Interior of_both = AP::interior(shapes::surface_of(shapes::joined(left, right)), grid);
  EXPECT_EQ(of_left.region.number_of_voxels(), 4u * 4 * 4);
  EXPECT_EQ(of_left.volume, 1);
  EXPECT_EQ(of_right.volume, 1);
  EXPECT_EQ(of_both.volume, 2);
  for(int k = 0; k < 9; ++k)
    for(int j = 0; j < 9; ++j)
      for(int i = 0; i < 13; ++i) {
        const bool is_left = of_left.region.contains(i, j, k);
        const bool is_right = of_right.region.contains(i, j, k);
        EXPECT_FALSE(is_left && is_right);
        EXPECT_EQ(of_both.region.contains(i, j, k), is_left || is_right);
      }
}

// The dome is seen by five of the six rays from each point below it, and by one or none elsewhere.
TEST(Interior, of_a_dome_is_what_it_covers)
{
  const auto surface = shapes::surface_of(shapes::hemisphere(40));
  const AP::Grid_3 grid = AP::grid_around(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), 0.0613, 0.1);
  const AP::Interior inside = AP::interior(surface, grid);
  EXPECT_NEAR(inside.coverage, 5. / 6, 1e-3);
  shapes::for_each_voxel(AP::Row_spans(grid), [&](const Point_3& p, std::size_t place) {
    const std::size_t nx = std::size_t(grid.size()[0]), ny = std::size_t(grid.size()[1]);
    const bool is_in =
        inside.region.contains(int(place % nx), int(place / nx % ny), int(place / nx / ny));
    if(std::abs(1 - distance_to_origin(p)) > 0.002 && std::abs(p.z()) > 0.001) {
      ASSERT_EQ(is_in, p.z() > 0 && distance_to_origin(p) < 1) << p;
    }
  });
}

TEST(Interior, of_a_sphere_with_a_hole_is_nearly_the_ball)
{
  const Soup holed =
      shapes::without_faces(shapes::icosphere(4), [](const Point_3& p) { return p.z() > 0.9; });
  const auto surface = shapes::surface_of(holed);
  const AP::Interior inside = AP::interior(surface, AP::grid_around(surface.bbox(), 0.05));
  // The hole takes one ray of six from the tube below it, 0.19 of the cross section: 3 %.
  EXPECT_LT(inside.coverage, 1 - 0.02);
  EXPECT_GT(inside.coverage, 1 - 0.05);
  const double cap = pi * 0.1 * 0.1 * (3 - 0.1) / 3; // not below any of the surface
  EXPECT_NEAR(inside.volume, 4 * pi / 3 - cap, 0.02 * 4 * pi / 3);
}

// Votes and winding numbers agree where both apply: a soup whose faces name their own points each is not
// known to be closed.
// With half of the faces missing, a voxel gets three votes of six in the mean, more or less by more than
// one; its 27 neighbours and their 54 lines along each axis tell better.
TEST(Interior, is_found_where_half_of_the_faces_are_missing)
{
  Soup sphere = shapes::icosphere(4);
  shapes::Random(7).shuffle(sphere.triangles);
  sphere.triangles.resize(sphere.triangles.size() / 2);
  const AP::Triangle_surface surface = shapes::surface_of(sphere);
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.05, 0.2);
  const AP::Interior inside = AP::interior(surface, grid);
  std::size_t wrong = 0, right = 0;
  for(int k = 0; k < grid.size()[2]; ++k)
    for(int j = 0; j < grid.size()[1]; ++j)
      for(int i = 0; i < grid.size()[0]; ++i) {
        const double distance = std::sqrt((grid.point(i, j, k) - CGAL::ORIGIN).squared_length());
        if(std::abs(distance - 1) > 0.1) // two voxels: the size of a neighbourhood
          ++(inside.region.contains(i, j, k) == (distance < 1) ? right : wrong);
      }
  EXPECT_LT(wrong, 0.01 * double(right));
  EXPECT_NEAR(inside.coverage, 0.5, 0.02);
  EXPECT_NEAR(inside.volume, 4. / 3 * pi, 4 * pi * 0.5 * grid.spacing()); // half a voxel all around
}

TEST(Interior, knows_what_is_observed_from_votes_that_are_a_majority)
{
  EXPECT_NEAR(AP::internal::observed_fraction(1), 1, 1e-9);
  // (3 * 20 + 4 * 15 + 5 * 6 + 6) / (20 + 15 + 6 + 1) / 6: all patterns of six are equally likely.
  EXPECT_NEAR(AP::internal::observed_fraction(156. / 42 / 6), 0.5, 1e-9);
}

TEST(Interior, of_a_soup_is_that_of_the_closed_mesh)
{
  for(const Soup& soup :
      {shapes::blob(3, 53), shapes::torus(1, 0.4, 30, 20), shapes::cone(20, 1, 2)}) {
    Soup loose;
    for(const shapes::Triangle& t : soup.triangles) {
      const std::uint32_t first = std::uint32_t(loose.points.size());
      for(const std::uint32_t v : t)
        loose.points.push_back(soup.points[v]);
      loose.triangles.push_back({first, first + 1, first + 2});
    }
    const auto closed = shapes::surface_of(soup), open = shapes::surface_of(loose);
    const AP::Grid_3 grid = AP::grid_around(closed.bbox(), 0.0831, 0.1);
    const AP::Interior expected = AP::interior(closed, grid), found = AP::interior(open, grid);
    EXPECT_EQ(found.volume, expected.volume);
    EXPECT_EQ(found.coverage, 1);
    for(std::size_t row = 0; row < grid.number_of_rows(); ++row) {
      EXPECT_EQ(found.region.hull(row).first, expected.region.hull(row).first);
      EXPECT_EQ(found.region.hull(row).last, expected.region.hull(row).last);
    }
  }
}

TEST(Interior, agrees_with_the_side_of_a_triangle_mesh)
{
  for(const Soup& soup : {shapes::bundled_mesh("hand.obj"), shapes::blob(4, 54)}) {
    const Mesh mesh = shapes::mesh_of<Mesh>(soup);
    const CGAL::Side_of_triangle_mesh<Mesh, Epick> side_of(mesh);
    const auto surface = shapes::surface_of(soup);
    const CGAL::Bbox_3 box = surface.bbox();
    const AP::Grid_3 grid = AP::grid_around(box, (box.xmax() - box.xmin()) / 57);
    const AP::Interior inside = AP::interior(surface, grid);
    shapes::Random random(55);
    int number_inside = 0;
    for(int n = 0; n < 3000; ++n) {
      std::array<int, 3> v;
      for(std::size_t axis = 0; axis < 3; ++axis)
        v[axis] = int(random(0, grid.size()[axis]));
      const Point_3 p = grid.point(v[0], v[1], v[2]);
      const bool is_inside = side_of(Epick::Point_3(p.x(), p.y(), p.z())) == CGAL::ON_BOUNDED_SIDE;
      ASSERT_EQ(inside.region.contains(v[0], v[1], v[2]), is_inside) << p;
      number_inside += is_inside;
    }
    EXPECT_GT(number_inside, 100);
  }
}

// Lines through edges and vertices, everywhere: the lattice points are those of the surface.
TEST(Interior, of_lattice_polyhedra_has_their_volume)
{
  shapes::Random random(58);
  for(int n = 0; n < 50; ++n) {
    Soup soup = shapes::box(Point_3(0, 0, 0), Point_3(1, 1, 1)); // sheared: a parallelepiped
    const auto integer = [&] { return std::floor(random(0, 5)); };
    const std::array<Vector_3, 3> edges{Vector_3(1 + integer(), integer(), integer()),
                                        Vector_3(0, 1 + integer(), integer()),
                                        Vector_3(0, 0, 1 + integer())};
    for(Point_3& p : soup.points)
      p = Point_3(0, 0, 0) + p.x() * edges[0] + p.y() * edges[1] + p.z() * edges[2];
    const auto surface = shapes::surface_of(soup);
    // The points that belong to a lattice cell of this kind are as many as its volume.
    const AP::Grid_3 grid(Point_3(-1, -1, -1), 1, {20, 20, 20});
    EXPECT_EQ(AP::interior(surface, grid).volume, edges[0].x() * edges[1].y() * edges[2].z());
  }
}

// Every edge is passed equally often both ways, or the surface is open, however often.
TEST(Interior, of_copies_of_one_triangle_is_empty)
{
  Soup soup;
  soup.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)};
  for(const std::size_t copies : {1u, 2u, 255u, 256u, 5000u}) {
    soup.triangles.assign(copies, {0, 1, 2});
    EXPECT_FALSE(AP::internal::is_closed(shapes::surface_of(soup))) << copies;
    soup.triangles.insert(soup.triangles.end(), copies, {0, 2, 1});
    EXPECT_TRUE(AP::internal::is_closed(shapes::surface_of(soup))) << copies;
    soup.triangles.push_back({1, 0, 2});
    EXPECT_FALSE(AP::internal::is_closed(shapes::surface_of(soup))) << copies;
    const AP::Grid_3 grid(Point_3(-1, -1, -1), 0.2, {11, 11, 11});
    EXPECT_EQ(AP::interior(shapes::surface_of(soup), grid).region.number_of_voxels(), 0u);
  }
}

#ifdef CGAL_LINKED_WITH_TBB

void expect_same(const AP::Row_spans& a, const AP::Row_spans& b)
{
  ASSERT_EQ(a.number_of_rows(), b.number_of_rows());
  for(std::size_t row = 0; row < a.number_of_rows(); ++row) {
    const auto [begin, end] = a.runs(row);
    const auto [other_begin, other_end] = b.runs(row);
    ASSERT_TRUE(
        std::equal(begin, end, other_begin, other_end, [](const auto& run, const auto& other) {
          return run.first == other.first && run.last == other.last;
        }));
  }
}

TEST(Regions, do_not_depend_on_the_number_of_threads)
{
  const Soup body = shapes::bundled_mesh("hand.obj");
  const Soup holed =
      shapes::without_faces(body, [](const Point_3& p) { return std::fmod(p.x(), 0.1) > 0.097; });
  for(const Soup& soup : {body, holed}) {
    const auto surface = shapes::surface_of(soup);
    const CGAL::Bbox_3 box = surface.bbox();
    const double voxel = (box.ymax() - box.ymin()) / 70;
    const AP::Grid_3 grid = AP::grid_around(box, voxel);
    const AP::Interior one = AP::interior(surface, grid);
    const AP::Interior many = AP::interior<CGAL::Parallel_tag>(surface, grid);
    expect_same(one.region, many.region);
    EXPECT_EQ(one.coverage, many.coverage);
    EXPECT_GT(one.region.number_of_voxels(), 1000u);
    expect_same(AP::band(surface, grid, 3 * voxel),
                AP::band<CGAL::Parallel_tag>(surface, grid, 3 * voxel));
  }
}

#endif

TEST(Interior, is_empty_where_nothing_is_enclosed)
{
  const auto sheet = shapes::surface_of(shapes::plane_patch(1, 0));
  const AP::Grid_3 grid(Point_3(-1, -1, -1), 0.21, {10, 10, 10});
  const AP::Interior inside = AP::interior(sheet, grid);
  EXPECT_EQ(inside.region.number_of_voxels(), 0u);
  EXPECT_EQ(inside.volume, 0);
  EXPECT_EQ(inside.coverage, 0);
  EXPECT_EQ(AP::interior(AP::Triangle_surface(), grid).region.number_of_voxels(), 0u);
}

// ---------------------------------------------------------------- band

double distance_to(const Soup& soup, const Point_3& p)
{
  double squared = std::numeric_limits<double>::infinity();
  for(const shapes::Triangle& t : soup.triangles)
    squared = std::min(squared, CGAL::squared_distance(
                                    p, AP::Kernel::Triangle_3(soup.points[t[0]], soup.points[t[1]],
                                                              soup.points[t[2]])));
  return std::sqrt(squared);
}

TEST(Band, holds_what_is_near_the_surface_and_nothing_else)
{
  for(const Soup& soup : {shapes::blob(1, 56), shapes::cylinder(12, 0.5, 2, true),
                          shapes::box(Point_3(-1, -0.6, -0.4), Point_3(1, 0.6, 0.4))}) {
    const auto surface = shapes::surface_of(soup);
    const double voxel = 0.1;
    const AP::Grid_3 grid = AP::grid_around(surface.bbox(), voxel, 0.45);
    const AP::Row_spans everything(grid);
    std::vector<double> distances(everything.storage_size());
    shapes::for_each_voxel(everything, [&](const Point_3& p, std::size_t place) {
      distances[place] = distance_to(soup, p);
    });
    for(const double largest : {0.1, 0.25, 0.4}) {
      const AP::Row_spans region = AP::band(surface, grid, largest);
      for(int k = 0; k < grid.size()[2]; ++k)
        for(int j = 0; j < grid.size()[1]; ++j)
          for(int i = 0; i < grid.size()[0]; ++i) {
            const double d = distances[everything.index(i, j, k)];
            if(std::abs(d - largest) > 1e-9) {
              ASSERT_EQ(region.contains(i, j, k), d < largest) << grid.point(i, j, k) << ": " << d;
            }
          }
    }
  }
}

TEST(Band, of_points_is_the_union_of_their_balls)
{
  AP::Surfels points;
  shapes::Random random(57);
  for(std::uint32_t i = 0; i < 50; ++i)
    points.push_back(random.point_in(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1)), Vector_3(0, 0, 1), 1., i);
  const AP::Grid_3 grid = AP::grid_around(points.bbox(), 0.1);
  for(const double distance : {0.03, 0.15, 0.4, 5.}) {
    const AP::Row_spans region = AP::band(points, grid, distance);
    for(int k = 0; k < grid.size()[2]; ++k)
      for(int j = 0; j < grid.size()[1]; ++j)
        for(int i = 0; i < grid.size()[0]; ++i) {
          double nearest = std::numeric_limits<double>::infinity();
          for(const Point_3& p : points.positions)
            nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(p, grid.point(i, j, k))));
          ASSERT_EQ(region.contains(i, j, k), nearest <= distance);
        }
  }
}

// Runs touch where neighbouring faces take over from each other: they are joined, so that a convex band
// has one in each row.
TEST(Band, has_no_more_runs_than_it_has_gaps)
{
  const auto surface = shapes::surface_of(shapes::plane_patch(6, 0));
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), 0.0313, 0.4);
  const AP::Row_spans region = AP::band(surface, grid, 0.3);
  std::size_t not_empty = 0;
  for(std::size_t row = 0; row < grid.number_of_rows(); ++row) {
    const auto [begin, end] = region.runs(row);
    ASSERT_LE(end - begin, 1);
    not_empty += begin != end;
  }
  EXPECT_GT(not_empty, 100u);
}

TEST(Band, names_the_argument_that_is_out_of_range)
{
  const AP::Grid_3 grid(Point_3(0, 0, 0), 1, {2, 2, 2});
  for(const double distance : {0., -1., double(INFINITY), double(NAN)})
    EXPECT_NE(shapes::complaint([&] {
                AP::band(shapes::surface_of(shapes::icosphere(0)), grid, distance);
              }).find("must be positive and finite"),
              std::string::npos);
  EXPECT_EQ(
      shapes::complaint([&] { AP::band(shapes::surface_of(shapes::icosphere(0)), grid, -1); }),
      "distance is -1: must be positive and finite");
}

} // namespace
