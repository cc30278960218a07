// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_mesh.h"

#include "map_file.h"

#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

namespace mapt {

namespace AP = CGAL::Area_projection;

std::vector<std::string> mesh_extensions()
{
  return {".off", ".obj", ".ply", ".stl"};
}

void write_mesh(const std::string& file, const AP::Triangle_surface& surface)
{
  const auto& points = surface.points;
  const auto& triangles = surface.triangles;
  const auto precision = CGAL::parameters::stream_precision(17);
  const std::string extension = extension_of(file);
  AP::IO::internal::Atomic_file output(file);
  std::ostream& stream = output.stream();
  if(extension == ".off")
    CGAL::IO::write_OFF(stream, points, triangles, precision);
  else if(extension == ".obj")
    CGAL::IO::write_OBJ(stream, points, triangles, precision);
  else if(extension == ".ply")
    CGAL::IO::write_PLY(stream, points, triangles, precision);
  else
    CGAL::IO::write_STL(stream, points, triangles, precision);
  output.commit();
}

} // namespace mapt
