// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A kernel that uses every operation on lanes; see test_lanes.cpp.

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// 16 results for 16 numbers, and the bits that tell which are in [1, 4].
inline unsigned compute_test(const float* from, float* to)
{
  unsigned bits_of_all = 0;
  for(int i = 0; i < 16; i += lanes) {
    const Floats x = load(from + i);
    const Floats root = sqrt(max(x, all(0.f)));
    // Fused and separate multiplication and addition round differently here.
    const Floats polynomial = root * x + (x * x - root) + steps() * all(0.f);
    const Ints whole = truncated(min(polynomial, all(1e6f)));
    const Ints is_within = (x >= 1.f) & (x <= 4.f);
    bits_of_all |= mask(is_within) << i;
    store(is_within ? polynomial : to_floats(whole), to + i);
  }
  return bits_of_all;
}

/// the sum of those of 16 weights whose numbers are in [1, 4], and which these are, as bits.
inline std::int64_t sum_test(const double* numbers, const std::int64_t* weights, unsigned* within)
{
  Longs total = all(std::int64_t(0));
  *within = 0;
  for(int i = 0; i < 16; i += double_lanes) {
    const Doubles x = load(numbers + i);
    const Longs is_within = max(min(x, all(4.)), all(1.)) == x;
    total += load(weights + i) & is_within;
    *within |= mask(is_within) << i;
  }
  return sum(total);
}

/// the same for doubles.
inline unsigned compute_test(const double* from, double* to)
{
  unsigned bits_of_all = 0;
  constexpr int size = Lanes_traits<Doubles>::size;
  for(int i = 0; i < 16; i += size) {
    const Doubles x = load(from + i);
    const Doubles root = sqrt(max(x, all(0.)));
    const Doubles polynomial = root * x + (x * x - root);
    const Half_ints whole = truncated(min(polynomial, all_of<Doubles>(1e6)));
    const Longs is_within = (x >= 1.) & (x <= 4.);
    bits_of_all |= mask(is_within) << i;
    store(is_within ? polynomial : to_numbers(whole), to + i);
  }
  return bits_of_all;
}

/// \brief 16 integers, cut off at 3 and 9 and increased by their place, but those of `selected` only.
/// \return how many
inline int select_test(const std::int32_t* from, unsigned selected, std::int32_t* to)
{
  int size = 0;
  for(int i = 0; i < 16; i += lanes) {
    const unsigned some = selected >> i & ((1u << lanes) - 1);
    const Ints x = min(max(load(from + i), all(3)), all(9));
    store_selected(x + int_steps() + i, some, to + size);
    size += number_of_bits(some);
  }
  return size;
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
