// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What results say about the file that a surface was read from.

#ifndef MAPT_FILE_ELEMENTS_H
#define MAPT_FILE_ELEMENTS_H

#include "body_view.h"
#include "input.h"
#include "surface.h"

#include <CGAL/Area_projection_transform/IO/PLY.h>

#include <string>
#include <vector>

namespace mapt {

// The edges of holes, between points of the input.
std::vector<Segment> holes_of(const Input& input);

// Writes faces or points that show their labels, which are the last element, and where each was in the input.
// \param what describes the property of the labels
// \throw Output_error if the file cannot be written.
void write_labelled_elements(const std::string& file, std::vector<AP::IO::PLY_element> elements,
                             const std::string& what, const Surface& surface, const Input& input);

} // namespace mapt

#endif // MAPT_FILE_ELEMENTS_H
