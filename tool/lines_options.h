// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the command line of mapt lines says.

#ifndef MAPT_LINES_OPTIONS_H
#define MAPT_LINES_OPTIONS_H

#include "command_line.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_options.h>

#include <string>
#include <vector>

namespace mapt {

struct Lines_options
{
  std::string mesh;
  std::vector<std::string> outputs; // the extension tells the format
  std::string segments;             // empty: not written
  std::string picture;              // empty: none
  std::string side = "inside";
  CGAL::Area_projection::Centerline_options lines;
  Common_options common;
};

// Reads the arguments; returns whether there is anything left to do after them.
// \throw Usage_error if they are wrong or contradict each other.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Lines_options& options);

} // namespace mapt

#endif // MAPT_LINES_OPTIONS_H
