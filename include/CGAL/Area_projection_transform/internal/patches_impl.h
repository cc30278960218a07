// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Adds patches to the voxels around them; compiled for each instruction set, see add_patches.h.
//
// Let a voxel lie at `e` from the mean of a piece of surface with covariance `C`, `d = |e|`. A point of the
// piece, at `δ` from the mean, is in the ball of radius `r` around the voxel if its component along `e` is
// more than `d - ρ`, where `ρ² = r² - |component of δ across e|²`: in the mean `r² - tr C + eᵀCe/d²`. The
// standard deviation of that component is `s = sqrt(eᵀCe)/d`. So the share of the piece in the ball is
// its cumulative distribution at `(ρ - d)/s = (ρ - d) d / sqrt(eᵀCe)`.
//
// Near the rim, where it matters, `(ρ - d) d = m - m²/(2 b)` to third order, with `m = (ρ² - d²)/2` and
// `b = r² - tr C`; with `u = m/(2 b)` that is `2 b u (1 - u)`. Over a ramp of `sqrt(20)` standard deviations
// (see Patch.h) the distribution goes from 0 to 1 around `t = 1/2 + u (1 - u)/sqrt(2 q)`, where
// `q = 5/(2 b²) eᵀCe` and, with `eᵀCe/d²` taken at the rim, `u = 1/4 + q/10 - d²/(4 b)`. Along a row of voxels
// `q` and `u` are quadratic polynomials.

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// 1/sqrt(2 x) for positive x, between 0 and 0.18 percent too small.
inline Floats reciprocal_sqrt_of_double(Floats x)
{
  const Floats guess = from_bits(0x5ef759df - (bits(x) >> 1));
  return guess * (1.5f - x * guess * guess);
}

/// what is the same for all voxels of a patch.
struct Patch_constants
{
  Floats x, q2, u2, double_amount, triple_amount;
  Ints full; ///< the amount, rounded like the others

  explicit Patch_constants(const Patch& p)
      : x(all(p.x))
      , q2(all(p.xx))
      , u2(all(0.1f * p.xx - p.quarter))
      , double_amount(all(2 * p.amount))
      , triple_amount(all(3 * p.amount))
      , full(truncated((triple_amount - double_amount) + 0.5f))
  {}
};

/// what is the same for all voxels of a row: `q = q0 + x (q1 + x q2)` and `u = u0 + x (u1 + x u2)`.
struct Row_constants
{
  Floats q0, q1, u0, u1;
};

/// adds to `lanes` voxels, the first of which is `voxel`, their shares.
inline void add_shares(const Patch_constants& patch, const Row_constants& row, int voxel,
                       std::int32_t* values)
{
  const Floats x = (steps() + float(voxel)) - patch.x;
  const Floats q = row.q0 + x * (row.q1 + x * patch.q2);
  const Floats u = row.u0 + x * (row.u1 + x * patch.u2);
  const Floats t = 0.5f + (u - u * u) * reciprocal_sqrt_of_double(q);
  const Floats w = min(max(t, all(0.f)), all(1.f));
  const Floats amount = w * w * (patch.triple_amount - patch.double_amount * w);
  store(load(values + voxel) + truncated(amount + 0.5f), values + voxel);
}

/// up to `lanes` rows of a patch, side by side.
struct Rows_of_patch
{
  float q0[lanes], q1[lanes], u0[lanes], u1[lanes];
  std::int32_t begin[lanes], end[lanes];           ///< the voxels within reach
  std::int32_t full_begin[lanes], full_end[lanes]; ///< those that hold all of a large patch
};

/// \param values those of the row, from the voxel nearest to the mean on
inline void add_row(const Patch_constants& patch, const Rows_of_patch& rows, int r, bool is_large,
                    std::int32_t* values)
{
  const Row_constants row{all(rows.q0[r]), all(rows.q1[r]), all(rows.u0[r]), all(rows.u1[r])};
  const int end = rows.end[r];
  int voxel = rows.begin[r];
  if(is_large) {
    for(; voxel < rows.full_begin[r]; voxel += lanes)
      add_shares(patch, row, voxel, values);
    for(; voxel + lanes <= rows.full_end[r]; voxel += lanes)
      store(load(values + voxel) + patch.full, values + voxel);
  }
  for(; voxel < end; voxel += lanes)
    add_shares(patch, row, voxel, values);
}

/// rounds down what is not less than `least`, a whole number.
inline Floats rounded_down(Floats x, float least)
{
  return to_floats(truncated(x - least)) + least;
}

/// \brief the rows from `j` on of a layer at `z` from the mean; `at` is the index of the first of them.
inline void set_rows(const Row_arrays& arrays, const Patch& p, int j, float z, std::size_t at,
                     bool is_large, Rows_of_patch& rows)
{
  const Floats y = (steps() + float(j - p.j)) - p.y;
  const Floats squared = y * y + z * z;
  const Floats q0 = y * (p.yy * y + 2 * p.yz * z) + (p.zz * z * z + p.least_q);
  const Floats q1 = 2 * p.xy * y + 2 * p.xz * z;
  store(q0, rows.q0);
  store(q1, rows.q1);
  store((0.25f - p.quarter * squared) + 0.1f * q0, rows.u0);
  store(0.1f * q1, rows.u1);

  const float least = -2.f - float(int(p.reach));
  const Floats half = sqrt(max(p.reach * p.reach - squared, all(0.f)));
  const Floats begin = max(-rounded_down(half - p.x, least), load(arrays.first + at) - float(p.i));
  const Floats end =
      min(rounded_down(half + p.x, least) + 1.f, load(arrays.last + at) - float(p.i));
  store(truncated(begin), rows.begin);
  store(truncated(end), rows.end);
  if(is_large) {
    const Floats full = sqrt(max(p.full * p.full - squared, all(0.f)));
    // A hull may end before the voxels that hold all.
    store(truncated(min(max(-rounded_down(full - p.x, least), begin), end)), rows.full_begin);
    store(truncated(min(rounded_down(full + p.x, least) + 1.f, end)), rows.full_end);
  }
}

/// a bit for each of the rows from index `at` on whose hull meets the interval.
inline unsigned rows_that_meet(const Row_arrays& arrays, std::size_t at, float low, float high)
{
  return mask((load(arrays.first + at) <= high) & (load(arrays.last + at) >= low));
}

inline void add_layer(const Row_arrays& arrays, const Patch& p, const Patch_constants& patch,
                      int layer)
{
  const float z = float(layer - p.k) - p.z;
  const float squared_half = p.reach * p.reach - z * z;
  if(!(squared_half >= 0))
    return;
  const float half = __builtin_sqrtf(squared_half);
  const int first = p.j - int(half - p.y), last = p.j + int(half + p.y);
  const int begin = first > 0 ? first : 0, end = last < arrays.rows ? last + 1 : arrays.rows;
  const float nearest = float(p.i) + p.x, wide = half + 0.02f; // floats resolve a hundredth here
  const bool is_large = p.full > lanes;
  for(int j = begin; j < end; j += lanes) {
    const std::size_t at = std::size_t(j) + arrays.stride * std::size_t(layer);
    // Most rows within reach have no voxel of interest in the way of the ball.
    unsigned live = rows_that_meet(arrays, at, nearest - wide, nearest + wide);
    if(end - j < lanes)
      live &= (1u << (end - j)) - 1;
    if(live == 0)
      continue;
    Rows_of_patch rows;
    set_rows(arrays, p, j, z, at, is_large, rows);
    for(; live != 0; live &= live - 1) {
      const int r = __builtin_ctz(live);
      add_row(patch, rows, r, is_large, arrays.values + (arrays.place[at + std::size_t(r)] + p.i));
    }
  }
}

inline void add_patches(const Row_arrays& arrays, const Patch* patches, std::size_t number)
{
  for(const Patch* p = patches; p != patches + number; ++p) {
    const Patch_constants constants(*p);
    const int first = p->k - int(p->reach - p->z), last = p->k + int(p->reach + p->z);
    const int begin = first > 0 ? first : 0, end = last < arrays.layers ? last + 1 : arrays.layers;
    for(int layer = begin; layer < end; ++layer)
      add_layer(arrays, *p, constants, layer);
  }
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
