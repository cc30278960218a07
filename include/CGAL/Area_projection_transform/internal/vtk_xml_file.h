// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_XML_FILE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_XML_FILE_H

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/vtk_byte_source.h>
#include <CGAL/Area_projection_transform/internal/whole_file.h>
#include <CGAL/Area_projection_transform/internal/xml_document.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

static_assert(boost::endian::order::native == boost::endian::order::little,
              "the file formats are written and read in the byte order of the machine");

/// \brief a file in VTK's XML format: its elements, and where its data are and how they are stored.
///
/// Every size in the file is a claim; it is held against the size of the file before it is used.
class Vtk_xml_file
{
public:
  /// \brief reads the file.
  /// \throw std::runtime_error if it is not a VTK file of the data set `type`, such as "PolyData".
  Vtk_xml_file(const std::string& name, std::string_view type)
      : m_name(name)
      , m_bytes(read_whole_file(name))
      , m_unread(m_bytes.size())
      , m_document(parsed(m_bytes, name))
  {
    if(document().root().name != "VTKFile")
      fail("is not a VTK XML file");
    read_root(type);
    if(const Xml_element* appended = document().last())
      read_appended(*appended);
  }

  Vtk_xml_file(const Vtk_xml_file&) = delete;
  Vtk_xml_file& operator=(const Vtk_xml_file&) = delete;

  const Xml_document& document() const { return m_document; }
  const Xml_element& data_set() const { return *m_data_set; }
  const std::string& name() const { return m_name; }

  bool is_compressed() const { return m_is_compressed; }
  /// the number of bytes of the sizes that precede binary data.
  std::size_t size_of_header_number() const { return m_size_of_header_number; }

  /// the data of an array with the given text or `offset` in the appended data.
  Vtk_byte_source inline_data(std::string_view text) const { return {text, true}; }
  Vtk_byte_source appended_data(std::size_t offset) const
  {
    if(offset > m_appended.size())
      throw std::runtime_error("offset is " + std::to_string(offset) + ": the appended data have " +
                               std::to_string(m_appended.size()) + " bytes");
    return {m_appended.substr(offset), m_is_appended_base64};
  }

  /// \brief counts bytes of the file as read. Without it a small file could ask for the same bytes
  /// under a thousand names.
  void consume(std::size_t number)
  {
    if(number > m_unread)
      throw std::runtime_error("overlaps another array");
    m_unread -= number;
  }

  /// \brief returns an attribute that is a list of numbers.
  /// \throw std::runtime_error unless there are `number` of them.
  template <class Number>
  std::vector<Number> numbers(const Xml_element& element, const char* attribute,
                              std::size_t number) const
  {
    const std::string text = element.attribute(attribute).value_or("");
    std::vector<Number> values;
    if(!read_numbers(text, values).empty() || values.size() != number)
      fail("attribute " + std::string(attribute) + " of element '" + std::string(element.name) +
           "' is " + in_quotes(text) + ": must be " + std::to_string(number) +
           (number == 1 ? " number" : " numbers"));
    return values;
  }

  [[noreturn]] void fail(const std::string& cause) const
  {
    throw std::runtime_error(m_name + ": " + cause);
  }

private:
  static Xml_document parsed(std::string_view bytes, const std::string& name)
  {
    if(bytes.empty())
      throw std::runtime_error(name + ": is empty");
    try {
      return Xml_document(bytes, "AppendedData");
    } catch(const std::runtime_error& error) {
      throw std::runtime_error(name + ": " + error.what());
    }
  }

  void read_root(std::string_view type)
  {
    const Xml_element& root = document().root();
    const std::string found = root.attribute("type").value_or("");
    m_data_set = document().child(root, type);
    if(found != type || m_data_set == nullptr)
      fail("holds " + in_quotes(found) + ": " + std::string(type) + " is needed");
    if(root.attribute("byte_order").value_or("LittleEndian") != "LittleEndian")
      fail("byte_order is not LittleEndian: not supported; write the file in ascii or on a "
           "little-endian machine");
    const std::string header = root.attribute("header_type").value_or("UInt32");
    if(header != "UInt32" && header != "UInt64")
      fail("header_type is " + in_quotes(header) + ": must be UInt32 or UInt64");
    m_size_of_header_number = header == "UInt32" ? 4 : 8;
    const std::string compressor = root.attribute("compressor").value_or("");
    if(!compressor.empty() && compressor != "vtkZLibDataCompressor")
      fail("compressor is " + in_quotes(compressor) +
           ": not supported; write the file with zlib or without compression");
    m_is_compressed = !compressor.empty();
  }

  void read_appended(const Xml_element& element)
  {
    const std::string encoding = element.attribute("encoding").value_or("");
    if(encoding != "raw" && encoding != "base64")
      fail("the encoding of element 'AppendedData' is " + in_quotes(encoding) +
           ": must be raw or base64");
    m_is_appended_base64 = encoding == "base64";
    m_appended = document().rest();
    const std::size_t mark = m_appended.find('_');
    if(mark == std::string_view::npos || !trim(m_appended.substr(0, mark)).empty())
      fail("element 'AppendedData' does not begin with '_'");
    m_appended.remove_prefix(mark + 1);
  }

  std::string m_name;
  std::string m_bytes;
  std::size_t m_unread;
  Xml_document m_document;
  const Xml_element* m_data_set = nullptr;
  std::string_view m_appended;
  bool m_is_appended_base64 = false;
  bool m_is_compressed = false;
  std::size_t m_size_of_header_number = 4;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_XML_FILE_H
