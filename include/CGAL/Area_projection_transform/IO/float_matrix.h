// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_FLOAT_MATRIX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_FLOAT_MATRIX_H

#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/internal/whole_file.h>
#include <CGAL/Area_projection_transform/retrieval/Distance_matrix.h>

#include <boost/endian/conversion.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a matrix of distances as the contests exchange them: `n²` floats of 32 bits, little endian, row by row,
/// and nothing else.
/// \param out where the numbers go
/// \param matrix the matrix
inline void write_float_matrix(std::ostream& out, const Distance_matrix& matrix)
{
  std::vector<std::uint32_t> row(matrix.size());
  for(std::size_t i = 0; i < matrix.size(); ++i) {
    std::memcpy(row.data(), matrix[i], 4 * row.size());
    for(std::uint32_t& bits : row)
      boost::endian::native_to_little_inplace(bits);
    out.write(reinterpret_cast<const char*>(row.data()), std::streamsize(4 * row.size()));
  }
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a matrix of distances to a file, which appears whole or not at all.
/// \param file_name the file; replaced as a whole, if it exists
/// \param matrix the matrix
/// \throw Output_error if the file cannot be written.
inline void write_float_matrix(const std::string& file_name, const Distance_matrix& matrix)
{
  internal::Atomic_file file(file_name);
  write_float_matrix(file.stream(), matrix);
  file.commit();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a file as `write_float_matrix()` writes it.
/// \param file_name the file
/// \throw std::runtime_error if it cannot be read, or is not a square of floats
inline Distance_matrix read_float_matrix(const std::string& file_name)
{
  const std::string bytes = internal::read_whole_file(file_name);
  const std::size_t size = std::size_t(std::llround(std::sqrt(double(bytes.size()) / 4)));
  if(bytes.size() != 4 * size * size)
    throw std::runtime_error(file_name + ": has " + std::to_string(bytes.size()) +
                             " bytes: a matrix has four times the square of its rows");
  std::vector<float> values(size * size);
  for(std::size_t i = 0; i < values.size(); ++i) {
    std::uint32_t bits;
    std::memcpy(&bits, bytes.data() + 4 * i, 4);
    boost::endian::little_to_native_inplace(bits);
    std::memcpy(&values[i], &bits, 4);
  }
  return Distance_matrix(size, std::move(values));
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_FLOAT_MATRIX_H
