// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the command line of mapt report says.

#ifndef MAPT_REPORT_OPTIONS_H
#define MAPT_REPORT_OPTIONS_H

#include "command_line.h"
#include "scale_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mapt {

/// what the user asks of `mapt report`. Words stand for themselves: they are checked when read.
struct Report_options
{
  std::string mesh;
  std::string output; // empty: no page is written
  std::string side = "inside";
  std::size_t resolution = 128;      // voxels along the longest side
  std::size_t most_faces = 100000;   // in the page
  std::vector<std::string> left_out; // some of salient, lines, medial, descriptor
  Scale_options scales;
  Common_options common;

  bool has(const std::string& part) const;
};

/// reads the arguments; returns whether there is anything left to do after them.
/// \throw Usage_error if they are wrong or contradict each other.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Report_options& options);

} // namespace mapt

#endif // MAPT_REPORT_OPTIONS_H
