// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The surface as seen at a radius: what smoothing does to spheres, planes, plates and bumps follows from
// the equation of heat, and from where area is.

#include "shapes.h"

#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scale_space/Mean_curvature_flow.h>
#include <CGAL/Area_projection_transform/scale_space/Smoothing_scale_space.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

namespace {

namespace AP = CGAL::Area_projection;
using AP::Averaged_normals;
using AP::Mean_curvature_flow;
using AP::Point_3;
using AP::Side;
using AP::Smoothing_scale_space;
using AP::Surfels;
using AP::Triangle_surface;
using AP::Vector_3;
using AP::internal::Heat_flow;
using shapes::fibonacci_sphere;
using shapes::pi;
using shapes::Soup;
using shapes::surface_of;

/// how long the normals of a unit sphere are after some time.
template <class Source>
double length_of_normals(const Source& sphere, double time)
{
  const Heat_flow flow = AP::internal::flow_between_elements(sphere);
  Heat_flow::Vectors normals(Eigen::Index(sphere.size()), 3);
  for(std::size_t i = 0; i < sphere.size(); ++i)
    AP::internal::set_row(normals, i, sphere.normals[i]);
  const Heat_flow::Vectors result = flow.diffused(normals, time, 1e-5);
  return std::sqrt(result.rowwise().squaredNorm().mean());
}

// The normals of a unit sphere are eigenfunctions of its Laplacian, of the eigenvalue 2: an implicit step
// of the time t divides them by 1 + 2 t.
TEST(Averaged_normals, spread_as_far_as_time_tells)
{
  for(const double time : {0.02, 0.1, 0.5})
    EXPECT_NEAR(length_of_normals(surface_of(shapes::icosphere(4)), time), 1 / (1 + 2 * time),
                0.01 / (1 + 2 * time));
}

// The constant, which is what is left in the end, is found as exactly as the rest.
TEST(Averaged_normals, know_the_mean_of_a_component_much_smaller_than_the_radius)
{
  const Triangle_surface patch = surface_of(shapes::icosphere(5));
  const Heat_flow flow = AP::internal::flow_between_elements(patch);
  Heat_flow::Vectors values(Eigen::Index(patch.size()), 3);
  for(std::size_t i = 0; i < patch.size(); ++i)
    AP::internal::set_row(values, i, patch.normals[i] + Vector_3(0.1, 0.2, 0.3));
  const double largest_error = 2e-3;
  const Heat_flow::Vectors result = flow.diffused(values, 1e3, largest_error);
  const Eigen::RowVector3d mean(0.1, 0.2, 0.3);
  // What is left of the normals is 1 / (1 + 2 · 1000).
  EXPECT_LT(std::sqrt((result.rowwise() - mean).rowwise().squaredNorm().mean()),
            std::sqrt(3.) * largest_error + 1. / 2001);
}

TEST(Averaged_normals, spread_as_far_where_half_of_the_faces_are_missing)
{
  Soup sphere = shapes::icosphere(5);
  shapes::Random(1).shuffle(sphere.triangles);
  sphere.triangles.resize(sphere.triangles.size() / 2);
  // Links at the rims stand for single faces; where several are missing they are too strong or too
  // weak. Nothing but that gap of the model makes the tolerance: a fifth of the decay.
  const double decay = 1 - 1 / (1 + 2 * 0.1);
  EXPECT_NEAR(length_of_normals(surface_of(sphere), 0.1), 1 - decay, 0.2 * decay);
}

TEST(Averaged_normals, spread_as_far_between_points)
{
  EXPECT_NEAR(length_of_normals(fibonacci_sphere(5000), 0.1), 1 / 1.2, 0.01);
}

TEST(Averaged_normals, leave_a_sphere_as_it_is)
{
  const Triangle_surface sphere = surface_of(shapes::icosphere(4));
  const Triangle_surface seen = Averaged_normals(sphere)(1);
  for(std::size_t t = 0; t < sphere.size(); ++t)
    EXPECT_GT(seen.normals[t] * sphere.normals[t], std::cos(0.02))
        << t; // least at the 12 irregular vertices
  EXPECT_NEAR(seen.total_area(), sphere.total_area(), 1e-4 * sphere.total_area());
  EXPECT_EQ(seen.sources, sphere.sources);
}

/// a box of `side` by `side` by `thickness`, in squares of about a tenth of the side.
Soup plate(double side, double thickness)
{
  const Soup faces =
      shapes::joined(shapes::plane_patch(side, 0.5 * thickness, 10),
                     shapes::flipped(shapes::plane_patch(side, -0.5 * thickness, 10)));
  Soup rim;
  for(int k = 0; k < 4; ++k) {
    const shapes::Rotation turn{Vector_3(0, 0, 1), 0.5 * pi * k};
    const Soup strip = shapes::lattice_patch(10, 1, [&](int i, int j) {
      return turn(Point_3(0.5 * side, side * (i / 10. - 0.5), thickness * (j - 0.5)));
    });
    rim = shapes::joined(rim, strip);
  }
  return shapes::welded(shapes::joined(faces, rim));
}

TEST(Averaged_normals, keep_the_sides_of_a_thin_plate_apart)
{
  const Triangle_surface thin = surface_of(plate(1, 1e-3));
  const Triangle_surface seen = Averaged_normals(thin)(0.4); // averages over 0.1
  for(std::size_t t = 0; t < thin.size(); ++t) {
    const Point_3 p = CGAL::centroid(thin.corner(t, 0), thin.corner(t, 1), thin.corner(t, 2));
    if(std::abs(p.x()) < 0.2 && std::abs(p.y()) < 0.2) {
      // The rim is three deviations away.
      EXPECT_GT(seen.normals[t] * thin.normals[t], 0.9999) << p;
    }
  }
}

/// the same triangles, each with three points of its own.
Soup unwelded(const Soup& mesh)
{
  Soup soup;
  for(const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t first = std::uint32_t(soup.points.size());
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.points.insert(soup.points.end(), {mesh.points[a], mesh.points[b], mesh.points[c]});
  }
  return soup;
}

TEST(Averaged_normals, keep_surfaces_that_touch_apart_and_join_soups)
{
  // Two sheets that share the positions of their inner points, but name points of their own.
  const Soup lower = shapes::plane_patch(2, 0, 8);
  const Soup upper = shapes::moved(shapes::plane_patch(2, 0, 8), [](const Point_3& p) {
    return std::abs(p.x()) < 0.9 && std::abs(p.y()) < 0.9 ? p : p + Vector_3(0, 0, 1);
  });
  const Triangle_surface both = surface_of(shapes::joined(lower, upper));
  const Triangle_surface seen = Averaged_normals(both)(2);
  for(std::size_t t = 0; t < lower.triangles.size(); ++t)
    EXPECT_NEAR(seen.normals[t].z(), 1, 1e-9) << t;

  const Soup mesh = shapes::blob(3, 5);
  const Triangle_surface of_mesh = Averaged_normals(surface_of(mesh))(0.5);
  const Triangle_surface of_soup = Averaged_normals(surface_of(unwelded(mesh)))(0.5);
  for(std::size_t t = 0; t < of_mesh.size(); ++t)
    EXPECT_LT((of_mesh.normals[t] - of_soup.normals[t]).squared_length(), 1e-12);
}

TEST(Averaged_normals, take_the_normals_of_the_user)
{
  Triangle_surface patch = surface_of(shapes::plane_patch(1, 0, 6));
  const Vector_3 tilted(0.6, 0, 0.8);
  std::fill(patch.normals.begin(), patch.normals.end(), tilted);
  EXPECT_LT((Averaged_normals(patch)(1).normals[7] - tilted).squared_length(), 1e-12);

  patch.vertex_normals.assign(patch.points.size(), Vector_3(0, 0.6, 0.8));
  const Triangle_surface seen = Averaged_normals(patch)(1);
  EXPECT_FALSE(seen.has_interpolated_normals());
  EXPECT_LT((seen.normals[7] - Vector_3(0, 0.6, 0.8)).squared_length(), 1e-12);
}

TEST(Averaged_normals, do_not_depend_on_the_order_of_points)
{
  shapes::Random random(8);
  Surfels points = fibonacci_sphere(1000), reversed;
  for(Vector_3& n : points.normals)
    n = AP::internal::normalized(n + 0.5 * random.direction());
  const std::size_t number = points.size();
  for(std::size_t i = number; i-- > 0;)
    reversed.push_back(points.positions[i], points.normals[i], points.areas[i], std::uint32_t(i));
  const Surfels seen = Averaged_normals(points)(1), seen_reversed = Averaged_normals(reversed)(1);
  for(std::size_t i = 0; i < number; ++i)
    EXPECT_EQ(seen.normals[i], seen_reversed.normals[number - 1 - i]);
}

TEST(Averaged_normals, average_over_copies_of_points)
{
  const Surfels sphere = fibonacci_sphere(2000);
  shapes::Random random(4);
  Surfels copies;
  for(int copy = 0; copy < 20; ++copy)
    for(std::size_t i = 0; i < sphere.size(); ++i)
      copies.push_back(sphere.positions[i],
                       AP::internal::normalized(sphere.normals[i] + 0.3 * random.direction()),
                       sphere.areas[i] / 20, std::uint32_t(copies.size()));
  // As far as the points alone, although the nearest neighbours of each are its own copies.
  Surfels radial = copies;
  for(std::size_t i = 0; i < radial.size(); ++i)
    radial.normals[i] = radial.positions[i] - CGAL::ORIGIN;
  EXPECT_NEAR(length_of_normals(radial, 0.1), 1 / 1.2, 0.01);
  const Surfels seen = Averaged_normals(copies)(1);
  for(std::size_t i = 0; i < seen.size(); ++i)
    EXPECT_GT(seen.normals[i] * radial.normals[i], std::cos(0.05)) << i;

  // A tree of equal points would take a minute.
  const Vector_3 up(0, 0, 1);
  Surfels heap;
  for(std::size_t i = 0; i < 100000; ++i)
    heap.push_back(Point_3(1, 2, 3), up, 1, std::uint32_t(i));
  EXPECT_EQ(Averaged_normals(heap)(1).normals.back(), up);
  EXPECT_TRUE(Averaged_normals(Surfels())(1).empty());
}

TEST(Averaged_normals, calm_the_noisy_normals_of_points)
{
  shapes::Random random(3);
  Surfels sphere = fibonacci_sphere(4000);
  const std::vector<Vector_3> radial = sphere.normals;
  for(Vector_3& n : sphere.normals)
    n = AP::internal::normalized(n + 0.5 * random.direction());
  const Surfels seen = Averaged_normals(sphere)(1);
  double before = 0, after = 0;
  for(std::size_t i = 0; i < seen.size(); ++i) {
    before += (sphere.normals[i] - radial[i]).squared_length();
    after += (seen.normals[i] - radial[i]).squared_length();
  }
  // The average is over the area 8 pi t of an implicit step and its double (the sum of the squares of its
  // weights is 1 / (4 pi t)): about 125 points with t = 1/32, which leave a hundredth of the variance.
  EXPECT_LT(after, 0.03 * before);
}

// ---------------------------------------------------------------- mean curvature flow

// The positions of a unit sphere are eigenfunctions, too: a step leaves 1 / (1 + a), a = 2 t, and with what
// was removed smoothed and added, 1 - (a / (1 + a))^2.
TEST(Mean_curvature_flow, shrinks_a_sphere_by_the_square_of_a_step)
{
  const Triangle_surface sphere = surface_of(shapes::icosphere(4));
  for(const double ratio : {0.2, 0.5}) {
    const Triangle_surface seen = Mean_curvature_flow(sphere, ratio)(1);
    const double a = ratio * ratio, radius = 1 - std::pow(a / (1 + a), 2);
    for(const Point_3& p : seen.points)
      EXPECT_NEAR(std::sqrt((p - CGAL::ORIGIN).squared_length()), radius, 0.003);
    EXPECT_NEAR(seen.total_area() / sphere.total_area(), radius * radius, 0.006);
  }
}

TEST(Mean_curvature_flow, leaves_rims_where_they_are)
{
  const Soup flat = shapes::plane_patch(1, 0.3, 8);
  const Triangle_surface patch = surface_of(flat);
  const Triangle_surface seen = Mean_curvature_flow(patch)(1);
  for(std::size_t i = 0; i < patch.points.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(seen.points[i], patch.points[i]), 1e-20);

  const Soup with_hole =
      shapes::without_faces(shapes::icosphere(4), [](const Point_3& p) { return p.z() > 0.8; });
  const Triangle_surface open = surface_of(with_hole);
  const Triangle_surface smooth = Mean_curvature_flow(open)(1);
  double highest_before = -1, highest_after = -1;
  for(const auto& triangle : open.triangles)
    for(std::uint32_t i : triangle) {
      highest_before = std::max(highest_before, open.points[i].z());
      highest_after = std::max(highest_after, smooth.points[i].z());
    }
  EXPECT_NEAR(highest_after, highest_before, 0.1);
}

TEST(Mean_curvature_flow, gives_no_area_to_a_wire_that_is_gone)
{
  const Triangle_surface wire = surface_of(shapes::cylinder(300, 1, 100, false, 30));
  const Triangle_surface seen = Mean_curvature_flow(wire)(100);
  for(std::size_t t = 0; t < wire.size(); ++t)
    EXPECT_LE(seen.areas[t], wire.areas[t]);
}

TEST(Mean_curvature_flow, keeps_the_ratio_between_the_areas_of_the_user_and_those_of_the_shape)
{
  Triangle_surface sphere = surface_of(shapes::icosphere(3));
  const Triangle_surface plain = Mean_curvature_flow(sphere)(1);
  for(double& area : sphere.areas)
    area *= 3;
  const Triangle_surface tripled = Mean_curvature_flow(sphere)(1);
  for(std::size_t t = 0; t < plain.size(); ++t)
    EXPECT_NEAR(tripled.areas[t], 3 * plain.areas[t], 1e-12);
}

TEST(Mean_curvature_flow, moves_the_triangles_of_a_soup_together)
{
  const Soup mesh = shapes::blob(4, 5);
  const Triangle_surface of_mesh = Mean_curvature_flow(surface_of(mesh))(0.5);
  const Triangle_surface of_soup = Mean_curvature_flow(surface_of(unwelded(mesh)))(0.5);
  // The cells are in another order, in which the solver errs by up to a thousandth of the deviation.
  for(std::size_t t = 0; t < of_mesh.size(); ++t)
    for(int i = 0; i < 3; ++i)
      EXPECT_LT(CGAL::squared_distance(of_mesh.corner(t, i), of_soup.corner(t, i)), 1e-6);
  EXPECT_NEAR(of_soup.total_area(), of_mesh.total_area(), 1e-3 * of_mesh.total_area());
}

// ---------------------------------------------------------------- both

/// a unit sphere with bumps and as many dents, half of an ellipsoid each, much smaller than its radius.
Soup bumpy_sphere()
{
  constexpr int bumps = 300;
  constexpr double height = 0.08, radius = 0.09;
  const Surfels centres = fibonacci_sphere(bumps);
  return shapes::moved(shapes::icosphere(5), [&](const Point_3& p) {
    double offset = 0;
    for(std::size_t i = 0; i < bumps; ++i) {
      const double squared = CGAL::squared_distance(p, centres.positions[i]) / (radius * radius);
      if(squared < 1)
        offset = (i % 2 == 0 ? height : -height) * std::sqrt(1 - squared);
    }
    return CGAL::ORIGIN + (1 + offset) * (p - CGAL::ORIGIN);
  });
}

template <class Scale_space>
double value_at_centre(const Scale_space& surface)
{
  return AP::Exact_evaluator(surface, 1, Side::INSIDE)(Point_3(0, 0, 0), 0.5) / (4 * pi);
}

// Figure 4 of the paper. All of a smooth sphere lands at its centre; the sides of bumps land elsewhere.
TEST(Smoothing_scale_space, sees_a_bumpy_sphere_as_a_sphere)
{
  const Triangle_surface bumpy = surface_of(bumpy_sphere());
  EXPECT_LT(value_at_centre(AP::Constant_scale_space(bumpy)), 0.7);
  EXPECT_NEAR(value_at_centre(Smoothing_scale_space(Averaged_normals(bumpy))), 1, 0.1);
  EXPECT_NEAR(value_at_centre(Smoothing_scale_space(Mean_curvature_flow(bumpy))), 1, 0.1);
}

template <class Smoother>
void expect_equivariant(const Triangle_surface& surface)
{
  const shapes::Rotation turn{Vector_3(2. / 3, 1. / 3, 2. / 3), 0.7};
  const double factor = 1e4;
  Soup moved{surface.points, surface.triangles};
  moved = shapes::translated(shapes::scaled(shapes::moved(moved, turn), factor),
                             factor * Vector_3(100, -200, 50));
  const Triangle_surface here = Smoother(surface)(0.4);
  const Triangle_surface there = Smoother(surface_of(moved))(0.4 * factor);
  for(std::size_t t = 0; t < here.size(); ++t) {
    const Vector_3 expected = turn(CGAL::ORIGIN + here.normals[t]) - CGAL::ORIGIN;
    // Coordinates two hundred times the shape leave 13 digits, and the solver three.
    EXPECT_LT((there.normals[t] - expected).squared_length(), 1e-5);
    EXPECT_NEAR(there.areas[t], factor * factor * here.areas[t],
                0.01 * factor * factor * here.areas[t]);
  }
}

TEST(Smoothing_scale_space, follows_similarities)
{
  const Triangle_surface blob = surface_of(shapes::blob(3, 11));
  expect_equivariant<Averaged_normals<>>(blob);
  expect_equivariant<Mean_curvature_flow>(blob);
}

TEST(Smoothing_scale_space, bears_needles_flaps_and_lone_triangles)
{
  // A cylinder of strips a thousand times as long as wide, three faces at an edge, and a triangle far away.
  Soup soup = shapes::cylinder(200, 0.03, 1, false, 1);
  soup.points.insert(soup.points.end(),
                     {Point_3(0.1, 0, 0), Point_3(9, 9, 9), Point_3(9, 8, 9), Point_3(8, 9, 9)});
  const std::uint32_t last = std::uint32_t(soup.points.size()) - 1;
  soup.triangles.push_back({soup.triangles[0][0], soup.triangles[0][1], last - 3});
  soup.triangles.push_back({last - 2, last - 1, last});
  Triangle_surface surface = surface_of(soup);
  // Two triangles that have no extent, but an area from the user.
  for(const std::size_t t : {surface.size() - 1, std::size_t(7)})
    surface.triangles[t][1] = surface.triangles[t][2] = surface.triangles[t][0];
  const auto expect_sound = [&](const Triangle_surface& seen) {
    ASSERT_EQ(seen.size(), surface.size());
    for(std::size_t t = 0; t < seen.size(); ++t) {
      EXPECT_NEAR(seen.normals[t].squared_length(), 1, 1e-9);
      EXPECT_TRUE(seen.areas[t] >= 0 && std::isfinite(seen.areas[t])) << t;
    }
  };
  for(const double radius : {1e-4, 0.03, 1., 100., 1e20}) {
    expect_sound(Averaged_normals(surface)(radius));
    expect_sound(Mean_curvature_flow(surface)(radius));
  }
}

TEST(Smoothing_scale_space, rejects_what_is_out_of_range)
{
  const Triangle_surface sphere = surface_of(shapes::icosphere(1));
  EXPECT_EQ(shapes::complaint([&] { Averaged_normals(sphere, 0); }),
            "averaging_ratio is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { Mean_curvature_flow(sphere, -1); }),
            "smoothing_ratio is -1: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { Smoothing_scale_space(Averaged_normals(sphere)).area(0); }),
            "radius is 0: must be positive and finite");
  EXPECT_EQ(Smoothing_scale_space(Averaged_normals(Triangle_surface())).area(1), 0);
  const Soup needle{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}; // no face of it is left
  EXPECT_EQ(Smoothing_scale_space(Averaged_normals(surface_of(needle))).area(1), 0);
  EXPECT_EQ(Smoothing_scale_space(Mean_curvature_flow(surface_of(needle))).area(1), 0);
}

} // namespace
