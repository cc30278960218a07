// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_DESCRIPTOR_TABLE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_DESCRIPTOR_TABLE_H

#include <CGAL/Area_projection_transform/internal/to_text.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief the descriptors of many shapes, one in a row: numbers that are finite and not negative.
class Descriptor_table
{
public:
  /// \param dimension the length of a descriptor
  /// \param block_size how many of its numbers belong together, as `Shape_descriptor::block_size` tells; the length is
  /// a multiple of it
  /// \throw std::invalid_argument if it is not, or one of them is zero
  Descriptor_table(std::size_t dimension, std::size_t block_size)
      : m_dimension(dimension), m_block_size(block_size)
  {
    if(dimension == 0 || block_size == 0 || dimension % block_size != 0)
      throw std::invalid_argument("dimension is " + std::to_string(dimension) +
                                  ": must be a positive multiple of block_size, " +
                                  std::to_string(block_size));
  }

  /// how many numbers a descriptor has.
  std::size_t dimension() const { return m_dimension; }
  /// how many of them belong together, as `Shape_descriptor::block_size`.
  std::size_t block_size() const { return m_block_size; }
  /// how many descriptors there are.
  std::size_t size() const { return m_values.size() / m_dimension; }
  /// whether there are none.
  bool empty() const { return m_values.empty(); }

  /// the first number of a row.
  const float* operator[](std::size_t row) const { return m_values.data() + row * m_dimension; }

  /// takes the memory for some descriptors.
  void reserve(std::size_t rows) { m_values.reserve(rows * m_dimension); }

  /// \brief adds a row.
  /// \tparam Range of numbers
  /// \param descriptor the numbers
  /// \throw std::invalid_argument if it has not `dimension()` of them, or one is negative or not finite
  template <class Range>
  void push_back(const Range& descriptor)
  {
    if(std::size(descriptor) != m_dimension)
      throw std::invalid_argument("descriptor has " + std::to_string(std::size(descriptor)) +
                                  " numbers: must have " + std::to_string(m_dimension));
    std::size_t place = 0;
    for(const auto value : descriptor) {
      if(!(value >= 0) || !std::isfinite(value))
        throw std::invalid_argument("descriptor[" + std::to_string(place) + "] is " +
                                    internal::to_text(value) + ": must be finite and not negative");
      ++place;
    }
    m_values.insert(m_values.end(), std::begin(descriptor), std::end(descriptor));
  }

private:
  std::size_t m_dimension, m_block_size;
  std::vector<float> m_values;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_DESCRIPTOR_TABLE_H
