// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The files of centrelines.

#ifndef MAPT_LINES_OUTPUT_H
#define MAPT_LINES_OUTPUT_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>

#include <string>

namespace mapt {

// Writes centrelines in the format of the extension of the file: .vtp, .swc, .obj or .json.
// \throw Output_error if the file cannot be written.
void write_lines(const std::string& file, const CGAL::Area_projection::Centerline_graph& graph);

} // namespace mapt

#endif // MAPT_LINES_OUTPUT_H
