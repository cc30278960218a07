// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "skeleton_peer.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <cmath>

namespace Paper {

namespace {

namespace AP = CGAL::Area_projection;
namespace PMP = CGAL::Polygon_mesh_processing;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<Mesh>;

AP::Centerline_vertex vertex_of(const Mesh& mesh, const Skeletonization::Skeleton& skeleton,
                                std::size_t v)
{
  AP::Centerline_vertex vertex;
  vertex.point = skeleton[v].point;
  double sum = 0;
  for(const Mesh::Vertex_index from : skeleton[v].vertices)
    sum += std::sqrt(CGAL::squared_distance(mesh.point(from), vertex.point));
  vertex.radius = sum / double(skeleton[v].vertices.size());
  return vertex;
}

} // namespace

std::optional<AP::Centerline_graph> skeleton_lines(const Soup& soup)
{
  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.triangles))
    return std::nullopt;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  if(!CGAL::is_closed(mesh))
    return std::nullopt;
  Skeletonization::Skeleton skeleton;
  CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  AP::Centerline_graph graph;
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v)
    add_vertex(vertex_of(mesh, skeleton, v), graph);
  for(auto [e, end] = edges(skeleton); e != end; ++e)
    add_edge(source(*e, skeleton), target(*e, skeleton), graph);
  return graph;
}

} // namespace Paper
