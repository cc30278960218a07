// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FIXED_POINT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FIXED_POINT_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief areas as integers, so that sums do not depend on the order of their terms.
///
/// The quantum is a power of two with `total <= 2^30` quanta: sums fit a signed 32-bit integer.
class Fixed_point
{
public:
  explicit Fixed_point(double total)
      : m_exponent(total > 0 ? std::ilogb(total) + 1 - 30 : 0)
      , m_inverse(std::ldexp(1., -m_exponent))
  {}

  double quantum() const { return std::ldexp(1., m_exponent); }

  /// \brief rounds; areas of few quanta up or down, up as often as the fraction says.
  ///
  /// Equal areas of some quanta and a half would otherwise all be rounded the same way and bias the
  /// map of a mesh of many million equal faces. What decides is a hash of the position, so that the
  /// result depends on the surfel and not on its place in a list.
  std::uint32_t dithered(double area, const Point_3& position) const
  {
    return rounded(quanta(area), uniform(position));
  }

  double quanta(double area) const { return area * m_inverse; }

  /// of this many quanta and more, rounding changes areas by less than 1/8000.
  static constexpr double many = 4096;

  /// the same for quanta, and what `uniform()` says of the position.
  static std::uint32_t rounded(double quanta, double dither)
  {
    return wrap(std::int64_t(quanta + (quanta > many ? 0.5 : dither)));
  }

  /// a number in [0, 1) that looks random, from the bits of the coordinates.
  static double uniform(const Point_3& p)
  {
    std::uint64_t h = bits(p.x()) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ bits(p.y())) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 32) ^ bits(p.z())) * 0x94d049bb133111ebu;
    return double(h >> 40) * 0x1p-24;
  }

private:
  // Differences of runs are negative; arithmetic modulo 2^32 carries them.
  static std::uint32_t wrap(std::int64_t quanta) { return std::uint32_t(std::uint64_t(quanta)); }

  static std::uint64_t bits(double value)
  {
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof result);
    return result;
  }

  int m_exponent;
  double m_inverse;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FIXED_POINT_H
