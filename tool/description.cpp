// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "description.h"

#include "cost.h"
#include "errors.h"
#include "text.h"

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <exception>
#include <new>
#include <stdexcept>

namespace mapt {

namespace {

AP::Shape_descriptor compute(const Input& input, const Describe_options& options)
{
  if(input.is_point_set)
    throw Input_error(input.file + ": has points only: a descriptor needs faces");
  try {
    return AP::shape_descriptor(AP::surface_from_triangle_soup(input.points, input.triangles),
                                options.descriptor);
  } catch(const std::invalid_argument& error) {
    throw Input_error(input.file + ": " + error.what() + "; see mapt info");
  }
}

void describe(const std::string& file, const Describe_options& options, Description& description)
{
  Stopwatch watch;
  const Input input = read_input(file, options.common.reading);
  description.reading = watch.seconds();
  for(const std::string& line : warnings(input.report))
    description.remark += (description.remark.empty() ? "" : "; ") + line;
  description.values = compute(input, options).values;
  description.computing = watch.seconds();
}

constexpr std::string_view hexadecimal = "0123456789ABCDEF";

} // namespace

Description describe_file(const std::string& file, const Describe_options& options)
{
  Description description;
  try {
    describe(file, options, description);
  } catch(const Input_error& error) {
    description.failure = printable(error.what());
  } catch(const Usage_error& error) {
    description.failure = printable(file + ": " + error.what());
  } catch(const std::bad_alloc&) {
    description.failure =
        printable(file) + ": does not fit into the memory: simplify the mesh, or lower --threads";
  } catch(const std::exception& error) {
    description.failure = printable(file + ": internal: " + error.what());
  }
  return description;
}

std::string to_line(const Description& description)
{
  std::string line = to_word(description.failure) + ' ' + to_word(description.remark) + ' ' +
                     AP::IO::to_text(description.reading) + ' ' +
                     AP::IO::to_text(description.computing);
  for(const float value : description.values)
    line += ' ' + AP::IO::to_text(value);
  return line;
}

std::optional<Description> description_from(std::string_view line)
{
  using AP::IO::internal::next_word;
  Description description;
  description.failure = text_from(next_word(line));
  description.remark = text_from(next_word(line));
  if(!AP::IO::from_text(next_word(line), description.reading) ||
     !AP::IO::from_text(next_word(line), description.computing) ||
     !AP::IO::internal::read_numbers(line, description.values).empty())
    return std::nullopt;
  return description;
}

std::string to_word(const std::string& text)
{
  if(text.empty())
    return "%";
  std::string word;
  for(const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if(byte > 0x20 && byte != 0x7f && c != '%')
      word += c;
    else
      ((word += '%') += hexadecimal[byte / 16]) += hexadecimal[byte % 16];
  }
  return word;
}

std::string text_from(std::string_view word)
{
  std::string text;
  for(std::size_t i = 0; i < word.size(); ++i) {
    if(word[i] != '%') {
      text += word[i];
    } else if(i + 2 < word.size()) {
      text += char(16 * hexadecimal.find(word[i + 1]) + hexadecimal.find(word[i + 2]));
      i += 2;
    }
  }
  return text;
}

} // namespace mapt
