// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIBE_OPTIONS_H
#define MAPT_DESCRIBE_OPTIONS_H

#include "command_line.h"
#include "surface.h"

#include <CGAL/Area_projection_transform/shape_descriptor/Shape_descriptor_options.h>

#include <string>
#include <vector>

namespace mapt {

/// what the user asks of `mapt describe`. Words stand for themselves: they are checked when read.
struct Describe_options
{
  std::vector<std::string> meshes; // files and folders
  std::string list;                // a file with more of them; empty: none; "-": stdin
  std::string output;              // empty or "-": stdout
  std::string kind = "paper";
  Surface_options surface;
  bool subdivide = false; // smooth coarse meshes
  AP::Shape_descriptor_options descriptor;
  Common_options common;

  bool is_to_stdout() const { return output.empty() || output == "-"; }
  /// whether what is finished can be kept beside the output: that of a pipe or a device cannot.
  bool has_journal() const;
  /// how many numbers there are in a row, and how many of them belong together.
  std::size_t dimension() const;
  std::size_t block_size() const;
};

/// reads the arguments; returns whether there is anything left to do after them.
/// \throw Usage_error if they are wrong.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Describe_options& options);

/// the choices that determine the numbers, with all defaults filled in, as --json tells them.
nlohmann::ordered_json choices_of(const Describe_options& options);

} // namespace mapt

#endif // MAPT_DESCRIBE_OPTIONS_H
