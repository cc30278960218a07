// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_DISTANCE_MATRIX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_DISTANCE_MATRIX_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/retrieval/Descriptor_table.h>
#include <CGAL/Area_projection_transform/retrieval/Histogram_distance.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief the distances of all shapes from all, row by row: 4 bytes for each pair.
class Distance_matrix
{
public:
  /// constructs a matrix of zeros for `size` shapes: 4 bytes for each pair.
  explicit Distance_matrix(std::size_t size) : m_size(size), m_values(size * size, 0.f) {}

  /// \brief constructs a matrix of given distances.
  /// \param size the number of shapes
  /// \param values the distances, row by row
  /// \throw std::invalid_argument if there are not `size²` values
  Distance_matrix(std::size_t size, std::vector<float> values)
      : m_size(size), m_values(std::move(values))
  {
    if(m_values.size() != size * size)
      throw std::invalid_argument("values has " + std::to_string(m_values.size()) +
                                  " elements: a matrix of " + std::to_string(size) +
                                  " shapes has the square of that");
  }

  /// the number of shapes.
  std::size_t size() const { return m_size; }
  /// the distances of a shape from all shapes.
  const float* operator[](std::size_t row) const { return m_values.data() + row * m_size; }
  /// the same, to be changed.
  float* operator[](std::size_t row) { return m_values.data() + row * m_size; }
  /// all distances, row by row.
  const std::vector<float>& values() const { return m_values; }

private:
  std::size_t m_size;
  std::vector<float> m_values;
};

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief returns the distances of all shapes of a table from each other. Symmetric, zero along the diagonal.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result does not depend on it
/// \param table the descriptors of the shapes
/// \param distance compares two of them
/// \throw std::invalid_argument if the distance is for descriptors of another length
///
/// Complexity: `n²/2` distances for `n` shapes.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Distance_matrix distance_matrix(const Descriptor_table& table, const Histogram_distance& distance)
{
  if(distance.dimension() != table.dimension())
    throw std::invalid_argument("distance is for descriptors of " +
                                std::to_string(distance.dimension()) + " numbers: the table has " +
                                std::to_string(table.dimension()));
  Distance_matrix matrix(table.size());
  internal::for_each_index<ConcurrencyTag>(table.size(), [&](std::size_t i) {
    for(std::size_t j = 0; j < i; ++j)
      matrix[i][j] = float(distance(table[i], table[j]));
  });
  for(std::size_t i = 0; i < table.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      matrix[j][i] = matrix[i][j];
  return matrix;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_DISTANCE_MATRIX_H
