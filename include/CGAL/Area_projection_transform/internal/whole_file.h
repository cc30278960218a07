// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WHOLE_FILE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WHOLE_FILE_H

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// \brief returns the bytes of a file.
/// \throw std::runtime_error with the name and the cause if it cannot be read.
inline std::string read_whole_file(const std::string& name)
{
  const auto fail = [&](const char* done) {
    throw std::runtime_error(name + ": cannot be " + done + ": " + std::strerror(errno));
  };
  struct Close
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(name.c_str(), "rb"));
  if(!file)
    fail("opened");
  std::string bytes;
  constexpr std::size_t step = std::size_t(1) << 20;
  for(std::size_t length = 0;;) {
    bytes.resize(length + step);
    const std::size_t number = std::fread(&bytes[length], 1, step, file.get());
    length += number;
    if(number < step) {
      bytes.resize(length);
      if(std::ferror(file.get()))
        fail("read");
      return bytes;
    }
  }
}

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WHOLE_FILE_H
