// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DISJOINT_SETS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// which things are connected.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t number) : m_parent(number), m_number(number)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  /// the smallest member of the set of a thing.
  std::size_t find(std::size_t i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  /// returns whether they were not connected before.
  bool unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    m_parent[std::max(i, j)] = std::min(i, j);
    m_number -= i != j;
    return i != j;
  }

  /// how many sets there are.
  std::size_t number() const { return m_number; }

private:
  std::vector<std::size_t> m_parent;
  std::size_t m_number;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_DISJOINT_SETS_H
