// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NRRD_READER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NRRD_READER_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/nrrd_writer.h>
#include <CGAL/Area_projection_transform/internal/whole_file.h>
#include <CGAL/Area_projection_transform/internal/zlib_streams.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// the other names that NRRD headers have for scalar types.
inline Scalar_type nrrd_scalar_type(const std::string& name)
{
  static const std::map<std::string, Scalar_type> synonyms = {
      {"int8", Scalar_type::INT8},       {"int8_t", Scalar_type::INT8},
      {"uchar", Scalar_type::UINT8},     {"uint8", Scalar_type::UINT8},
      {"uint8_t", Scalar_type::UINT8},   {"int16", Scalar_type::INT16},
      {"int16_t", Scalar_type::INT16},   {"ushort", Scalar_type::UINT16},
      {"uint16", Scalar_type::UINT16},   {"uint16_t", Scalar_type::UINT16},
      {"int32", Scalar_type::INT32},     {"int32_t", Scalar_type::INT32},
      {"uint", Scalar_type::UINT32},     {"uint32", Scalar_type::UINT32},
      {"uint32_t", Scalar_type::UINT32}, {"longlong", Scalar_type::INT64},
      {"long long", Scalar_type::INT64}, {"int64", Scalar_type::INT64},
      {"int64_t", Scalar_type::INT64},   {"uint64", Scalar_type::UINT64},
      {"uint64_t", Scalar_type::UINT64}};
  for(std::size_t i = 0; i < nrrd_type_names.size(); ++i)
    if(nrrd_type_names[i] == name)
      return Scalar_type(i);
  const auto found = synonyms.find(name);
  if(found == synonyms.end())
    throw std::runtime_error("type is " + in_quotes(name) + ": not supported");
  return found->second;
}

/// reads an image of NRRD with an attached header.
class Nrrd_reader
{
public:
  explicit Nrrd_reader(const std::string& name) : m_name(name), m_bytes(read_whole_file(name)) {}

  Stored_image read()
  {
    try {
      read_header();
      Stored_image image{grid(), {}, m_metadata};
      read_arrays(image);
      return image;
    } catch(const std::logic_error& error) {
      throw std::runtime_error(m_name + ": " + error.what());
    } catch(const std::runtime_error& error) {
      throw std::runtime_error(m_name + ": " + error.what());
    }
  }

private:
  void read_header()
  {
    std::string_view rest = m_bytes;
    const std::string_view magic = next_line(rest);
    if(magic.size() != 8 || magic.substr(0, 7) != "NRRD000")
      throw std::runtime_error("is not a NRRD file");
    for(std::size_t number = 2;; ++number) {
      if(rest.empty())
        throw std::runtime_error("ends early: no empty line after the header");
      const std::string_view line = next_line(rest);
      if(line.empty())
        break;
      if(line.front() != '#' && !read_key(line) && !read_field(line))
        throw std::runtime_error("line " + std::to_string(number) + ": " + in_quotes(line) +
                                 " is no field");
    }
    m_data = rest;
    for(const char* detached : {"data file", "datafile", "line skip", "byte skip"})
      if(m_fields.count(detached) != 0)
        throw std::runtime_error("field '" + std::string(detached) + "' is not supported");
  }

  static std::string_view next_line(std::string_view& text)
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if(!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    return line;
  }

  bool read_field(std::string_view line)
  {
    const std::size_t colon = line.find(": ");
    if(colon != std::string_view::npos)
      m_fields[std::string(line.substr(0, colon))] = std::string(trim(line.substr(colon + 2)));
    return colon != std::string_view::npos;
  }

  bool read_key(std::string_view line)
  {
    const std::size_t mark = line.find(":=");
    if(mark == std::string_view::npos || line.find(": ") < mark)
      return false;
    const std::string key = unescaped(line.substr(0, mark));
    const std::string value = unescaped(line.substr(mark + 2));
    std::vector<double> numbers;
    if(key == "axis 0 index values")
      m_names = value;
    else if(key == "axis 0 index type")
      ;
    else if(read_numbers(value, numbers).empty() && !numbers.empty())
      m_metadata.push_back({key, std::move(numbers)});
    else
      m_metadata.push_back({key, value});
    return true;
  }

  static std::string unescaped(std::string_view text)
  {
    std::string result;
    for(std::size_t i = 0; i < text.size(); ++i) {
      const char next = i + 1 < text.size() ? text[i + 1] : '\0';
      const bool is_escape = text[i] == '\\' && (next == 'n' || next == '\\');
      result += is_escape ? (next == 'n' ? '\n' : '\\') : text[i];
      i += is_escape;
    }
    return result;
  }

  const std::string& field(const std::string& name) const
  {
    const auto found = m_fields.find(name);
    if(found == m_fields.end())
      throw std::runtime_error("field '" + name + "' is missing");
    return found->second;
  }

  template <class Number>
  std::vector<Number> numbers(const std::string& name, const std::string& text,
                              std::size_t number) const
  {
    std::vector<Number> values;
    if(!read_numbers(text, values).empty() || values.size() != number)
      throw std::runtime_error("field '" + name + "' is " + in_quotes(field(name)) + ": must be " +
                               std::to_string(number) + " numbers");
    return values;
  }

  /// the numbers of a field that has vectors such as `(1,0,0)`.
  std::vector<double> vectors(const std::string& name, std::size_t number) const
  {
    std::string text = field(name);
    if(is_list() && text.substr(0, 5) == "none ")
      text.erase(0, 5);
    for(char& c : text)
      if(c == '(' || c == ')' || c == ',')
        c = ' ';
    return numbers<double>(name, text, number);
  }

  bool is_list() const { return field("dimension") == "4"; }

  /// the sizes of the axes, after a first one for the list of arrays.
  std::array<int, 4> sizes() const
  {
    if(field("dimension") != "3" && field("dimension") != "4")
      throw std::runtime_error("field 'dimension' is " + in_quotes(field("dimension")) +
                               ": must be 3, or 4 with a list of arrays first");
    const auto values = numbers<int>("sizes", (is_list() ? "" : "1 ") + field("sizes"), 4);
    if(values[0] < 1)
      throw std::runtime_error("field 'sizes' is " + in_quotes(field("sizes")) +
                               ": must be positive");
    return {values[0], values[1], values[2], values[3]};
  }

  Grid_3 grid() const
  {
    const std::array<int, 4> n = sizes();
    const std::vector<double> d = vectors("space directions", 9);
    const std::vector<double> diagonal = {d[0], 0, 0, 0, d[0], 0, 0, 0, d[0]};
    if(d != diagonal)
      throw std::runtime_error("field 'space directions' is " +
                               in_quotes(field("space directions")) +
                               ": must be the axes, with the same spacing along the three");
    const std::vector<double> origin = vectors("space origin", 3);
    return Grid_3(Point_3(origin[0], origin[1], origin[2]), d[0], {n[1], n[2], n[3]});
  }

  void read_arrays(Stored_image& image)
  {
    Typed_values values = empty_values(nrrd_scalar_type(field("type")));
    if(size_of(type_of(values)) > 1 && field("endian") != "little")
      throw std::runtime_error("field 'endian' is " + in_quotes(field("endian")) +
                               ": only little is supported");
    std::visit([&](auto& v) { read_values(image.grid, v); }, values);
    const std::size_t arrays = std::size_t(sizes()[0]);
    std::string_view names = m_names;
    for(std::size_t a = 0; a < arrays; ++a) {
      const std::string name = is_list() ? word_text(next_word(names)) : content();
      image.arrays.push_back({name, 1, arrays == 1 ? std::move(values) : every(values, a, arrays)});
    }
  }

  std::string content() const
  {
    const auto found = m_fields.find("content");
    return found == m_fields.end() ? "" : unescaped(found->second);
  }

  /// one of several arrays whose values alternate.
  static Typed_values every(const Typed_values& values, std::size_t first, std::size_t step)
  {
    Typed_values result = empty_values(type_of(values));
    std::visit(
        [&](auto& selected) {
          const auto& all = std::get<std::decay_t<decltype(selected)>>(values);
          selected.reserve(all.size() / step);
          for(std::size_t i = first; i < all.size(); i += step)
            selected.push_back(all[i]);
        },
        result);
    return result;
  }

  static std::string word_text(std::string_view word)
  {
    std::string result;
    for(std::size_t i = 0; i < word.size(); ++i) {
      int code = 0;
      const bool is_code =
          word[i] == '%' && i + 2 < word.size() &&
          std::from_chars(word.data() + i + 1, word.data() + i + 3, code, 16).ptr ==
              word.data() + i + 3;
      result += is_code ? static_cast<char>(code) : word[i];
      i += is_code ? 2 : 0;
    }
    return result;
  }

  template <class Scalar>
  void read_values(const Grid_3& grid, std::vector<Scalar>& values) const
  {
    // as a double, for the product may not fit into an integer
    const double needed = double(sizes()[0]) * grid.size()[0] * double(grid.number_of_rows()) *
                          double(sizeof(Scalar));
    const std::string& encoding = field("encoding");
    const bool is_raw = encoding == "raw";
    if(!is_raw && encoding != "gzip" && encoding != "gz")
      throw std::runtime_error("field 'encoding' is " + in_quotes(encoding) +
                               ": must be raw or gzip");
    if(is_raw ? needed != double(m_data.size()) : needed > most_inflated())
      throw std::runtime_error("has " + std::to_string(m_data.size()) +
                               " bytes of data: its sizes announce " + to_text(needed));
    Byte_appender<Scalar> append(values);
    if(is_raw)
      std::memcpy(append(m_data.size()), m_data.data(), m_data.size());
    else
      Inflater(Zlib_wrapper::GZIP).run(m_data, std::size_t(needed), append);
  }

  /// deflate turns no byte into more than 1032.
  double most_inflated() const { return 1032. * double(m_data.size()); }

  std::string m_name;
  std::string m_bytes;
  std::string_view m_data;
  std::map<std::string, std::string> m_fields;
  std::string m_names;
  Metadata m_metadata;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_NRRD_READER_H
