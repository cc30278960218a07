// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Descriptors of shapes whose maps are known, and what must not change them.

#include "shapes.h"

#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::Binning;
using AP::Descriptor_normals;
using AP::Shape_descriptor;
using AP::Shape_descriptor_options;
using shapes::Soup;
using shapes::Vector_3;

constexpr std::array<Descriptor_normals, 5> all_normals{
    Descriptor_normals::FACE, Descriptor_normals::INTERPOLATED, Descriptor_normals::SUBDIVIDED,
    Descriptor_normals::AVERAGED, Descriptor_normals::SMOOTHED};

Shape_descriptor describe(const Soup& soup, const Shape_descriptor_options& options = {})
{
  return AP::shape_descriptor(shapes::surface_of(soup), options);
}

double sum(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.);
}

double l1(const std::vector<float>& a, const std::vector<float>& b)
{
  double result = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    result += std::abs(double(a[i]) - double(b[i]));
  return result;
}

/// a closed shape of three different axes.
Soup long_blob(int level = 4)
{
  return shapes::moved(shapes::blob(level, 3), [](const AP::Point_3& p) {
    return AP::Point_3(2 * p.x(), 1.4 * p.y(), p.z());
  });
}

TEST(Bins, put_values_where_they_belong)
{
  const AP::Bins bins(4, 2); // 0, 0.5, 1, 1.5, 2
  EXPECT_EQ(bins.bin(0.f), 0u);
  EXPECT_EQ(bins.bin(0.49f), 0u);
  EXPECT_EQ(bins.bin(0.5f), 1u);
  EXPECT_EQ(bins.bin(1.99f), 3u);
  EXPECT_EQ(bins.bin(1e30f), 3u);
  EXPECT_EQ(AP::Bins(4, 2, 2.).bin(0.25f), 1u); // counted as twice as much
  const AP::Bins tiny(8, 1e-100);               // whose number per unit is no float
  EXPECT_EQ(tiny.bin(0), 0u);
  EXPECT_EQ(tiny.bin(1e-10f), 7u);
  EXPECT_EQ(tiny.place(0).bin, 0u);
  EXPECT_EQ(tiny.place(1e-10f).upper, AP::Bins::unit);
}

TEST(Bins, share_values_between_the_middles_of_neighbours)
{
  const AP::Bins bins(4, 4); // middles at 0.5, 1.5, 2.5, 3.5
  const auto expect_place = [&](float value, std::size_t bin, double share) {
    const auto place = bins.place(value);
    EXPECT_EQ(place.bin, bin) << value;
    EXPECT_EQ(double(place.upper) / double(AP::Bins::unit), share) << value;
  };
  expect_place(0, 0, 0);
  expect_place(0.5f, 0, 0);
  expect_place(0.75f, 0, 0.25);
  expect_place(1.5f, 1, 0);
  expect_place(3, 2, 0.5);
  expect_place(3.5f, 2, 1);
  expect_place(100, 2, 1);
}

TEST(Histogram_sinks, count_by_hand)
{
  const AP::Bins bins(2, 2); // middles at 0.5 and 1.5
  const std::vector<float> values{0, 1, 1, 5};
  AP::Histogram_sink hard(1, bins, false), soft(1, bins, true);
  hard.consume(0, {1, 0.5}, 0, values.data(), values.size());
  soft.consume(0, {1, 0.5}, 0, values.data(), values.size());
  EXPECT_EQ(hard.histograms()[0], (std::vector<std::int64_t>{1, 3}));
  EXPECT_EQ(soft.histograms()[0],
            (std::vector<std::int64_t>{2 * AP::Bins::unit, 2 * AP::Bins::unit}));
  const std::vector<float> first{9, 1, 0, 0}; // upper, half, lower, lower
  AP::Pair_histogram_sink pairs(first, bins);
  pairs.consume(0, {1, 0.5}, 0, values.data(), values.size());
  const std::int64_t one = AP::Bins::unit * AP::Bins::unit;
  EXPECT_EQ(pairs.table(),
            (std::vector<std::int64_t>{one / 4 + one / 2, one / 4 + one / 2 + one, // first is low
                                       one + one / 4, one / 4}));
}

TEST(Shape_descriptor, says_what_it_was_made_with)
{
  const Soup box = shapes::fine_box(Vector_3(3, 2, 4.5), 0.25);
  const Shape_descriptor d = describe(box);
  EXPECT_NEAR(d.volume, 27, 1e-9);
  EXPECT_NEAR(d.reference_length, 0.1, 1e-12);
  EXPECT_EQ(d.coverage, 1);
  EXPECT_EQ(d.block_size, 12u);
  ASSERT_EQ(d.scales.size(), 8u);
  EXPECT_NEAR(d.scales.front().radius, 0.2, 1e-12);
  EXPECT_NEAR(d.scales.back().radius, 0.9, 1e-12);
  EXPECT_NEAR(d.scales.back().sigma, 0.45, 1e-12);
  // 30³ voxels have the volume; a layer around the box holds no more than its area in voxels.
  EXPECT_NEAR(double(d.number_of_voxels), 27000, 0.5 * box.area() / 0.01);
}

TEST(Shape_descriptor, sums_to_one_the_same_for_each_radius)
{
  for(Binning binning : {Binning::HARD, Binning::SOFT, Binning::PAIRS})
    for(Descriptor_normals normals : all_normals) {
      Shape_descriptor_options options;
      options.binning = binning;
      options.normals = normals;
      const Shape_descriptor d = describe(long_blob(3), options);
      const std::size_t blocks = binning == Binning::PAIRS ? 4 : 8;
      ASSERT_EQ(d.values.size(), binning == Binning::PAIRS ? 256u : 96u);
      ASSERT_EQ(d.block_size * blocks, d.values.size());
      for(std::size_t b = 0; b < blocks; ++b)
        EXPECT_NEAR(sum({d.values.begin() + std::ptrdiff_t(b * d.block_size),
                         d.values.begin() + std::ptrdiff_t((b + 1) * d.block_size)}),
                    1. / double(blocks), 1e-6);
    }
}

// A ball of radius ρ at the scale R: its surface lands on a sphere of radius q = ρ - R. At a distance t from the centre
// the collecting ball holds of that sphere the cap of height (σ² - (t - q)²)/2t, which is the share
// (σ² - (t - q)²)/(4 t q) of it, and all of it where σ > t + q.
double value_in_ball(double rho, double t, double radius)
{
  const double q = rho - radius, sigma = radius / 2;
  const double share = sigma >= t + q ? 1
                       : std::abs(t - q) >= sigma
                           ? 0
                           : (sigma * sigma - (t - q) * (t - q)) / (4 * t * q);
  return share * rho * rho / (radius * radius);
}

TEST(Shape_descriptor, of_a_ball_is_what_geometry_says)
{
  const double rho = 1;
  Shape_descriptor_options options;
  options.voxel_size = 0.5;
  const Shape_descriptor d = describe(shapes::icosphere(5, AP::Point_3(0, 0, 0), rho), options);
  // The paper's algorithm moves what lands to the nearest voxel, by half a diagonal at most, and takes whole voxels for
  // the ball, another half; each bin begins and ends at no more than two distances from the centre. So of the
  // volume up to a bin no more may be amiss than that of two shells as thick as that, at any distance.
  const double voxel = options.voxel_size * d.reference_length;
  const double tolerance = 2 * 3 * std::sqrt(3.) * voxel / rho;
  constexpr int steps = 20000;
  for(std::size_t k = 0; k < d.scales.size(); ++k) {
    std::vector<double> expected(12, 0.);
    for(int i = 0; i < steps; ++i) {
      const double t = rho * (i + 0.5) / steps;
      const double value = value_in_ball(rho, t, d.scales[k].radius);
      expected[std::size_t(std::min(11., 12 * value))] +=
          3 * t * t / (rho * rho * rho) * rho / steps;
    }
    double up_to_here = 0;
    for(std::size_t b = 0; b < 12; ++b) {
      up_to_here += 8 * double(d.values[12 * k + b]) - expected[b];
      EXPECT_LT(std::abs(up_to_here), tolerance) << k << " " << b;
    }
    EXPECT_NEAR(up_to_here, 0, 1e-5);
  }
}

TEST(Shape_descriptor, does_not_depend_on_threads_faces_or_the_type_of_the_mesh)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const Soup soup = long_blob(3);
  const Soup holed = shapes::thinned(soup, 0.9, 5);
  for(Binning binning : {Binning::HARD, Binning::SOFT, Binning::PAIRS})
    for(const Soup* shape : {&soup, &holed}) {
      Shape_descriptor_options options;
      options.binning = binning;
      const Shape_descriptor d = describe(*shape, options);
      EXPECT_EQ(describe(shapes::shuffled(*shape, 4), options).values, d.values);
      const auto parallel = AP::shape_descriptor<CGAL::Parallel_if_available_tag>(
          shapes::surface_of(*shape), options);
      EXPECT_EQ(parallel.values, d.values);
      EXPECT_EQ(parallel.volume, d.volume);
    }
  const auto mesh = shapes::mesh_of<CGAL::Surface_mesh<Point>>(soup);
  const auto polyhedron = shapes::mesh_of<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>(soup);
  EXPECT_EQ(AP::shape_descriptor(mesh).values, describe(soup).values);
  EXPECT_EQ(AP::shape_descriptor(polyhedron).values, describe(soup).values);
}

TEST(Shape_descriptor, follows_the_shape)
{
  const Soup soup = long_blob();
  const shapes::Rotation turn{shapes::Random(6).direction(), 1.234};
  const Soup moved =
      shapes::translated(shapes::scaled(shapes::moved(soup, turn), 37), Vector_3(500, -70, 3));
  const Soup holed = shapes::thinned(soup, 0.9, 5);
  const Soup moved_holed = shapes::thinned(moved, 0.9, 5); // the same triangles
  for(Binning binning : {Binning::HARD, Binning::SOFT, Binning::PAIRS}) {
    Shape_descriptor_options options;
    options.binning = binning;
    // Voxels lie along the principal axes, so that only rounding can move a sample to the next voxel, or a voxel
    // across the surface: some of the tens of thousands, if any.
    EXPECT_LT(l1(describe(moved, options).values, describe(soup, options).values), 1e-3);
    EXPECT_LT(l1(describe(moved_holed, options).values, describe(holed, options).values), 1e-3);
  }
  EXPECT_NEAR(describe(moved).volume / describe(soup).volume, 37 * 37 * 37, 1e-6);
}

TEST(Shape_descriptor, hardly_changes_when_a_shape_without_axes_is_turned)
{
  // All axes of a cube are principal ones: the frame is arbitrary, and with it how voxels meet the surface.
  const Soup cube = shapes::fine_box(Vector_3(1, 1, 1), 0.05);
  const Soup turned = shapes::moved(cube, shapes::Rotation{shapes::Random(7).direction(), 0.7});
  Shape_descriptor_options options;
  options.binning = Binning::SOFT;
  EXPECT_LT(l1(describe(turned, options).values, describe(cube, options).values), 0.1);
}

TEST(Shape_descriptor, does_not_see_how_a_surface_is_cut)
{
  // The same planes in squares of 1/20 and of 1/7: samples lie elsewhere, nothing else differs.
  const Soup coarse = shapes::fine_box(Vector_3(1, 1.3, 2), 1. / 7),
             fine = shapes::fine_box(Vector_3(1, 1.3, 2), 1. / 20);
  Shape_descriptor_options options;
  options.binning = Binning::SOFT;
  options.sample_spacing = 0.5;
  EXPECT_LT(l1(describe(coarse, options).values, describe(fine, options).values), 0.02);
}

TEST(Shape_descriptor, pairs_hold_the_histograms_of_both_radii)
{
  Shape_descriptor_options soft, pairs;
  soft.binning = Binning::SOFT;
  pairs.binning = Binning::PAIRS;
  pairs.bins_of_pair = soft.bins;
  const Shape_descriptor single = describe(long_blob(3), soft),
                         both = describe(long_blob(3), pairs);
  for(std::size_t k = 0; k < 4; ++k)
    for(std::size_t b = 0; b < 12; ++b) {
      double row = 0, column = 0;
      for(std::size_t c = 0; c < 12; ++c) {
        row += both.values[144 * k + 12 * b + c];
        column += both.values[144 * k + 12 * c + b];
      }
      EXPECT_NEAR(row, 2 * single.values[12 * k + b], 1e-6); // of a quarter and of an eighth in all
      EXPECT_NEAR(column, 2 * single.values[12 * (k + 4) + b], 1e-6);
    }
}

TEST(Shape_descriptor, makes_up_for_missing_faces)
{
  const Soup soup = long_blob();
  const Shape_descriptor whole = describe(soup);
  const Soup holed = shapes::thinned(soup, 0.8, 8);
  const Shape_descriptor compensated = describe(holed);
  Shape_descriptor_options options;
  options.compensate = false;
  const Shape_descriptor raw = describe(holed, options);
  // Each of the six directions sees the surface with the probability of 0.8.
  EXPECT_NEAR(compensated.coverage, 0.8, 0.03);
  EXPECT_NEAR(compensated.volume / whole.volume, 1, 0.03);
  EXPECT_LT(l1(compensated.values, whole.values), 0.5 * l1(raw.values, whole.values));
}

TEST(Shape_descriptor, smooth_normals_tell_less_of_noise)
{
  const Soup soup = long_blob(4);
  const Soup noisy = shapes::displaced(soup, 0.03, 9); // edges are 0.1 to 0.2 long
  std::vector<double> changes;
  for(Descriptor_normals normals :
      {Descriptor_normals::FACE, Descriptor_normals::INTERPOLATED, Descriptor_normals::AVERAGED}) {
    Shape_descriptor_options options;
    options.normals = normals;
    changes.push_back(l1(describe(noisy, options).values, describe(soup, options).values));
  }
  EXPECT_LT(changes[1], changes[0]);
  EXPECT_LT(changes[2], changes[0]);
}

TEST(Shape_descriptor, subdivides_coarse_meshes_only)
{
  Shape_descriptor_options interpolated, subdivided;
  interpolated.normals = Descriptor_normals::INTERPOLATED;
  subdivided.normals = Descriptor_normals::SUBDIVIDED;
  EXPECT_EQ(describe(long_blob(5), subdivided).values, describe(long_blob(5), interpolated).values);
  EXPECT_NE(describe(long_blob(2), subdivided).values, describe(long_blob(2), interpolated).values);
}

TEST(Shape_descriptor, says_what_is_wrong)
{
  const Soup ball = shapes::icosphere(2);
  const auto complaint = [&ball](auto change) {
    Shape_descriptor_options options;
    change(options);
    return shapes::complaint([&] { describe(ball, options); });
  };
  using Options = Shape_descriptor_options&;
  EXPECT_NE(complaint([](Options o) { o.scale_divisor = 0; }).find("scale_divisor"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.smallest_radius = -1; }).find("smallest_radius"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.largest_radius = 1; }).find("largest_radius"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.radius_step = 1e-9; }).find("largest_radius"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.sigma_ratio = 1; }).find("sigma_ratio"), std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.voxel_size = std::nan(""); }).find("voxel_size"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.bins = 1; }).find("bins"), std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.bins_of_pair = 0; }).find("bins_of_pair"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.largest_value = 0; }).find("largest_value"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.smoothing_ratio = 0; }).find("smoothing_ratio"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.sample_spacing = 0; }).find("sample_spacing"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) {
              o.binning = Binning::PAIRS;
              o.largest_radius = 8;
            }).find("PAIRS"),
            std::string::npos);
  EXPECT_NE(complaint([](Options o) { o.voxel_size = 100; }).find("voxel"), std::string::npos);
}

TEST(Shape_descriptor, surfaces_without_an_inside_are_refused)
{
  const auto expect_refused = [](const Soup& soup, const std::string& why) {
    const std::string text = shapes::complaint([&] { describe(soup); });
    EXPECT_NE(text.find(why), std::string::npos) << text;
  };
  expect_refused(Soup(), "no face");
  expect_refused(shapes::flipped(shapes::icosphere(2)), "outward");
  expect_refused(shapes::plane_patch(1, 0), "no volume");
  expect_refused(shapes::thinned(shapes::flipped(shapes::icosphere(3)), 0.9, 1), "outward");
  expect_refused(shapes::box(AP::Point_3(0, 0, 0), AP::Point_3(1, 1, 1e-12)), "no volume");
  Soup far = shapes::icosphere(1);
  for(const Vector_3& v : {Vector_3(1e4, 0, 0), Vector_3(0, 2e4, 0), Vector_3(0, 0, 3e4)})
    far = shapes::joined(far, shapes::translated(shapes::icosphere(1), v));
  expect_refused(far, "too wide");
}

TEST(Shape_descriptor, points_are_refused)
{
  EXPECT_THROW(AP::shape_descriptor(AP::Surfels()), std::invalid_argument);
}

TEST(Enclosed_volume, of_closed_and_of_open_surfaces)
{
  const Soup soup = long_blob();
  const double exact = soup.volume();
  EXPECT_NEAR(AP::enclosed_volume(shapes::surface_of(soup)), exact, 1e-9 * exact);
  // Points that are not joined leave gaps that nothing falls through: voxels count it to a layer's error.
  EXPECT_NEAR(AP::enclosed_volume(shapes::surface_of(shapes::unmerged(soup))), exact,
              0.005 * exact);
  // Without its top, which is open, it holds what is below the rim, and the hill above it at most.
  constexpr double rim = 0.75;
  const Soup cup = shapes::without_faces(soup, [](const AP::Point_3& p) { return p.z() > rim; });
  const double seen = AP::enclosed_volume(shapes::surface_of(cup));
  EXPECT_LT(seen, 1.005 * exact);
  EXPECT_GT(seen, 0.9 * exact);
}

TEST(Loop_subdivision, keeps_planes_and_closed_surfaces)
{
  const Soup patch = shapes::plane_patch(1, 0.25);
  const AP::Triangle_surface finer = AP::internal::Loop_subdivision(shapes::surface_of(patch))();
  EXPECT_EQ(finer.size(), 4 * patch.triangles.size());
  for(const AP::Point_3& p : finer.points)
    EXPECT_NEAR(p.z(), 0.25, 1e-15);
  // Only the four corners are rounded off: each moves by an eighth of the way to either neighbour.
  EXPECT_LT(finer.total_area(), patch.area());
  EXPECT_GT(finer.total_area(), 0.95 * patch.area());
  const AP::Triangle_surface ball =
      AP::internal::Loop_subdivision(shapes::surface_of(shapes::unmerged(shapes::icosphere(2))))();
  EXPECT_EQ(ball.size(), 4u * 320);
  EXPECT_TRUE(AP::internal::is_closed(ball)); // points at the same place are joined
}

TEST(Passed_normals, average_to_those_of_a_smooth_surface)
{
  // On a sphere averages are radial. Those of a noisy one come nearer to that from radius to radius.
  const Soup ball = shapes::icosphere(4);
  const Soup noisy = shapes::displaced(ball, 0.02, 10);
  const auto error = [](const AP::Triangle_surface& surface, const std::vector<Vector_3>& normals) {
    double squares = 0;
    for(std::size_t t = 0; t < surface.size(); ++t) {
      const AP::Point_3 c =
          CGAL::centroid(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
      squares += (normals[t] - AP::internal::normalized(c - CGAL::ORIGIN)).squared_length();
    }
    return std::sqrt(squares / double(surface.size()));
  };
  const AP::Triangle_surface surface = shapes::surface_of(noisy), clean = shapes::surface_of(ball);
  const auto seen = AP::internal::Passed_normals(surface)({0.1, 0.2, 0.3});
  EXPECT_LT(error(surface, seen[0].normals), 0.6 * error(surface, surface.normals));
  EXPECT_LT(error(surface, seen[1].normals), 0.8 * error(surface, seen[0].normals));
  EXPECT_LT(error(surface, seen[2].normals), error(surface, seen[1].normals));
  // Of a clean one, where the neighbours of a face do not lie evenly around it, they are off by a part of an edge, which
  // is 0.066 long.
  EXPECT_LT(error(clean, AP::internal::Passed_normals(clean)({0.3})[0].normals), 0.066 / 4);
}

TEST(Passed_normals, spread_as_far_as_told)
{
  // On a plane of equal squares, a normal that differs spreads as heat does: with the variance of the neighbourhood along
  // either direction, wherever it is small enough not to reach the rim.
  const int n = 40;
  AP::Triangle_surface surface = shapes::surface_of(shapes::plane_patch(1, 0, n));
  std::size_t center = 0;
  double nearest = 1;
  const auto middle = [&surface](std::size_t t) {
    return CGAL::centroid(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
  };
  for(std::size_t t = 0; t < surface.size(); ++t)
    if(const double d = CGAL::squared_distance(middle(t), AP::Point_3(0, 0, 0)); d < nearest) {
      nearest = d;
      center = t;
    }
  surface.normals[center] = AP::internal::normalized(Vector_3(0.01, 0, 1));
  const double deviation = 0.1;
  const auto seen = AP::internal::Passed_normals(surface)({0.5 * deviation, deviation});
  double weight = 0, variance = 0;
  for(std::size_t t = 0; t < surface.size(); ++t) {
    const double x = seen[1].normals[t].x(); // to first order the share of the one that differs
    weight += x;
    variance += x * CGAL::squared_distance(middle(t), middle(center)) / 2;
  }
  EXPECT_NEAR(weight / 0.01, 1, 0.01);
  EXPECT_NEAR(std::sqrt(variance / weight) / deviation, 1, 0.05);
}

// A plane that is folded into waves much smaller than the radius is seen as the plane: averaged normals are those of the
// plane, the waves are α steep, and cos α of their area is that of the plane below them.
TEST(Sampled_averaging_scale_space, of_a_folded_plane_has_the_area_of_the_plane)
{
  constexpr int n = 40;
  const Soup folded = shapes::lattice_patch(
      n, n, [](int i, int j) { return AP::Point_3(i, j, i % 2 == 0 ? 0.4 : -0.4); });
  const AP::Triangle_surface surface = shapes::surface_of(folded);
  const AP::internal::Passed_normals normals(surface);
  const AP::internal::Sampled_averaging_scale_space scale_space(surface, normals, {10.}, 0.3, 0.5);
  double area = 0;
  scale_space.project(10, AP::Side::INSIDE, 1, [&](const AP::Projected_surfels& batch) {
    area += std::accumulate(batch.areas.begin(), batch.areas.end(), 0.);
  });
  EXPECT_GT(surface.total_area(), 1.28 * n * n); // √(1 + 0.8²)
  EXPECT_NEAR(area, n * n, 0.01 * n * n);
}

} // namespace
