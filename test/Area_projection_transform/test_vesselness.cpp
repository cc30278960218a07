// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Vesselness, against Hessians in closed form, and the normals of voters, against tubes, spheres and walls.

#include "scale_maps.h"

#include <CGAL/Area_projection_transform/vesselness.h>
#include <CGAL/Area_projection_transform/voter_normals.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace scale_maps;
using AP::Vector_3;
using AP::Vesselness_map;
using AP::Vesselness_options;
using Eigen::Matrix3d;
using Eigen::Vector3d;

AP::Covariance_3 symmetric(const Matrix3d& m)
{
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

Matrix3d random_rotation(shapes::Random& random)
{
  const Vector_3 a = random.direction(), b = random.direction();
  const Vector3d u = Vector3d(a.x(), a.y(), a.z());
  const Vector3d v = u.cross(Vector3d(b.x(), b.y(), b.z())).normalized();
  Matrix3d q;
  q << u, v, u.cross(v);
  return q;
}

// ---------------------------------------------------------------- eigenvalues

TEST(Symmetric_eigen, is_right_where_eigenvalues_are_nearly_the_same)
{
  shapes::Random random(3);
  std::vector<Vector3d> spectra{{0, 0, 0},   {0, 0, -1},  {0, -1, -1},      {1, 1, 1},
                                {-1, 1, -1}, {-2, 1, -2}, {1e-300, -1, -1}, {-1e-9, 1e-9, -1}};
  for(double gap = 1e-2; gap > 1e-18; gap *= 0.03) {
    spectra.push_back({1, 1 + gap, 1 + 2 * gap});
    spectra.push_back({gap, -1, -1 - gap});
    spectra.push_back({0.5, -1, -1 + gap});
    spectra.push_back({gap, 2 * gap, -1});
  }
  for(const Vector3d& spectrum : spectra)
    for(const double unit : {1., 1e-120, 1e120})
      for(int repetition = 0; repetition < 20; ++repetition) {
        const Matrix3d q = random_rotation(random);
        const Matrix3d m = q * (unit * spectrum).asDiagonal() * q.transpose();
        const double norm = m.norm();
        std::array<double, 3> expected{spectrum[0], spectrum[1], spectrum[2]};
        std::sort(expected.begin(), expected.end());
        std::array<double, 3> found = AP::internal::eigenvalues_by_magnitude(symmetric(m));
        EXPECT_LE(std::abs(found[0]), std::abs(found[1]));
        EXPECT_LE(std::abs(found[1]), std::abs(found[2]));
        std::sort(found.begin(), found.end());
        for(std::size_t i = 0; i < 3; ++i) // a root of the machine epsilon, and what q is off
          EXPECT_NEAR(found[i], unit * expected[i], 4e-8 * norm);
        const Vector_3 v = AP::internal::direction_of_smallest(symmetric(m));
        const Vector3d direction(v.x(), v.y(), v.z());
        EXPECT_NEAR(direction.norm(), 1, 1e-14);
        // Backward stable: an eigenvector of a matrix that differs by some epsilons; and that eigenvalue
        // is the smallest one, by the theorem of Weyl.
        const double value = direction.dot(m * direction);
        EXPECT_LE((m * direction - value * direction).norm(), 1e-14 * norm);
        EXPECT_NEAR(std::abs(value), unit * spectrum.cwiseAbs().minCoeff(), 1e-14 * norm);
      }
}

TEST(Symmetric_eigen, gives_one_of_two_signs)
{
  EXPECT_EQ(AP::internal::without_sign({0, 0, -1}), Vector_3(0, 0, 1));
  EXPECT_EQ(AP::internal::without_sign({0.6, -0.8, 0}), Vector_3(-0.6, 0.8, 0));
  EXPECT_EQ(AP::internal::without_sign({-1, 0, 0}), Vector_3(1, 0, 0));
}

// ---------------------------------------------------------------- Hessians

using Hessian_function = std::function<void(const Voxel&, const Matrix3d&)>;

void for_each_hessian(const Row_spans& region, const std::vector<float>& map, double s,
                      const Hessian_function& function)
{
  AP::internal::for_each_hessian_row<CGAL::Sequential_tag>(
      region, map, region, s, [&](const AP::internal::Derivative_row& row, float factor) {
        for(int i = row.first; i < row.last; ++i) {
          const auto d = [&](std::size_t n) {
            return double(factor) * double(row.derivatives[n][std::size_t(i - row.first)]);
          };
          Matrix3d h;
          h << d(0), d(3), d(4), d(3), d(1), d(5), d(4), d(5), d(2);
          function({i, row.j, row.k}, h);
        }
      });
}

TEST(Hessian, of_a_parabola_is_its_own_at_any_scale)
{
  const int n = 41, c = n / 2;
  const auto region = whole_region(n);
  const Matrix3d a = (Matrix3d() << -3, 1, 0.5, 1, 2, -1, 0.5, -1, 1).finished();
  const Vector3d slope(0.7, -2, 3);
  const auto place = [&](const Voxel& v) { return Vector3d(v[0] - c, v[1] - c, v[2] - c); };
  const std::vector<float> map = map_of(*region, [&](const Voxel& v) {
    return 5 + slope.dot(place(v)) + 0.5 * place(v).dot(a * place(v));
  });
  for(const double s : {0.5, 0.8, 1.7, 2.5}) {
    const int reach = 5 * int(std::ceil(s)) + (s > 2 ? 5 : 0); // of one Gaussian, or of two
    int seen = 0;
    for_each_hessian(*region, map, s, [&](const Voxel& v, const Matrix3d& h) {
      if(*std::min_element(v.begin(), v.end()) < reach ||
         *std::max_element(v.begin(), v.end()) >= n - reach)
        return;
      ++seen;
      // Values are below 2000 on the cube, and so are their weighted sums, in which floats are rounded.
      EXPECT_LE((h - s * s * a).cwiseAbs().maxCoeff(), 2000 * 30 * 6e-8);
    });
    EXPECT_EQ(seen, std::pow(n - 2 * reach, 3));
  }
}

/// the Hessian, times `s²`, of a Gaussian of height 1 and the given covariance, smoothed with `s`, in its middle.
Matrix3d hessian_of_gaussian(const Matrix3d& covariance, double s)
{
  const Matrix3d wider = covariance + s * s * Matrix3d::Identity();
  const double height = std::sqrt(covariance.determinant() / wider.determinant());
  return -s * s * height * wider.inverse();
}

TEST(Hessian, of_a_gaussian_is_that_of_a_wider_one)
{
  shapes::Random random(5);
  const int n = 49, c = n / 2;
  const auto region = whole_region(n);
  for(int repetition = 0; repetition < 4; ++repetition) {
    const Matrix3d q = random_rotation(random);
    const Matrix3d covariance = q * Vector3d(9, 4, 2.5).asDiagonal() * q.transpose();
    const Matrix3d inverse = covariance.inverse();
    const std::vector<float> map = map_of(*region, [&](const Voxel& v) {
      const Vector3d x(v[0] - c, v[1] - c, v[2] - c);
      return std::exp(-0.5 * x.dot(inverse * x));
    });
    for(const double s : {1., 2., 3.}) {
      const Matrix3d expected = hessian_of_gaussian(covariance, s);
      for_each_hessian(*region, map, s, [&](const Voxel& v, const Matrix3d& h) {
        if(v == Voxel{c, c, c}) { // cut off at five standard deviations, and between voxels
          EXPECT_LE((h - expected).norm(), 1e-3 * expected.norm());
        }
      });
    }
  }
}

TEST(Hessian, counts_zero_outside_of_the_region)
{
  const auto ragged = ragged_region({23, 19, 11}, 7);
  const auto whole = std::make_shared<const Row_spans>(ragged->grid());
  const std::vector<float> map = random_map(*ragged, 100, 8);
  const std::vector<float> filled =
      map_of(*whole, [&](const Voxel& v) { return value_at(*ragged, map, v); });
  const int margin = 8;
  const Row_spans in_larger_grid = AP::internal::with_margin(*ragged, margin);
  for(const double s : {0.5, 1.3, 3.5}) {
    std::vector<Matrix3d> expected(whole->storage_size());
    for_each_hessian(*whole, filled, s, [&](const Voxel& v, const Matrix3d& h) {
      expected[whole->index(v[0], v[1], v[2])] = h;
    });
    for_each_hessian(*ragged, map, s, [&](const Voxel& v, const Matrix3d& h) {
      EXPECT_EQ(h, expected[whole->index(v[0], v[1], v[2])]);
    });
    for_each_hessian(in_larger_grid, map, s, [&](const Voxel& v, const Matrix3d& h) {
      EXPECT_EQ(h, expected[whole->index(v[0] - margin, v[1] - margin, v[2] - margin)]);
    });
  }
}

// ---------------------------------------------------------------- vesselness

/// a joint map of one scale.
AP::Joint_map joint_map_of(const std::shared_ptr<const Row_spans>& region,
                           const std::vector<float>& values, double radius = 6)
{
  const AP::Scale scale{radius, radius / 2};
  AP::Joint_map map(region, {scale});
  map.consume(0, scale, 0, values.data(), values.size());
  return map;
}

double frangi(double l1, double l2, double l3, const Vesselness_options& options = {})
{
  return AP::frangi_vesselness({l1, l2, l3}, options);
}

TEST(Frangi, tells_lines_from_plates_blobs_and_nothing)
{
  EXPECT_NEAR(frangi(0, -10, -10), 1 - std::exp(-2.), 1e-12); // a line
  EXPECT_EQ(frangi(0, 0, -10), 0);                            // a plate
  EXPECT_NEAR(frangi(0, -0.1, -10), 1 - std::exp(-2e-4), 1e-12);
  EXPECT_NEAR(frangi(-10, -10, -10), (1 - std::exp(-2.)) * std::exp(-2.), 1e-12); // a ball
  EXPECT_EQ(frangi(0, 10, 10), 0);                                                // dark
  EXPECT_EQ(frangi(0, 1, -10), 0);
  EXPECT_EQ(frangi(0, -1, 10), 0);
  EXPECT_EQ(frangi(0, 0, 0), 0);
  EXPECT_NEAR(frangi(0, -0.05, -0.05), (1 - std::exp(-2.)) * (1 - std::exp(-1.)), 1e-12);
  EXPECT_EQ(frangi(0, -1e-300, -1e-300), 0);
  Vesselness_options half;
  half.coverage = 0.5;
  for(double l = 1; l > 1e-4; l *= 0.7)
    EXPECT_EQ(frangi(0.1 * l, -0.9 * l, -l, half), frangi(0.2 * l, -1.8 * l, -2 * l));
}

/// a ridge along a line through the middle, as a Gaussian of its distance.
std::vector<float> ridge(const Row_spans& region, const Vector3d& direction, double width)
{
  const double c = 0.5 * (region.grid().size()[0] - 1);
  return map_of(region, [&](const Voxel& v) {
    const Vector3d x(v[0] - c, v[1] - c, v[2] - c);
    return std::exp(-0.5 * x.cross(direction).squaredNorm() / (width * width));
  });
}

double cosine(const Vesselness_map::Direction& d, const Vector3d& direction)
{
  return std::abs(Vector3d(d[0], d[1], d[2]).dot(direction));
}

TEST(Vesselness, of_a_ridge_is_largest_at_its_own_width)
{
  shapes::Random random(11);
  const int n = 45, c = n / 2;
  const auto region = whole_region(n);
  for(int repetition = 0; repetition < 3; ++repetition) {
    const Vector3d direction = random_rotation(random).col(0);
    const double width = 2.5;
    const AP::Joint_map map = joint_map_of(region, ridge(*region, direction, width));
    Vesselness_options options;
    options.structure = 0.4; // at which the strength of the Hessian matters
    options.scales = {4.2, 1.5, 2.5, 3.2, 1.9};
    const Vesselness_map found = AP::vesselness(map, options);
    const std::size_t middle = region->index(c, c, c);
    // s² / (w² + s²) times w² / (w² + s²) is largest for s = w: 1/4.
    EXPECT_FLOAT_EQ(found.scales[middle], 2.5f);
    EXPECT_NEAR(found.values[middle], frangi(0, -0.25, -0.25, options), 5e-3);
    // Values of 1 are sums of 43 rounded floats along each axis, and directions their ratio to 1/4.
    EXPECT_NEAR(cosine(found.directions[middle], direction), 1, 1e-5);
    std::sort(options.scales.begin(), options.scales.end());
    const Vesselness_map again = AP::vesselness(map, options);
    EXPECT_EQ(again.values, found.values);
    EXPECT_EQ(again.directions, found.directions);
    EXPECT_EQ(again.scales, found.scales);
  }
}

TEST(Vesselness, takes_the_scale_of_each_voxel_from_the_map)
{
  const int n = 33, c = n / 2;
  const auto region = whole_region(n);
  const std::vector<float> values = ridge(*region, {0, 0.6, 0.8}, 2);
  const std::vector<AP::Scale> scales{{0.1, 0.05}, {0.2, 0.1}, {4, 2}, {8, 4}};
  AP::Joint_map map(region, scales);
  const auto radius_of = [&](const Voxel& v) { return std::size_t(v[0] % 4); };
  for(std::size_t k = 0; k < scales.size(); ++k) {
    const std::vector<float> own =
        map_of(*region, [&](const Voxel& v) { return radius_of(v) == k ? 1 : 0; });
    std::vector<float> part(values.size());
    for(std::size_t i = 0; i < part.size(); ++i)
      part[i] = own[i] * values[i];
    map.consume(k, scales[k], 0, part.data(), part.size());
  }
  const Vesselness_map found = AP::vesselness(map);
  for(const double s : {0.5, 1.4, 2.8}) { // the first two radii share the smallest
    Vesselness_options options;
    options.scales = {s};
    const Vesselness_map expected = AP::vesselness(map, options);
    for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
      const std::size_t k = radius_of(v);
      if(map.values()[place] == 0 || s != (k < 2 ? 0.5 : k == 2 ? 1.4 : 2.8))
        return;
      EXPECT_EQ(found.values[place], expected.values[place]);
      EXPECT_EQ(found.directions[place], expected.directions[place]);
      if(found.values[place] > 0) {
        EXPECT_FLOAT_EQ(found.scales[place], float(s));
      }
    });
  }
  EXPECT_GT(found.values[region->index(c, c, c)], 0.5);
}

TEST(Vesselness, is_that_of_the_whole_surface_if_half_of_the_map_is_missing)
{
  const auto region = whole_region(21);
  std::vector<float> values = ridge(*region, {0, 0.6, 0.8}, 2);
  const Vesselness_map whole = AP::vesselness(joint_map_of(region, values));
  for(float& value : values)
    value *= 0.5f; // exactly
  Vesselness_options options;
  options.coverage = 0.5;
  const Vesselness_map half = AP::vesselness(joint_map_of(region, values), options);
  EXPECT_EQ(half.values, whole.values);
  EXPECT_EQ(half.directions, whole.directions);
}

TEST(Vesselness, is_zero_without_direction_where_there_is_no_line)
{
  const auto region = ragged_region({23, 19, 17}, 9);
  const Vesselness_map nothing =
      AP::vesselness(joint_map_of(region, std::vector<float>(region->storage_size(), 0.f)));
  for(std::size_t i = 0; i < nothing.values.size(); ++i) {
    EXPECT_EQ(nothing.values[i], 0);
    EXPECT_EQ(nothing.scales[i], 0);
    EXPECT_EQ(nothing.directions[i], Vesselness_map::Direction());
  }
  EXPECT_EQ(nothing.region, region);
}

TEST(Vesselness, has_the_same_bits_with_any_number_of_threads)
{
  const auto region = ragged_region({40, 30, 20}, 11);
  const AP::Joint_map map = joint_map_of(region, random_map(*region, 1000, 12), 4);
  Vesselness_options scan;
  scan.scales = {1, 2};
  for(const Vesselness_options& options : {Vesselness_options(), scan}) {
    const Vesselness_map expected = AP::vesselness(map, options);
    EXPECT_GT(*std::max_element(expected.values.begin(), expected.values.end()), 0);
    for(const int threads : {1, 2, 5, 40})
      with_threads(threads, [&] {
        const Vesselness_map found = AP::vesselness<CGAL::Parallel_if_available_tag>(map, options);
        EXPECT_EQ(found.values, expected.values);
        EXPECT_EQ(found.directions, expected.directions);
        EXPECT_EQ(found.scales, expected.scales);
      });
  }
}

TEST(Vesselness, refuses_options_out_of_range)
{
  const auto region = whole_region(5);
  const AP::Joint_map map = joint_map_of(region, std::vector<float>(region->storage_size(), 1.f));
  const auto complaint = [&](auto change) {
    Vesselness_options options;
    change(options);
    return shapes::complaint([&] { AP::vesselness(map, options); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto begins = [](const std::string& text, const std::string& name) {
    return text.compare(0, name.size(), name) == 0;
  };
  for(const double bad : {0., -1., nan}) {
    EXPECT_TRUE(begins(complaint([&](auto& o) { o.structure = bad; }), "structure"));
    EXPECT_TRUE(begins(complaint([&](auto& o) { o.plate_sensitivity = bad; }), "plate"));
    EXPECT_TRUE(begins(complaint([&](auto& o) { o.blob_sensitivity = bad; }), "blob"));
    EXPECT_TRUE(begins(complaint([&](auto& o) { o.scale_ratio = bad; }), "scale_ratio"));
    EXPECT_TRUE(begins(complaint([&](auto& o) { o.coverage = bad; }), "coverage"));
    EXPECT_TRUE(begins(complaint([&](auto& o) { o.scales = {1, bad}; }), "scales[1]"));
  }
  EXPECT_TRUE(begins(complaint([&](auto& o) { o.coverage = 1.01; }), "coverage"));
  EXPECT_TRUE(begins(complaint([&](auto& o) { o.scales = {0.49}; }), "scales[0]"));
}

// ---------------------------------------------------------------- normals of voters

AP::Voter_normals normals_at(const shapes::Soup& soup, const Point_3& point, const AP::Scale& scale,
                             AP::Side side = AP::Side::INSIDE)
{
  return AP::voter_normals(shapes::surface_of(soup), {{point, scale}}, side).front();
}

TEST(Voter_normals, of_a_tube_are_even_across_its_axis)
{
  // The normals of a regular prism sum to half the identity across the axis, exactly, and all its faces are as long.
  shapes::Random random(3);
  const shapes::Soup tube = shapes::cylinder(24, 1, 10, false, 20);
  for(int repetition = 0; repetition < 5; ++repetition) {
    const Vector_3 about = random.direction();
    const shapes::Rotation rotation{about, random(0, 6)};
    const shapes::Soup turned = shapes::moved(tube, rotation);
    const Vector_3 axis = rotation(Point_3(0, 0, 1)) - CGAL::ORIGIN;
    for(const double radius : {0.8, 1.}) {
      const AP::Voter_normals n = normals_at(turned, Point_3(0, 0, 0), {radius, 0.5});
      EXPECT_NEAR(n.shares()[0], 0, 1e-6);
      EXPECT_NEAR(n.shares()[1], 0.5, 2e-2); // where samples are cut off by the ball
      EXPECT_NEAR(n.shares()[2], 0.5, 2e-2);
      EXPECT_NEAR(std::abs(n.axis() * axis), 1, 1e-6);
      // The part of the tube in the ball is 2√(σ² - (1-R)²) long.
      const double length = 2 * std::sqrt(0.25 - (1 - radius) * (1 - radius));
      EXPECT_NEAR(n.area(), 2 * shapes::pi * length, 0.06 * 2 * shapes::pi * length);
    }
  }
}

TEST(Voter_normals, of_spheres_and_walls_have_no_axis)
{
  const AP::Voter_normals sphere = normals_at(shapes::icosphere(4), Point_3(0, 0, 0), {1, 0.5});
  for(const double share : sphere.shares())
    EXPECT_NEAR(share, 1. / 3, 1e-6); // the group of the icosahedron leaves no other tensor
  EXPECT_NEAR(sphere.area(), shapes::icosphere(4).area(), 1e-6 * sphere.area());
  const AP::Voter_normals walls = normals_at(shapes::slab(10, 2), Point_3(0, 0, 0), {1, 0.5});
  EXPECT_NEAR(walls.shares()[2], 1, 1e-6);
  const AP::Voter_normals nothing = normals_at(shapes::icosphere(2), Point_3(9, 9, 9), {1, 0.5});
  EXPECT_EQ(nothing.area(), 0);
  EXPECT_EQ(nothing.shares(), (std::array<double, 3>{0, 0, 0}));
  EXPECT_NEAR(normals_at(shapes::flipped(shapes::icosphere(3)), Point_3(0, 0, 0), {1, 0.5},
                         AP::Side::OUTSIDE)
                  .shares()[0],
              1. / 3, 1e-6);
}

TEST(Voter_normals, have_the_same_bits_for_any_order_of_faces_and_number_of_threads)
{
  const shapes::Soup blob = shapes::blob(3, 5);
  shapes::Random random(8);
  std::vector<AP::Query> queries;
  for(int i = 0; i < 40; ++i)
    queries.push_back({random.point_in({-1, -1, -1, 1, 1, 1}), {i % 2 ? 0.5 : 0.3, 0.2}});
  const auto components = [](const std::vector<AP::Voter_normals>& all) {
    std::vector<double> result;
    for(const AP::Voter_normals& n : all)
      result.insert(result.end(), {n.moments.xx, n.moments.xy, n.moments.xz, n.moments.yy,
                                   n.moments.yz, n.moments.zz});
    return result;
  };
  const auto expected = components(AP::voter_normals(shapes::surface_of(blob), queries));
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0);
  for(const int threads : {1, 3})
    with_threads(threads, [&] {
      EXPECT_EQ(components(AP::voter_normals<CGAL::Parallel_if_available_tag>(
                    shapes::surface_of(shapes::shuffled(blob, 4)), queries)),
                expected);
    });
  EXPECT_NE(shapes::complaint([&] {
              AP::voter_normals(shapes::surface_of(blob), {{{}, {-1, 1}}});
            }),
            "");
  EXPECT_NE(shapes::complaint([&] {
              AP::voter_normals(shapes::surface_of(blob), queries, AP::Side::INSIDE, 1.5);
            }),
            "");
}

} // namespace
