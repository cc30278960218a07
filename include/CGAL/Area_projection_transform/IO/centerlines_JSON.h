// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_JSON_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_JSON_H

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// JSON has no NaN.
inline std::string json_number(double value)
{
  return std::isfinite(value) ? IO::to_text(value) : "null";
}

inline std::string json_point(const Point_3& p)
{
  return '[' + json_number(p.x()) + ',' + json_number(p.y()) + ',' + json_number(p.z()) + ']';
}

/// writes `"name":[…]` with a text for each element of a range.
template <class Range, class Text>
void write_json_array(std::ostream& out, const char* name, const Range& range, const Text& text)
{
  out << '"' << name << "\":[";
  const char* separator = "";
  for(const auto& element : range) {
    out << separator << text(element);
    separator = ",";
  }
  out << ']';
}

inline void write_json_branch(std::ostream& out, const Centerline_graph& graph,
                              const Centerline_branch& branch,
                              const std::vector<std::size_t>& nodes)
{
  const auto place = [&](std::size_t vertex) {
    return IO::to_text(
        std::size_t(std::lower_bound(nodes.begin(), nodes.end(), vertex) - nodes.begin()));
  };
  const auto write = [&](const char* name, double Centerline_vertex::*member) {
    out << ",\n     ";
    write_json_array(out, name, branch.vertices,
                     [&](std::size_t v) { return json_number(graph[v].*member); });
  };
  out << "    {\"from\":" << place(branch.from()) << ",\"to\":" << place(branch.to())
      << ",\"length\":" << json_number(branch.length)
      << ",\"mean_radius\":" << json_number(branch.mean_radius)
      << ",\"score\":" << json_number(branch.score) << ",\n     ";
  write_json_array(out, "points", branch.vertices,
                   [&](std::size_t v) { return json_point(graph[v].point); });
  write("radii", &Centerline_vertex::radius);
  write("radii_low", &Centerline_vertex::radius_low);
  write("radii_high", &Centerline_vertex::radius_high);
  write("coverage", &Centerline_vertex::coverage);
  write("mapt", &Centerline_vertex::mapt);
  write("area", &Centerline_vertex::area);
  write("perimeter", &Centerline_vertex::perimeter);
  write("inscribed_radius", &Centerline_vertex::inscribed_radius);
  out << ",\n     ";
  write_json_array(out, "voters", branch.voters, [](std::uint32_t v) { return IO::to_text(v); });
  out << '}';
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes centrelines as JSON: `{"branches":[{"from":node,"to":node,"points":[[x,y,z],…],"radii":[…],…},…],
/// "nodes":[[x,y,z],…]}`.
///
/// `from` and `to` count the nodes from 0. Further arrays of a branch, a number for each of its points, are `radii_low`,
/// `radii_high`, `coverage`, `mapt`, `area`, `perimeter` and `inscribed_radius` of `Centerline_vertex`; `voters`
/// are the faces (or points) of the input around it; and it has `length`, `mean_radius` and `score`. What is unknown
/// is `null`.
/// \param file_name the file; replaced as a whole, if it exists
/// \param graph the lines
/// \throw Output_error if the file cannot be written; nothing is left of it then
inline void write_centerlines_JSON(const std::string& file_name, const Centerline_graph& graph)
{
  const std::vector<std::size_t> ends = nodes(graph);
  internal::Atomic_file file(file_name);
  std::ostream& out = file.stream();
  out << "{\"branches\":[\n";
  const char* separator = "";
  for(const Centerline_branch& branch : branches(graph)) {
    out << separator;
    internal::write_json_branch(out, graph, branch, ends);
    separator = ",\n";
  }
  out << "],\n ";
  internal::write_json_array(out, "nodes", ends,
                             [&](std::size_t v) { return internal::json_point(graph[v].point); });
  out << "}\n";
  file.commit();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_JSON_H
