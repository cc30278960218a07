// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Included once for each instruction set by `for_each_instruction_set.h`; guarded for each of them.
//
// The plain forms of the AVX-512 intrinsics make g++ warn of what they leave undefined; hence `maskz`.
//
// Several floats or integers side by side. `+ - * / < <= > >= & |` and `mask ? a : b` work lane by lane;
// a comparison gives integers, -1 where it holds and 0 elsewhere. Doubles and long integers have half as
// many lanes.

#if CGAL_AREA_PROJECTION_LANES == 16
#ifndef CGAL_AREA_PROJECTION_LANES_16
#define CGAL_AREA_PROJECTION_LANES_16
#define CGAL_AREA_PROJECTION_DEFINE_LANES
#endif
#elif CGAL_AREA_PROJECTION_LANES == 8
#ifndef CGAL_AREA_PROJECTION_LANES_8
#define CGAL_AREA_PROJECTION_LANES_8
#define CGAL_AREA_PROJECTION_DEFINE_LANES
#endif
#else
#ifndef CGAL_AREA_PROJECTION_LANES_4
#define CGAL_AREA_PROJECTION_LANES_4
#define CGAL_AREA_PROJECTION_DEFINE_LANES
#endif
#endif

#ifdef CGAL_AREA_PROJECTION_DEFINE_LANES
#undef CGAL_AREA_PROJECTION_DEFINE_LANES

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

constexpr int lanes = CGAL_AREA_PROJECTION_LANES;
constexpr int double_lanes = lanes / 2;

typedef float Floats __attribute__((vector_size(4 * CGAL_AREA_PROJECTION_LANES)));
typedef std::int32_t Ints __attribute__((vector_size(4 * CGAL_AREA_PROJECTION_LANES)));
typedef double Doubles __attribute__((vector_size(4 * CGAL_AREA_PROJECTION_LANES)));
/// what comparisons of doubles give; `long` or `long long`, as the compiler likes it.
using Longs = decltype(Doubles{} < Doubles{});
/// as many integers as there are doubles.
typedef std::int32_t Half_ints __attribute__((vector_size(2 * CGAL_AREA_PROJECTION_LANES)));

/// \name What a template over `Floats` or `Doubles` needs to know of them
/// `tiny` is far below the rounding of 1, and its cube is not zero.
/// @{
template <class Lanes>
struct Lanes_traits;

template <>
struct Lanes_traits<Floats>
{
  using Number = float;
  using Integers = Ints;
  static constexpr int size = lanes;
  static constexpr double tiny = 1e-12;
};

template <>
struct Lanes_traits<Doubles>
{
  using Number = double;
  using Integers = Half_ints;
  static constexpr int size = double_lanes;
  static constexpr double tiny = 1e-60;
};
/// @}

inline Floats all(float x)
{
  return x - Floats{};
}

inline Ints all(std::int32_t x)
{
  return x - Ints{};
}

inline Doubles all(double x)
{
  return x - Doubles{};
}

inline Longs all(std::int64_t x)
{
  return x - Longs{};
}

/// `x` rounded to the lanes of a template.
template <class Lanes>
inline Lanes all_of(double x)
{
  return all(typename Lanes_traits<Lanes>::Number(x));
}

inline Floats load(const float* from)
{
  Floats x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

inline Ints load(const std::int32_t* from)
{
  Ints x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

inline Doubles load(const double* from)
{
  Doubles x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

inline Longs load(const std::int64_t* from)
{
  Longs x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

/// loads as many integers as the lanes of a template.
template <class Lanes>
inline typename Lanes_traits<Lanes>::Integers load_integers(const std::int32_t* from)
{
  typename Lanes_traits<Lanes>::Integers x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

inline void store(Floats x, float* to)
{
  std::memcpy(to, &x, sizeof x);
}

inline void store(Ints x, std::int32_t* to)
{
  std::memcpy(to, &x, sizeof x);
}

inline void store(Half_ints x, std::int32_t* to)
{
  std::memcpy(to, &x, sizeof x);
}

inline void store(Doubles x, double* to)
{
  std::memcpy(to, &x, sizeof x);
}

/// 0, 1, 2, …
inline Floats steps()
{
  Floats x{};
  for(int i = 0; i < lanes; ++i)
    x[i] = float(i);
  return x;
}

inline Ints int_steps()
{
  Ints x{};
  for(int i = 0; i < lanes; ++i)
    x[i] = i;
  return x;
}

/// the same bits as integers, and back.
inline Ints bits(Floats x)
{
  return (Ints)x;
}

inline Floats from_bits(Ints x)
{
  return (Floats)x;
}

/// rounds towards zero.
inline Ints truncated(Floats x)
{
  return __builtin_convertvector(x, Ints);
}

inline Half_ints truncated(Doubles x)
{
  return __builtin_convertvector(x, Half_ints);
}

inline Floats to_floats(Ints x)
{
  return __builtin_convertvector(x, Floats);
}

/// integers as the numbers of a template.
inline Floats to_numbers(Ints x)
{
  return to_floats(x);
}

inline Doubles to_numbers(Half_ints x)
{
  return __builtin_convertvector(x, Doubles);
}

/// the smaller and the larger of two; the second, if one is not a number.
inline Floats min(Floats a, Floats b)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return (Floats)_mm512_maskz_min_ps(0xffff, (__m512)a, (__m512)b);
#elif CGAL_AREA_PROJECTION_LANES == 8
  return (Floats)_mm256_min_ps((__m256)a, (__m256)b);
#elif defined(__SSE2__)
  return (Floats)_mm_min_ps((__m128)a, (__m128)b);
#else
  return a < b ? a : b;
#endif
}

inline Floats max(Floats a, Floats b)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return (Floats)_mm512_maskz_max_ps(0xffff, (__m512)a, (__m512)b);
#elif CGAL_AREA_PROJECTION_LANES == 8
  return (Floats)_mm256_max_ps((__m256)a, (__m256)b);
#elif defined(__SSE2__)
  return (Floats)_mm_max_ps((__m128)a, (__m128)b);
#else
  return a > b ? a : b;
#endif
}

inline Doubles min(Doubles a, Doubles b)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return (Doubles)_mm512_maskz_min_pd(0xff, (__m512d)a, (__m512d)b);
#elif CGAL_AREA_PROJECTION_LANES == 8
  return (Doubles)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  return (Doubles)_mm_min_pd((__m128d)a, (__m128d)b);
#else
  return a < b ? a : b;
#endif
}

inline Doubles max(Doubles a, Doubles b)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return (Doubles)_mm512_maskz_max_pd(0xff, (__m512d)a, (__m512d)b);
#elif CGAL_AREA_PROJECTION_LANES == 8
  return (Doubles)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  return (Doubles)_mm_max_pd((__m128d)a, (__m128d)b);
#else
  return a > b ? a : b;
#endif
}

// SSE2 has no minimum of integers; compilers see what this is on others.
inline Ints min(Ints a, Ints b)
{
  return a < b ? a : b;
}

inline Ints max(Ints a, Ints b)
{
  return a > b ? a : b;
}

inline Floats sqrt(Floats x)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return (Floats)_mm512_maskz_sqrt_ps(0xffff, (__m512)x);
#elif CGAL_AREA_PROJECTION_LANES == 8
  return (Floats)_mm256_sqrt_ps((__m256)x);
#elif defined(__SSE2__)
  return (Floats)_mm_sqrt_ps((__m128)x);
#else
  for(int i = 0; i < lanes; ++i)
    x[i] = __builtin_sqrtf(x[i]);
  return x;
#endif
}

inline Doubles sqrt(Doubles x)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return (Doubles)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif CGAL_AREA_PROJECTION_LANES == 8
  return (Doubles)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__)
  return (Doubles)_mm_sqrt_pd((__m128d)x);
#else
  for(int i = 0; i < lanes / 2; ++i)
    x[i] = __builtin_sqrt(x[i]);
  return x;
#endif
}

/// a number whose bit `i` is set where a comparison holds in lane `i`.
inline unsigned mask(Ints comparison)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return unsigned(_mm512_movepi32_mask((__m512i)comparison));
#elif CGAL_AREA_PROJECTION_LANES == 8
  return unsigned(_mm256_movemask_ps((__m256)comparison));
#elif defined(__SSE2__)
  return unsigned(_mm_movemask_ps((__m128)comparison));
#else
  unsigned result = 0;
  for(int i = 0; i < lanes; ++i)
    result |= unsigned(comparison[i] != 0) << i;
  return result;
#endif
}

inline unsigned mask(Longs comparison)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  return unsigned(_mm512_movepi64_mask((__m512i)comparison));
#elif CGAL_AREA_PROJECTION_LANES == 8
  return unsigned(_mm256_movemask_pd((__m256d)comparison));
#elif defined(__SSE2__)
  return unsigned(_mm_movemask_pd((__m128d)comparison));
#else
  unsigned result = 0;
  for(int i = 0; i < double_lanes; ++i)
    result |= unsigned(comparison[i] != 0) << i;
  return result;
#endif
}

/// the sum of the lanes, exact and so the same for any number of them.
inline std::int64_t sum(Longs x)
{
  std::int64_t result = 0;
  for(int i = 0; i < double_lanes; ++i)
    result += x[i];
  return result;
}

/// \brief stores the lanes whose bits in `selected` are set, one after the other; what follows them in
/// the length of a vector is overwritten.
inline void store_selected(Ints x, unsigned selected, std::int32_t* to)
{
#if CGAL_AREA_PROJECTION_LANES == 16
  x = (Ints)_mm512_maskz_compress_epi32(__mmask16(selected), (__m512i)x);
  store(x, to);
#elif CGAL_AREA_PROJECTION_LANES == 8
  const __m256i order = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(selected_lanes.lane[selected].data())));
  store((Ints)_mm256_permutevar8x32_epi32((__m256i)x, order), to);
#else
  for(int i = 0; i < lanes; ++i) {
    *to = x[i];
    to += selected >> i & 1;
  }
#endif
}

/// the number of bits that are set in a mask.
inline int number_of_bits(unsigned mask)
{
#if CGAL_AREA_PROJECTION_LANES == 4
  return int(0x4332322132212110u >> 4 * mask & 15); // not every processor counts bits
#else
  return __builtin_popcount(mask);
#endif
}

/// the sum of the lanes, pairwise: in the same order for any number of threads, but not of lanes.
inline float sum(Floats x)
{
  float result = 0;
  for(int i = 0; i < lanes; ++i)
    result += x[i];
  return result;
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif
