// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_INPUT_TEXT_H
#define MAPT_INPUT_TEXT_H

#include "input_file.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace mapt {

/// reads a text word by word and knows the line it is on.
///
/// Blanks separate words, `#` begins a comment up to the end of the line, and a backslash at the
/// end of a line continues it on the next one.
class Text_cursor
{
public:
  explicit Text_cursor(std::string_view text) : m_text(text) {}

  /// the number of the current line, from 1.
  std::size_t line() const { return m_line; }
  /// the number of bytes up to and including the current line's last word read.
  std::size_t position() const { return m_at; }
  std::size_t bytes_left() const { return m_text.size() - m_at; }

  /// moves to the next line that has a word on it; returns whether there is one.
  bool next_line();
  /// returns the next word of the line, empty at its end.
  std::string_view word();
  /// returns the next word, on this line or a later one; empty at the end of the text.
  std::string_view word_of_any_line();
  /// moves behind the end of the line.
  void skip_line();

private:
  void skip_blanks();
  bool is_at_end_of_line() const;

  std::string_view m_text;
  std::size_t m_at = 0;
  std::size_t m_line = 1;
  bool m_is_at_start_of_line = true;
};

/// \name Words
/// convert a whole word and return whether it is such a number. A real number may be infinite or
/// not a number: the caller looks, since only it knows the element to name.
/// @{
bool parse(std::string_view word, double& value);
bool parse(std::string_view word, long long& value);
/// @}

/// returns the word as a message shows it: quoted, shortened, and printable.
std::string in_quotes(std::string_view word);

/// returns a vector of the next three real numbers of the line; `element` ("vertex 812") is
/// made only for the message.
template <class Element>
Vector_3 three_numbers(const Input_file& file, Text_cursor& cursor, const Element& element)
{
  double number[3];
  for(double& x : number) {
    const std::string_view word = cursor.word();
    if(!parse(word, x))
      file.fail(cursor.line(), element() +
                                   (word.empty() ? std::string(" has fewer than 3 coordinates: ")
                                                 : " has " + in_quotes(word) + " for a number: ") +
                                   "the file is damaged or cut off; export it again");
  }
  return Vector_3(number[0], number[1], number[2]);
}

/// as `three_numbers()`, but of coordinates that can be computed with.
template <class Element>
Vector_3 three_coordinates(const Input_file& file, Text_cursor& cursor, const Element& element)
{
  const Vector_3 v = three_numbers(file, cursor, element);
  if(!is_usable(v.x(), v.y(), v.z()))
    file.fail(cursor.line(), element() + " " + coordinate_defect(v.x(), v.y(), v.z()));
  return v;
}

} // namespace mapt

#endif // MAPT_INPUT_TEXT_H
