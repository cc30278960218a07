// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MESH_REPORT_H
#define MAPT_MESH_REPORT_H

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mapt {

/// what is in a file, what is wrong with it, and what was done about it.
///
struct Mesh_report
{
  /// \name As the file has it
  /// @{
  std::size_t vertices = 0; // or points
  std::size_t faces = 0;
  std::size_t polygons_triangulated = 0; // faces of more than 3 corners
  std::size_t degenerate_faces = 0;      // of no area: left out
  std::size_t duplicate_vertices = 0;    // at the position of an earlier one
  bool are_duplicates_joined = false;    // when counting edges, because that closes gaps
  std::size_t unused_vertices = 0;       // of no face that has an area
  std::size_t points_without_normal = 0; // of a point set: left out
  /// @}

  /// \name Normals of points that have none in the file
  /// @{
  std::size_t normal_neighbours = 0; // that each was estimated from, or 0
  std::size_t points_unoriented = 0; // of which no estimate is possible: left out
  /// @}

  /// \name The triangles that are used
  /// @{
  std::size_t triangles = 0;
  std::size_t boundary_edges = 0;     // of one face
  std::size_t holes = 0;              // connected pieces of the boundary
  std::size_t nonmanifold_edges = 0;  // of three faces or more
  std::size_t inconsistent_edges = 0; // that neighbours run through in the same direction
  std::size_t components = 0;         // connected through edges; or of points, if estimated
  bool is_closed = false;
  bool is_consistently_oriented = false;
  std::optional<std::size_t> genus; // sum over the components, if closed, manifold and consistent
  double area = 0;                  // of a point set: if the file has areas
  std::optional<double> signed_volume; // if closed and consistent; positive if faces point outward
  CGAL::Bbox_3 bounding_box;           // of the vertices in use
  /// @}

  /// \name Which way the faces look
  /// @{
  std::size_t components_found_inward = 0; // closed, faces inward, not the wall of a cavity
  std::size_t open_components_inward = 0;  // open, but the sign of the volume is clear
  std::size_t faces_reoriented = 0;        // to agree with their neighbours, on demand
  bool was_flipped = false;                // all faces, on demand
  bool is_orientation_repaired = false;    // the closed components found inward were turned over
  /// @}
};

/// returns a line for each thing that the user should know, with its count and, where there is one,
/// the remedy. An open mesh is no defect.
std::vector<std::string> warnings(const Mesh_report& report);

} // namespace mapt

#endif // MAPT_MESH_REPORT_H
