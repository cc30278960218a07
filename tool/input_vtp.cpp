// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_file.h"

#include <CGAL/Area_projection_transform/IO/VTP.h>

#include <exception>
#include <utility>

namespace mapt {

// The library's reader checks indices; it opens the file itself and names it in its messages.
Raw_mesh read_vtp(const Input_file& file)
{
  CGAL::Area_projection::IO::Poly_data data;
  try {
    data = CGAL::Area_projection::IO::read_VTP(file.name);
  } catch(const std::exception& error) {
    const std::string what = error.what();
    const std::string prefix = file.name + ": ";
    file.fail(what.compare(0, prefix.size(), prefix) == 0 ? what.substr(prefix.size()) : what);
  }
  Raw_mesh mesh;
  for(std::size_t i = 0; i < data.points.size(); ++i) {
    const Point_3& p = data.points[i];
    if(!is_usable(p.x(), p.y(), p.z()))
      file.fail("vertex " + std::to_string(i) + " " + coordinate_defect(p.x(), p.y(), p.z()));
  }
  for(const std::vector<std::size_t>& polygon : data.polygons) {
    for(const std::size_t vertex : polygon)
      mesh.polygons.vertices.push_back(std::uint32_t(vertex));
    mesh.polygons.close_face();
  }
  mesh.points = std::move(data.points);
  mesh.normals = std::move(data.normals);
  return mesh;
}

} // namespace mapt
