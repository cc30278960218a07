// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_BYTE_SOURCE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_BYTE_SOURCE_H

#include <CGAL/Area_projection_transform/IO/number_text.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// the value of a base64 digit, or -1.
inline int base64_value(char c)
{
  return c >= 'A' && c <= 'Z'   ? c - 'A'
         : c >= 'a' && c <= 'z' ? c - 'a' + 26
         : c >= '0' && c <= '9' ? c - '0' + 52
         : c == '+'             ? 62
         : c == '/'             ? 63
                                : -1;
}

/// \brief the bytes that are stored in a text, raw or in base64.
///
/// In base64 several encoded pieces may follow each other, each padded on its own: VTK writes the
/// table of compressed blocks so. Blanks between the digits are skipped.
class Vtk_byte_source
{
public:
  Vtk_byte_source(std::string_view encoded, bool is_base64)
      : m_encoded(encoded), m_is_base64(is_base64)
  {}

  /// the greatest number of bytes there can be.
  std::size_t capacity() const { return m_is_base64 ? m_encoded.size() / 4 * 3 : m_encoded.size(); }

  /// \brief returns the first `number` bytes; valid until the next call.
  /// \throw std::runtime_error if there are fewer.
  std::string_view first(std::size_t number)
  {
    if(number > capacity())
      fail(number, capacity());
    if(!m_is_base64) {
      m_used = std::max(m_used, number);
      return m_encoded.substr(0, number);
    }
    while(m_decoded.size() < number)
      if(!decode_group())
        fail(number, m_decoded.size());
    return std::string_view(m_decoded).substr(0, number);
  }

  /// how much of the text has been read.
  std::size_t number_of_used_characters() const { return m_used; }

private:
  bool next_digit(char& digit)
  {
    while(m_used < m_encoded.size() && is_blank(m_encoded[m_used]))
      ++m_used;
    if(m_used == m_encoded.size() || m_encoded[m_used] == '<')
      return false;
    digit = m_encoded[m_used++];
    return true;
  }

  /// decodes four digits into up to three bytes; returns whether there are any left.
  bool decode_group()
  {
    unsigned bits = 0;
    int digits = 0;
    for(int i = 0; i < 4; ++i) {
      char digit;
      if(!next_digit(digit))
        return false;
      const int value = base64_value(digit);
      if(value < 0 && !(digit == '=' && i >= 2))
        throw std::runtime_error("is not base64: has the character " +
                                 in_quotes(std::string_view(&digit, 1)));
      if(value >= 0 && digits == i)
        ++digits;
      bits = bits << 6 | static_cast<unsigned>(value < 0 ? 0 : value);
    }
    for(int byte = 0; byte + 1 < digits; ++byte)
      m_decoded += static_cast<char>(bits >> (16 - 8 * byte) & 0xFF);
    return true;
  }

  [[noreturn]] static void fail(std::size_t needed, std::size_t present)
  {
    throw std::runtime_error("ends early: needs " + std::to_string(needed) + " bytes, has " +
                             std::to_string(present));
  }

  std::string_view m_encoded;
  bool m_is_base64;
  std::string m_decoded;
  std::size_t m_used = 0;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_BYTE_SOURCE_H
