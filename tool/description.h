// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIPTION_H
#define MAPT_DESCRIPTION_H

#include "describe_options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mapt {

/// what became of a mesh that was to be described.
struct Description
{
  std::string failure;       // with file, cause and remedy; empty: there is none
  std::string remark;        // what is odd about the mesh; empty: nothing
  std::vector<float> values; // empty after a failure
  double reading = 0;        // in seconds
  double computing = 0;      // in seconds
};

/// reads a mesh and describes it. Whatever goes wrong becomes the failure.
Description describe_file(const std::string& file, const Describe_options& options);

/// \name A description as a line of text
/// It has no line end in it, and its numbers read back as the same ones.
/// @{
std::string to_line(const Description& description);
/// nothing if that is no such line.
std::optional<Description> description_from(std::string_view line);
/// @}

/// \name Any text as one word, which is not empty and has neither blanks nor line ends
/// @{
std::string to_word(const std::string& text);
std::string text_from(std::string_view word);
/// @}

} // namespace mapt

#endif // MAPT_DESCRIPTION_H
