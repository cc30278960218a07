// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_NUMBER_TEXT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_NUMBER_TEXT_H

#include <CGAL/Area_projection_transform/internal/to_text.h>

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns the shortest text that reads back as exactly the same number, whatever the
/// locale.
/// \param value the number
template <class Number>
std::string to_text(Number value)
{
  return Area_projection::internal::to_text(value);
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a number that makes up the whole of `text`, whatever the locale.
///
/// Returns whether it is one and fits in `value`; `nan` and `inf` are numbers of a floating type.
/// \param text what is read
/// \param value becomes the number
template <class Number>
bool from_text(std::string_view text, Number& value)
{
  static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>);
  if(text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/// \cond SKIP_IN_MANUAL
namespace internal {

inline bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

inline std::string_view trim(std::string_view text)
{
  while(!text.empty() && is_blank(text.front()))
    text.remove_prefix(1);
  while(!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

/// takes the next word off the front of `text`; empty at the end.
inline std::string_view next_word(std::string_view& text)
{
  std::size_t begin = 0;
  while(begin < text.size() && is_blank(text[begin]))
    ++begin;
  std::size_t end = begin;
  while(end < text.size() && !is_blank(text[end]))
    ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// appends the words of `text` to `numbers`; returns the first that is not a number, or nothing.
template <class Numbers>
std::string_view read_numbers(std::string_view text, Numbers& numbers)
{
  for(std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
    typename Numbers::value_type value;
    if(!from_text(word, value))
      return word;
    numbers.push_back(value);
  }
  return {};
}

/// makes text of a file fit for a message: one line, printable, not too long.
inline std::string in_quotes(std::string_view text)
{
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for(char c : text.substr(0, longest))
    result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return result + (text.size() > longest ? "…'" : "'");
}

} // namespace internal
/// \endcond

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_NUMBER_TEXT_H
