// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_HIERARCHY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_HIERARCHY_H

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

using Sparse_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, std::int32_t>;

/// \brief cells with areas, and the conductances between them: off the diagonal their negatives, on
/// it the sum of each row.
struct Linked_cells
{
  Eigen::VectorXd areas;
  Sparse_matrix conductances;
  /// the cell of the next coarser level that each is a part of, or `no_parent`
  std::vector<std::int32_t> parents;

  static constexpr std::int32_t no_parent = -1;

  Eigen::Index size() const { return areas.size(); }

  /// whether no link leads to the cell.
  bool is_alone(Eigen::Index i) const
  {
    for(Sparse_matrix::InnerIterator link(conductances, i); link; ++link)
      if(link.col() != i)
        return false;
    return true;
  }
};

/// \brief the same surface in cells that are larger from level to level, of about four cells of the
/// level below.
///
/// Cells that are alone are on no coarser level: there is nothing to be told of them. On the last level
/// each component is one cell, or there are cells that do not find partners, as those around the
/// hub of a star.
class Cell_hierarchy
{
public:
  explicit Cell_hierarchy(Linked_cells cells)
  {
    m_levels.push_back(std::move(cells));
    for(;;) {
      Linked_cells pairs = coarser(m_levels.back(), Lone_cells::LEFT_OUT);
      // A pair that is alone now stands for two cells that are not.
      Linked_cells fours = coarser(pairs, Lone_cells::KEPT);
      if(fours.size() == 0 || 4 * fours.size() > 3 * m_levels.back().size())
        break;
      for(std::int32_t& parent : m_levels.back().parents)
        if(parent != Linked_cells::no_parent)
          parent = pairs.parents[std::size_t(parent)];
      m_levels.push_back(std::move(fours));
    }
  }

  const std::vector<Linked_cells>& levels() const { return m_levels; }

private:
  enum class Lone_cells { LEFT_OUT, KEPT };

  /// \brief joins each cell with the neighbour to which its link is the strongest, or, if all
  /// neighbours are taken, with the pair of that neighbour; returns the number of parents.
  static std::int32_t find_parents(Linked_cells& cells, Lone_cells lone_cells)
  {
    constexpr std::int32_t none = Linked_cells::no_parent;
    const std::size_t number = std::size_t(cells.size());
    std::vector<std::int32_t>& parents = cells.parents;
    parents.assign(number, none);
    std::vector<bool> is_full(number, false); // a parent, of three cells
    std::int32_t found = 0;
    for(std::int32_t i = 0; i < std::int32_t(number); ++i) {
      if(parents[std::size_t(i)] != none ||
         (lone_cells == Lone_cells::LEFT_OUT && cells.is_alone(i)))
        continue;
      std::int32_t free = none, taken = none;
      double strongest_to_free = 0, strongest_to_taken = 0;
      for(Sparse_matrix::InnerIterator link(cells.conductances, i); link; ++link) {
        const std::int32_t parent = parents[std::size_t(link.col())];
        const double conductance = -link.value();
        if(link.col() == i)
          continue;
        if(parent == none && conductance > strongest_to_free) {
          strongest_to_free = conductance;
          free = std::int32_t(link.col());
        } else if(parent != none && conductance > strongest_to_taken &&
                  !is_full[std::size_t(parent)]) {
          strongest_to_taken = conductance;
          taken = parent;
        }
      }
      if(free == none && taken != none) {
        parents[std::size_t(i)] = taken;
        is_full[std::size_t(taken)] = true;
        continue;
      }
      parents[std::size_t(i)] = found;
      if(free != none)
        parents[std::size_t(free)] = found;
      ++found;
    }
    return found;
  }

  /// \brief finds the parents of some cells and returns the level that they make up.
  ///
  /// The links between two cells of twice the area cross an edge that is sqrt(2) times as long and lead
  /// sqrt(2) times as far: their conductance is the same. The sum of the links between the parts of
  /// the two is sqrt(2) times that, and is divided by it.
  static Linked_cells coarser(Linked_cells& cells, Lone_cells lone_cells)
  {
    const std::int32_t number = find_parents(cells, lone_cells);
    Linked_cells result;
    result.areas = Eigen::VectorXd::Zero(number);
    std::vector<Eigen::Triplet<double, std::int32_t>> entries;
    entries.reserve(std::size_t(cells.conductances.nonZeros()));
    const double factor = std::sqrt(0.5);
    for(std::int32_t i = 0; i < std::int32_t(cells.size()); ++i) {
      const std::int32_t parent = cells.parents[std::size_t(i)];
      if(parent == Linked_cells::no_parent)
        continue;
      result.areas[parent] += cells.areas[i];
      for(Sparse_matrix::InnerIterator link(cells.conductances, i); link; ++link)
        entries.emplace_back(parent, cells.parents[std::size_t(link.col())], factor * link.value());
    }
    result.conductances.resize(number, number);
    result.conductances.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  std::vector<Linked_cells> m_levels;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_CELL_HIERARCHY_H
