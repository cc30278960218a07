// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_KEPT_MAPS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_KEPT_MAPS_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the map of one scale.
struct Kept_map
{
  Scale scale{};
  std::vector<float> values;
  double area_outside = 0;
  bool is_new = true; ///< yet to be computed
};

/// \brief copies the values of scales into maps that others own.
/// \cgalModels `MultiscaleSink`
class Copying_sink
{
public:
  /// \param maps for each scale, the first value of its map
  explicit Copying_sink(std::vector<float*> maps) : m_maps(std::move(maps)) {}

  void consume(std::size_t scale_index, const Scale&, std::size_t first_voxel, const float* values,
               std::size_t number)
  {
    std::copy(values, values + number, m_maps[scale_index] + first_voxel);
  }

private:
  std::vector<float*> m_maps;
};

/// tells a visitor of scales by their places in a longer list.
template <class Visitor>
struct Renumbering_visitor
{
  Visitor& visitor;
  const std::vector<std::size_t>& places;

  void scale_begins(std::size_t index, const Scale& scale)
  {
    visitor.scale_begins(places[index], scale);
  }
  void scale_ends(std::size_t index, const Scale& scale, double area_outside)
  {
    visitor.scale_ends(places[index], scale, area_outside);
  }
};

/// the map of a scale among `maps`, or null.
inline Kept_map* find_map(std::vector<Kept_map>& maps, const Scale& scale)
{
  const auto found = std::find_if(maps.begin(), maps.end(), [&](const Kept_map& map) {
    return map.scale.radius == scale.radius && map.scale.sigma == scale.sigma;
  });
  return found == maps.end() ? nullptr : &*found;
}

/// folds the maps of its scales into a joint map.
template <class ConcurrencyTag>
void fold(const std::vector<Kept_map>& maps, Joint_map& joint)
{
  constexpr std::size_t block = 1 << 14; // stays in the first caches from scale to scale
  const std::size_t size = joint.values().size();
  for_each_index<ConcurrencyTag>((size + block - 1) / block, [&](std::size_t b) {
    const std::size_t first = b * block, number = std::min(block, size - first);
    for(std::size_t k = 0; k < maps.size(); ++k)
      joint.consume(k, maps[k].scale, first, maps[k].values.data() + first, number);
  });
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_KEPT_MAPS_H
