// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEAN_CURVATURE_SKELETON_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEAN_CURVATURE_SKELETON_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Surface_distance.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_topology.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>

// g++ 12 and later take sets in there for pointers that outlive what they point to.
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdangling-pointer"
#endif
#include <CGAL/extract_mean_curvature_flow_skeleton.h>
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
#pragma GCC diagnostic pop
#endif

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief tells why \cgal cannot make a skeleton of a surface; nothing if it can.
///
/// `extract_mean_curvature_flow_skeleton()` expects a closed mesh of one part without faces that have no area, and does not
/// check that.
inline std::string skeleton_obstacle(const Triangle_surface& surface)
{
  const auto counted = [](std::size_t number, const std::string& one, const std::string& many) {
    return std::to_string(number) + " " + (number == 1 ? one : many);
  };
  if(surface.empty())
    return "the surface has no faces";
  const internal::Surface_connections connections(surface);
  if(connections.open_edges > 0)
    return "the surface is open: " + counted(connections.open_edges, "edge has", "edges have") +
           " one face only" +
           (surface.number_of_skipped_faces > 0
                ? ", of which some may be due to faces without area: repair the mesh"
                : "; fill the holes");
  if(connections.crowded_edges > 0)
    return counted(connections.crowded_edges, "edge has", "edges have") + " more than two faces";
  if(connections.opposed_edges > 0)
    return "faces are turned over: the two at " +
           counted(connections.opposed_edges, "edge", "edges") + " disagree";
  if(connections.part_volumes.size() > 1)
    return "the surface has " + std::to_string(connections.part_volumes.size()) +
           " parts: give one at a time";
  if(!(connections.part_volumes.front() > 0))
    return "the faces point inward: turn them over";
  return "";
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// points have no skeleton of that kind.
inline std::string skeleton_obstacle(const Surfels&)
{
  return "points have no faces: give a mesh";
}

/// \cond SKIP_IN_MANUAL
namespace internal {

using Skeleton_mesh = CGAL::Surface_mesh<Point_3>;

inline Skeleton_mesh mesh_for_skeleton(const Triangle_surface& surface)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const std::vector<std::uint32_t> places = joined_points(surface);
  std::vector<Point_3> points = surface.points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const Triangle_surface::Triangle& t : surface.triangles)
    triangles.push_back({places[t[0]], places[t[1]], places[t[2]]});
  PMP::remove_isolated_points_in_polygon_soup(points, triangles);
  PMP::orient_polygon_soup(points,
                           triangles); // gives each fan at a pinched vertex a vertex of its own
  Skeleton_mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief represents \cgal's skeleton by mean curvature flow (Tagliasacchi et al. 2012), with its defaults.
///
/// The skeleton has no radii; those given are the distances from the surface.
/// \throw std::invalid_argument with `skeleton_obstacle()`, if there is one
/// \throw std::runtime_error if \cgal fails
inline Medial_representation mean_curvature_skeleton(const Triangle_surface& surface)
{
  const std::string obstacle = skeleton_obstacle(surface);
  if(!obstacle.empty())
    throw std::invalid_argument(obstacle);
  const auto start = std::chrono::steady_clock::now();
  const internal::Skeleton_mesh mesh = internal::mesh_for_skeleton(surface);
  CGAL::Mean_curvature_flow_skeletonization<internal::Skeleton_mesh>::Skeleton skeleton;
  try {
    CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  } catch(const std::exception& error) {
    throw std::runtime_error("CGAL found no skeleton: " + std::string(error.what()));
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  const Surface_distance<Triangle_surface> distance(surface);
  Medial_representation result = skeleton_representation(
      "skeleton", skeleton, [&](std::size_t v) { return distance(skeleton[v].point); });
  result.seconds = passed.count();
  return result;
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \throw std::invalid_argument always
inline Medial_representation mean_curvature_skeleton(const Surfels& points)
{
  throw std::invalid_argument(skeleton_obstacle(points));
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEAN_CURVATURE_SKELETON_H
