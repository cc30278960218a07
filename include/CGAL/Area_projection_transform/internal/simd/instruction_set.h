// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIMD_INSTRUCTION_SET_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIMD_INSTRUCTION_SET_H

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Whether kernels are compiled for several instruction sets and chosen at run time. What the portable
/// kernel uses is up to the flags of the user in any case. Define it as 0 to compile one kernel only.
#ifndef CGAL_AREA_PROJECTION_DISPATCH
#if defined(__x86_64__) && defined(__GNUC__)
#define CGAL_AREA_PROJECTION_DISPATCH 1
#else
#define CGAL_AREA_PROJECTION_DISPATCH 0
#endif
#endif

namespace CGAL {
namespace Area_projection {
namespace internal {

/// how wide the kernels compute; all give the same bits.
enum class Instruction_set {
  PORTABLE, ///< 4 lanes, whatever the compiler makes of them
  AVX2,     ///< 8 lanes
  AVX512    ///< 16 lanes
};

inline const char* name(Instruction_set set)
{
  return std::array<const char*, 3>{"portable", "AVX2", "AVX-512"}[std::size_t(set)];
}

/// the instruction sets that this computer has and that kernels are compiled for, the best last.
inline std::vector<Instruction_set> available_instruction_sets()
{
  std::vector<Instruction_set> sets{Instruction_set::PORTABLE};
#if CGAL_AREA_PROJECTION_DISPATCH
  if(__builtin_cpu_supports("avx2"))
    sets.push_back(Instruction_set::AVX2);
  if(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    sets.push_back(Instruction_set::AVX512);
#endif
  return sets;
}

inline std::atomic<Instruction_set>& chosen_instruction_set()
{
  static std::atomic<Instruction_set> chosen{available_instruction_sets().back()};
  return chosen;
}

/// what kernels use: the best, unless a test or a benchmark has chosen another.
inline Instruction_set instruction_set()
{
  return chosen_instruction_set().load(std::memory_order_relaxed);
}

/// for each set of eight lanes, given by the bits of a number, its lanes in ascending order.
struct Selected_lanes
{
  std::array<std::array<std::uint8_t, 8>, 256> lane{};

  constexpr Selected_lanes()
  {
    for(std::size_t set = 0; set < 256; ++set) {
      std::size_t size = 0;
      for(std::size_t i = 0; i < 8; ++i)
        if(set >> i & 1)
          lane[set][size++] = std::uint8_t(i);
    }
  }
};

inline constexpr Selected_lanes selected_lanes;

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

/// \brief calls `function(arguments...)` compiled for the instruction set in use; `function` is defined by
/// a file that `for_each_instruction_set.h` has included.
#if CGAL_AREA_PROJECTION_DISPATCH
#define CGAL_AREA_PROJECTION_DISPATCHED(function, ...)                                             \
  (::CGAL::Area_projection::internal::instruction_set() ==                                         \
           ::CGAL::Area_projection::internal::Instruction_set::AVX512                              \
       ? ::CGAL::Area_projection::internal::avx512::function(__VA_ARGS__)                          \
   : ::CGAL::Area_projection::internal::instruction_set() ==                                       \
           ::CGAL::Area_projection::internal::Instruction_set::AVX2                                \
       ? ::CGAL::Area_projection::internal::avx2::function(__VA_ARGS__)                            \
       : ::CGAL::Area_projection::internal::portable::function(__VA_ARGS__))
#else
#define CGAL_AREA_PROJECTION_DISPATCHED(function, ...)                                             \
  ::CGAL::Area_projection::internal::portable::function(__VA_ARGS__)
#endif

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIMD_INSTRUCTION_SET_H
