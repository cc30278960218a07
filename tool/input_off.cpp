// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_text.h"

#include <algorithm>

namespace mapt {

namespace {

struct Off_header
{
  bool has_normals = false;
  bool is_homogeneous = false;
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

std::size_t count(const Input_file& file, const Text_cursor& cursor, std::string_view word,
                  const char* what)
{
  long long value = 0;
  if(!parse(word, value) || value < 0 || value > 0xffffffffLL)
    file.fail(cursor.line(),
              std::string("the number of ") + what + " is " + in_quotes(word) +
                  ": must be an integer from 0 to 4294967295; export the file again");
  return std::size_t(value);
}

// [ST][C][N][4]OFF, then the counts, perhaps on the same line, perhaps without a blank between.
Off_header read_header(const Input_file& file, Text_cursor& cursor)
{
  cursor.next_line();
  std::string_view word = cursor.word();
  const std::size_t off = word.find("OFF");
  const std::string_view prefix = word.substr(0, off);
  if(off == std::string_view::npos || prefix.find_first_not_of("STCN4n") != std::string_view::npos)
    file.fail("is not an OFF file: it begins with " + in_quotes(word) +
              ", not with OFF; check its format and extension");
  if(prefix.find('n') != std::string_view::npos)
    file.fail("is an nOFF file: points of other than 3 dimensions; export it as OFF");

  Off_header header;
  header.has_normals = prefix.find('N') != std::string_view::npos;
  header.is_homogeneous = prefix.find('4') != std::string_view::npos;
  word.remove_prefix(off + 3);
  if(word.empty())
    word = cursor.word_of_any_line();
  if(word == "BINARY")
    file.fail("is a binary OFF file, which mapt does not read: export it as text");
  header.vertices = count(file, cursor, word, "vertices");
  header.faces = count(file, cursor, cursor.word_of_any_line(), "faces");
  return header; // the number of edges, if there, is the rest of the line
}

void read_vertices(const Input_file& file, Text_cursor& cursor, const Off_header& header,
                   Raw_mesh& mesh)
{
  // a vertex takes at least the bytes of "0 0 0\n"
  mesh.points.reserve(std::min(header.vertices, cursor.bytes_left() / 6 + 1));
  for(std::size_t i = 0; i < header.vertices; ++i) {
    if(!cursor.next_line())
      file.fail("ends after " + std::to_string(i) + " of " + std::to_string(header.vertices) +
                " vertices: the file is cut off; export it again");
    const auto element = [i] { return "vertex " + std::to_string(i); };
    Vector_3 v = three_coordinates(file, cursor, element);
    if(header.is_homogeneous) {
      double w = 0;
      if(!parse(cursor.word(), w) || w == 0 || !is_usable(v.x() / w, v.y() / w, v.z() / w))
        file.fail(cursor.line(), element() + " has no usable fourth coordinate: give it a weight "
                                             "other than 0, or export the file as OFF");
      v = v / w;
    }
    mesh.points.emplace_back(v.x(), v.y(), v.z());
    if(header.has_normals)
      mesh.normals.push_back(three_numbers(file, cursor, element));
  }
}

void read_faces(const Input_file& file, Text_cursor& cursor, const Off_header& header,
                Raw_mesh& mesh)
{
  const auto last = (long long)(header.vertices) - 1;
  mesh.polygons.ends.reserve(std::min(header.faces, cursor.bytes_left() / 4 + 1));
  mesh.polygons.vertices.reserve(3 * mesh.polygons.ends.capacity());
  for(std::size_t i = 0; i < header.faces; ++i) {
    if(!cursor.next_line())
      file.fail("ends after " + std::to_string(i) + " of " + std::to_string(header.faces) +
                " faces: the file is cut off; export it again");
    const auto fail = [&](const std::string& what) {
      file.fail(cursor.line(), "face " + std::to_string(i) + " " + what);
    };
    std::string_view word = cursor.word();
    long long degree = 0;
    if(!parse(word, degree) || degree < 0)
      fail("has " + in_quotes(word) + " for its number of vertices: export the file again");
    for(long long corner = 0; corner < degree; ++corner) {
      word = cursor.word();
      long long index = 0;
      if(word.empty())
        fail("has " + std::to_string(corner) + " of " + std::to_string(degree) +
             " vertices: the file is damaged or cut off; export it again");
      if(!parse(word, index))
        fail("has " + in_quotes(word) + " for a vertex index: export the file again");
      if(index < 0 || index > last)
        fail(index_defect(index, 0, last));
      mesh.polygons.vertices.push_back(std::uint32_t(index));
    }
    mesh.polygons.close_face(); // the rest of the line is colour
  }
}

} // namespace

Raw_mesh read_off(const Input_file& file)
{
  Text_cursor cursor(file.bytes);
  const Off_header header = read_header(file, cursor);
  Raw_mesh mesh;
  read_vertices(file, cursor, header, mesh);
  read_faces(file, cursor, header, mesh);
  return mesh;
}

} // namespace mapt
