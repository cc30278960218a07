// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SALIENT_OPTIONS_H
#define MAPT_SALIENT_OPTIONS_H

#include "command_line.h"

#include <optional>
#include <string>
#include <vector>

namespace mapt {

/// what the user asks of `mapt salient`. Words stand for themselves: they are checked when read.
struct Salient_options
{
  std::string mesh;
  std::string output;  // empty or "-": stdout
  std::string voters;  // empty: not written
  std::string picture; // empty: none
  std::string mode = "fitted";
  std::string side = "inside";
  std::vector<std::string> types; // empty: all
  std::optional<double> threshold, smallest_radius, largest_radius, tube_spacing;
  Common_options common;

  bool is_fitted() const { return mode == "fitted"; }
  bool is_to_stdout() const { return output.empty() || output == "-"; }
  /// the threshold that counts: the given one, or that of the library for the mode.
  double used_threshold() const;
};

/// reads the arguments; returns whether there is anything left to do after them.
/// \throw Usage_error if they are wrong.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Salient_options& options);

} // namespace mapt

#endif // MAPT_SALIENT_OPTIONS_H
