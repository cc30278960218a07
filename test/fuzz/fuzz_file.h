// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_FILE_H
#define AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_FILE_H

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unistd.h>

namespace fuzz {

/// the name of a file with these bytes, for readers that take nothing else. It lasts until the next call, and has
/// no name in any folder that could be left behind.
inline std::string file_of(std::string_view bytes)
{
  static std::FILE* const file = std::tmpfile();
  if(file == nullptr || ftruncate(fileno(file), 0) != 0 ||
     pwrite(fileno(file), bytes.data(), bytes.size(), 0) != ssize_t(bytes.size()))
    throw std::logic_error("there is no room for temporary files");
  return "/dev/fd/" + std::to_string(fileno(file));
}

} // namespace fuzz

#endif // AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_FILE_H
