// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_ERRORS_H
#define MAPT_ERRORS_H

#include <stdexcept>
#include <string>

namespace mapt {

/// what the command answers to the shell.
enum Exit_code {
  DONE = 0, // also when nothing was found
  INTERNAL_ERROR = 1,
  WRONG_USAGE = 2,
  UNUSABLE_INPUT = 3, // also: does not fit into the memory
  OUTPUT_NOT_WRITTEN = 4,
  INTERRUPTED = 130 // by SIGINT, as shells have it
};

/// an option or an argument that makes no sense; the message names it and its value.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// the user asked to stop.
class Interruption : public std::runtime_error
{
public:
  explicit Interruption(const std::string& text = "interrupted: nothing was written")
      : std::runtime_error(text)
  {}
};

} // namespace mapt

#endif // MAPT_ERRORS_H
