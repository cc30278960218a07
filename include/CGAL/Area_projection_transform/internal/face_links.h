// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FACE_LINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FACE_LINKS_H

#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>
#include <CGAL/Area_projection_transform/internal/Heat_flow.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/internal/triangle_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief links the triangles of a surface that are neighbours: across their common edges, and
/// across gaps.
///
/// Where faces are missing, those on either side of a gap are linked at the vertices of its rim, as
/// well as a missing face would have linked them: a mesh keeps its conductance on the large when
/// faces are removed at random. Of very many faces at an edge or a rim vertex only the first few
/// are linked, so that the cost is `O(n log n)` for any `n` faces.
class Face_linker
{
public:
  explicit Face_linker(const Triangle_surface& surface)
      : m_surface(surface), m_areas(geometric_areas(surface)), m_links(surface.size())
  {
    const std::vector<std::uint32_t> places = joined_points(surface);
    std::vector<Corner> rim;
    Edges_by_vertex(surface, [&places](std::uint32_t i) {
      return places[i];
    }).all_edges([&](std::uint32_t lower, const Side* begin, const Side* end) {
      if(end - begin == 1) {
        rim.push_back({lower, begin->face});
        rim.push_back({begin->higher, begin->face});
      } else
        link_across_edge(lower, begin, end);
      return true;
    });
    std::sort(rim.begin(), rim.end());
    for(auto begin = rim.begin(); begin != rim.end();) {
      const auto end = std::find_if(begin, rim.end(),
                                    [begin](const Corner& c) { return c.first != begin->first; });
      link_across_gaps(begin, end);
      begin = end;
    }
  }

  Heat_flow flow() && { return Heat_flow(m_areas, std::move(m_links)); }

private:
  using Side = Edges_by_vertex::Side;
  using Corner = std::pair<std::uint32_t, std::uint32_t>; // vertex and face

  /// \brief links all pairs of faces at an edge, up to a number that only broken meshes have.
  ///
  /// The conductance is the length of the edge over the sum of the distances of the two centroids from
  /// it, which are a third of the heights.
  void link_across_edge(std::uint32_t lower, const Side* begin, const Side* end)
  {
    constexpr std::ptrdiff_t most_faces = 8;
    constexpr double largest = 1e3; // between needles: they need not be coupled better
    end = std::min(end, begin + most_faces);
    const double squared_length =
        squared_distance(m_surface.points[lower], m_surface.points[begin->higher]);
    for(const Side* a = begin; a != end; ++a)
      for(const Side* b = a + 1; b != end; ++b)
        if(a->face != b->face) {
          const double area = m_areas[a->face] + m_areas[b->face];
          const double conductance =
              area > 0 ? std::min(1.5 * squared_length / area, largest) : largest;
          m_links.add(a->face, b->face, conductance / double(end - begin - 1));
        }
  }

  /// \brief links the faces at a vertex that have an edge of the rim there.
  ///
  /// An equilateral face links its three neighbours with sqrt(3) to itself, which is sqrt(1/3) between
  /// each two of them. Gaps of an unknown order share what each would have alone.
  void link_across_gaps(std::vector<Corner>::iterator begin, std::vector<Corner>::iterator end)
  {
    constexpr std::ptrdiff_t most_faces = 16;
    end = std::min(end, begin + most_faces);
    const double conductance = 2 / (std::sqrt(3.) * double(end - begin));
    for(auto a = begin; a != end; ++a)
      for(auto b = a + 1; b != end; ++b)
        if(a->second != b->second)
          m_links.add(a->second, b->second, conductance);
  }

  const Triangle_surface& m_surface;
  std::vector<double> m_areas;
  Heat_flow::Links m_links;
};

/// the flow of heat from triangle to triangle.
inline Heat_flow flow_between_elements(const Triangle_surface& surface)
{
  return Face_linker(surface).flow();
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_FACE_LINKS_H
