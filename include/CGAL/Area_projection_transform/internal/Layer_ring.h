// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_LAYER_RING_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_LAYER_RING_H

#include <CGAL/Area_projection_transform/Row_spans.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// a layer of a grid without gaps, with a margin of zeros around it: rows and places in them begin at
/// `-margin`.
class Padded_layer
{
public:
  Padded_layer(int width, int height, int margin)
      : m_margin(margin)
      , m_stride(std::size_t(width + 2 * margin))
      , m_values(m_stride * std::size_t(height + 2 * margin), 0.f)
  {}

  float* row(int j) { return m_values.data() + m_stride * std::size_t(j + m_margin) + m_margin; }
  void clear() { std::fill(m_values.begin(), m_values.end(), 0.f); }

private:
  int m_margin;
  std::size_t m_stride;
  std::vector<float> m_values;
};

/// \brief the layers of a map around one of them, as far as a separable filter reaches, laid out without gaps, so
/// that what the region leaves out counts as zero along all axes alike.
class Layer_ring
{
public:
  Layer_ring(const Row_spans& region, const std::vector<float>& map, int reach)
      : m_region(region)
      , m_map(map)
      , m_reach(reach)
      , m_layers(std::size_t(2 * reach + 1), empty_layer())
  {}

  int width() const { return m_region.grid().size()[0]; }
  int height() const { return m_region.grid().size()[1]; }
  int reach() const { return m_reach; }
  Padded_layer empty_layer() const { return Padded_layer(width(), height(), m_reach); }

  /// \pre no more than `2 reach()` layers before and none after it were loaded last
  Padded_layer& layer(int k)
  {
    const int number = 2 * m_reach + 1;
    return m_layers[std::size_t((k % number + number) % number)];
  }

  /// loads a layer, in the place of that `2 reach() + 1` before; beyond the grid it is zero.
  void load(int k)
  {
    layer(k).clear();
    if(k < 0 || k >= m_region.grid().size()[2])
      return;
    for(int j = 0; j < height(); ++j) {
      const std::size_t row = m_region.grid().row(j, k);
      const Row_spans::Hull& h = m_region.hull(row);
      const auto [begin, end] = m_region.runs(row);
      for(auto run = begin; run != end; ++run)
        std::copy_n(m_map.data() + h.offset + (run->first - h.first), run->last - run->first,
                    layer(k).row(j) + run->first);
    }
  }

private:
  const Row_spans& m_region;
  const std::vector<float>& m_map;
  int m_reach;
  std::vector<Padded_layer> m_layers;
};

/// places of a row.
struct Places
{
  int first, last;
  bool is_empty() const { return first >= last; }
};

/// \brief finds in each row of a layer the places at which sums along `z` are needed for what is wanted in the
/// layer.
/// \return whether there are any
inline bool find_needed_places(const Row_spans& wanted, int k, int reach,
                               std::vector<Places>& needed)
{
  const int width = wanted.grid().size()[0], height = wanted.grid().size()[1];
  needed.assign(std::size_t(height), Places{width, 0});
  bool are_any = false;
  for(int j = 0; j < height; ++j) {
    const Row_spans::Hull& h = wanted.hull(wanted.grid().row(j, k));
    if(h.first == h.last)
      continue;
    are_any = true;
    const int last_row = std::min(j + reach, height - 1);
    for(int row = std::max(j - reach, 0); row <= last_row; ++row) {
      Places& places = needed[std::size_t(row)];
      places.first = std::min(places.first, std::max(h.first - reach, 0));
      places.last = std::max(places.last, std::min(h.last + reach, width));
    }
  }
  return are_any;
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_LAYER_RING_H
