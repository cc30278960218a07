// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "local_maxima.h"

#include <algorithm>
#include <array>
#include <limits>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

using Voxel = std::array<int, 3>;

template <class Visit>
void for_each_neighbour(const Voxel& v, const AP::Grid_3& grid, Visit&& visit)
{
  const auto first = [&](int axis) { return std::max(v[axis] - 1, 0); };
  const auto last = [&](int axis) { return std::min(v[axis] + 1, grid.size()[axis] - 1); };
  for(int k = first(2); k <= last(2); ++k)
    for(int j = first(1); j <= last(1); ++j)
      for(int i = first(0); i <= last(0); ++i)
        if(i != v[0] || j != v[1] || k != v[2])
          if(!visit(Voxel{i, j, k}))
            return;
}

class Maxima_finder
{
public:
  explicit Maxima_finder(const AP::Joint_map& map)
      : m_map(map), m_is_seen(map.region().storage_size(), false)
  {}

  std::vector<Local_maximum> find()
  {
    const AP::Grid_3& grid = m_map.grid();
    for(int k = 0; k < grid.size()[2]; ++k)
      for(int j = 0; j < grid.size()[1]; ++j) {
        const auto [begin, end] = m_map.region().runs(grid.row(j, k));
        for(auto run = begin; run != end; ++run)
          for(int i = run->first; i < run->last; ++i)
            visit({i, j, k});
      }
    return std::move(m_found);
  }

private:
  float value(const Voxel& v) const { return m_map.value(v[0], v[1], v[2]); }
  std::size_t index(const Voxel& v) const { return m_map.region().index(v[0], v[1], v[2]); }

  void visit(const Voxel& voxel)
  {
    const float height = value(voxel);
    if(!(height > 0) || m_is_seen[index(voxel)])
      return;
    bool is_highest = true;
    bool is_alone = true;
    for_each_neighbour(voxel, m_map.grid(), [&](const Voxel& neighbour) {
      is_highest = value(neighbour) <= height;
      is_alone = is_alone && value(neighbour) < height;
      return is_highest;
    });
    if(is_highest && is_alone)
      add(voxel);
    else if(is_highest)
      visit_plateau(voxel);
  }

  // collects the voxels of equal value that hang together, and whether they overlook their
  // surroundings
  void visit_plateau(const Voxel& seed)
  {
    const float height = value(seed);
    bool is_highest = true;
    std::vector<Voxel> plateau{seed};
    m_is_seen[index(seed)] = true;
    for(std::size_t next = 0; next < plateau.size(); ++next) {
      const Voxel voxel = plateau[next];
      for_each_neighbour(voxel, m_map.grid(), [&](const Voxel& neighbour) {
        is_highest = is_highest && value(neighbour) <= height;
        if(value(neighbour) == height && !m_is_seen[index(neighbour)]) {
          m_is_seen[index(neighbour)] = true;
          plateau.push_back(neighbour);
        }
        return true;
      });
    }
    if(is_highest)
      add(middle(plateau));
  }

  static Voxel middle(const std::vector<Voxel>& plateau)
  {
    std::array<double, 3> mean{0, 0, 0};
    for(const Voxel& v : plateau)
      for(int axis = 0; axis < 3; ++axis)
        mean[axis] += double(v[axis]) / double(plateau.size());
    const auto squared_distance = [&](const Voxel& v) {
      double sum = 0;
      for(int axis = 0; axis < 3; ++axis)
        sum += (v[axis] - mean[axis]) * (v[axis] - mean[axis]);
      return sum;
    };
    return *std::min_element(plateau.begin(), plateau.end(), [&](const Voxel& a, const Voxel& b) {
      return squared_distance(a) < squared_distance(b);
    });
  }

  void add(const Voxel& v)
  {
    m_found.push_back(
        {m_map.grid().point(v[0], v[1], v[2]), m_map.radius(v[0], v[1], v[2]), double(value(v))});
  }

  const AP::Joint_map& m_map;
  std::vector<bool> m_is_seen; // part of a plateau
  std::vector<Local_maximum> m_found;
};

} // namespace

std::vector<Local_maximum> strongest_local_maxima(const AP::Joint_map& map, std::size_t number)
{
  std::vector<Local_maximum> all = Maxima_finder(map).find();
  std::stable_sort(all.begin(), all.end(), [](const Local_maximum& a, const Local_maximum& b) {
    return a.value > b.value;
  });
  std::vector<Local_maximum> kept;
  for(const Local_maximum& candidate : all) {
    if(kept.size() == number)
      break;
    const double reach = candidate.radius / 2;
    if(std::none_of(kept.begin(), kept.end(), [&](const Local_maximum& stronger) {
         return CGAL::squared_distance(candidate.position, stronger.position) < reach * reach;
       }))
      kept.push_back(candidate);
  }
  return kept;
}

} // namespace mapt
