// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lines_output.h"

#include "map_file.h"

#include <CGAL/Area_projection_transform/IO/centerlines_JSON.h>
#include <CGAL/Area_projection_transform/IO/centerlines_OBJ.h>
#include <CGAL/Area_projection_transform/IO/centerlines_SWC.h>
#include <CGAL/Area_projection_transform/IO/centerlines_VTP.h>

namespace mapt {

namespace AP = CGAL::Area_projection;

void write_lines(const std::string& file, const AP::Centerline_graph& graph)
{
  const std::string extension = extension_of(file);
  if(extension == ".vtp")
    AP::IO::write_centerlines_VTP(file, graph);
  else if(extension == ".swc")
    AP::IO::write_centerlines_SWC(file, graph);
  else if(extension == ".obj")
    AP::IO::write_centerlines_OBJ(file, graph);
  else
    AP::IO::write_centerlines_JSON(file, graph);
}

} // namespace mapt
