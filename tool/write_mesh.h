// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces as files.

#ifndef MAPT_WRITE_MESH_H
#define MAPT_WRITE_MESH_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <string>
#include <vector>

namespace mapt {

// The extensions of the files that can be written.
std::vector<std::string> mesh_extensions();

// Writes the triangles of a surface; the extension tells the format.
// \throw Output_error if the file cannot be written.
void write_mesh(const std::string& file, const CGAL::Area_projection::Triangle_surface& surface);

} // namespace mapt

#endif // MAPT_WRITE_MESH_H
