// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CENTERLINE_GRAPH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CENTERLINE_GRAPH_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief how a vertex of a centreline came to its place.
enum class Centerline_origin {
  FITTED,   ///< a piece of tube fits to the surface around it
  EXTENDED, ///< straight on from there, to the surface or the rim in which the tube ends
  BRIDGED   ///< on the way through a blob to another line
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief a point of a centreline, and what is known of the tube there.
///
/// Lengths are in the units of the surface. What was fitted is interpolated between vertices of the origin
/// `FITTED`; beyond them the radius is that of the last one or of the inner ball, and the rest is NaN.
struct Centerline_vertex
{
  /// what was not determined: not a number.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Point_3 point = Point_3(0, 0, 0); ///< on the line
  /// the radius of the circle that has the area of the section: of round tubes their radius, of elliptic ones
  /// the geometric mean of the semi-axes.
  double radius = unknown;
  /// the radius is between these with a probability of 95 %, if the errors of the points are independent.
  double radius_low = unknown;
  double radius_high = unknown; ///< \copydoc radius_low
  Vector_3 tangent =
      Vector_3(0, 0, 0);     ///< a unit vector along the branch, from its first vertex to the last
  double coverage = unknown; ///< the part of the circumference where there is a surface, in [0, 1]
  /// MAPT at the point, the radius and `σ/R = 1/2`: 1/2 on the axis of a complete tube.
  double mapt = unknown;
  double area = unknown;             ///< of the cross-section
  double perimeter = unknown;        ///< of the cross-section
  double inscribed_radius = unknown; ///< of the largest circle around the point in the section
  Centerline_origin origin = Centerline_origin::FITTED; ///< how the point was found
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// an edge of a graph of centrelines.
struct Centerline_edge
{
  std::size_t branch = 0; ///< the branch that it belongs to
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief a chain of vertices between two nodes, or a closed one.
///
/// Nodes are the vertices that end a branch: where a tube ends, where several meet, or the vertex in which
/// a closed curve begins.
struct Centerline_branch
{
  /// at least two, neighbours in the graph one after the other; a closed one ends with the vertex it began with.
  std::vector<std::size_t> vertices;
  double length = 0;      ///< along the vertices
  double mean_radius = 0; ///< over the length
  /// how sure it is: the part of the length that was fitted times the mean coverage there, in [0, 1].
  double score = 0;
  /// the faces or points of the input that surround it, ascending: the branches share them out.
  std::vector<std::uint32_t> voters;

  std::size_t from() const { return vertices.front(); } ///< the first node
  std::size_t to() const { return vertices.back(); }    ///< the last node
  /// whether it is a closed curve.
  bool is_closed() const { return from() == to() && vertices.size() > 2; }
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// what belongs to a graph of centrelines as a whole.
struct Centerline_branches
{
  std::vector<Centerline_branch> branches; ///< in the order of their first vertices
  /// whether the normals pointed into the shape, more than out of it, so that they were turned around.
  bool is_turned_over = false;
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief centrelines and how they are connected: a graph of the Boost Graph Library, as CGAL's skeletons are.
///
/// `graph[v]` is a `Centerline_vertex` (its `point` is where that of
/// `Mean_curvature_flow_skeletonization::Skeleton` is), `graph[e]` a `Centerline_edge`. See `branches()`.
using Centerline_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Centerline_vertex,
                          Centerline_edge, Centerline_branches>;

/// \ingroup PkgAreaProjectionTransformCenterlines
/// returns the branches of a graph of centrelines: each edge belongs to one.
/// \param graph the lines
inline const std::vector<Centerline_branch>& branches(const Centerline_graph& graph)
{
  return graph[boost::graph_bundle].branches;
}

/// \ingroup PkgAreaProjectionTransformCenterlines
/// returns the vertices in which branches end, ascending.
/// \param graph the lines
inline std::vector<std::size_t> nodes(const Centerline_graph& graph)
{
  std::vector<std::size_t> nodes;
  for(const Centerline_branch& branch : branches(graph))
    nodes.insert(nodes.end(), {branch.from(), branch.to()});
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief returns a segmentation: for each element of an input, a face or a point, the branch that it surrounds, or
/// -1.
/// \param graph the centrelines of the input
/// \param sources the elements that are asked for, as `Triangle_surface::sources`
inline std::vector<std::int32_t> branch_of_each(const Centerline_graph& graph,
                                                const std::vector<std::uint32_t>& sources)
{
  const auto last = std::max_element(sources.begin(), sources.end());
  std::vector<std::int32_t> of_source(last == sources.end() ? 0 : std::size_t(*last) + 1, -1);
  std::int32_t index = 0;
  for(const Centerline_branch& branch : branches(graph)) {
    for(const std::uint32_t voter : branch.voters)
      if(voter < of_source.size())
        of_source[voter] = index;
    ++index;
  }
  std::vector<std::int32_t> result;
  result.reserve(sources.size());
  for(const std::uint32_t source : sources)
    result.push_back(of_source[source]);
  return result;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_CENTERLINE_GRAPH_H
