// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_HISTOGRAM_DISTANCE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_HISTOGRAM_DISTANCE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief distances between histograms `h` and `k`; logarithms are natural, and `0 log 0 = 0`.
enum class Distance_kind {
  /// \brief the Jeffrey divergence of Puzicha et al., which the paper takes: `Σ h log(h/m) + k log(k/m)` with
  /// `m = (h + k)/2`. Twice the Jensen–Shannon divergence, at most `2 log 2` where both sum to 1. (Not the symmetric
  /// divergence of Kullback and Leibler, which has this name as well.)
  JEFFREY,
  /// \brief the sum over the blocks (the radii) of the Jensen–Shannon distance, `sqrt(J/2)` with the Jeffrey divergence
  /// `J` of that block: a metric. Also for tables of pairs.
  JENSEN_SHANNON,
  CHI_SQUARED, ///< `Σ (h - k)² / (h + k)`
  L1,          ///< `Σ |h - k|`: a metric
  /// \brief the sum over the blocks of the work that it takes to turn one histogram into the other, the step between
  /// neighbouring bins being 1: a metric. Of no meaning for tables of pairs, whose cells are no line.
  EARTH_MOVER
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief `(1 + x) log(1 + x) + (1 - x) log(1 - x)` for `u = x²`, 0 ≤ u ≤ 1.
///
/// With `m = (h + k)/2` and `x = (h - k)/(h + k)` a term of the Jeffrey divergence is `m` times this. So it is never
/// negative, and has all its digits where the histograms hardly differ.
inline double jeffrey_factor(double u)
{
  constexpr double largest = 0.0625;
  if(u <= largest) { // the series Σ uⁿ / (n (2n - 1)), to the last bit
    constexpr std::array<double, 11> inverse = {1,        1. / 6,   1. / 15, 1. / 28,
                                                1. / 45,  1. / 66,  1. / 91, 1. / 120,
                                                1. / 153, 1. / 190, 1. / 231};
    double sum = 1. / 276;
    for(std::size_t n = inverse.size(); n-- > 0;)
      sum = inverse[n] + u * sum;
    return u * sum;
  }
  const double x = std::sqrt(u), more = 1 + x, less = 1 - x;
  return more * std::log(more) + (less > 0 ? less * std::log(less) : 0.);
}

inline double jeffrey_term(double h, double k)
{
  const double sum = h + k;
  if(!(sum > 0))
    return 0;
  const double x = (h - k) / sum;
  return 0.5 * sum * jeffrey_factor(x * x);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief compares two descriptors.
///
/// Symmetric, not negative, and zero for equal ones. `metric()` turns it into a metric, if it is not one already:
/// the triangle inequality then holds, and the order of distances is the same.
class Histogram_distance
{
public:
  /// \param kind which distance
  /// \param dimension the length of a descriptor
  /// \param block_size the length of its blocks, which only `JENSEN_SHANNON` and `EARTH_MOVER` know of
  /// \throw std::invalid_argument if `dimension` is not a positive multiple of `block_size`
  Histogram_distance(Distance_kind kind, std::size_t dimension, std::size_t block_size)
      : m_kind(kind), m_dimension(dimension), m_block_size(block_size)
  {
    if(dimension == 0 || block_size == 0 || dimension % block_size != 0)
      throw std::invalid_argument("dimension is " + std::to_string(dimension) +
                                  ": must be a positive multiple of block_size, " +
                                  std::to_string(block_size));
  }

  /// the kind of distance.
  Distance_kind kind() const { return m_kind; }
  /// how many numbers a descriptor has.
  std::size_t dimension() const { return m_dimension; }
  /// how many of them belong together.
  std::size_t block_size() const { return m_block_size; }

  /// \brief the distance of two descriptors.
  /// \param a one of them, `dimension()` numbers
  /// \param b the other one
  /// \param limit where it is larger, any number that is larger than `limit` may be returned
  double operator()(const float* a, const float* b,
                    double limit = std::numeric_limits<double>::infinity()) const
  {
    double sum = 0;
    for(std::size_t begin = 0; begin < m_dimension && sum <= limit; begin += m_block_size)
      sum += of_block(a + begin, b + begin);
    return sum;
  }

  /// a metric that orders shapes as `distance` does: the root of it, for those that are squares by nature.
  double metric(double distance) const
  {
    return m_kind == Distance_kind::JEFFREY || m_kind == Distance_kind::CHI_SQUARED
               ? std::sqrt(distance)
               : distance;
  }

private:
  double of_block(const float* a, const float* b) const
  {
    const auto sum_of = [&](auto term) {
      double sum = 0;
      for(std::size_t i = 0; i < m_block_size; ++i)
        sum += term(double(a[i]), double(b[i]));
      return sum;
    };
    switch(m_kind) {
    case Distance_kind::JEFFREY:
      return sum_of(internal::jeffrey_term);
    case Distance_kind::JENSEN_SHANNON:
      return std::sqrt(0.5 * sum_of(internal::jeffrey_term));
    case Distance_kind::CHI_SQUARED:
      return sum_of(
          [](double h, double k) { return h + k > 0 ? (h - k) * (h - k) / (h + k) : 0.; });
    case Distance_kind::L1:
      return sum_of([](double h, double k) { return std::abs(h - k); });
    case Distance_kind::EARTH_MOVER:
      break;
    }
    double moved = 0;
    return sum_of([&moved](double h, double k) { return std::abs(moved += h - k); });
  }

  Distance_kind m_kind;
  std::size_t m_dimension, m_block_size;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_HISTOGRAM_DISTANCE_H
