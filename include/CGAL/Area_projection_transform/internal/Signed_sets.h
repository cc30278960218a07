// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_SETS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_SETS_H

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief disjoint sets that grow together and know of any two members whether they have the same sign.
class Signed_sets
{
public:
  struct Place
  {
    std::size_t set;  ///< the member that stands for it
    bool is_opposite; ///< whether the sign is not that of this member
  };

  explicit Signed_sets(std::size_t number)
      : m_parents(number), m_is_opposite(number, false), m_sizes(number, 1)
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  Place find(std::size_t i)
  {
    Place place{i, false};
    for(; m_parents[place.set] != place.set; place.set = m_parents[place.set])
      place.is_opposite = place.is_opposite != m_is_opposite[place.set];
    bool is_opposite = place.is_opposite; // of i; the way up becomes short
    while(m_parents[i] != place.set && i != place.set) {
      const bool is_opposite_to_parent = m_is_opposite[i];
      m_is_opposite[i] = is_opposite;
      is_opposite = is_opposite != is_opposite_to_parent;
      i = std::exchange(m_parents[i], place.set);
    }
    return place;
  }

  /// joins the sets of `i` and `j`, unless they are the same: then the signs stay as they are.
  void join(std::size_t i, std::size_t j, bool are_opposite)
  {
    Place a = find(i), b = find(j);
    if(a.set == b.set)
      return;
    if(m_sizes[a.set] > m_sizes[b.set])
      std::swap(a, b);
    m_parents[a.set] = b.set;
    m_is_opposite[a.set] = (a.is_opposite != b.is_opposite) != are_opposite;
    m_sizes[b.set] += m_sizes[a.set];
  }

private:
  std::vector<std::size_t> m_parents;
  std::vector<char> m_is_opposite; // of each to its parent
  std::vector<std::size_t> m_sizes;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SIGNED_SETS_H
