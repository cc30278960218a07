// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_SCALE_MAPS_H
#define AREA_PROJECTION_TRANSFORM_TEST_SCALE_MAPS_H

// Regions and maps for tests of what is read from maps, and the local maxima by their definition.

#include "shapes.h"

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/salient_points/inertia.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace scale_maps {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Row_spans;
using Maps = std::vector<std::vector<float>>;
using Voxel = std::array<int, 3>;

template <class Function>
void with_threads(int number, Function function)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(number));
  tbb::task_arena(number).execute(function);
#else
  static_cast<void>(number);
  function();
#endif
}

/// a region with empty rows, rows of one run and rows of two.
inline std::shared_ptr<const Row_spans> ragged_region(const std::array<int, 3>& size,
                                                      std::uint64_t seed)
{
  shapes::Random random(seed);
  const AP::Grid_3 grid(Point_3(0, 0, 0), 1, size);
  const auto place = [&] { return std::int32_t(random(0, double(size[0]))); };
  return std::make_shared<const Row_spans>(
      grid, [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
        if(row % 7 == 3)
          return;
        std::array<std::int32_t, 4> ends{place(), place(), place(), place()};
        std::sort(ends.begin(), ends.end());
        if(row % 3 == 0)
          runs.push_back({ends[0], ends[3] + 1});
        else {
          runs.push_back({ends[0], ends[1] + 1});
          if(ends[1] + 1 < ends[2])
            runs.push_back({ends[2], ends[3] + 1});
        }
      });
}

inline std::shared_ptr<const Row_spans> whole_region(int size)
{
  return std::make_shared<const Row_spans>(
      AP::Grid_3(Point_3(0, 0, 0), 1, std::array<int, 3>{size, size, size}));
}

/// calls `function(voxel, place)` for each voxel of interest.
template <class Function>
void for_each_voxel(const Row_spans& region, Function function)
{
  const auto& size = region.grid().size();
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j)
      for(int i = 0; i < size[0]; ++i)
        if(region.contains(i, j, k))
          function(Voxel{i, j, k}, region.index(i, j, k));
}

template <class Value>
std::vector<float> map_of(const Row_spans& region, Value value)
{
  std::vector<float> map(region.storage_size(), 0.f);
  for_each_voxel(region, [&](const Voxel& v, std::size_t place) { map[place] = float(value(v)); });
  return map;
}

/// values from few, so that many neighbours are equal.
inline std::vector<float> random_map(const Row_spans& region, int number_of_values,
                                     std::uint64_t seed)
{
  shapes::Random random(seed);
  return map_of(region, [&](const Voxel&) { return std::floor(random(0, number_of_values)); });
}

inline float value_at(const Row_spans& region, const std::vector<float>& map, const Voxel& v)
{
  const std::size_t place = region.index(v[0], v[1], v[2]);
  return place < map.size() ? map[place] : 0.f;
}

using Maximum = std::tuple<std::size_t, std::size_t, float>; // scale, place, value

/// the maxima by definition: of all maps at once, with everything ordered by (value, scale, place).
inline std::vector<Maximum> maxima_by_definition(const Row_spans& region, const Maps& maps,
                                                 double threshold)
{
  std::vector<Maximum> found;
  for(std::size_t scale = 0; scale < maps.size(); ++scale)
    for_each_voxel(region, [&](const Voxel& v, std::size_t place) {
      const float value = maps[scale][place];
      if(!(value > 0) || value < threshold)
        return;
      const auto rank = [](float of, std::size_t s, std::size_t p) {
        return std::make_tuple(-of, s, p);
      };
      for(std::size_t s = scale > 0 ? scale - 1 : 0; s < std::min(scale + 2, maps.size()); ++s)
        for(int k = v[2] - 1; k <= v[2] + 1; ++k)
          for(int j = v[1] - 1; j <= v[1] + 1; ++j)
            for(int i = v[0] - 1; i <= v[0] + 1; ++i)
              if(region.contains(i, j, k)) {
                const std::size_t p = region.index(i, j, k);
                if(rank(maps[s][p], s, p) < rank(value, scale, place))
                  return;
              }
      found.emplace_back(scale, place, value);
    });
  return found;
}

/// of a map over a cube of voxels, about its centre.
inline AP::Inertia_descriptors inertia_of(const Row_spans& region, const std::vector<float>& map,
                                          double radius)
{
  const int centre = region.grid().size()[0] / 2;
  return AP::inertia_descriptors(AP::map_covariance(region, map, {centre, centre, centre}, radius));
}

} // namespace scale_maps

#endif // AREA_PROJECTION_TRANSFORM_TEST_SCALE_MAPS_H
