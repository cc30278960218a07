// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_text.h"

#include <limits>

namespace mapt {

namespace {

// The largest positive index, which may refer to a vertex further down the file.
struct Largest_index
{
  long long value = 0;
  std::size_t face = 0;
  std::size_t line = 0;
};

// "7", "7/1", "7//3" or "7/1/3"; counted from 1, or backwards from the last vertex with -1.
void read_face(const Input_file& file, Text_cursor& cursor, Raw_mesh& mesh, Largest_index& largest)
{
  const auto vertices = (long long)(mesh.points.size());
  const std::size_t face = mesh.polygons.size() + 1;
  for(std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
    long long index = 0;
    if(!parse(word.substr(0, word.find('/')), index))
      file.fail(cursor.line(), "face " + std::to_string(face) + " has " + in_quotes(word) +
                                   " for a vertex index: export the file again");
    const long long from_one = index < 0 ? vertices + 1 + index : index;
    if(from_one < 1 || from_one > std::numeric_limits<std::uint32_t>::max())
      file.fail(cursor.line(),
                "face " + std::to_string(face) + " " + index_defect(index, 1, vertices));
    if(from_one > largest.value)
      largest = {from_one, face, cursor.line()};
    mesh.polygons.vertices.push_back(std::uint32_t(from_one - 1));
  }
  mesh.polygons.close_face();
}

} // namespace

Raw_mesh read_obj(const Input_file& file)
{
  Raw_mesh mesh;
  Largest_index largest;
  Text_cursor cursor(file.bytes);
  while(cursor.next_line()) {
    const std::string_view keyword = cursor.word();
    if(keyword == "v") {
      const Vector_3 v = three_coordinates(
          file, cursor, [&mesh] { return "vertex " + std::to_string(mesh.points.size() + 1); });
      mesh.points.emplace_back(v.x(), v.y(), v.z());
    } else if(keyword == "vn") {
      mesh.normals.push_back(three_numbers(
          file, cursor, [&mesh] { return "normal " + std::to_string(mesh.normals.size() + 1); }));
    } else if(keyword == "f") {
      read_face(file, cursor, mesh, largest);
    } // groups, materials, curves and what exporters invent do not change the surface
  }
  const auto vertices = (long long)(mesh.points.size());
  if(largest.value > vertices)
    file.fail(largest.line, "face " + std::to_string(largest.face) + " " +
                                index_defect(largest.value, 1, vertices));
  if(mesh.points.empty())
    file.fail("is not an OBJ mesh: it has no line that begins with v; check its format and "
              "extension");
  if(mesh.normals.size() != mesh.points.size())
    mesh.normals.clear(); // normals of corners, not of points
  return mesh;
}

} // namespace mapt
