// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The lanes that kernels compute with: what each lane gets, with the same bits for every instruction set.

#define CGAL_AREA_PROJECTION_KERNEL "test_lanes_impl.h"
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using CGAL::Area_projection::internal::available_instruction_sets;
using CGAL::Area_projection::internal::chosen_instruction_set;
using CGAL::Area_projection::internal::Instruction_set;

class Every_instruction_set : public testing::TestWithParam<Instruction_set>
{
protected:
  void SetUp() override { chosen_instruction_set() = GetParam(); }
  void TearDown() override { chosen_instruction_set() = available_instruction_sets().back(); }
};

template <class Number>
void expect_each_lane_as_a_single_number()
{
  std::array<Number, 16> x, result;
  for(int i = 0; i < 16; ++i)
    x[i] = Number(0.37f) * Number(i - 3);
  const unsigned within = CGAL_AREA_PROJECTION_DISPATCHED(compute_test, x.data(), result.data());
  for(int i = 0; i < 16; ++i) {
    // volatile keeps the compiler from fusing
    volatile Number root = std::sqrt(std::max(x[i], Number(0)));
    volatile Number square = x[i] * x[i], difference = square - root, product = root * x[i];
    volatile Number polynomial = product + difference;
    const bool is_within = x[i] >= 1 && x[i] <= 4;
    EXPECT_EQ(result[i], is_within ? polynomial : std::trunc(polynomial)) << "lane " << i;
    EXPECT_EQ((within >> i) & 1, unsigned(is_within)) << "lane " << i;
  }
}

TEST_P(Every_instruction_set, sums_chosen_integers_without_error)
{
  std::array<double, 16> x;
  std::array<std::int64_t, 16> weights;
  std::int64_t expected = 0;
  unsigned expected_bits = 0, bits = 0;
  for(unsigned i = 0; i < 16; ++i) {
    x[i] = 0.37 * (double(i) - 3);
    weights[i] = (std::int64_t(1) << (3 * i + 10)) + i;
    if(x[i] >= 1 && x[i] <= 4) {
      expected += weights[i];
      expected_bits |= 1u << i;
    }
  }
  EXPECT_EQ(CGAL_AREA_PROJECTION_DISPATCHED(sum_test, x.data(), weights.data(), &bits), expected);
  EXPECT_EQ(bits, expected_bits);
}

TEST_P(Every_instruction_set, computes_each_lane_as_a_single_number)
{
  expect_each_lane_as_a_single_number<float>();
  expect_each_lane_as_a_single_number<double>();
}

TEST_P(Every_instruction_set, stores_selected_lanes_one_after_the_other)
{
  std::array<std::int32_t, 16> x;
  for(int i = 0; i < 16; ++i)
    x[i] = 7 * i % 13 - 1;
  for(unsigned selected = 0; selected < 0x10000; selected += selected % 7 + 1) {
    std::vector<std::int32_t> expected, result(32);
    for(int i = 0; i < 16; ++i)
      if(selected >> i & 1)
        expected.push_back(std::clamp(x[i], 3, 9) + i);
    const int size =
        CGAL_AREA_PROJECTION_DISPATCHED(select_test, x.data(), selected, result.data());
    result.resize(std::size_t(size));
    ASSERT_EQ(result, expected) << selected;
  }
}

INSTANTIATE_TEST_SUITE_P(all, Every_instruction_set,
                         testing::ValuesIn(available_instruction_sets()),
                         [](const auto& set) { return "set_" + std::to_string(set.index); });

} // namespace
