// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_PLY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_PLY_H

#include <CGAL/Area_projection_transform/IO/Typed_values.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

static_assert(boost::endian::order::native == boost::endian::order::little,
              "PLY files are written on little-endian machines only");

/// \ingroup PkgAreaProjectionTransformIO
/// \brief a kind of element of a PLY file, such as `vertex`, with its properties.
class PLY_element
{
public:
  /// lists of three indices of vertices.
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// a property with its values, one for each element.
  struct Property
  {
    std::string name;                             ///< such as `x`, `radius`, `vertex_indices`
    std::variant<Typed_values, Triangles> values; ///< as many as there are elements
  };

  /// constructs a kind of which there are `size` elements, without properties as yet.
  PLY_element(std::string name, std::size_t size) : m_name(std::move(name)), m_size(size) {}

  /// \brief adds a property with a value for each element.
  /// \param property the name of the property
  /// \param values the values, one for each element
  /// \throw std::invalid_argument if there is another number of values, or PLY has no such type (integers
  /// of 64 bits).
  PLY_element& add(const std::string& property, Typed_values values)
  {
    check_size(property, number_of_values(values));
    const Scalar_type type = type_of(values);
    if(type == Scalar_type::INT64 || type == Scalar_type::UINT64)
      throw std::invalid_argument("property " + property +
                                  " has integers of 64 bits: PLY has no such type");
    m_properties.push_back({property, std::move(values)});
    return *this;
  }

  /// \brief adds a list of three indices for each element, such as `vertex_indices` of faces.
  /// \param property the name of the property
  /// \param triangles the lists, one for each element
  /// \throw std::invalid_argument if there is another number of triangles.
  PLY_element& add_list(const std::string& property, Triangles triangles)
  {
    check_size(property, triangles.size());
    m_properties.push_back({property, std::move(triangles)});
    return *this;
  }

  /// the name of the kind, such as `vertex` or `face`.
  const std::string& name() const { return m_name; }
  /// how many elements there are.
  std::size_t size() const { return m_size; }
  /// the properties, in the order in which they were added.
  const std::vector<Property>& properties() const { return m_properties; }

private:
  void check_size(const std::string& property, std::size_t size) const
  {
    if(size != m_size)
      throw std::invalid_argument("property " + property + " has " + std::to_string(size) +
                                  " values: must be " + std::to_string(m_size) + ", one for each " +
                                  m_name);
  }

  std::string m_name;
  std::size_t m_size;
  std::vector<Property> m_properties;
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief how a PLY file is written.
struct PLY_options
{
  bool is_ascii = false; ///< text, in which numbers read back as exactly the same ones
  /// lines for the reader in the header; control characters, such as line ends, are written as `?`.
  std::vector<std::string> comments;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

class Ply_writer
{
public:
  Ply_writer(std::ostream& out, const PLY_options& options) : m_out(out), m_options(options) {}

  void write(const std::vector<PLY_element>& elements)
  {
    write_header(elements);
    for(const PLY_element& element : elements)
      for(std::size_t i = 0; i < element.size(); ++i) {
        m_is_first = true;
        for(const PLY_element::Property& property : element.properties())
          std::visit([&](const auto& values) { write_value(values, i); }, property.values);
        if(m_options.is_ascii)
          m_out << '\n';
      }
  }

private:
  void write_header(const std::vector<PLY_element>& elements)
  {
    m_out << "ply\nformat " << (m_options.is_ascii ? "ascii" : "binary_little_endian") << " 1.0\n";
    for(std::string comment : m_options.comments) {
      // Names of files may have them: a line end would end the comment.
      std::replace_if(
          comment.begin(), comment.end(),
          [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, '?');
      m_out << "comment " << comment << '\n';
    }
    for(const PLY_element& element : elements) {
      m_out << "element " << element.name() << ' ' << element.size() << '\n';
      for(const PLY_element::Property& property : element.properties())
        m_out << "property " << type_name(property) << ' ' << property.name << '\n';
    }
    m_out << "end_header\n";
  }

  static const char* type_name(const PLY_element::Property& property)
  {
    constexpr const char* names[] = {"char", "uchar", "short", "ushort", "int",
                                     "uint", "",      "",      "float",  "double"};
    const auto* values = std::get_if<Typed_values>(&property.values);
    return values ? names[std::size_t(type_of(*values))] : "list uchar int";
  }

  void write_value(const Typed_values& values, std::size_t i)
  {
    std::visit([&](const auto& v) { put(v[i]); }, values);
  }

  void write_value(const PLY_element::Triangles& triangles, std::size_t i)
  {
    put(std::uint8_t(3));
    for(const std::uint32_t vertex : triangles[i])
      put(std::int32_t(vertex));
  }

  template <class Number>
  void put(Number value)
  {
    if(m_options.is_ascii)
      m_out << (m_is_first ? "" : " ") << to_text(value);
    else
      m_out.write(reinterpret_cast<const char*>(&value), sizeof value);
    m_is_first = false;
  }

  std::ostream& m_out;
  const PLY_options& m_options;
  bool m_is_first = true;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a PLY file, binary and little endian or as text.
///
/// Elements and properties are in the given order; `vertex` with `x`, `y`, `z` and `face` with
/// `vertex_indices`, `red`, `green`, `blue` are what most programs look for. Failure is told by the state of
/// `out`.
/// \param out where the elements go
/// \param elements the kinds of elements, in the order of the file
/// \param options how
inline void write_PLY(std::ostream& out, const std::vector<PLY_element>& elements,
                      const PLY_options& options = {})
{
  internal::Ply_writer(out, options).write(elements);
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a `.ply` file, which appears whole or not at all.
/// \param file_name the file; replaced as a whole, if it exists
/// \param elements the kinds of elements, in the order of the file
/// \param options how
/// \throw Output_error if the file cannot be written.
inline void write_PLY(const std::string& file_name, const std::vector<PLY_element>& elements,
                      const PLY_options& options = {})
{
  internal::Atomic_file file(file_name);
  write_PLY(file.stream(), elements, options);
  file.commit();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_PLY_H
