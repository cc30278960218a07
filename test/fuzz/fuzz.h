// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_H
#define AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_H

// What the harnesses share. Each is a file with a function `LLVMFuzzerTestOneInput()`, which takes any
// bytes and ends, or calls `require()` in vain: libFuzzer looks for such bytes, replay.cpp tries those that
// are known.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

/// ends the program, as a crash does, if what is promised does not hold.
inline void require(bool holds, const std::string& promise)
{
  if(holds)
    return;
  std::fprintf(stderr, "broken promise: %s\n", promise.c_str());
  std::abort();
}

/// a message is one line, and begins with what it is about.
inline void require_one_line(const std::string& message, const std::string& about = "")
{
  require(!message.empty() && message.find_first_of("\n\r") == std::string::npos &&
              message.compare(0, about.size(), about) == 0,
          "an error is one line that begins with '" + about + "', but this is: " + message);
}

/// bytes as small and as hostile numbers; zeros once they are used up.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_data(data), m_size(size) {}

  bool empty() const { return m_size == 0; }

  std::uint8_t byte()
  {
    if(m_size == 0)
      return 0;
    --m_size;
    return *m_data++;
  }

  /// in [0, number)
  std::size_t choice(std::size_t number) { return byte() % number; }

  /// in [-1, 1], of 2^16 values
  double fraction()
  {
    const int low = byte();
    return (low + 256 * byte() - 32768) / 32768.;
  }

  /// in [low, high]
  double between(double low, double high) { return low + (high - low) * 0.5 * (fraction() + 1); }

  /// any double at all: not finite, subnormal, huge.
  double any()
  {
    std::uint8_t bytes[sizeof(double)];
    for(std::uint8_t& b : bytes)
      b = byte();
    double value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

private:
  const std::uint8_t* m_data;
  std::size_t m_size;
};

/// splits bytes into their first line, which chooses what is tried, and the rest.
inline std::string_view first_line(std::string_view& text)
{
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

} // namespace fuzz

#endif // AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_H
