// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_CREASE_NORMALS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_CREASE_NORMALS_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the normals of the corners of each triangle, smooth but at creases.
///
/// The normal of a corner is the mean, weighted by angle, of those faces around the vertex whose normals are within an
/// angle of that of the triangle. With the normals of the facets the balls of a torus are off by a third, with
/// these by less than a hundredth.
class Crease_normals
{
public:
  using Vector = Eigen::Vector3d;

  Crease_normals(const Triangle_surface& surface, double crease_angle)
      : m_surface(surface), m_joined(joined_points(surface)), m_begin(surface.points.size() + 1, 0)
  {
    for_each_corner([this](std::uint32_t v, std::size_t, int) { ++m_begin[v]; });
    std::uint32_t sum = 0;
    for(std::uint32_t& begin : m_begin)
      begin = sum += begin; // the end of the group, which becomes its beginning as it is filled
    m_corners.resize(3 * surface.size());
    for_each_corner([this](std::uint32_t v, std::size_t t, int i) {
      m_corners[--m_begin[v]] = {std::uint32_t(t), angle(t, i)};
    });
    m_least_cosine = std::cos(crease_angle * 3.14159265358979323846 / 180);
  }

  std::array<Vector, 3> operator()(std::size_t t) const
  {
    std::array<Vector, 3> normals;
    for(int i = 0; i < 3; ++i)
      normals[std::size_t(i)] =
          m_surface.has_interpolated_normals()
              ? to_eigen(m_surface.vertex_normals[m_surface.triangles[t][std::size_t(i)]])
              : corner_normal(t, i);
    return normals;
  }

private:
  struct Corner
  {
    std::uint32_t triangle;
    double angle;
  };

  template <class Function>
  void for_each_corner(Function&& function) const
  {
    for(std::size_t t = 0; t < m_surface.size(); ++t)
      for(int i = 0; i < 3; ++i)
        function(m_joined[m_surface.triangles[t][std::size_t(i)]], t, i);
  }

  double angle(std::size_t t, int i) const
  {
    const Vector p = to_eigen(m_surface.corner(t, i));
    const Vector a = to_eigen(m_surface.corner(t, (i + 1) % 3)) - p;
    const Vector b = to_eigen(m_surface.corner(t, (i + 2) % 3)) - p;
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  Vector corner_normal(std::size_t t, int i) const
  {
    constexpr std::uint32_t most_faces = 100; // around hubs of more each face keeps to itself
    const std::uint32_t v = m_joined[m_surface.triangles[t][std::size_t(i)]];
    const Vector own = to_eigen(m_surface.normals[t]);
    if(m_begin[v + 1] - m_begin[v] > most_faces)
      return own;
    Vector sum = Vector::Zero();
    for(std::uint32_t k = m_begin[v]; k < m_begin[v + 1]; ++k) {
      const Vector normal = to_eigen(m_surface.normals[m_corners[k].triangle]);
      if(normal.dot(own) >= m_least_cosine)
        sum += m_corners[k].angle * normal;
    }
    const double length = sum.norm();
    return length > 0 ? Vector(sum / length) : own;
  }

  const Triangle_surface& m_surface;
  std::vector<std::uint32_t> m_joined, m_begin;
  std::vector<Corner> m_corners; ///< grouped by vertex
  double m_least_cosine = 1;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_CREASE_NORMALS_H
