// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_COLLAPSE_TETRAHEDRA_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_COLLAPSE_TETRAHEDRA_H

#include <CGAL/Area_projection_transform/medial_complex/Dual_complex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief makes sheets of the tetrahedra of a complex: takes away one after the other, each together with a triangle that
/// belongs to it alone, until none is left.
///
/// Each of these steps keeps the homotopy type. In space there is always a next one: of any tetrahedra, those at their
/// border have a triangle of their own. Triangles in whose cells the balls overlap least go first.
class Tetrahedron_collapser
{
public:
  Tetrahedron_collapser(Dual_complex& complex, const std::vector<Point_3>& centers,
                        const std::vector<double>& radii)
      : m_complex(complex)
      , m_is_gone(complex.triangles.size(), false)
      , m_is_dissolved(complex.tetrahedra.size(), false)
      , m_tetrahedra(complex.triangles.size(), {none, none})
  {
    for(std::size_t t = 0; t < complex.tetrahedra.size(); ++t)
      for(const std::size_t f : triangles_of(t))
        m_tetrahedra[f][m_tetrahedra[f][0] != none] = t;
    for(const Dual_complex::Triangle& triangle : complex.triangles)
      m_depths.push_back(depth(triangle, centers, radii));
  }

  void run()
  {
    for(std::size_t f = 0; f < m_complex.triangles.size(); ++f)
      push_if_free(f);
    while(!m_queue.empty()) {
      const std::size_t f = m_queue.top().triangle;
      m_queue.pop();
      const std::size_t t = only_tetrahedron(f);
      if(t == none)
        continue;
      m_is_gone[f] = m_is_dissolved[t] = true;
      for(const std::size_t other : triangles_of(t))
        push_if_free(other);
    }
    std::size_t left = 0;
    for(std::size_t f = 0; f < m_complex.triangles.size(); ++f)
      if(!m_is_gone[f])
        m_complex.triangles[left++] = m_complex.triangles[f];
    m_complex.triangles.resize(left);
    m_complex.tetrahedra.clear();
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  struct Candidate
  {
    double depth;
    std::size_t triangle;
    bool operator<(const Candidate& other) const
    {
      return depth > other.depth || (depth == other.depth && triangle > other.triangle);
    }
  };

  /// \brief how deep the balls of a triangle overlap: minus the squared radius of the smallest sphere that is orthogonal to
  /// all.
  ///
  /// With the first centre as the origin and the plane of the others, its centre solves two linear equations.
  static double depth(const Dual_complex::Triangle& triangle, const std::vector<Point_3>& centers,
                      const std::vector<double>& radii)
  {
    const Vector_3 u = centers[triangle[1]] - centers[triangle[0]],
                   v = centers[triangle[2]] - centers[triangle[0]];
    const auto weight = [&](int i) { return radii[triangle[i]] * radii[triangle[i]]; };
    const double uu = u * u, uv = u * v, vv = v * v, determinant = uu * vv - uv * uv;
    const double a = (uu + weight(0) - weight(1)) / 2, b = (vv + weight(0) - weight(2)) / 2;
    const double s = (a * vv - b * uv) / determinant, t = (b * uu - a * uv) / determinant;
    const double result = weight(0) - (s * u + t * v).squared_length();
    return std::isfinite(result) ? result : -std::numeric_limits<double>::max(); // no triangle
  }

  std::array<std::size_t, 4> triangles_of(std::size_t t) const
  {
    const Dual_complex::Tetrahedron& c = m_complex.tetrahedra[t];
    const auto place = [this](const Dual_complex::Triangle& triangle) {
      const auto& all = m_complex.triangles;
      return std::size_t(std::lower_bound(all.begin(), all.end(), triangle) - all.begin());
    };
    return {place({c[1], c[2], c[3]}), place({c[0], c[2], c[3]}), place({c[0], c[1], c[3]}),
            place({c[0], c[1], c[2]})};
  }

  std::size_t only_tetrahedron(std::size_t f) const
  {
    const auto is_left = [&](std::size_t t) { return t != none && !m_is_dissolved[t]; };
    const auto [first, second] = m_tetrahedra[f];
    if(m_is_gone[f] || is_left(first) == is_left(second))
      return none;
    return is_left(first) ? first : second;
  }

  void push_if_free(std::size_t f)
  {
    if(only_tetrahedron(f) != none)
      m_queue.push({m_depths[f], f});
  }

  Dual_complex& m_complex;
  std::vector<bool> m_is_gone;                          ///< triangles
  std::vector<bool> m_is_dissolved;                     ///< tetrahedra
  std::vector<std::array<std::size_t, 2>> m_tetrahedra; ///< on the sides of each triangle
  std::vector<double> m_depths;
  std::priority_queue<Candidate> m_queue;
};

inline void collapse_tetrahedra(Dual_complex& complex, const std::vector<Point_3>& centers,
                                const std::vector<double>& radii)
{
  Tetrahedron_collapser(complex, centers, radii).run();
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_COLLAPSE_TETRAHEDRA_H
