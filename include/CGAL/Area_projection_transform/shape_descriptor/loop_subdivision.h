// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_LOOP_SUBDIVISION_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_LOOP_SUBDIVISION_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/internal/triangle_measures.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief divides each triangle of a surface into four, and smooths: one step of the scheme of Loop, for what is no mesh
/// as well: rims of holes, and edges of more than two triangles.
class Loop_subdivision
{
public:
  explicit Loop_subdivision(const Triangle_surface& surface)
      : m_surface(surface)
      , m_places(joined_points(surface))
      , m_rings(surface.points.size())
      , m_middles(surface.size(), {{0, 0, 0}})
  {
    const auto place_of = [this](std::uint32_t point) { return m_places[point]; };
    Edges_by_vertex(surface, place_of)
        .all_edges([this](std::uint32_t lower, const auto* begin, const auto* end) {
          add_edge(lower, begin, end);
          return true;
        });
  }

  Triangle_surface operator()() const
  {
    Triangle_surface result;
    for(std::size_t i = 0; i < m_surface.points.size(); ++i)
      result.points.push_back(CGAL::ORIGIN + moved(i));
    result.points.insert(result.points.end(), m_edge_points.begin(), m_edge_points.end());
    const std::uint32_t first = std::uint32_t(m_surface.points.size());
    for(std::size_t t = 0; t < m_surface.size(); ++t) {
      const auto& [a, b, c] = m_surface.triangles[t];
      const std::uint32_t ab = first + m_middles[t][0], bc = first + m_middles[t][1],
                          ca = first + m_middles[t][2];
      append(result, t, {m_places[a], ab, ca});
      append(result, t, {m_places[b], bc, ab});
      append(result, t, {m_places[c], ca, bc});
      append(result, t, {ab, bc, ca});
    }
    return result;
  }

private:
  /// the neighbours of a point: all, and those along rims.
  struct Ring
  {
    Vector_3 sum = Vector_3(0, 0, 0), sum_on_rim = Vector_3(0, 0, 0);
    int number = 0, number_on_rim = 0;
  };

  Vector_3 position(std::uint32_t point) const { return m_surface.points[point] - CGAL::ORIGIN; }

  template <class Side>
  void add_edge(std::uint32_t lower, const Side* begin, const Side* end)
  {
    const std::uint32_t higher = begin->higher;
    Vector_3 middle = 0.5 * (position(lower) + position(higher));
    if(end - begin == 2)
      middle = 0.75 * middle + 0.125 * (position(opposite(begin[0].face, lower, higher)) +
                                        position(opposite(begin[1].face, lower, higher)));
    for(const auto& [at, other] : {std::pair(lower, higher), std::pair(higher, lower)}) {
      Ring& ring = m_rings[at];
      ring.sum += position(other);
      ++ring.number;
      if(end - begin == 1) {
        ring.sum_on_rim += position(other);
        ++ring.number_on_rim;
      }
    }
    for(const Side* side = begin; side != end; ++side)
      m_middles[side->face][place_of_edge(side->face, lower, higher)] =
          std::uint32_t(m_edge_points.size());
    m_edge_points.push_back(CGAL::ORIGIN + middle);
  }

  /// which of the three edges of a triangle, each from a corner to the next, lies between two points.
  std::size_t place_of_edge(std::uint32_t face, std::uint32_t lower, std::uint32_t higher) const
  {
    const Triangle_surface::Triangle& t = m_surface.triangles[face];
    std::size_t i = 0;
    while(i < 2 && !(std::min(m_places[t[i]], m_places[t[i + 1]]) == lower &&
                     std::max(m_places[t[i]], m_places[t[i + 1]]) == higher))
      ++i;
    return i;
  }

  std::uint32_t opposite(std::uint32_t face, std::uint32_t lower, std::uint32_t higher) const
  {
    return m_surface.triangles[face][(place_of_edge(face, lower, higher) + 2) % 3];
  }

  Vector_3 moved(std::size_t point) const
  {
    const Vector_3 p = position(std::uint32_t(point));
    const Ring& ring = m_rings[point];
    if(ring.number_on_rim == 2)
      return 0.75 * p + 0.125 * ring.sum_on_rim;
    if(ring.number_on_rim != 0 || ring.number < 3)
      return p;
    const double c = 0.375 + 0.25 * std::cos(2 * 3.14159265358979323846 / ring.number);
    const double share = 0.625 - c * c; // of all neighbours
    return (1 - share) * p + share / ring.number * ring.sum;
  }

  /// a quarter of a triangle votes for its own area, or with the same factor as the whole where the user gave one.
  void append(Triangle_surface& result, std::size_t t,
              const Triangle_surface::Triangle& triangle) const
  {
    const double whole = 0.5 * std::sqrt(doubled_area_vector(m_surface, t).squared_length());
    const Point_3& a = result.points[triangle[0]];
    const double area = 0.5 * std::sqrt(cross_product(result.points[triangle[1]] - a,
                                                      result.points[triangle[2]] - a)
                                            .squared_length());
    append_triangle(result, triangle, m_surface.sources[t], nullptr,
                    whole > 0 ? area * (m_surface.areas[t] / whole) : 0);
  }

  const Triangle_surface& m_surface;
  std::vector<std::uint32_t> m_places;
  std::vector<Ring> m_rings;
  std::vector<std::array<std::uint32_t, 3>>
      m_middles; ///< for each edge of a triangle, an edge point
  std::vector<Point_3> m_edge_points;
};

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_LOOP_SUBDIVISION_H
