// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_INDEX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_INDEX_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief numbers cells of an unbounded lattice in the order in which they are met first.
///
/// A hash table with open addressing. Coordinates must be in `[-2^19, 2^19)`, labels in `[0, 8)`.
class Cell_index
{
public:
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  explicit Cell_index(std::size_t expected = 16) { reserve(expected); }

  std::size_t size() const { return m_size; }

  static std::uint64_t key(const std::array<std::int32_t, 3>& cell, unsigned label = 0)
  {
    constexpr std::int64_t shift = std::int64_t(1) << 19;
    std::uint64_t key = label;
    for(const std::int32_t coordinate : cell)
      key = key << 20 | (std::uint64_t(coordinate + shift) & 0xfffff);
    return key;
  }

  /// the number of a cell, a new one if it was not met before.
  std::uint32_t insert(std::uint64_t key)
  {
    if(2 * (m_size + 1) > m_slots.size())
      grow();
    Slot& slot = m_slots[place(key)];
    if(slot.number == none)
      slot = {key, std::uint32_t(m_size++)};
    return slot.number;
  }

  /// the number of a cell, or `none`.
  std::uint32_t find(std::uint64_t key) const { return m_slots[place(key)].number; }

private:
  struct Slot
  {
    std::uint64_t key = 0;
    std::uint32_t number = none;
  };

  void reserve(std::size_t expected)
  {
    std::size_t size = 16;
    while(size < 2 * expected)
      size *= 2;
    m_slots.assign(size, Slot());
  }

  void grow()
  {
    std::vector<Slot> old;
    old.swap(m_slots);
    m_slots.assign(2 * old.size(), Slot());
    for(const Slot& slot : old)
      if(slot.number != none)
        m_slots[place(slot.key)] = slot;
  }

  std::size_t place(std::uint64_t key) const
  {
    std::uint64_t h = key * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = std::size_t(h) & mask;
    while(m_slots[i].number != none && m_slots[i].key != key)
      i = (i + 1) & mask;
    return i;
  }

  std::vector<Slot> m_slots;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_INDEX_H
