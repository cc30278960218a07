// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The salient points of the paper, against maps of spheres and cylinders in closed form, and against the
// maxima of all maps.

#include "scale_maps.h"

#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/salient_points/paper_salient_points.h>
#include <CGAL/Area_projection_transform/sinks.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace {

using namespace scale_maps;
using AP::Paper_salient_options;
using AP::Salient_point;
using AP::Side;
using AP::Vector_3;
using shapes::Soup;

constexpr double pi = shapes::pi;

// ---------------------------------------------------------------- maps in closed form

/// \brief the map of a sphere of radius 1 at the distance `e` from its centre.
///
/// Its parallel surface is a sphere of radius `d = 1 - R`; the ball cuts a cap out of it, which has the area
/// of as much of the height.
double map_of_sphere(double e, const AP::Scale& scale)
{
  const double d = std::abs(1 - scale.radius);
  double fraction = d <= scale.sigma;
  if(e > 0 && d > 0) {
    const double cosine = (d * d + e * e - scale.sigma * scale.sigma) / (2 * d * e);
    fraction = std::clamp(0.5 * (1 - cosine), 0., 1.);
  } else if(d == 0)
    fraction = e <= scale.sigma;
  return fraction / (scale.radius * scale.radius);
}

/// \brief the map of an endless cylinder of radius 1 at the distance `e` from its axis.
///
/// Of each line of the parallel surface the ball cuts out a piece.
double map_of_cylinder(double e, const AP::Scale& scale)
{
  const double d = 1 - scale.radius;
  const int steps = 2000;
  double area = 0;
  for(int step = 0; step < steps; ++step) {
    const double phi = 2 * pi * (step + 0.5) / steps;
    const double rest = scale.sigma * scale.sigma - d * d - e * e + 2 * d * e * std::cos(phi);
    area += 2 * std::sqrt(std::max(rest, 0.)) * 2 * pi / steps;
  }
  return area * scale.normalization();
}

/// the smoothed value of the map of the unit sphere in its centre, which lies `offset` from a voxel.
double smoothed_map_of_sphere(const Vector_3& offset, double voxel_size, const AP::Scale& scale)
{
  const std::vector<float> weights = AP::Gaussian_smoother().weights();
  const auto weight = [&](int d) { return double(weights[std::size_t(std::abs(d))]); };
  double sum = 0;
  for(int k = -3; k <= 3; ++k)
    for(int j = -3; j <= 3; ++j)
      for(int i = -3; i <= 3; ++i) {
        const Vector_3 x = offset + voxel_size * Vector_3(i, j, k);
        sum +=
            weight(i) * weight(j) * weight(k) * map_of_sphere(std::sqrt(x.squared_length()), scale);
      }
  return sum;
}

Paper_salient_options options_of(double reference_length)
{
  Paper_salient_options options;
  options.reference_length = reference_length;
  return options;
}

bool is_unknown(double value)
{
  return std::isnan(value);
}

/// what the mode of the paper says of every point, and what it leaves open.
void expect_paper_point(const Salient_point& p)
{
  EXPECT_EQ(p.shape, AP::Salient_shape::OTHER);
  EXPECT_EQ(p.radius, p.scale);
  EXPECT_EQ(p.sphericity, p.inertia.blobness);
  EXPECT_TRUE(is_unknown(p.radius_low) && is_unknown(p.radius_high) && is_unknown(p.residual) &&
              is_unknown(p.observed_fraction) && is_unknown(p.length));
  EXPECT_TRUE(p.voters.empty());
}

TEST(Paper_salient_points, of_a_sphere_are_its_centre_at_the_scale_of_the_smoothed_closed_form)
{
  const Vector_3 centre(3, -2, 1);
  const AP::Triangle_surface sphere =
      shapes::surface_of(shapes::translated(shapes::icosphere(5), centre));
  for(const double s : {2 / 39.5, 2 / 30.5}) {
    const std::vector<Salient_point> points = AP::paper_salient_points(sphere, options_of(s));
    ASSERT_EQ(points.size(), 1u);
    const Salient_point& p = points[0];
    expect_paper_point(p);
    const Vector_3 offset = p.position - (CGAL::ORIGIN + centre);
    for(int axis = 0; axis < 3; ++axis)
      EXPECT_LE(std::abs(offset[axis]), 0.5001 * s);

    double largest = 0;
    for(double R = s; R <= 1; R += s)
      largest = std::max(largest, smoothed_map_of_sphere(offset, s, {R, 0.5 * R}));
    // The projector and the faces that lie inside of the sphere make errors of half a percent.
    EXPECT_NEAR(p.intensity, largest, 0.02 * largest);
    EXPECT_NEAR(smoothed_map_of_sphere(offset, s, {p.scale, 0.5 * p.scale}), largest,
                0.02 * largest);
    // Before it is smoothed the map is largest at 2/3, where its peak is narrow. Four voxels are more than
    // the Gaussian reaches in any direction but the diagonals, and the peak is as wide at (1 + 4s)/1.5.
    EXPECT_GE(p.scale, 2 / 3.);
    EXPECT_LE(p.scale, (1 + 4 * s) / 1.5 + s);
    EXPECT_NEAR(p.sphericity, 1, 0.01);
  }
}

TEST(Paper_salient_points, without_smoothing_have_the_first_radius_at_which_a_sphere_is_in_the_ball)
{
  // 40 intervals across, so that the centre is on the lattice; 13 s < 2/3 < 14 s.
  const double s = 2 / 39.5;
  Paper_salient_options options = options_of(s);
  options.smoothing = 0;
  const std::vector<Salient_point> points =
      AP::paper_salient_points(shapes::surface_of(shapes::icosphere(5)), options);
  ASSERT_FALSE(points.empty());
  EXPECT_NEAR(points[0].scale, 14 * s, 1e-9);
  EXPECT_NEAR(points[0].intensity, 1 / (14 * s) / (14 * s), 0.01);
  EXPECT_LE(std::sqrt(CGAL::squared_distance(points[0].position, Point_3(0, 0, 0))), 1.0001 * s);
}

/// the points of a cylinder of radius 1 about the z axis that see nothing of its ends.
std::vector<Salient_point> points_of_cylinder(double s, double length, bool use_joint_map)
{
  Paper_salient_options options = options_of(s);
  options.use_joint_map = use_joint_map;
  std::vector<Salient_point> points = AP::paper_salient_points(
      shapes::surface_of(shapes::cylinder(128, 1, length, true, 40)), options);
  EXPECT_FALSE(points.empty());
  const auto is_near_end = [length](const Salient_point& p) {
    return std::abs(p.position.z()) >
           0.5 * length - 2.6; // two and a half radii, at most one, and a bit
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_near_end), points.end());
  return points;
}

/// the inertia of the smoothed map of an endless cylinder, on a lattice that has its axis.
AP::Inertia_descriptors inertia_of_cylinder(double s, const AP::Scale& scale)
{
  const double radius = AP::inertia_radius(scale.sigma / s);
  const int centre = int(radius) + 5, n = 2 * centre + 1;
  const auto region = whole_region(n);
  std::map<int, double> values;
  const std::vector<float> map = map_of(*region, [&](const Voxel& v) {
    const int square = (v[0] - centre) * (v[0] - centre) + (v[1] - centre) * (v[1] - centre);
    const auto [place, is_new] = values.emplace(square, 0.);
    if(is_new)
      place->second = map_of_cylinder(s * std::sqrt(double(square)), scale);
    return place->second;
  });
  std::vector<float> smoothed;
  AP::Gaussian_smoother().smooth(*region, map, smoothed);
  return inertia_of(*region, smoothed, radius);
}

TEST(Paper_salient_points, of_a_cylinder_are_on_its_axis_and_long)
{
  const double s = 2 / 37.5; // 38 intervals across: the axis is on the lattice
  const std::vector<Salient_point> points = points_of_cylinder(s, 8, false);
  ASSERT_FALSE(points.empty());
  for(const Salient_point& p : points) {
    expect_paper_point(p);
    EXPECT_LE(std::abs(p.position.x()), 0.01 * s);
    EXPECT_LE(std::abs(p.position.y()), 0.01 * s);
    // Of the closed form, (3 + √3)/4 is the best ratio, and the map is flat there.
    EXPECT_NEAR(p.scale, 4 / (3 + std::sqrt(3.)), 2 * s);
    EXPECT_NEAR(p.intensity, map_of_cylinder(0, {p.scale, 0.5 * p.scale}), 0.05 * p.intensity);
    const AP::Inertia_descriptors expected = inertia_of_cylinder(s, {p.scale, 0.5 * p.scale});
    EXPECT_NEAR(p.inertia.blobness, expected.blobness, 0.02);
    EXPECT_NEAR(p.inertia.vesselness, expected.vesselness, 0.02);
    EXPECT_LT(p.sphericity, 0.6);
    EXPECT_LT(p.inertia.flatness, 0.02);
  }
}

// ---------------------------------------------------------------- options

Soup two_spheres_and_a_cylinder()
{
  const Soup spheres =
      shapes::joined(shapes::icosphere(4), shapes::icosphere(3, Point_3(1.9, 0.3, 0.2), 0.5));
  return shapes::joined(
      spheres, shapes::translated(shapes::cylinder(48, 0.4, 2, true), Vector_3(0.3, -1.7, 0)));
}

void expect_same(const std::vector<Salient_point>& a, const std::vector<Salient_point>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].position, b[i].position);
    EXPECT_EQ(a[i].scale, b[i].scale);
    EXPECT_EQ(a[i].intensity, b[i].intensity);
    EXPECT_EQ(a[i].inertia.blobness, b[i].inertia.blobness);
    EXPECT_EQ(a[i].inertia.flatness, b[i].inertia.flatness);
  }
}

TEST(Paper_salient_points, are_the_maxima_of_all_maps_by_definition)
{
  const AP::Constant_scale_space space(shapes::surface_of(two_spheres_and_a_cylinder()));
  const double s = 0.08;
  const Row_spans region = AP::interior(space.source(), AP::grid_around(space.bbox(), s)).region;
  const double half_side =
      0.5 * std::min({space.bbox().x_span(), space.bbox().y_span(), space.bbox().z_span()});
  const std::vector<AP::Scale> scales =
      AP::proportional_scales(AP::uniform_radii(s, s, std::size_t(half_side / s)));
  AP::Scale_maps_sink sink(region, scales.size());
  AP::project_scales(
      space, region, scales, Side::INSIDE,
      [](const Row_spans& part) { return AP::Grid_projector(part); }, sink);
  Maps smoothed(scales.size());
  for(std::size_t k = 0; k < scales.size(); ++k)
    AP::Gaussian_smoother().smooth(region, sink.maps()[k], smoothed[k]);

  std::vector<Maximum> found;
  for(const Salient_point& p : AP::paper_salient_points(space, options_of(s))) {
    const Vector_3 v = region.grid().lattice_coordinates(p.position);
    const std::size_t place =
        region.index(int(std::lround(v.x())), int(std::lround(v.y())), int(std::lround(v.z())));
    found.emplace_back(std::size_t(std::lround(p.scale / s)) - 1, place, float(p.intensity));
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, maxima_by_definition(region, smoothed, 0.2));
  EXPECT_GE(found.size(), 3u);
}

TEST(Paper_salient_points, have_the_same_bits_with_any_number_of_threads)
{
  const AP::Triangle_surface surface = shapes::surface_of(two_spheres_and_a_cylinder());
  Paper_salient_options options = options_of(0.08);
  for(const bool use_joint_map : {false, true}) {
    options.use_joint_map = use_joint_map;
    const auto expected = AP::paper_salient_points(surface, options);
    ASSERT_FALSE(expected.empty());
    for(const int threads : {1, 2, 5})
      with_threads(threads, [&] {
        expect_same(AP::paper_salient_points<CGAL::Parallel_if_available_tag>(surface, options),
                    expected);
      });
  }
}

TEST(Paper_salient_points, are_sorted_and_none_is_below_the_threshold)
{
  const AP::Triangle_surface surface = shapes::surface_of(two_spheres_and_a_cylinder());
  for(const bool use_joint_map : {false, true}) {
    Paper_salient_options options = options_of(0.08);
    options.use_joint_map = use_joint_map;
    options.threshold = 0.05;
    const std::vector<Salient_point> all = AP::paper_salient_points(surface, options);
    for(std::size_t i = 1; i < all.size(); ++i)
      EXPECT_GE(all[i - 1].intensity, all[i].intensity);
    // A higher threshold takes away the weaker ones, and changes nothing else.
    for(const double threshold : {1.0001 * all.back().intensity, 0.9999 * all[0].intensity}) {
      options.threshold = threshold;
      std::vector<Salient_point> expected = all;
      while(!expected.empty() && expected.back().intensity < threshold)
        expected.pop_back();
      ASSERT_LT(expected.size(), all.size());
      expect_same(AP::paper_salient_points(surface, options), expected);
    }
  }
}

TEST(Paper_salient_points, of_the_joint_map_are_its_maxima)
{
  const double s = 2 / 37.5;
  Paper_salient_options options = options_of(s);
  options.use_joint_map = true;
  const std::vector<Salient_point> points =
      AP::paper_salient_points(shapes::surface_of(shapes::icosphere(5)), options);
  ASSERT_EQ(points.size(), 1u);
  expect_paper_point(points[0]);
  EXPECT_LE(std::sqrt(CGAL::squared_distance(points[0].position, Point_3(0, 0, 0))), 0.01 * s);
  // Not smoothed at the single scales: the first radius of at least 2/3.
  EXPECT_NEAR(points[0].scale, s * std::ceil(2 / 3. / s), 1e-9);
  for(const Salient_point& p : points_of_cylinder(s, 8, true)) {
    EXPECT_LE(std::abs(p.position.x()), 0.01 * s);
    EXPECT_LE(std::abs(p.position.y()), 0.01 * s);
    EXPECT_NEAR(p.scale, 4 / (3 + std::sqrt(3.)), 2 * s);
  }
}

TEST(Paper_salient_points, have_the_radii_of_the_paper)
{
  // A = 2.4 makes s = √2.4/(80π) = 0.00616, of which eight fit into half of the height.
  const AP::Triangle_surface plate =
      shapes::surface_of(shapes::box(Point_3(0, 0, 0), Point_3(1, 1, 0.1)));
  const double s = std::sqrt(2.4) / (80 * pi);
  EXPECT_NEAR(AP::paper_reference_length(plate.total_area()), s, 1e-12);
  struct Visitor : AP::Multiscale_default_visitor
  {
    std::vector<std::size_t> indices;
    std::vector<double> radii;
    void scale_begins(std::size_t index, const AP::Scale& scale)
    {
      EXPECT_EQ(scale.sigma, 0.5 * scale.radius);
      indices.push_back(index);
      radii.push_back(scale.radius);
    }
  } visitor;
  AP::paper_salient_points(plate, {}, CGAL::parameters::visitor(std::ref(visitor)));
  ASSERT_EQ(visitor.radii.size(), 8u);
  for(std::size_t k = 0; k < visitor.radii.size(); ++k) {
    EXPECT_EQ(visitor.indices[k], k);
    EXPECT_NEAR(visitor.radii[k], double(k + 1) * s, 1e-12);
  }
}

TEST(Paper_salient_points, tell_progress_and_stop)
{
  const AP::Triangle_surface surface = shapes::surface_of(shapes::icosphere(3));
  double last = 0;
  bool stops = false;
  const std::function<bool(double)> callback = [&](double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return !stops || fraction < 0.3;
  };
  const auto np = CGAL::parameters::callback(callback);
  EXPECT_EQ(AP::paper_salient_points(surface, options_of(0.1), np).size(), 1u);
  EXPECT_NEAR(last, 1, 1e-12);
  last = 0;
  stops = true;
  EXPECT_TRUE(AP::paper_salient_points(surface, options_of(0.1), np).empty());
  EXPECT_LT(last, 0.5);
}

TEST(Paper_salient_points, are_found_outside_and_of_points)
{
  const double s = 0.1;
  Paper_salient_options options = options_of(s);
  options.side = Side::OUTSIDE;
  const Soup cavity = shapes::flipped(shapes::icosphere(4));
  const AP::Triangle_surface ball = shapes::surface_of(shapes::icosphere(4));
  const auto outside = AP::paper_salient_points(shapes::surface_of(cavity), options);
  const auto of_points = AP::paper_salient_points(AP::sample_surfels(ball, 0.04), options_of(s));
  for(const auto* points : {&outside, &of_points}) {
    ASSERT_FALSE(points->empty());
    const Point_3& p = (*points)[0].position;
    for(int axis = 0; axis < 3; ++axis)
      EXPECT_LE(std::abs(p[axis]), 0.5001 * s);
    EXPECT_NEAR((*points)[0].scale, 2 / 3. * (1 + 2 * s), 2 * s);
  }
}

TEST(Paper_salient_points, complain_about_what_they_cannot_do)
{
  const AP::Triangle_surface surface = shapes::surface_of(shapes::icosphere(2));
  const auto complaint = [&](auto change) {
    Paper_salient_options options = options_of(0.1);
    change(options);
    return shapes::complaint([&] { AP::paper_salient_points(surface, options); });
  };
  EXPECT_NE(complaint([](auto& o) { o.reference_length = 0; }).find("reference_length"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& o) { o.reference_length = 0.003; }).find("255"), std::string::npos);
  EXPECT_NE(complaint([](auto& o) {
              o.reference_length = 0.001;
              o.largest_radius = 0.01;
            }).find("voxels"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& o) { o.largest_radius = 0.05; }).find("largest_radius"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& o) { o.sigma_ratio = 1; }).find("sigma_ratio"), std::string::npos);
  EXPECT_NE(complaint([](auto& o) { o.smoothing = -1; }).find("smoothing"), std::string::npos);
  EXPECT_NE(complaint([](auto& o) { o.threshold = -1; }).find("threshold"), std::string::npos);
  EXPECT_NE(shapes::complaint([] { AP::paper_salient_points(AP::Triangle_surface()); }), "");
  // Small and far apart: by default there would be more radii than can be.
  const Soup far =
      shapes::joined(shapes::icosphere(2), shapes::icosphere(2, Point_3(100, 100, 100)));
  EXPECT_NE(shapes::complaint([&] {
              AP::paper_salient_points(shapes::surface_of(far));
            }).find("reference_length"),
            std::string::npos);
}

} // namespace
