// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SURFACE_MOMENTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SURFACE_MOMENTS_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief sums of numbers between -1 and 1, rounded to a quantum and added up as integers: their order has no
/// effect.
template <std::size_t number>
class Integer_sums
{
public:
  /// \param terms how many there will be in each sum
  explicit Integer_sums(std::size_t terms)
      : m_quanta(std::ldexp(1., 61 - int(std::ceil(std::log2(double(terms) + 1)))))
  {}

  void add(std::size_t i, double term) { m_sums[i] += std::int64_t(term * m_quanta); }

  double operator[](std::size_t i) const { return double(m_sums[i]) / m_quanta; }

private:
  double m_quanta;
  std::array<std::int64_t, number> m_sums{};
};

/// \brief the volume within a surface, and how its area spreads.
struct Surface_moments
{
  double signed_volume =
      0; ///< by the theorem of Gauss, if the surface is closed; negative if it faces inward
  double area = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of its area; up to a factor
};

/// the moments; the same bits for any order of the triangles.
inline Surface_moments surface_moments(const Triangle_surface& surface)
{
  const Bbox_3 box = surface.bbox();
  const Point_3 middle(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                       0.5 * (box.zmin() + box.zmax()));
  const double extent = std::max({box.x_span(), box.y_span(), box.z_span()});
  Surface_moments moments;
  if(surface.empty() || !(extent > 0) || !std::isfinite(extent))
    return moments;
  // In units in which corners are nowhere farther from the middle than 1/2 along an axis, and areas less than 1.
  Integer_sums<11> sums(surface.size());
  for(std::size_t t = 0; t < surface.size(); ++t) {
    std::array<Vector_3, 3> p;
    for(int i = 0; i < 3; ++i)
      p[std::size_t(i)] = (surface.corner(t, i) - middle) / extent;
    const double weight = 0.5 * std::sqrt(cross_product(p[1] - p[0], p[2] - p[0]).squared_length());
    sums.add(0, cross_product(p[0], p[1]) * p[2]);
    sums.add(1, weight);
    const Vector_3 sum = p[0] + p[1] + p[2];
    for(int a = 0, next = 5; a < 3; ++a) {
      sums.add(std::size_t(2 + a), weight * sum[a] / 3);
      for(int b = a; b < 3; ++b, ++next) // the second moments of a triangle, from its corners
        sums.add(std::size_t(next),
                 weight *
                     (sum[a] * sum[b] + p[0][a] * p[0][b] + p[1][a] * p[1][b] + p[2][a] * p[2][b]) /
                     12);
    }
  }
  moments.area = extent * extent * sums[1];
  moments.signed_volume = extent * extent * extent * sums[0] / 6;
  for(int a = 0, next = 5; a < 3; ++a)
    for(int b = a; b < 3; ++b, ++next)
      moments.covariance(a, b) = moments.covariance(b, a) =
          sums[std::size_t(next)] - sums[std::size_t(2 + a)] * sums[std::size_t(2 + b)] / sums[1];
  return moments;
}

/// \brief turns a surface so that its principal axes, of the least, the middle and the largest variance, lie along x, y
/// and z; which way they point is open, but for the handedness.
inline Triangle_surface along_principal_axes(Triangle_surface surface,
                                             const Eigen::Matrix3d& covariance)
{
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  if(axes.determinant() < 0)
    axes.col(0) = -axes.col(0);
  const std::array<Vector_3, 3> rows{Vector_3(axes(0, 0), axes(1, 0), axes(2, 0)),
                                     Vector_3(axes(0, 1), axes(1, 1), axes(2, 1)),
                                     Vector_3(axes(0, 2), axes(1, 2), axes(2, 2))};
  const auto turned = [&rows](const Vector_3& v) {
    return Vector_3(rows[0] * v, rows[1] * v, rows[2] * v);
  };
  for(Point_3& p : surface.points)
    p = CGAL::ORIGIN + turned(p - CGAL::ORIGIN);
  for(auto* vectors : {&surface.normals, &surface.vertex_normals})
    for(Vector_3& v : *vectors)
      v = turned(v);
  return surface;
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SURFACE_MOMENTS_H
