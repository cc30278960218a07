// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_input.h"

#include "text.h"

namespace mapt {

nlohmann::ordered_json to_json(const Mesh_report& report)
{
  nlohmann::ordered_json json;
  json["vertices"] = report.vertices;
  json["faces"] = report.faces;
  json["triangles"] = report.triangles;
  json["polygons_triangulated"] = report.polygons_triangulated;
  json["degenerate_faces"] = report.degenerate_faces;
  json["duplicate_vertices"] = report.duplicate_vertices;
  json["unused_vertices"] = report.unused_vertices;
  json["points_without_normal"] = report.points_without_normal;
  json["normals_estimated"] = report.normal_neighbours > 0;
  json["normal_neighbours"] = report.normal_neighbours;
  json["points_unoriented"] = report.points_unoriented;
  json["is_closed"] = report.is_closed;
  json["is_consistently_oriented"] = report.is_consistently_oriented;
  json["boundary_edges"] = report.boundary_edges;
  json["holes"] = report.holes;
  json["nonmanifold_edges"] = report.nonmanifold_edges;
  json["inconsistent_edges"] = report.inconsistent_edges;
  json["components"] = report.components;
  json["components_found_inward"] = report.components_found_inward;
  json["open_components_inward"] = report.open_components_inward;
  json["faces_reoriented"] = report.faces_reoriented;
  json["was_flipped"] = report.was_flipped;
  json["is_orientation_repaired"] = report.is_orientation_repaired;
  json["genus"] = report.genus ? nlohmann::ordered_json(*report.genus) : nullptr;
  json["area"] = report.area;
  json["volume"] = report.signed_volume ? nlohmann::ordered_json(*report.signed_volume) : nullptr;
  const CGAL::Bbox_3& box = report.bounding_box;
  json["box"] = {{"min", {box.xmin(), box.ymin(), box.zmin()}},
                 {"max", {box.xmax(), box.ymax(), box.zmax()}}};
  return json;
}

std::string summary(const Input& input)
{
  const Mesh_report& report = input.report;
  if(input.is_point_set)
    return counted(report.vertices, "point", "points") +
           (report.normal_neighbours > 0 ? ", normals estimated" : " with normals") +
           (input.areas.empty() ? ", areas from their density" : " and areas");
  std::string text = counted(report.vertices, "vertex", "vertices") + ", " +
                     counted(report.faces, "face", "faces") + ", ";
  text += report.is_closed ? "closed"
                           : "open: " + counted(report.holes, "hole", "holes") + " with " +
                                 counted(report.boundary_edges, "edge", "edges");
  if(report.components > 1)
    text += ", " + std::to_string(report.components) + " parts";
  return text;
}

void warn_of(const Input& input, Console& console)
{
  for(const std::string& line : warnings(input.report))
    console.warn(input.file + ": " + line);
}

Input read_described(const std::string& file, const Reading_options& options, Console& console)
{
  Input input = read_input(file, options);
  console.report["input"] = {{"file", file}};
  console.report["input"].update(to_json(input.report));
  console.row("mesh", file + ": " + summary(input));
  warn_of(input, console);
  return input;
}

} // namespace mapt
