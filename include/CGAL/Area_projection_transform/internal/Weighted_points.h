// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WEIGHTED_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WEIGHTED_POINTS_H

#include <CGAL/Area_projection_transform/Projected_surfels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a point whose weight is a number of quanta; see `Weight_quantum`.
struct Weighted_point
{
  double position[3];
  std::int64_t weight;
};

/// \brief a ball that a point belongs to if its squared distance, computed in double and added up in
/// the order of the axes, is at most the square of the radius: as `CGAL::Fuzzy_sphere` decides it.
struct Weighted_points_ball
{
  double center[3];
  double squared_radius;
};

template <class Point>
Weighted_points_ball ball_around(const Point& center, double radius)
{
  const Point_3 c = to_point(center);
  return {{c.x(), c.y(), c.z()}, radius * radius};
}

/// \brief the unit in which weights are counted.
///
/// Sums of integers are the same for any order of their terms: of the points, of the nodes of a tree, of
/// lanes and threads, and whether terms are added or sums subtracted. The quantum is a power of two with
/// a total of about `2^61` quanta, so that a weight is rounded by less than `2^-61` of the total, and whole
/// numbers that sum to less than `2^53` not at all.
class Weight_quantum
{
public:
  /// \param weights are finite and not negative, fewer than `2^32`.
  explicit Weight_quantum(const std::vector<double>& weights)
  {
    const double largest = weights.empty() ? 0 : *std::max_element(weights.begin(), weights.end());
    if(!(largest > 0))
      return;
    // The total in units of 2^-30 of the largest: an integer as well, so that the order has no say.
    const int coarse = std::ilogb(largest) - 29;
    const Scale coarsely(-coarse);
    std::int64_t total = 0;
    for(double weight : weights)
      total += std::int64_t(coarsely(weight)) + 1;
    m_exponent = coarse + std::ilogb(double(total)) - 61;
    m_to_quanta = Scale(-m_exponent);
  }

  std::int64_t quanta(double weight) const { return std::llrint(m_to_quanta(weight)); }

  double weight(std::int64_t quanta) const { return std::ldexp(double(quanta), m_exponent); }

private:
  /// multiplies by a power of two, in two steps since one may be too large for a double.
  struct Scale
  {
    explicit Scale(int exponent = 0)
        : first(std::ldexp(1., exponent / 2)), second(std::ldexp(1., exponent - exponent / 2))
    {}
    double operator()(double x) const { return x * first * second; }
    double first, second;
  };

  int m_exponent = 0;
  Scale m_to_quanta;
};

inline std::vector<Weighted_point> weighted_points(const Projected_surfels& surfels,
                                                   const Weight_quantum& quantum)
{
  std::vector<Weighted_point> points(surfels.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Point_3& p = surfels.positions[i];
    points[i] = {{p.x(), p.y(), p.z()}, quantum.quanta(surfels.areas[i])};
  }
  return points;
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WEIGHTED_POINTS_H
