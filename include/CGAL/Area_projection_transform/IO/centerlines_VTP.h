// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_VTP_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_VTP_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/internal/vtk_lines_writer.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void add_vertices(const Centerline_graph& graph, Vtk_lines_writer& writer)
{
  const auto of_each = [&](const auto& value) {
    std::vector<double> values;
    for(std::size_t v = 0; v < num_vertices(graph); ++v)
      values.push_back(value(graph[v]));
    return values;
  };
  const auto add = [&](const char* name, double Centerline_vertex::*member) {
    writer.add_to_points(name, of_each([member](const Centerline_vertex& v) { return v.*member; }));
  };
  add("radius", &Centerline_vertex::radius);
  add("mapt", &Centerline_vertex::mapt);
  std::vector<std::int64_t> branch(num_vertices(graph), -1), origin;
  for(std::size_t b = branches(graph).size(); b-- > 0;)
    for(const std::size_t v : branches(graph)[b].vertices)
      branch[v] = std::int64_t(b);
  writer.add_to_points("branch", std::move(branch));
  add("radius_low", &Centerline_vertex::radius_low);
  add("radius_high", &Centerline_vertex::radius_high);
  add("coverage", &Centerline_vertex::coverage);
  add("area", &Centerline_vertex::area);
  add("perimeter", &Centerline_vertex::perimeter);
  add("inscribed_radius", &Centerline_vertex::inscribed_radius);
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    origin.push_back(std::int64_t(graph[v].origin));
  writer.add_to_points("origin", std::move(origin));
  std::vector<double> tangents;
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    for(int axis = 0; axis < 3; ++axis)
      tangents.push_back(graph[v].tangent[axis]);
  writer.add_to_points("tangent", std::move(tangents), 3);
}

inline void add_branches(const Centerline_graph& graph, Vtk_lines_writer& writer)
{
  std::vector<std::int64_t> index, voters;
  std::vector<double> length, radius, score;
  for(const Centerline_branch& branch : branches(graph)) {
    index.push_back(std::int64_t(index.size()));
    length.push_back(branch.length);
    radius.push_back(branch.mean_radius);
    score.push_back(branch.score);
    voters.push_back(std::int64_t(branch.voters.size()));
  }
  writer.add_to_lines("branch", std::move(index));
  writer.add_to_lines("length", std::move(length));
  writer.add_to_lines("mean_radius", std::move(radius));
  writer.add_to_lines("score", std::move(score));
  writer.add_to_lines("voters", std::move(voters));
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes centrelines as polylines of VTK (`.vtp`), for ParaView, VMTK or PyVista.
///
/// A line for each branch; branches that meet share the point. Points have `radius`, `mapt`, `branch` (at nodes the
/// first one), `radius_low`, `radius_high`, `coverage`, `area`, `perimeter`, `inscribed_radius`, `origin` (0 fitted,
/// 1 extended, 2 bridged) and `tangent`; lines have `branch`, `length`, `mean_radius`, `score` and the number of
/// `voters`. What is unknown is NaN.
/// \param file_name the file; replaced as a whole, if it exists
/// \param graph the lines
/// \throw Output_error if the file cannot be written; nothing is left of it then
inline void write_centerlines_VTP(const std::string& file_name, const Centerline_graph& graph)
{
  internal::Vtk_lines_writer writer;
  internal::add_vertices(graph, writer);
  internal::add_branches(graph, writer);
  std::vector<double> coordinates;
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    for(int axis = 0; axis < 3; ++axis)
      coordinates.push_back(graph[v].point[axis]);
  std::vector<std::vector<std::size_t>> lines;
  for(const Centerline_branch& branch : branches(graph))
    lines.push_back(branch.vertices);
  internal::Atomic_file file(file_name);
  writer.write(file.stream(), coordinates, lines);
  file.commit();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_VTP_H
