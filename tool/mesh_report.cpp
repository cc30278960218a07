// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_report.h"

namespace mapt {

namespace {

// "1 face is ", "3 faces are "
std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many) + " ";
}

void warn_of_faces(const Mesh_report& report, std::vector<std::string>& lines)
{
  if(report.polygons_triangulated > 0)
    lines.push_back(
        counted(report.polygons_triangulated, "face is a polygon", "faces are polygons") +
        "of more than 3 corners: cut into triangles");
  if(report.degenerate_faces > 0)
    lines.push_back(counted(report.degenerate_faces, "face has", "faces have") +
                    "no area: left out");
  if(report.are_duplicates_joined)
    lines.push_back(counted(report.duplicate_vertices, "vertex repeats", "vertices repeat") +
                    "the position of another: counted as one to find edges and parts");
  if(report.unused_vertices > 0)
    lines.push_back(counted(report.unused_vertices, "vertex is", "vertices are") +
                    "on no face: ignored");
  if(report.nonmanifold_edges > 0)
    lines.push_back(counted(report.nonmanifold_edges, "edge has", "edges have") +
                    "more than 2 faces: each face counts");
}

void warn_of_orientation(const Mesh_report& report, std::vector<std::string>& lines)
{
  if(report.faces_reoriented > 0)
    lines.push_back(counted(report.faces_reoriented, "face was", "faces were") +
                    "turned over to agree with the neighbours (--orient)");
  if(report.inconsistent_edges > 0)
    lines.push_back(counted(report.inconsistent_edges, "edge lies", "edges lie") +
                    "between faces that disagree about the outside: " +
                    (report.faces_reoriented > 0
                         ? "the surface has no two sides; use --side both of mapt transform"
                         : "use --orient, or --side both of mapt transform"));
  if(report.components_found_inward > 0) {
    const std::string parts =
        report.components > 1 ? "the faces of " + std::to_string(report.components_found_inward) +
                                    " of " + std::to_string(report.components) + " parts point"
                              : "the faces point";
    lines.push_back(parts + " inward" +
                    (report.is_orientation_repaired
                         ? ": turned over (--flip turns them all instead)"
                         : ", as --flip asks"));
  }
  if(report.open_components_inward > 0)
    lines.push_back(counted(report.open_components_inward, "open part seems", "open parts seem") +
                    "to have faces that point inward: if so, use --flip");
}

void warn_of_points(const Mesh_report& report, std::vector<std::string>& lines)
{
  if(report.points_without_normal > 0)
    lines.push_back(counted(report.points_without_normal, "point has", "points have") +
                    "a normal of length 0: left out");
  if(report.normal_neighbours > 0)
    lines.push_back("normals were estimated from " + std::to_string(report.normal_neighbours) +
                    " neighbours of each point; " +
                    counted(report.components, "part faces", "parts face") +
                    "outward, as far as can be told (--flip turns all over)");
  if(report.points_unoriented > 0)
    lines.push_back(counted(report.points_unoriented, "point lies", "points lie") +
                    "on a line, or apart from others, and could not be oriented: left out");
}

} // namespace

std::vector<std::string> warnings(const Mesh_report& report)
{
  std::vector<std::string> lines;
  warn_of_faces(report, lines);
  warn_of_orientation(report, lines);
  warn_of_points(report, lines);
  return lines;
}

} // namespace mapt
