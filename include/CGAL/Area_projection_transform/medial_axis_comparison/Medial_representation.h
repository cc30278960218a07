// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_REPRESENTATION_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_REPRESENTATION_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/internal/Disjoint_sets.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_complex.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief what all medial axes, skeletons and centrelines have in common: balls, and what connects them.
///
/// Whatever can be written down like that can be compared. Lengths are in the units of the surface.
struct Medial_representation
{
  std::string name;                                    ///< of it in tables
  std::vector<Point_3> centers;                        ///< of the balls
  std::vector<double> radii;                           ///< one for each centre
  std::vector<std::array<std::uint32_t, 2>> edges;     ///< positions in `centers`; none if unknown
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< positions in `centers`; none of lines
  std::optional<Betti_numbers> topology;               ///< nothing if the connections are unknown
  double seconds = 0; ///< what it took to find it, from the surface on

  /// the number of balls.
  std::size_t size() const { return centers.size(); }
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief represents some medial balls, connected as `medial_complex()` connects them.
/// \param name of the result
/// \param balls all of them
/// \param selected positions in `balls`
/// \param growth of the balls for their connections, see `crack_width()`
/// \param use_refitted whether balls are where the surface around them comes together
/// (`Medial_ball::refitted_center`, `Medial_ball::refitted_radius`), which withstands noise, instead of where they touch
/// \throw std::invalid_argument if one of `selected` is out of range, or as `medial_complex()` does
inline Medial_representation medial_representation(const std::string& name,
                                                   const std::vector<Medial_ball>& balls,
                                                   const std::vector<std::size_t>& selected,
                                                   double growth = 0, bool use_refitted = false)
{
  Medial_representation result;
  result.name = name;
  for(const std::size_t i : selected) {
    internal::check_selected(i, balls);
    const Medial_ball& ball = balls[i];
    result.centers.push_back(use_refitted ? ball.refitted_center : ball.center);
    result.radii.push_back(use_refitted ? ball.refitted_radius : ball.radius);
  }
  Medial_complex complex = medial_complex(result.centers, result.radii, growth);
  result.edges = std::move(complex.edges);
  result.triangles = std::move(complex.triangles);
  result.topology = complex.topology;
  return result;
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief represents a curve skeleton: a graph with the places of its vertices in `graph[v].point`, as those of
/// \cgal and of `centerlines()` have them.
/// \tparam Graph a model of `VertexListGraph` and `EdgeListGraph` whose vertices are numbers from 0 on
/// \param name of the result
/// \param graph the skeleton
/// \param radius_of tells the radius at a vertex, in the units of its places
template <class Graph, class RadiusOfVertex>
Medial_representation skeleton_representation(const std::string& name, const Graph& graph,
                                              const RadiusOfVertex& radius_of)
{
  Medial_representation result;
  result.name = name;
  internal::Disjoint_sets pieces(num_vertices(graph));
  for(auto [v, end] = vertices(graph); v != end; ++v) {
    result.centers.push_back(internal::to_point(graph[*v].point));
    result.radii.push_back(radius_of(*v));
  }
  for(auto [e, end] = edges(graph); e != end; ++e) {
    const std::size_t from = source(*e, graph), to = target(*e, graph);
    result.edges.push_back({std::uint32_t(from), std::uint32_t(to)});
    pieces.unite(from, to);
  }
  Betti_numbers topology;
  topology.components = long(pieces.number());
  topology.loops = topology.components - (long(result.centers.size()) - long(result.edges.size()));
  result.topology = topology;
  return result;
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief represents centrelines, with the radii that were fitted.
inline Medial_representation medial_representation(const std::string& name,
                                                   const Centerline_graph& graph)
{
  return skeleton_representation(name, graph, [&graph](std::size_t v) { return graph[v].radius; });
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_REPRESENTATION_H
