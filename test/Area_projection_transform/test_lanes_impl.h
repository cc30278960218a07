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

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
