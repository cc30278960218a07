// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_IMAGE_WRITER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_IMAGE_WRITER_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/vtk_data_array.h>
#include <CGAL/Area_projection_transform/internal/xml_document.h>
#include <CGAL/Area_projection_transform/internal/zlib_streams.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// an array of the appended data: its bytes come in rows of equal length.
struct Vtk_appended_array
{
  std::string attributes; ///< of its element, all but format and offset
  std::size_t row_size;   ///< in bytes
  std::size_t number_of_rows;
  std::function<void(std::size_t row, void* bytes)> fill_row;

  std::size_t size() const { return row_size * number_of_rows; }
};

/// \brief writes an image in VTK's XML format with appended raw data.
///
/// Sizes of compressed data are known only after compressing, but precede the data in the file.
/// They get a place there, and their values once all else is written: so compressing needs a stream
/// that can be changed behind the place of writing, but never more than a block in memory.
class Vtk_image_writer
{
public:
  /// `level` is zlib's, 0 to store the bytes as they are.
  Vtk_image_writer(std::ostream& out, const Grid_image& image, int level)
      : m_out(out), m_image(image), m_level(level), m_deflater(level, Zlib_wrapper::ZLIB)
  {
    for(const Metadata_entry& entry : image.metadata())
      if(const auto* numbers = std::get_if<std::vector<double>>(&entry.value))
        if(!are_finite(*numbers))
          m_arrays.push_back(appended_numbers(entry.name, *numbers));
    for(const Grid_image::Array& array : image.arrays())
      m_arrays.push_back({attributes(array.name, array.type),
                          size_of(array.type) * std::size_t(image.grid().size()[0]),
                          image.grid().number_of_rows(), array.fill_row});
  }

  void write()
  {
    write_start();
    write_metadata();
    write_piece();
    m_out << "  </ImageData>\n  <AppendedData encoding=\"raw\">\n   _";
    std::vector<std::size_t> offsets;
    for(std::size_t a = 0, offset = 0; a < m_arrays.size(); ++a) {
      offsets.push_back(offset);
      offset += is_compressed() ? write_compressed(m_arrays[a]) : write_plain(m_arrays[a]);
    }
    m_out << "\n  </AppendedData>\n</VTKFile>\n";
    if(is_compressed())
      for(std::size_t a = 0; a < m_arrays.size(); ++a)
        write_at(m_offset_positions[a], offset_attribute(offsets[a]));
  }

private:
  /// the size of the blocks that are compressed one by one.
  static constexpr std::size_t block_size = std::size_t(1) << 20;

  bool is_compressed() const { return m_level != 0; }

  static std::string attributes(const std::string& name, Scalar_type type)
  {
    return "type=\"" + std::string(vtk_type_names[std::size_t(type)]) + "\" Name=\"" +
           xml_escaped(name) + "\"";
  }

  void write_start()
  {
    const Grid_3& grid = m_image.grid();
    const std::string spacing = to_text(grid.spacing());
    m_out << "<?xml version=\"1.0\"?>\n"
          << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
          << "header_type=\"UInt64\""
          << (is_compressed() ? " compressor=\"vtkZLibDataCompressor\">\n" : ">\n")
          << "  <ImageData WholeExtent=\"" << extent() << "\" Origin=\""
          << to_text(grid.origin().x()) << ' ' << to_text(grid.origin().y()) << ' '
          << to_text(grid.origin().z()) << "\" Spacing=\"" << spacing << ' ' << spacing << ' '
          << spacing << "\">\n";
  }

  std::string extent() const
  {
    std::string text;
    for(int axis = 0; axis < 3; ++axis)
      text += (axis == 0 ? "0 " : " 0 ") + to_text(m_image.grid().size()[axis] - 1);
    return text;
  }

  void write_metadata()
  {
    m_out << "    <FieldData>\n";
    for(const Metadata_entry& entry : m_image.metadata())
      if(const auto* text = std::get_if<std::string>(&entry.value))
        write_text(entry.name, *text);
      else
        write_numbers(entry.name, std::get<std::vector<double>>(entry.value));
    m_out << "    </FieldData>\n";
  }

  void write_text(const std::string& name, const std::string& text)
  {
    m_out << "      <Array type=\"String\" Name=\"" << xml_escaped(name)
          << "\" NumberOfTuples=\"1\" format=\"ascii\">";
    for(char c : text)
      m_out << to_text(int(static_cast<unsigned char>(c))) << ' ';
    m_out << "0</Array>\n";
  }

  static bool are_finite(const std::vector<double>& numbers)
  {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  }

  static std::string numbers_attributes(const std::string& name, std::size_t number)
  {
    return attributes(name, Scalar_type::FLOAT64) + " NumberOfTuples=\"" + to_text(number) + '"';
  }

  static Vtk_appended_array appended_numbers(const std::string& name,
                                             const std::vector<double>& numbers)
  {
    return {numbers_attributes(name, numbers.size()), numbers.size() * sizeof(double), 1,
            [&numbers](std::size_t, void* bytes) {
              std::copy(numbers.begin(), numbers.end(), static_cast<double*>(bytes));
            }};
  }

  /// numbers are written as text, for people to read, unless VTK would not read them: `nan`, `inf`.
  void write_numbers(const std::string& name, const std::vector<double>& numbers)
  {
    if(!are_finite(numbers)) {
      write_next_appended_element("      ");
      return;
    }
    m_out << "      <DataArray " << numbers_attributes(name, numbers.size())
          << " format=\"ascii\">";
    for(std::size_t i = 0; i < numbers.size(); ++i)
      m_out << (i == 0 ? "" : " ") << to_text(numbers[i]);
    m_out << "</DataArray>\n";
  }

  void write_piece()
  {
    m_out << "    <Piece Extent=\"" << extent() << "\">\n      <PointData";
    if(!m_image.arrays().empty())
      m_out << " Scalars=\"" << xml_escaped(m_image.arrays().front().name) << '"';
    m_out << ">\n";
    while(m_offset_positions.size() < m_arrays.size())
      write_next_appended_element("        ");
    m_out << "      </PointData>\n      <CellData>\n      </CellData>\n    </Piece>\n";
  }

  void write_next_appended_element(const char* indent)
  {
    const Vtk_appended_array& array = m_arrays[m_offset_positions.size()];
    m_out << indent << "<DataArray " << array.attributes << " format=\"appended\" ";
    m_offset_positions.push_back(m_out.tellp());
    m_out << offset_attribute(m_next_offset) << "/>\n";
    m_next_offset += sizeof(std::uint64_t) + array.size();
  }

  /// has the same length for every offset.
  static std::string offset_attribute(std::size_t offset)
  {
    std::string text = "offset=\"" + to_text(offset) + '"';
    text.resize(29, ' ');
    return text;
  }

  /// returns the number of bytes written, as `write_compressed()` does.
  std::size_t write_plain(const Vtk_appended_array& array)
  {
    write_header({array.size()});
    std::vector<char> row(array.row_size);
    for(std::size_t r = 0; r < array.number_of_rows && m_out; ++r) {
      array.fill_row(r, row.data());
      m_out.write(row.data(), std::streamsize(array.row_size));
    }
    return sizeof(std::uint64_t) + array.size();
  }

  std::size_t write_compressed(const Vtk_appended_array& array)
  {
    const std::size_t blocks = (array.size() + block_size - 1) / block_size;
    std::vector<std::uint64_t> header(3 + blocks);
    header[0] = blocks;
    header[1] = block_size;
    header[2] = array.size() % block_size;
    const std::ostream::pos_type position = m_out.tellp();
    write_header(header);
    write_blocks(array, header.data() + 3);
    const std::size_t written = std::size_t(m_out.tellp() - position);
    write_at(position, std::string(reinterpret_cast<const char*>(header.data()),
                                   header.size() * sizeof(std::uint64_t)));
    return written;
  }

  /// compresses the rows in blocks, whose ends are not the ends of rows, and counts their bytes.
  void write_blocks(const Vtk_appended_array& array, std::uint64_t* sizes)
  {
    const auto write = [&](const char* bytes, std::size_t number) {
      m_out.write(bytes, std::streamsize(number));
      *sizes += number;
    };
    std::vector<char> row(array.row_size);
    std::size_t in_block = 0;
    for(std::size_t r = 0; r < array.number_of_rows && m_out; ++r) {
      array.fill_row(r, row.data());
      for(std::size_t done = 0; done < array.row_size;) {
        const std::size_t step = std::min(array.row_size - done, block_size - in_block);
        m_deflater.append(row.data() + done, step, write);
        done += step;
        in_block += step;
        const bool is_last = r + 1 == array.number_of_rows && done == array.row_size;
        if(in_block == block_size || is_last) {
          m_deflater.finish(write);
          ++sizes;
          in_block = 0;
        }
      }
    }
  }

  void write_header(const std::vector<std::uint64_t>& numbers)
  {
    m_out.write(reinterpret_cast<const char*>(numbers.data()),
                std::streamsize(numbers.size() * sizeof(std::uint64_t)));
  }

  void write_at(std::ostream::pos_type position, const std::string& bytes)
  {
    const std::ostream::pos_type end = m_out.tellp();
    m_out.seekp(position);
    m_out.write(bytes.data(), std::streamsize(bytes.size()));
    m_out.seekp(end);
  }

  std::ostream& m_out;
  const Grid_image& m_image;
  int m_level;
  Deflater m_deflater;
  std::vector<Vtk_appended_array> m_arrays;
  std::vector<std::ostream::pos_type> m_offset_positions; ///< of the elements written so far
  std::size_t m_next_offset = 0;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_IMAGE_WRITER_H
