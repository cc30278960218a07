// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SHAPE_TOPOLOGY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SHAPE_TOPOLOGY_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Disjoint_sets.h>
#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/medial_complex/Betti_numbers.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief how the triangles of a surface are connected across their edges.
///
/// Corners that name different points are at the same vertex if those points are at the same place on the rim of a gap, as
/// in soups. A vertex in which a surface touches itself counts once for each fan of triangles around it.
struct Surface_connections
{
  std::size_t open_edges = 0;    ///< of one triangle
  std::size_t crowded_edges = 0; ///< of more than two
  std::size_t opposed_edges = 0; ///< that both triangles pass the same way
  std::size_t vertices = 0, edges = 0;
  std::vector<double>
      part_volumes; ///< of the connected parts, negative where the faces point inward

  explicit Surface_connections(const Triangle_surface& surface)
  {
    Disjoint_sets fans(3 * surface.size()), parts(surface.size());
    const std::vector<std::uint32_t> places = joined_points(surface);
    const auto corner_at = [&](std::uint32_t triangle, std::uint32_t place) {
      std::size_t i = 0;
      while(i < 2 && places[surface.triangles[triangle][i]] != place)
        ++i;
      return 3 * std::size_t(triangle) + i;
    };
    using Side = Edges_by_vertex::Side;
    Edges_by_vertex(surface, [&places](std::uint32_t i) {
      return places[i];
    }).all_edges([&](std::uint32_t lower, const Side* begin, const Side* end) {
      ++edges;
      open_edges += end - begin == 1;
      crowded_edges += end - begin > 2;
      opposed_edges += end - begin == 2 && begin[0].is_ascending == begin[1].is_ascending;
      for(const Side* side = begin + 1; side != end; ++side) {
        parts.unite(begin->face, side->face);
        for(const std::uint32_t place : {lower, begin->higher})
          fans.unite(corner_at(begin->face, place), corner_at(side->face, place));
      }
      return true;
    });
    vertices = fans.number();
    measure_parts(surface, parts);
  }

  bool is_closed_manifold() const
  {
    return edges > 0 && open_edges == 0 && crowded_edges == 0 && opposed_edges == 0;
  }

private:
  void measure_parts(const Triangle_surface& surface, Disjoint_sets& parts)
  {
    std::map<std::size_t, double> volumes;
    const Point_3 origin = surface.empty() ? Point_3(0, 0, 0) : surface.corner(0, 0);
    for(std::size_t t = 0; t < surface.size(); ++t)
      volumes[parts.find(t)] +=
          CGAL::volume(origin, surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
    for(const auto& [part, volume] : volumes)
      part_volumes.push_back(volume);
  }
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns the topology of the solid that a surface bounds.
///
/// A part of the surface whose faces point outward bounds a piece, one whose faces point inward a cavity. Nothing if the
/// surface is open, has edges of more than two faces, faces that are turned over, or is inside out.
inline std::optional<Betti_numbers> shape_topology(const Triangle_surface& surface)
{
  const internal::Surface_connections connections(surface);
  if(!connections.is_closed_manifold())
    return std::nullopt;
  Betti_numbers result;
  for(const double volume : connections.part_volumes)
    ++(volume > 0 ? result.components : result.cavities);
  if(result.components == 0)
    return std::nullopt;
  // The Euler number of a solid is half of that of its surface.
  const long euler_number =
      (long(connections.vertices) - long(connections.edges) + long(surface.size())) / 2;
  result.loops = result.components + result.cavities - euler_number;
  return result;
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// returns nothing: what points bound is unknown.
inline std::optional<Betti_numbers> shape_topology(const Surfels&)
{
  return std::nullopt;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SHAPE_TOPOLOGY_H
