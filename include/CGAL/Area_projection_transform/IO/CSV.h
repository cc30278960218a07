// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CSV_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CSV_H

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/lengths.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <istream>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// with which some programs begin a file of UTF-8 text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a table of comma-separated values, row by row.
///
/// Numbers read back as exactly the same ones, whatever the locale; text is quoted where needed.
class CSV_writer
{
public:
  /// \param out where the table goes; must outlive the writer
  explicit CSV_writer(std::ostream& out) : m_out(out) {}

  /// adds a field to the row.
  template <class Field>
  CSV_writer& field(const Field& value)
  {
    if(!m_is_first)
      m_out << ',';
    m_is_first = false;
    if constexpr(std::is_arithmetic_v<Field>)
      m_out << to_text(value);
    else
      write_text(value);
    return *this;
  }

  /// ends the row; the next field begins another one.
  void end_row()
  {
    m_out << '\n';
    m_is_first = true;
  }

  /// writes a row.
  template <class... Fields>
  void row(const Fields&... fields)
  {
    (field(fields), ...);
    end_row();
  }

private:
  void write_text(std::string_view text)
  {
    if(text.find_first_of(",\"\n\r#") == std::string_view::npos && trimmed_is_same(text) &&
       text.substr(0, internal::byte_order_mark.size()) != internal::byte_order_mark) {
      m_out << text;
      return;
    }
    m_out << '"';
    for(const char c : text)
      m_out << (c == '"' ? "\"\"" : std::string(1, c));
    m_out << '"';
  }

  static bool trimmed_is_same(std::string_view text)
  {
    return internal::trim(text).size() == text.size();
  }

  std::ostream& m_out;
  bool m_is_first = true;
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a table of comma-separated values, row by row.
///
/// Fields may be quoted, and then hold commas, line ends and doubled quotes. Blanks around fields,
/// empty lines and lines that begin with `#` are skipped.
class CSV_reader
{
public:
  /// `name` stands for the input in messages.
  CSV_reader(std::istream& in, const std::string& name) : m_in(in), m_name(name) {}

  /// \brief reads the next row; returns whether there is one.
  /// \throw std::runtime_error if a quote is not closed.
  bool read(std::vector<std::string>& fields)
  {
    std::string text;
    while(next_line(text)) {
      m_row_line = m_line;
      const std::string_view trimmed = internal::trim(text);
      if(trimmed.empty() || trimmed.front() == '#')
        continue;
      auto quotes = std::count(text.begin(), text.end(), '"');
      while(quotes % 2 != 0) {
        std::string more;
        if(!next_line(more))
          fail("a quote is not closed");
        quotes += std::count(more.begin(), more.end(), '"');
        text += '\n' + more;
      }
      split(text, fields);
      return true;
    }
    m_row_line = 0;
    return false;
  }

  /// throws a `std::runtime_error` about the row that was read last, or about all of the table if there was none.
  [[noreturn]] void fail(const std::string& cause) const
  {
    const std::string line = "line " + std::to_string(m_row_line) + ": ";
    throw std::runtime_error(m_name + ": " + (m_row_line > 0 ? line : "") + cause);
  }

private:
  bool next_line(std::string& line)
  {
    if(!std::getline(m_in, line)) {
      if(m_in.bad())
        throw std::runtime_error(m_name + ": cannot be read");
      return false;
    }
    const std::size_t length = internal::byte_order_mark.size();
    if(++m_line == 1 && line.compare(0, length, internal::byte_order_mark) == 0)
      line.erase(0, length);
    return true; // a carriage return at its end is a blank, or within quotes part of the field
  }

  static void split(std::string_view text, std::vector<std::string>& fields)
  {
    fields.clear();
    bool is_quoted = false;
    std::size_t begin = 0;
    for(std::size_t i = 0; i <= text.size(); ++i) {
      if(i < text.size() && text[i] == '"')
        is_quoted = !is_quoted;
      if(i == text.size() || (text[i] == ',' && !is_quoted)) {
        fields.push_back(unquoted(internal::trim(text.substr(begin, i - begin))));
        begin = i + 1;
      }
    }
  }

  static std::string unquoted(std::string_view field)
  {
    if(field.size() < 2 || field.front() != '"' || field.back() != '"')
      return std::string(field);
    std::string result;
    for(std::size_t i = 1; i + 1 < field.size(); ++i) {
      result += field[i];
      if(field[i] == '"' && field[i + 1] == '"')
        ++i;
    }
    return result;
  }

  std::istream& m_in;
  std::string m_name;
  std::size_t m_line = 0;
  std::size_t m_row_line = 0;
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief a point at which the transform is asked for.
struct Query
{
  Point_3 point; ///< where
  double radius; ///< the distance of projection, in the units of the surface
  double sigma;  ///< the radius of the collecting ball; NaN if the table has none
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// finds the columns of a table of queries and reads its rows.
class Query_table
{
public:
  Query_table(std::istream& in, const std::string& name) : m_reader(in, name) { read_header(); }

  std::vector<Query> read()
  {
    std::vector<Query> queries;
    while(m_reader.read(m_fields)) {
      if(m_fields.size() > m_number_of_columns) // as with a comma for the decimal point
        m_reader.fail("has " + std::to_string(m_fields.size()) + " fields: the first line names " +
                      std::to_string(m_number_of_columns));
      std::array<double, 5> v;
      for(std::size_t c = 0; c < v.size(); ++c)
        v[c] = number(c);
      queries.push_back({Point_3(v[0], v[1], v[2]), v[RADIUS], v[SIGMA]});
    }
    return queries;
  }

private:
  static constexpr std::array<const char*, 5> names = {"x", "y", "z", "radius", "sigma"};
  static constexpr std::size_t RADIUS = 3, SIGMA = 4;
  static constexpr std::size_t absent = static_cast<std::size_t>(-1);

  void read_header()
  {
    m_columns.fill(absent);
    if(!m_reader.read(m_fields))
      m_reader.fail("is empty: the first line must name the columns x, y, z, radius[, sigma]");
    m_number_of_columns = m_fields.size();
    for(std::size_t c = 0; c < names.size(); ++c) {
      const auto found = std::find(m_fields.begin(), m_fields.end(), names[c]);
      if(found != m_fields.end())
        m_columns[c] = std::size_t(found - m_fields.begin());
      else if(c != SIGMA)
        m_reader.fail(
            "column '" + std::string(names[c]) +
            "' is missing: the first line must name the columns x, y, z, radius[, sigma]");
      if(std::count(m_fields.begin(), m_fields.end(), names[c]) > 1)
        m_reader.fail("column '" + std::string(names[c]) + "' is there twice");
    }
  }

  double number(std::size_t c) const
  {
    const auto fail = [&](const std::string& text, const std::string& cause) {
      m_reader.fail(std::string(names[c]) + " is " + in_quotes(text) + ": " + cause);
    };
    if(m_columns[c] == absent)
      return std::numeric_limits<double>::quiet_NaN();
    if(m_columns[c] >= m_fields.size())
      m_reader.fail(std::string(names[c]) + " is missing: there are " +
                    std::to_string(m_fields.size()) + " fields");
    const std::string& text = m_fields[m_columns[c]];
    if(c == SIGMA && text.empty())
      return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    if(!from_text(text, value))
      fail(text, "not a number");
    if(!std::isfinite(value))
      fail(text, "must be finite");
    if(c >= RADIUS && !(value > 0))
      fail(text, "must be positive");
    if(c >= RADIUS && !(value >= 1 / largest_length && value <= largest_length))
      fail(text, "must be from 1e-150 to 1e150, for its square to be a number");
    return value;
  }

  CSV_reader m_reader;
  std::vector<std::string> m_fields;
  std::array<std::size_t, 5> m_columns;
  std::size_t m_number_of_columns = 0;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a table of queries with the columns `x`, `y`, `z`, `radius` and possibly `sigma`.
///
/// The first line names the columns, in any order; others are skipped. `name` stands for the input
/// in messages.
/// \param in the text of the table
/// \param name stands for the input in messages
/// \throw std::runtime_error if a column is missing, a value is not a finite number, a radius or sigma is
/// not from 1e-150 to 1e150, or a line has more fields than the first; its text names the line, the
/// column and the defect.
inline std::vector<Query> read_queries(std::istream& in, const std::string& name)
{
  return internal::Query_table(in, name).read();
}

/// \ingroup PkgAreaProjectionTransformIO
/// reads a table of queries from a file.
/// \param file_name the file
inline std::vector<Query> read_queries(const std::string& file_name)
{
  errno = 0;
  std::ifstream in(file_name, std::ios_base::binary);
  if(!in)
    throw std::runtime_error(file_name + ": cannot be opened: " + std::strerror(errno));
  return read_queries(in, file_name);
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CSV_H
