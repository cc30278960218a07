// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_REGION_PARTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_REGION_PARTS_H

#include <CGAL/Area_projection_transform/Row_spans.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief some layers of a region, as a region of the same grid.
struct Region_part
{
  const Row_spans* region;
  int first_layer, last_layer;
  bool is_first; ///< of the parts
};

/// \brief a region, cut between layers into parts of about as many voxels each.
///
/// A part has the rows of the region in its layers, and no voxel elsewhere. A single part is the region.
class Region_parts
{
public:
  /// \param region must outlive the parts
  Region_parts(const Row_spans& region, std::size_t number)
  {
    const int layers = region.grid().size()[2];
    const std::size_t most = std::size_t(layers);
    number = std::clamp(number, std::size_t(1), most);
    if(number == 1) {
      m_parts.push_back({&region, 0, layers, true});
      return;
    }
    int first = 0;
    for(std::size_t part = 1; part <= number; ++part) {
      // At least one layer for this part, and for each that follows.
      const int at_most = layers - int(number - part);
      int last = first + 1;
      while(last < at_most && stored_below(region, last) * number < region.storage_size() * part)
        ++last;
      if(part == number)
        last = layers;
      m_regions.push_back(layers_of(region, first, last));
      m_parts.push_back({&m_regions.back(), first, last, part == 1});
      first = last;
    }
  }

  Region_parts(const Region_parts&) = delete;
  Region_parts& operator=(const Region_parts&) = delete;

  std::size_t size() const { return m_parts.size(); }
  const Region_part& operator[](std::size_t part) const { return m_parts[part]; }

private:
  static std::size_t stored_below(const Row_spans& region, int layer)
  {
    return region.hull(region.grid().row(0, layer)).offset;
  }

  static Row_spans layers_of(const Row_spans& region, int first, int last)
  {
    const std::size_t rows = std::size_t(region.grid().size()[1]);
    return Row_spans(region.grid(), [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
      if(row < rows * std::size_t(first) || row >= rows * std::size_t(last))
        return;
      const auto [begin, end] = region.runs(row);
      runs.assign(begin, end);
    });
  }

  std::deque<Row_spans> m_regions; // which do not move
  std::vector<Region_part> m_parts;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_REGION_PARTS_H
