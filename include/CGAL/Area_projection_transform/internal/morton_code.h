// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_MORTON_CODE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_MORTON_CODE_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the place of an element on a curve that fills space and goes through octants recursively.
struct Morton_code
{
  std::uint64_t code;
  std::uint32_t element;
};

/// moves bit `i` of a number of 21 bits to bit `3 i`.
inline std::uint64_t spread_bits(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffu;
  x = (x | x << 16) & 0x001f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  x = (x | x << 2) & 0x1249249249249249u;
  return x;
}

/// \brief returns the codes of the positions of elements, ascending.
///
/// Elements in the same cell of the finest level are ordered by `precedes()`, so that the order of the
/// input does not matter.
template <class Element>
std::vector<Morton_code> sorted_morton_codes(const std::vector<Element>& elements)
{
  Bbox_3 box;
  for(const Element& e : elements)
    box += e.position.bbox();
  double extent = 0;
  for(int axis = 0; axis < 3; ++axis)
    extent = std::max(extent, box.max(axis) - box.min(axis));
  const double cells = 2097151; // 2^21 - 1
  const double scale = extent > 0 ? cells / extent : 0;

  std::vector<Morton_code> codes;
  codes.reserve(elements.size());
  for(std::size_t i = 0; i < elements.size(); ++i) {
    std::uint64_t code = 0;
    for(int axis = 0; axis < 3; ++axis)
      code |= spread_bits(std::uint64_t((elements[i].position[axis] - box.min(axis)) * scale))
              << axis;
    codes.push_back({code, std::uint32_t(i)});
  }
  std::sort(codes.begin(), codes.end(), [&](const Morton_code& a, const Morton_code& b) {
    if(a.code != b.code)
      return a.code < b.code;
    return precedes(elements[a.element], elements[b.element]);
  });
  return codes;
}

/// \brief returns where the highest bit that is not common to a range of ascending codes becomes
/// one; in the middle if all are equal. The range has at least two codes.
inline std::size_t split_of_morton_range(const std::vector<Morton_code>& codes, std::size_t first,
                                         std::size_t last)
{
  std::uint64_t differing = codes[first].code ^ codes[last - 1].code;
  if(differing == 0)
    return first + (last - first) / 2;
  while((differing & (differing - 1)) != 0)
    differing &= differing - 1; // keeps the highest bit
  return std::size_t(std::partition_point(
                         codes.begin() + first, codes.begin() + last,
                         [differing](const Morton_code& c) { return (c.code & differing) == 0; }) -
                     codes.begin());
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_MORTON_CODE_H
