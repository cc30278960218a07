// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_REFINE_CHAIN_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_REFINE_CHAIN_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

inline Point_3 to_point_3(const Eigen::Vector3d& p)
{
  return Point_3(p.x(), p.y(), p.z());
}

inline Vector_3 to_vector_3(const Eigen::Vector3d& v)
{
  return Vector_3(v.x(), v.y(), v.z());
}

inline double distance(const Centerline_vertex& a, const Centerline_vertex& b)
{
  return std::sqrt(squared_distance(a.point, b.point));
}

/// \brief a point of the cubic between two vertices that has their tangents (Hermite), as what is known of it.
///
/// Where a curve of a small angle is sampled at steps of `h`, the chord is wrong by `h²` times the curvature over 8, and
/// the cubic by `h⁴`.
inline Centerline_vertex between(const Centerline_vertex& a, const Centerline_vertex& b, double t)
{
  const Eigen::Vector3d p = to_eigen(a.point), q = to_eigen(b.point);
  const double length = (q - p).norm();
  const Eigen::Vector3d u = length * to_eigen(a.tangent), v = length * to_eigen(b.tangent);
  const double s = 1 - t;
  const Eigen::Vector3d point =
      s * s * (1 + 2 * t) * p + t * t * (1 + 2 * s) * q + s * s * t * u - t * t * s * v;
  const Eigen::Vector3d tangent = 6 * s * t * (q - p) + s * (s - 2 * t) * u + t * (t - 2 * s) * v;
  Centerline_vertex vertex = a.origin == Centerline_origin::FITTED ? b : a;
  const auto mean = [s, t](double x, double y) { return s * x + t * y; };
  vertex.point = to_point_3(point);
  vertex.tangent =
      to_vector_3(tangent.norm() > 0 ? Eigen::Vector3d(tangent.normalized()) : tangent);
  vertex.radius = mean(a.radius, b.radius);
  vertex.radius_low = mean(a.radius_low, b.radius_low);
  vertex.radius_high = mean(a.radius_high, b.radius_high);
  vertex.coverage = mean(a.coverage, b.coverage);
  vertex.mapt = mean(a.mapt, b.mapt);
  vertex.area = mean(a.area, b.area);
  vertex.perimeter = mean(a.perimeter, b.perimeter);
  vertex.inscribed_radius = mean(a.inscribed_radius, b.inscribed_radius);
  return vertex;
}

/// \brief appends what is between two vertices, without the first and with the last.
/// \param spacing of the vertices, in units of their radius
inline void append_curve(const Centerline_vertex& a, const Centerline_vertex& b, double spacing,
                         std::vector<Centerline_vertex>& chain)
{
  constexpr double most_pieces = 1000;
  const double step = spacing * std::min(a.radius, b.radius);
  const double pieces =
      step > 0 ? std::clamp(std::ceil(distance(a, b) / step), 1., most_pieces) : 1;
  for(int i = 1; i < int(pieces); ++i)
    chain.push_back(between(a, b, i / pieces));
  chain.push_back(b);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_REFINE_CHAIN_H
