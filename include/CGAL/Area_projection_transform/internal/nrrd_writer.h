// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NRRD_WRITER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NRRD_WRITER_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/zlib_streams.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// the names of the scalar types in NRRD headers, in the order of `Scalar_type`.
constexpr std::array<std::string_view, 10> nrrd_type_names = {
    "signed char",   "unsigned char",          "short", "unsigned short", "int", "unsigned int",
    "long long int", "unsigned long long int", "float", "double"};

/// \brief writes an image as NRRD.
///
/// Several arrays go to one file: they are the first axis, a list, which 3D Slicer shows as a
/// sequence of volumes. Arrays of different types are then all written as doubles.
class Nrrd_writer
{
public:
  Nrrd_writer(std::ostream& out, const Grid_image& image, const Image_options& options)
      : m_out(out), m_image(image), m_options(options), m_type(common_type(image))
  {}

  void write()
  {
    write_header();
    std::visit(
        [this](const auto& v) { write_rows<typename std::decay_t<decltype(v)>::value_type>(); },
        empty_values(m_type));
  }

private:
  static Scalar_type common_type(const Grid_image& image)
  {
    if(image.arrays().empty())
      throw std::invalid_argument("image has no array: a NRRD file needs one");
    const Scalar_type first = image.arrays().front().type;
    const bool is_common = std::all_of(image.arrays().begin(), image.arrays().end(),
                                       [&](const auto& array) { return array.type == first; });
    return is_common ? first : Scalar_type::FLOAT64;
  }

  bool is_list() const { return m_image.arrays().size() > 1; }

  void write_header()
  {
    const Grid_3& grid = m_image.grid();
    const std::string s = to_text(grid.spacing());
    const std::string list_size = is_list() ? to_text(m_image.arrays().size()) + " " : "";
    // sizes come before space: VTK 9 takes their number from the field that was there last
    m_out << "NRRD0004\n"
          << "# Complete NRRD file format specification at:\n"
          << "# http://teem.sourceforge.net/nrrd/format.html\n"
          << "type: " << nrrd_type_names[std::size_t(m_type)] << '\n'
          << "dimension: " << (is_list() ? 4 : 3) << '\n'
          << "sizes: " << list_size << to_text(grid.size()[0]) << ' ' << to_text(grid.size()[1])
          << ' ' << to_text(grid.size()[2]) << '\n'
          << "space: left-posterior-superior\n"
          << "space directions: " << (is_list() ? "none " : "") << '(' << s << ",0,0) (0," << s
          << ",0) (0,0," << s << ")\n"
          << "kinds: " << (is_list() ? "list " : "") << "domain domain domain\n"
          << (is_list() ? "labels: \"array\" \"\" \"\" \"\"\n" : "") << "endian: little\n"
          << "encoding: " << (m_options.compress ? "gzip" : "raw") << '\n'
          << "space origin: (" << to_text(grid.origin().x()) << ',' << to_text(grid.origin().y())
          << ',' << to_text(grid.origin().z()) << ")\n";
    write_names();
    for(const Metadata_entry& entry : m_image.metadata())
      m_out << one_line(entry.name) << ":=" << one_line(value_text(entry)) << '\n';
    m_out << '\n';
  }

  void write_names()
  {
    if(!is_list()) {
      m_out << "content: " << one_line(m_image.arrays().front().name) << '\n';
      return;
    }
    m_out << "axis 0 index type:=text\naxis 0 index values:=";
    for(const Grid_image::Array& array : m_image.arrays())
      m_out << (&array == &m_image.arrays().front() ? "" : " ") << one_word(array.name);
    m_out << '\n';
  }

  static std::string value_text(const Metadata_entry& entry)
  {
    if(const auto* text = std::get_if<std::string>(&entry.value))
      return *text;
    std::string text;
    for(const double number : std::get<std::vector<double>>(entry.value))
      text += (text.empty() ? "" : " ") + to_text(number);
    return text;
  }

  static std::string one_line(std::string_view text)
  {
    std::string result;
    for(const char c : text)
      if(c == '\n')
        result += "\\n";
      else if(c == '\\')
        result += "\\\\";
      else
        result += c;
    return result;
  }

  /// blanks separate words: they are replaced as in the address of a page.
  static std::string one_word(std::string_view text)
  {
    constexpr char digits[] = "0123456789ABCDEF";
    std::string result;
    for(const char c : text)
      if(is_blank(c) || c == '%')
        result += {'%', digits[c / 16], digits[c % 16]};
      else
        result += c;
    return result;
  }

  template <class Scalar>
  void write_rows()
  {
    const std::size_t length = std::size_t(m_image.grid().size()[0]);
    const std::size_t arrays = m_image.arrays().size();
    std::vector<Scalar> row(length);
    std::vector<Scalar> rows(length * arrays);
    Deflater deflater(m_options.compress ? m_options.level : 0, Zlib_wrapper::GZIP);
    const auto write = [this](const char* bytes, std::size_t number) {
      m_out.write(bytes, std::streamsize(number));
    };
    for(std::size_t r = 0; r < m_image.grid().number_of_rows() && m_out; ++r) {
      for(std::size_t a = 0; a < arrays; ++a) {
        fill_row(m_image.arrays()[a], r, row);
        for(std::size_t x = 0; x < length; ++x)
          rows[x * arrays + a] = row[x];
      }
      const char* const bytes = reinterpret_cast<const char*>(rows.data());
      if(m_options.compress)
        deflater.append(bytes, rows.size() * sizeof(Scalar), write);
      else
        write(bytes, rows.size() * sizeof(Scalar));
    }
    if(m_options.compress)
      deflater.finish(write);
  }

  template <class Scalar>
  static void fill_row(const Grid_image::Array& array, std::size_t r, std::vector<Scalar>& row)
  {
    if(array.type == scalar_type<Scalar>) {
      array.fill_row(r, row.data());
      return;
    }
    Typed_values values = empty_values(array.type);
    std::visit(
        [&](auto& v) {
          v.resize(row.size());
          array.fill_row(r, v.data());
        },
        values);
    row = converted<Scalar>(values);
  }

  std::ostream& m_out;
  const Grid_image& m_image;
  Image_options m_options;
  Scalar_type m_type;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NRRD_WRITER_H
