// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_DATA_ARRAY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_DATA_ARRAY_H

#include <CGAL/Area_projection_transform/IO/Typed_values.h>
#include <CGAL/Area_projection_transform/internal/vtk_xml_file.h>
#include <CGAL/Area_projection_transform/internal/zlib_streams.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// the names of the scalar types in VTK's XML format, in the order of `Scalar_type`.
constexpr std::array<std::string_view, 10> vtk_type_names = {
    "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float32", "Float64"};

inline Scalar_type vtk_scalar_type(const std::string& name)
{
  for(std::size_t i = 0; i < vtk_type_names.size(); ++i)
    if(vtk_type_names[i] == name)
      return Scalar_type(i);
  throw std::runtime_error("type is " + in_quotes(name) + ": not supported");
}

/// reads the array of a `DataArray` element, however it is stored.
class Vtk_data_array_reader
{
public:
  Vtk_data_array_reader(Vtk_xml_file& file, const Xml_element& element)
      : m_file(file), m_element(element)
  {}

  Typed_values read(Scalar_type type)
  {
    Typed_values values = empty_values(type);
    std::visit([&](auto& v) { read(v); }, values);
    return values;
  }

  template <class Scalar>
  void read(std::vector<Scalar>& values)
  {
    const std::string format = m_element.attribute("format").value_or("ascii");
    if(format == "ascii") {
      m_file.consume(m_element.text.size());
      const std::string_view wrong = read_numbers(m_element.text, values);
      if(!wrong.empty())
        throw std::runtime_error("value " + std::to_string(values.size()) + " is " +
                                 in_quotes(wrong) + ": not a number of its type");
      return;
    }
    if(format != "binary" && format != "appended")
      throw std::runtime_error("format is " + in_quotes(format) +
                               ": must be ascii, binary or appended");
    Vtk_byte_source source =
        format == "binary" ? m_file.inline_data(m_element.text) : m_file.appended_data(offset());
    Byte_appender<Scalar> appender(values);
    if(m_file.is_compressed())
      read_compressed(source, appender);
    else
      read_plain(source, appender);
    if(appender.number_of_bytes() % sizeof(Scalar) != 0)
      throw std::runtime_error("has " + std::to_string(appender.number_of_bytes()) +
                               " bytes: not a whole number of values");
  }

private:
  std::size_t offset() const
  {
    const std::string text = m_element.attribute("offset").value_or("");
    std::size_t value = 0;
    if(!from_text(trim(text), value))
      throw std::runtime_error("offset is " + in_quotes(text) + ": not a number of bytes");
    return value;
  }

  /// the header number with the given index.
  std::size_t header_number(Vtk_byte_source& source, std::size_t index) const
  {
    const std::size_t size = m_file.size_of_header_number();
    const std::string_view bytes = source.first((index + 1) * size).substr(index * size);
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data(), size);
    return static_cast<std::size_t>(value);
  }

  template <class Appender>
  void read_plain(Vtk_byte_source& source, Appender& appender)
  {
    const std::size_t header = m_file.size_of_header_number();
    const std::size_t number = header_number(source, 0);
    if(number > source.capacity() - header)
      throw std::runtime_error("claims " + std::to_string(number) +
                               " bytes: more than are left in "
                               "the file");
    const std::string_view bytes = source.first(header + number).substr(header);
    m_file.consume(source.number_of_used_characters());
    if(number != 0)
      std::memcpy(appender(number), bytes.data(), number);
  }

  /// the header is: number of blocks, size of a block, size of the last one if it is smaller, and
  /// the compressed size of each.
  template <class Appender>
  void read_compressed(Vtk_byte_source& source, Appender& appender)
  {
    const std::size_t blocks = header_number(source, 0);
    if(blocks == 0)
      return;
    if(blocks > source.capacity() / m_file.size_of_header_number())
      throw std::runtime_error("claims " + std::to_string(blocks) +
                               " compressed blocks: more than fit in the file");
    const std::size_t block_size = header_number(source, 1);
    const std::size_t last_size = header_number(source, 2);
    const std::vector<std::size_t> sizes = compressed_sizes(source, blocks);
    std::size_t position = (3 + blocks) * m_file.size_of_header_number();
    const std::string_view bytes = source.first(position + sizes.back());
    m_file.consume(source.number_of_used_characters());
    Inflater inflater(Zlib_wrapper::ZLIB);
    for(std::size_t block = 0, begin = 0; block < blocks; begin = sizes[block++])
      inflater.run(bytes.substr(position + begin, sizes[block] - begin),
                   block + 1 == blocks && last_size != 0 ? last_size : block_size, appender);
  }

  /// the ends of the compressed blocks, counted from the first one.
  std::vector<std::size_t> compressed_sizes(Vtk_byte_source& source, std::size_t blocks) const
  {
    source.first((3 + blocks) * m_file.size_of_header_number());
    std::vector<std::size_t> ends;
    std::size_t end = 0;
    for(std::size_t block = 0; block < blocks; ++block) {
      const std::size_t size = header_number(source, 3 + block);
      if(size > source.capacity() - end)
        throw std::runtime_error("block " + std::to_string(block) + " claims " +
                                 std::to_string(size) + " bytes: more than are left in the file");
      ends.push_back(end += size);
    }
    return ends;
  }

  Vtk_xml_file& m_file;
  const Xml_element& m_element;
};

/// the number of values of the array that make up one point or cell.
inline std::size_t vtk_components(const Xml_element& element)
{
  const std::string text = element.attribute("NumberOfComponents").value_or("1");
  std::size_t components = 0;
  if(!from_text(trim(text), components) || components == 0)
    throw std::runtime_error("NumberOfComponents is " + in_quotes(text) + ": must be at least 1");
  return components;
}

/// runs `read()` and puts the names of the file and of the array before what it complains about.
template <class Read>
auto with_array_name(const Vtk_xml_file& file, const std::string& array, Read read)
{
  try {
    return read();
  } catch(const std::runtime_error& error) {
    file.fail("array " + in_quotes(array) + ": " + error.what());
  }
}

/// reads an array in the type it has in the file.
inline Typed_values read_vtk_array(Vtk_xml_file& file, const Xml_element& element)
{
  return with_array_name(file, element.attribute("Name").value_or(""), [&] {
    return Vtk_data_array_reader(file, element)
        .read(vtk_scalar_type(element.attribute("type").value_or("")));
  });
}

/// \brief reads a text: its characters, as bytes or as a list of numbers, end with a zero. Several
/// texts become the lines of one.
inline std::string read_vtk_text(Vtk_xml_file& file, const Xml_element& element)
{
  return with_array_name(file, element.attribute("Name").value_or(""), [&] {
    const bool is_ascii = element.attribute("format").value_or("ascii") == "ascii";
    const Typed_values codes = Vtk_data_array_reader(file, element)
                                   .read(is_ascii ? Scalar_type::INT16 : Scalar_type::UINT8);
    std::string text;
    for(const int code : converted<int>(codes))
      text += code == 0 ? '\n' : static_cast<char>(code);
    if(!text.empty() && text.back() == '\n')
      text.pop_back();
    return text;
  });
}

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_DATA_ARRAY_H
