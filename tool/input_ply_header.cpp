// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_ply_header.h"

#include <utility>

namespace mapt {

namespace {

Ply_type read_type(const Input_file& file, Text_cursor& cursor)
{
  static const std::pair<const char*, Ply_type> names[] = {
      {"char", Ply_type::int8},      {"int8", Ply_type::int8},       {"uchar", Ply_type::uint8},
      {"uint8", Ply_type::uint8},    {"short", Ply_type::int16},     {"int16", Ply_type::int16},
      {"ushort", Ply_type::uint16},  {"uint16", Ply_type::uint16},   {"int", Ply_type::int32},
      {"int32", Ply_type::int32},    {"uint", Ply_type::uint32},     {"uint32", Ply_type::uint32},
      {"float", Ply_type::float32},  {"float32", Ply_type::float32}, {"double", Ply_type::float64},
      {"float64", Ply_type::float64}};
  const std::string_view word = cursor.word();
  for(const auto& [name, type] : names)
    if(word == name)
      return type;
  file.fail(cursor.line(), in_quotes(word) + " is no type of PLY: export the file again");
}

Ply_property read_property(const Input_file& file, Text_cursor& cursor)
{
  Ply_property property;
  Text_cursor ahead = cursor;
  if(ahead.word() == "list") {
    cursor = ahead;
    property.is_list = true;
    property.count_type = read_type(file, cursor);
    if(property.count_type >= Ply_type::float32)
      file.fail(cursor.line(), "a list has a length that is not an integer: export the file again");
  }
  property.type = read_type(file, cursor);
  property.name = std::string(cursor.word());
  return property;
}

Ply_element read_element(const Input_file& file, Text_cursor& cursor)
{
  Ply_element element;
  element.name = std::string(cursor.word());
  const std::string_view word = cursor.word();
  long long count = 0;
  if(!parse(word, count) || count < 0 || count > 0xffffffffLL)
    file.fail(cursor.line(), "the number of elements " + in_quotes(element.name) + " is " +
                                 in_quotes(word) + ": must be an integer from 0 to 4294967295");
  element.count = std::size_t(count);
  return element;
}

Ply_encoding read_encoding(const Input_file& file, Text_cursor& cursor)
{
  const std::string_view word = cursor.word();
  if(word == "ascii")
    return Ply_encoding::text;
  if(word == "binary_little_endian")
    return Ply_encoding::little_endian;
  if(word == "binary_big_endian")
    return Ply_encoding::big_endian;
  file.fail(cursor.line(), in_quotes(word) + " is no format of PLY: must be ascii, "
                                             "binary_little_endian or binary_big_endian");
}

} // namespace

std::size_t size_of(Ply_type type)
{
  static const std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[std::size_t(type)];
}

Ply_header read_ply_header(const Input_file& file, Text_cursor& cursor)
{
  Ply_header header;
  cursor.next_line();
  const std::string_view first = cursor.word();
  if(first != "ply")
    file.fail("is not a PLY file: it begins with " + in_quotes(first) +
              ", not with ply; check its format and extension");
  while(cursor.next_line()) {
    const std::string_view keyword = cursor.word();
    if(keyword == "format") {
      header.encoding = read_encoding(file, cursor);
    } else if(keyword == "element") {
      header.elements.push_back(read_element(file, cursor));
    } else if(keyword == "property") {
      if(header.elements.empty())
        file.fail(cursor.line(), "a property comes before any element: export the file again");
      header.elements.back().properties.push_back(read_property(file, cursor));
    } else if(keyword == "end_header") {
      cursor.skip_line();
      return header;
    } else if(keyword != "comment" && keyword != "obj_info") {
      file.fail(cursor.line(), in_quotes(keyword) + " is no word of a PLY header: export the file "
                                                    "again");
    }
  }
  file.fail("has no end_header: the file is cut off; export it again");
}

} // namespace mapt
