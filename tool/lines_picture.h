// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A picture of centrelines and their tubes in the surface that they belong to.

#ifndef MAPT_LINES_PICTURE_H
#define MAPT_LINES_PICTURE_H

#include "body_view.h"
#include "picture.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>

#include <string>
#include <vector>

namespace mapt {

// Each branch has a colour; where nothing was fitted the line has no tube. Nodes are dots.
// \throw Output_error if the file cannot be written.
void write_lines_picture(const std::string& file, const Picture_source& surface,
                         const AP::Centerline_graph& graph, const std::vector<Segment>& holes);

} // namespace mapt

#endif // MAPT_LINES_PICTURE_H
