// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_SHAPE_DESCRIPTORS_CSV_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_SHAPE_DESCRIPTORS_CSV_H

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/retrieval/Descriptor_table.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes the names of the columns of a table of descriptors: `file`, `h0`, `h1`, …
/// \param out where the table goes
/// \param dimension how many numbers a descriptor has
inline void write_shape_descriptors_CSV_header(std::ostream& out, std::size_t dimension)
{
  CSV_writer table(out);
  table.field("file");
  for(std::size_t i = 0; i < dimension; ++i)
    table.field("h" + std::to_string(i));
  table.end_row();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a row of a table of descriptors: the name of a shape, and numbers that read back as the same floats.
/// \tparam Range of `float`
/// \param out where the table goes
/// \param name the shape
/// \param values its descriptor
template <class Range>
void write_shape_descriptor_CSV_row(std::ostream& out, const std::string& name, const Range& values)
{
  CSV_writer table(out);
  table.field(name);
  for(float value : values)
    table.field(value);
  table.end_row();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief descriptors with the names of their shapes.
struct Named_descriptors
{
  std::vector<std::string> names; ///< of the shapes, one for each row of the table
  Descriptor_table table;         ///< the descriptors, in the order of the file
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a table of descriptors: a line with the names of the columns, `file` and then one for each number, and a
/// row for each shape.
/// \param in the text of the table
/// \param name stands for the input in messages
/// \param block_size as `Shape_descriptor::block_size`; not told by the table
/// \throw std::runtime_error if a row has another number of fields than the first line, or one that is not a number
/// or negative; its text names the line and the defect
/// \throw std::invalid_argument if the number of numbers is not a multiple of `block_size`
inline Named_descriptors read_shape_descriptors_CSV(std::istream& in, const std::string& name,
                                                    std::size_t block_size)
{
  CSV_reader reader(in, name);
  std::vector<std::string> fields;
  if(!reader.read(fields))
    reader.fail("is empty: the first line must name the columns file, h0, h1, …");
  if(fields.size() < 2 || fields[0] != "file")
    reader.fail("the first line must name the columns file, h0, h1, …");
  const std::size_t dimension = fields.size() - 1;
  Named_descriptors result{{}, Descriptor_table(dimension, block_size)};
  std::vector<float> values(dimension);
  while(reader.read(fields)) {
    if(fields.size() != dimension + 1)
      reader.fail("has " + std::to_string(fields.size()) + " fields: the first line has " +
                  std::to_string(dimension + 1));
    for(std::size_t i = 0; i < dimension; ++i)
      if(!from_text(fields[i + 1], values[i]))
        reader.fail("h" + std::to_string(i) + " is " + internal::in_quotes(fields[i + 1]) +
                    ": not a number");
    try {
      result.table.push_back(values);
    } catch(const std::invalid_argument& defect) {
      reader.fail(defect.what());
    }
    result.names.push_back(fields[0]);
  }
  return result;
}

/// \ingroup PkgAreaProjectionTransformIO
/// reads a table of descriptors from a file.
/// \param file_name the file
/// \param block_size as `Shape_descriptor::block_size`
inline Named_descriptors read_shape_descriptors_CSV(const std::string& file_name,
                                                    std::size_t block_size)
{
  errno = 0;
  std::ifstream in(file_name, std::ios_base::binary);
  if(!in)
    throw std::runtime_error(file_name + ": cannot be opened: " + std::strerror(errno));
  return read_shape_descriptors_CSV(in, file_name, block_size);
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_SHAPE_DESCRIPTORS_CSV_H
