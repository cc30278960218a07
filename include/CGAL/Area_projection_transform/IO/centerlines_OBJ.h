// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_OBJ_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_OBJ_H

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes centrelines as polylines of Wavefront (`.obj`): a group `branch_<index>` with one element `l` for each
/// branch. The format has no radii.
/// \param file_name the file; replaced as a whole, if it exists
/// \param graph the lines
/// \throw Output_error if the file cannot be written; nothing is left of it then
inline void write_centerlines_OBJ(const std::string& file_name, const Centerline_graph& graph)
{
  internal::Atomic_file file(file_name);
  std::ostream& out = file.stream();
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    const Point_3& p = graph[v].point;
    out << "v " << to_text(p.x()) << ' ' << to_text(p.y()) << ' ' << to_text(p.z()) << '\n';
  }
  std::size_t index = 0;
  for(const Centerline_branch& branch : branches(graph)) {
    out << "g branch_" << to_text(index++) << "\nl";
    for(const std::size_t v : branch.vertices)
      out << ' ' << to_text(v + 1);
    out << '\n';
  }
  file.commit();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_OBJ_H
