// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_ply_header.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace mapt {

namespace {

// The values behind the header, one after the other, whatever their encoding.
class Ply_body
{
public:
  Ply_body(const Input_file& file, Text_cursor cursor, Ply_encoding encoding)
      : m_file(file), m_cursor(cursor), m_at(cursor.position()), m_encoding(encoding)
  {}

  std::size_t bytes_left() const
  {
    return m_encoding == Ply_encoding::text ? m_cursor.bytes_left() : m_file.bytes.size() - m_at;
  }

  // returns the next value; a double holds every integer of PLY.
  double value(Ply_type type)
  {
    return m_encoding == Ply_encoding::text ? text_value(type) : binary_value(type);
  }

  // skips the next values of which nobody needs to know the number.
  void skip(Ply_type type, std::size_t count)
  {
    if(m_encoding == Ply_encoding::text) {
      for(std::size_t i = 0; i < count; ++i)
        text_value(type);
    } else {
      if(count > bytes_left() / size_of(type))
        fail("the file is cut off; export it again");
      m_at += count * size_of(type);
    }
  }

  std::size_t list_length(const Ply_property& list)
  {
    const double length = value(list.count_type);
    if(!(length >= 0))
      fail("has a list of negative length: the file is damaged; export it again");
    if(length > double(bytes_left())) // a value takes a byte or more
      fail("has a list longer than the rest of the file: it is damaged or cut off; export it "
           "again");
    return std::size_t(length);
  }

  void set_element(const std::string& name, std::size_t index)
  {
    m_element = &name;
    m_index = index;
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    const std::string text = *m_element + " " + std::to_string(m_index) + " " + what;
    if(m_encoding == Ply_encoding::text)
      m_file.fail(m_cursor.line(), text);
    m_file.fail(text);
  }

private:
  double text_value(Ply_type type)
  {
    const std::string_view word = m_cursor.word_of_any_line();
    if(word.empty())
      fail("is not complete: the file is cut off; export it again");
    double number = 0;
    long long integer = 0;
    const bool is_real = type >= Ply_type::float32;
    if(!(is_real ? parse(word, number) : parse(word, integer)))
      fail("has " + in_quotes(word) + " for " + (is_real ? "a number" : "an integer") +
           ": export the file again");
    return is_real ? number : double(integer);
  }

  template <class T>
  double decode()
  {
    std::array<char, sizeof(T)> bytes;
    std::copy_n(m_file.bytes.data() + m_at, sizeof(T), bytes.begin());
    const bool is_host_little_endian = [] {
      const std::uint16_t one = 1;
      char first;
      std::memcpy(&first, &one, 1);
      return first == 1;
    }();
    if((m_encoding == Ply_encoding::little_endian) != is_host_little_endian)
      std::reverse(bytes.begin(), bytes.end());
    m_at += sizeof(T);
    T result;
    std::memcpy(&result, bytes.data(), sizeof(T));
    return double(result);
  }

  double binary_value(Ply_type type)
  {
    if(bytes_left() < size_of(type))
      fail("is not complete: the file is cut off; export it again");
    switch(type) {
    case Ply_type::int8:
      return decode<std::int8_t>();
    case Ply_type::uint8:
      return decode<std::uint8_t>();
    case Ply_type::int16:
      return decode<std::int16_t>();
    case Ply_type::uint16:
      return decode<std::uint16_t>();
    case Ply_type::int32:
      return decode<std::int32_t>();
    case Ply_type::uint32:
      return decode<std::uint32_t>();
    case Ply_type::float32:
      return decode<float>();
    case Ply_type::float64:
      break;
    }
    return decode<double>();
  }

  const Input_file& m_file;
  Text_cursor m_cursor;
  std::size_t m_at;
  Ply_encoding m_encoding;
  const std::string* m_element = nullptr;
  std::size_t m_index = 0;
};

int position(const std::vector<Ply_property>& properties, const char* name)
{
  for(std::size_t i = 0; i < properties.size(); ++i)
    if(!properties[i].is_list && properties[i].name == name)
      return int(i);
  return -1;
}

void skip_property(Ply_body& body, const Ply_property& property)
{
  body.skip(property.type, property.is_list ? body.list_length(property) : 1);
}

void read_vertices(const Input_file& file, Ply_body& body, const Ply_element& element,
                   Raw_mesh& mesh)
{
  const char* const names[7] = {"x", "y", "z", "nx", "ny", "nz", "area"};
  std::array<int, 7> places;
  std::transform(std::begin(names), std::end(names), places.begin(),
                 [&](const char* name) { return position(element.properties, name); });
  if(places[0] < 0 || places[1] < 0 || places[2] < 0)
    file.fail("its vertices lack a property x, y or z: export the file again");
  const bool has_normals = places[3] >= 0 && places[4] >= 0 && places[5] >= 0;

  mesh.points.reserve(std::min(element.count, body.bytes_left()));
  std::vector<double> values(element.properties.size());
  for(std::size_t i = 0; i < element.count; ++i) {
    body.set_element(element.name, i);
    for(std::size_t p = 0; p < values.size(); ++p)
      if(element.properties[p].is_list)
        skip_property(body, element.properties[p]);
      else
        values[p] = body.value(element.properties[p].type);
    const auto of = [&](int which) { return values[std::size_t(places[std::size_t(which)])]; };
    if(!is_usable(of(0), of(1), of(2)))
      body.fail(coordinate_defect(of(0), of(1), of(2)));
    mesh.points.emplace_back(of(0), of(1), of(2));
    if(has_normals)
      mesh.normals.emplace_back(of(3), of(4), of(5));
    if(places[6] >= 0)
      mesh.areas.push_back(of(6));
  }
}

void read_faces(const Input_file& file, Ply_body& body, const Ply_element& element,
                std::size_t number_of_points, Raw_mesh& mesh)
{
  const auto is_indices = [](const Ply_property& p) {
    return p.is_list && p.type < Ply_type::float32 &&
           (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  if(std::none_of(element.properties.begin(), element.properties.end(), is_indices))
    file.fail("its faces have no list of integers vertex_indices: export the file again");
  mesh.polygons.ends.reserve(std::min(element.count, body.bytes_left()));
  for(std::size_t i = 0; i < element.count; ++i) {
    body.set_element(element.name, i);
    for(const Ply_property& property : element.properties) {
      if(!is_indices(property)) {
        skip_property(body, property);
        continue;
      }
      for(std::size_t left = body.list_length(property); left > 0; --left) {
        const double index = body.value(property.type);
        if(!(index >= 0 && index < double(number_of_points)))
          body.fail(index_defect((long long)(index), 0, (long long)(number_of_points)-1));
        mesh.polygons.vertices.push_back(std::uint32_t(index));
      }
    }
    mesh.polygons.close_face();
  }
}

bool is_vertex(const Ply_element& e)
{
  return e.name == "vertex" || e.name == "vertices";
}
bool is_face(const Ply_element& e)
{
  return e.name == "face" || e.name == "faces";
}

} // namespace

Raw_mesh read_ply(const Input_file& file)
{
  Text_cursor cursor(file.bytes);
  const Ply_header header = read_ply_header(file, cursor);
  const auto vertices = std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
  if(vertices == header.elements.end())
    file.fail("has no element vertex: must hold a mesh or points; export it again");

  Ply_body body(file, cursor, header.encoding);
  Raw_mesh mesh;
  for(const Ply_element& element : header.elements) {
    if(&element == &*vertices)
      read_vertices(file, body, element, mesh);
    else if(is_face(element))
      read_faces(file, body, element, vertices->count, mesh);
    else if(!element.properties.empty()) // else its items take no bytes, whatever their number
      for(std::size_t i = 0; i < element.count; ++i) {
        body.set_element(element.name, i);
        for(const Ply_property& property : element.properties)
          skip_property(body, property);
      }
  }
  return mesh;
}

} // namespace mapt
