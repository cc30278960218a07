// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SINKS_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief keeps the map of every scale: `maps()[k]` holds the values of scale `k`, at the places that
/// `Row_spans::index()` gives.
///
/// Takes 4 bytes for each voxel with storage and each scale.
/// \cgalModels `MultiscaleSink`
class Scale_maps_sink
{
public:
  /// \param region the voxels
  /// \param number_of_scales how many scales will come
  Scale_maps_sink(const Row_spans& region, std::size_t number_of_scales)
      : m_maps(number_of_scales, std::vector<float>(region.storage_size(), 0.f))
  {}

  /// copies the values of some voxels.
  void consume(std::size_t scale_index, const Scale&, std::size_t first_voxel, const float* values,
               std::size_t number)
  {
    std::copy(values, values + number, m_maps[scale_index].begin() + std::ptrdiff_t(first_voxel));
  }

  /// the maps, in the order of the list of scales.
  const std::vector<std::vector<float>>& maps() const { return m_maps; }

private:
  std::vector<std::vector<float>> m_maps;
};

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief hands everything to two sinks, one after the other.
/// \cgalModels `MultiscaleSink`
template <class First, class Second>
class Sink_pair
{
public:
  /// \param first receives everything first
  /// \param second receives everything afterwards
  Sink_pair(First& first, Second& second) : m_first(first), m_second(second) {}

  /// hands the values of some voxels to both.
  void consume(std::size_t scale_index, const Scale& scale, std::size_t first_voxel,
               const float* values, std::size_t number)
  {
    m_first.consume(scale_index, scale, first_voxel, values, number);
    m_second.consume(scale_index, scale, first_voxel, values, number);
  }

private:
  First& m_first;
  Second& m_second;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SINKS_H
