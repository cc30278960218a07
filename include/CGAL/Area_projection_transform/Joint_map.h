// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_JOINT_MAP_H
#define CGAL_AREA_PROJECTION_TRANSFORM_JOINT_MAP_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief the joint multiscale map: at each voxel, the largest value over the scales (JMAPT) and the
/// scale that attains it (SMAPT).
///
/// Takes 5 bytes for each voxel with storage, whatever the number of scales. The scales can be
/// consumed in any order; where two attain the same value, the one of smaller radius counts.
/// \cgalModels `MultiscaleSink`
class Joint_map
{
public:
  /// the index of no scale: where the transform is zero at all scales.
  static constexpr std::uint8_t no_scale = 255;

  /// \brief constructs a map that is zero.
  /// \param region the voxels
  /// \param scales the scales that will come
  /// \throw std::invalid_argument if there are more than 255 scales or their radii do not ascend.
  Joint_map(std::shared_ptr<const Row_spans> region, std::vector<Scale> scales)
      : m_region(std::move(region))
      , m_scales(std::move(scales))
      , m_values(m_region->storage_size(), 0.f)
      , m_scale_indices(m_region->storage_size(), no_scale)
  {
    if(m_scales.size() > no_scale)
      throw std::invalid_argument("scales has " + std::to_string(m_scales.size()) +
                                  " elements: a joint map holds at most 255");
    for(std::size_t k = 1; k < m_scales.size(); ++k)
      if(!(m_scales[k - 1].radius < m_scales[k].radius))
        throw std::invalid_argument("scales[" + std::to_string(k) +
                                    "] has not a larger radius than the one before");
  }

  /// the voxels that have a value.
  const Row_spans& region() const { return *m_region; }
  /// the region, for what outlives the map.
  const std::shared_ptr<const Row_spans>& shared_region() const { return m_region; }
  /// the lattice on which the voxels lie.
  const Grid_3& grid() const { return m_region->grid(); }
  /// the scales, their radii ascending.
  const std::vector<Scale>& scales() const { return m_scales; }

  /// the largest value over the scales; 0 outside of the region.
  float value(int i, int j, int k) const
  {
    const std::size_t voxel = m_region->index(i, j, k);
    return voxel < m_values.size() ? m_values[voxel] : 0.f;
  }

  /// the radius of the scale of the largest value; 0 where the transform is zero.
  double radius(int i, int j, int k) const
  {
    const std::size_t voxel = m_region->index(i, j, k);
    return voxel < m_values.size() ? radius_of_index(m_scale_indices[voxel]) : 0.;
  }

  /// the radius of a scale index, as `scale_indices()` has them; 0 for `no_scale`.
  double radius_of_index(std::uint8_t index) const
  {
    return index == no_scale ? 0. : m_scales[index].radius;
  }

  /// \name Storage
  /// The values and scale indices at the places that `Row_spans::index()` gives.
  /// @{

  /// the largest values over the scales.
  const std::vector<float>& values() const { return m_values; }
  /// the positions in `scales()` of those that attain them, or `no_scale`.
  const std::vector<std::uint8_t>& scale_indices() const { return m_scale_indices; }
  /// @}

  /// raises the values at some voxels to those of a scale, where these are larger.
  void consume(std::size_t scale_index, const Scale&, std::size_t first_voxel, const float* values,
               std::size_t number)
  {
    const std::uint8_t index = std::uint8_t(scale_index);
    float* best = m_values.data() + first_voxel;
    std::uint8_t* best_index = m_scale_indices.data() + first_voxel;
    for(std::size_t i = 0; i < number; ++i)
      if(values[i] > best[i] || (values[i] == best[i] && values[i] > 0 && index < best_index[i])) {
        best[i] = values[i];
        best_index[i] = index;
      }
  }

private:
  std::shared_ptr<const Row_spans> m_region;
  std::vector<Scale> m_scales;
  std::vector<float> m_values;
  std::vector<std::uint8_t> m_scale_indices;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_JOINT_MAP_H
