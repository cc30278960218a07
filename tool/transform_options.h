// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_TRANSFORM_OPTIONS_H
#define MAPT_TRANSFORM_OPTIONS_H

#include "command_line.h"
#include "scale_options.h"
#include "surface.h"

#include <optional>
#include <string>
#include <vector>

namespace mapt {

/// what the user asks of `mapt transform`. Words stand for themselves: they are checked when read.
struct Transform_options
{
  std::string mesh;
  std::string output;  // empty: no map is written
  std::string picture; // empty: none
  bool is_compressed = true;
  bool is_compensated = false; // divided by the coverage
  std::string kind = "jmapt";
  std::string side = "inside";
  std::string region; // empty: depends on the side
  Surface_options surface;
  std::string method = "grid";
  std::string kernel = "ball";
  double sampling_ratio;
  std::optional<double> voxel, margin;
  std::string coarser_grid = "raise --voxel"; // how the user would get one
  Scale_options scales;
  Common_options common;
};

/// reads the arguments; returns whether there is anything left to do after them.
/// \throw Usage_error if they are wrong.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Transform_options& options);

} // namespace mapt

#endif // MAPT_TRANSFORM_OPTIONS_H
