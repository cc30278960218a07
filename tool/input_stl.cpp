// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_text.h"
#include "mesh_topology.h"

#include <cctype>
#include <cstring>

namespace mapt {

namespace {

constexpr std::size_t header_size = 84; // 80 bytes of comment, 4 of the number of facets
constexpr std::size_t facet_size = 50;  // a normal, 3 vertices, 2 bytes of attributes

std::uint32_t little_endian(const char* bytes)
{
  std::uint32_t value = 0;
  for(int i = 3; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

double little_endian_float(const char* bytes)
{
  const std::uint32_t bits = little_endian(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return double(value);
}

std::string lower_case(std::string_view word)
{
  std::string result(word);
  for(char& c : result)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// The corners of the facets, three after three. The format knows no shared vertices.
std::vector<Point_3> read_binary(const Input_file& file)
{
  if(file.bytes.size() < header_size)
    file.fail("is not an STL file: it has neither 'solid' nor the 84 bytes of a binary header; "
              "check its format and extension");
  const std::size_t facets = little_endian(file.bytes.data() + 80);
  const std::size_t available = (file.bytes.size() - header_size) / facet_size;
  if(facets > available)
    file.fail("ends after " + std::to_string(available) + " of " + std::to_string(facets) +
              " facets: the file is cut off or not a binary STL; export it again");
  std::vector<Point_3> corners;
  corners.reserve(3 * facets);
  for(std::size_t i = 0; i < facets; ++i)
    for(std::size_t corner = 0; corner < 3; ++corner) {
      const char* at = file.bytes.data() + header_size + i * facet_size + 12 * (1 + corner);
      const double x = little_endian_float(at);
      const double y = little_endian_float(at + 4);
      const double z = little_endian_float(at + 8);
      if(!is_usable(x, y, z))
        file.fail("vertex " + std::to_string(corner) + " of facet " + std::to_string(i) + " " +
                  coordinate_defect(x, y, z));
      corners.emplace_back(x, y, z);
    }
  return corners;
}

std::vector<Point_3> read_text(const Input_file& file)
{
  std::vector<Point_3> corners;
  Text_cursor cursor(file.bytes);
  bool is_ended = false;
  std::size_t facet_begin = 0;
  const auto facet = [&facet_begin] { return "facet " + std::to_string(facet_begin / 3); };
  while(cursor.next_line()) {
    const std::string keyword = lower_case(cursor.word());
    if(keyword == "vertex") {
      const Vector_3 v = three_coordinates(file, cursor, [&] { return "a vertex of " + facet(); });
      corners.emplace_back(v.x(), v.y(), v.z());
    } else if(keyword == "endfacet") {
      if(corners.size() != facet_begin + 3)
        file.fail(cursor.line(), facet() + " has " + std::to_string(corners.size() - facet_begin) +
                                     " vertices: must be 3; export the file again");
      facet_begin = corners.size();
    } else if(keyword == "solid") {
      is_ended = false;
    } else if(keyword == "endsolid") {
      is_ended = true;
    } else if(keyword != "facet" && keyword != "outer" && keyword != "endloop") {
      file.fail(cursor.line(), in_quotes(keyword) + " is no word of STL: the file is damaged or of "
                                                    "another format; export it again");
    }
  }
  if(!is_ended || facet_begin != corners.size())
    file.fail("ends within " + facet() +
              ", without 'endsolid': the file is cut off; export it "
              "again");
  return corners;
}

// Gives equal corners one vertex, facets of STL share them by position only; vertices keep the order
// in which the file names them first.
Raw_mesh join_corners(const std::vector<Point_3>& corners)
{
  const std::vector<std::uint32_t> first_equal = join_equal_points(corners);
  Raw_mesh mesh;
  std::vector<std::uint32_t> vertex(corners.size());
  mesh.polygons.vertices.reserve(corners.size());
  mesh.polygons.ends.reserve(corners.size() / 3);
  for(std::size_t i = 0; i < corners.size(); ++i) {
    if(first_equal[i] == i) {
      vertex[i] = std::uint32_t(mesh.points.size());
      mesh.points.push_back(corners[i]);
    }
    mesh.polygons.vertices.push_back(vertex[first_equal[i]]);
    if(i % 3 == 2)
      mesh.polygons.close_face();
  }
  return mesh;
}

// Binary files may begin with "solid" too, so that the size decides where it fits exactly.
bool is_binary(const Input_file& file)
{
  const std::string& bytes = file.bytes;
  if(bytes.size() >= header_size &&
     bytes.size() == header_size + facet_size * std::size_t(little_endian(bytes.data() + 80)))
    return true;
  return lower_case(Text_cursor(bytes).word_of_any_line()) != "solid";
}

} // namespace

Raw_mesh read_stl(const Input_file& file)
{
  const std::vector<Point_3> corners = is_binary(file) ? read_binary(file) : read_text(file);
  if(corners.size() > 0xffffffffu)
    file.fail("has more than 4294967295 corners: simplify the mesh");
  return join_corners(corners);
}

} // namespace mapt
