// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Smoothing, local maxima over space and scales, and inertia of maps, against their definitions.

#include "scale_maps.h"

#include <CGAL/Area_projection_transform/salient_points/Scale_maxima.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace {

using namespace scale_maps;
using AP::Scale_maximum;

// ---------------------------------------------------------------- smoothing

TEST(Gaussian_smoother, has_the_weights_of_a_gaussian)
{
  for(const double sigma : {0.5, 1., 2.3}) {
    const std::vector<float> weights = AP::Gaussian_smoother(sigma).weights();
    ASSERT_EQ(weights.size(), std::size_t(std::ceil(3 * sigma)) + 1);
    double sum = weights[0];
    for(std::size_t d = 1; d < weights.size(); ++d) {
      sum += 2. * weights[d];
      EXPECT_NEAR(weights[d] / weights[0], std::exp(-0.5 * double(d * d) / (sigma * sigma)), 1e-6);
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST(Gaussian_smoother, is_the_convolution_with_zeros_outside)
{
  const auto region = ragged_region({23, 19, 11}, 7);
  const std::vector<float> map = random_map(*region, 100, 8);
  const AP::Gaussian_smoother smoother(1);
  std::vector<float> smoothed;
  smoother.smooth(*region, map, smoothed);
  const auto weight = [&](int d) { return double(smoother.weights()[std::size_t(std::abs(d))]); };
  for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
    double sum = 0;
    for(int k = -3; k <= 3; ++k)
      for(int j = -3; j <= 3; ++j)
        for(int i = -3; i <= 3; ++i)
          if(region->contains(v[0] + i, v[1] + j, v[2] + k))
            sum += weight(i) * weight(j) * weight(k) *
                   map[region->index(v[0] + i, v[1] + j, v[2] + k)];
    // Three sums of seven positive terms, each rounded.
    EXPECT_NEAR(smoothed[place], sum, 30 * std::numeric_limits<float>::epsilon() * sum);
  });
  for(int k = 0; k < 11; ++k)
    for(int j = 0; j < 19; ++j)
      for(int i = 0; i < 23; ++i)
        if(!region->contains(i, j, k)) {
          EXPECT_EQ(value_at(*region, smoothed, {i, j, k}), 0) << "between runs";
        }
}

TEST(Gaussian_smoother, turns_mirror_images_into_mirror_images)
{
  const int n = 20;
  const auto region = whole_region(n);
  const std::vector<float> map = random_map(*region, 1000, 9);
  for(int axis = 0; axis < 3; ++axis) {
    const auto mirrored = [&](Voxel v) {
      v[std::size_t(axis)] = n - 1 - v[std::size_t(axis)];
      return v;
    };
    const std::vector<float> mirror_image =
        map_of(*region, [&](const Voxel& v) { return value_at(*region, map, mirrored(v)); });
    std::vector<float> smoothed, other;
    AP::Gaussian_smoother().smooth(*region, map, smoothed);
    AP::Gaussian_smoother().smooth(*region, mirror_image, other);
    for_each_voxel(*region, [&](const Voxel& v, std::size_t place) {
      ASSERT_EQ(other[place], value_at(*region, smoothed, mirrored(v)));
    });
  }
}

TEST(Gaussian_smoother, gives_the_same_bits_with_any_number_of_threads)
{
  const auto region = ragged_region({40, 30, 20}, 11);
  const std::vector<float> map = random_map(*region, 1000, 12);
  std::vector<float> expected, smoothed;
  AP::Gaussian_smoother().smooth(*region, map, expected);
  for(const int threads : {1, 2, 5, 40})
    with_threads(threads, [&] {
      AP::Gaussian_smoother().smooth<CGAL::Parallel_if_available_tag>(*region, map, smoothed);
      EXPECT_EQ(smoothed, expected);
    });
}

TEST(Gaussian_smoother, does_nothing_with_a_standard_deviation_of_zero)
{
  const auto region = ragged_region({12, 10, 9}, 13);
  const std::vector<float> map = random_map(*region, 1000, 14);
  std::vector<float> smoothed;
  AP::Gaussian_smoother(0).smooth(*region, map, smoothed);
  EXPECT_EQ(smoothed, map);
  EXPECT_NE(shapes::complaint([] { AP::Gaussian_smoother(-1.); }), "");
  EXPECT_NE(shapes::complaint([] { AP::Gaussian_smoother(1e9); }), "");
}

// ---------------------------------------------------------------- maxima

template <class ConcurrencyTag>
std::vector<Maximum> streamed_maxima(std::shared_ptr<const Row_spans> region, const Maps& maps,
                                     double smoothing, double threshold)
{
  AP::Scale_maxima<ConcurrencyTag> maxima(region, smoothing, threshold);
  std::vector<Maximum> found;
  const auto add = [&](const std::vector<Scale_maximum>& more) {
    for(const Scale_maximum& m : more) {
      const std::size_t place = region->index(m.voxel[0], m.voxel[1], m.voxel[2]);
      EXPECT_EQ(maxima.map_of_maxima()[place], m.value);
      found.emplace_back(m.scale, place, m.value);
    }
  };
  for(const std::vector<float>& map : maps)
    add(maxima.push(map));
  add(maxima.finish());
  return found;
}

TEST(Scale_maxima, finds_in_the_stream_what_the_definition_finds_in_all_maps)
{
  for(const std::size_t number_of_scales : {1, 2, 3, 6})
    for(const int number_of_values : {3, 1000}) {
      const auto region = ragged_region({17, 13, 9}, number_of_scales);
      Maps maps;
      for(std::size_t k = 0; k < number_of_scales; ++k)
        maps.push_back(random_map(*region, number_of_values, 20 + k));
      for(const double smoothing : {0., 1.}) {
        Maps smoothed(number_of_scales);
        for(std::size_t k = 0; k < number_of_scales; ++k)
          AP::Gaussian_smoother(smoothing).smooth(*region, maps[k], smoothed[k]);
        for(const double threshold : {0., 0.4 * number_of_values}) {
          const auto expected = maxima_by_definition(*region, smoothed, threshold);
          EXPECT_EQ(streamed_maxima<CGAL::Sequential_tag>(region, maps, smoothing, threshold),
                    expected);
          for(const int threads : {1, 3})
            with_threads(threads, [&] {
              EXPECT_EQ(streamed_maxima<CGAL::Parallel_if_available_tag>(region, maps, smoothing,
                                                                         threshold),
                        expected);
            });
        }
        EXPECT_FALSE(maxima_by_definition(*region, smoothed, 0).empty());
      }
    }
}

TEST(Scale_maxima, takes_one_voxel_of_a_block_of_equal_values)
{
  const auto region = whole_region(9);
  for(const Voxel& last : {Voxel{4, 3, 3}, Voxel{6, 3, 3}, Voxel{4, 4, 4}, Voxel{6, 5, 4}}) {
    const std::vector<float> block = map_of(*region, [&](const Voxel& v) {
      for(std::size_t axis = 0; axis < 3; ++axis)
        if(v[axis] < 3 || v[axis] > last[axis])
          return 0;
      return 1;
    });
    const Maps maps(4, block);
    const std::vector<Maximum> found = streamed_maxima<CGAL::Sequential_tag>(region, maps, 0, 0.5);
    EXPECT_EQ(found, (std::vector<Maximum>{{0, region->index(3, 3, 3), 1.f}}));
  }
}

TEST(Scale_maxima, refuses_a_negative_threshold)
{
  const auto region = whole_region(3);
  EXPECT_NE(shapes::complaint([&] { AP::Scale_maxima<>(region, 1, -0.1); }), "");
}

// ---------------------------------------------------------------- inertia

void expect_inertia(const AP::Inertia_descriptors& d, double blobness, double flatness,
                    double vesselness, double tolerance)
{
  EXPECT_NEAR(d.blobness, blobness, tolerance);
  EXPECT_NEAR(d.flatness, flatness, tolerance);
  EXPECT_NEAR(d.vesselness, vesselness, tolerance);
  EXPECT_NEAR(d.blobness + d.flatness + d.vesselness, 1, 1e-12);
}

TEST(Inertia, tells_balls_disks_and_lines)
{
  const int n = 21, c = n / 2;
  const auto region = whole_region(n);
  const auto square = [](int a) { return double((a - c) * (a - c)); };
  // A zero eigenvalue may come out as 1e-15 of the largest: its root is 3e-8.
  const double tolerance = 1e-6;
  expect_inertia(inertia_of(*region,
                            map_of(*region,
                                   [&](const Voxel& v) {
                                     return std::exp(-0.05 *
                                                     (square(v[0]) + square(v[1]) + square(v[2])));
                                   }),
                            8),
                 1, 0, 0, tolerance);
  expect_inertia(inertia_of(*region, map_of(*region, [](const Voxel&) { return 0.3; }), 6), 1, 0, 0,
                 tolerance);
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t second = (axis + 1) % 3;
    expect_inertia(
        inertia_of(*region, map_of(*region, [&](const Voxel& v) { return v[axis] == c; }), 7), 0, 1,
        0, tolerance);
    expect_inertia(
        inertia_of(*region,
                   map_of(*region, [&](const Voxel& v) { return v[axis] == c && v[second] == c; }),
                   7),
        0, 0, 1, tolerance);
  }
  // A line along a diagonal, of values that change along it.
  expect_inertia(inertia_of(*region,
                            map_of(*region,
                                   [&](const Voxel& v) {
                                     return v[0] == v[1] && v[1] == v[2] ? 1 + v[0] : 0;
                                   }),
                            7),
                 0, 0, 1, tolerance);
}

TEST(Inertia, of_a_gaussian_is_its_own)
{
  // Wide enough for sums over the lattice to be integrals, and 4.5 standard deviations within the ball.
  const double a = 4, b = 2.5, c = 1.5;
  const int n = 39, centre = n / 2;
  const auto region = whole_region(n);
  const std::vector<float> map = map_of(*region, [&](const Voxel& v) {
    const double x = (v[0] - centre) / b, y = (v[1] - centre) / a, z = (v[2] - centre) / c;
    return std::exp(-0.5 * (x * x + y * y + z * z));
  });
  expect_inertia(inertia_of(*region, map, 18), c / a, (b - c) / a, (a - b) / a, 2e-3);
}

TEST(Inertia, of_a_point_is_unknown)
{
  const auto region = whole_region(9);
  const AP::Inertia_descriptors d = inertia_of(*region,
                                               map_of(*region,
                                                      [](const Voxel& v) {
                                                        return v == Voxel{4, 4, 4};
                                                      }),
                                               3);
  EXPECT_TRUE(std::isnan(d.blobness));
  EXPECT_TRUE(std::isnan(d.vesselness));
  EXPECT_EQ(
      AP::map_covariance(*region, std::vector<float>(region->storage_size(), 0.f), {4, 4, 4}, 3)
          .trace(),
      0);
}

} // namespace
