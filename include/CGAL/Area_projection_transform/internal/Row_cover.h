// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_COVER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_COVER_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/offset_chords.h>
#include <CGAL/Area_projection_transform/internal/region_by_slabs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the voxels that offset solids cover, row by row.
///
/// A row cuts a chord out of each solid. Their union is found by following it: a hierarchy of boxes
/// tells which solid covers a voxel and reaches farthest, or which is the next to begin. So a row costs
/// some searches for each of its runs, however many solids cover it.
/// \tparam Solids has `size()`, `bbox(i)` and `chord(i, line)`; a solid is all points within a distance of
/// something in its box.
template <class Solids>
class Row_cover
{
public:
  Row_cover(const Solids& solids, const Grid_3& grid, double distance)
      : m_solids(solids), m_grid(grid), m_distance(distance / grid.spacing())
  {
    if(m_solids.size() == 0)
      return;
    std::vector<std::uint32_t> order(m_solids.size());
    std::iota(order.begin(), order.end(), 0u);
    m_nodes.reserve(2 * order.size() - 1);
    build(order.data(), order.data() + order.size());
  }

  /// appends the runs of voxels of row (`j`, `k`) that are covered.
  void append_runs(int j, int k, std::vector<Row_spans::Run>& runs) const
  {
    const std::int32_t size = m_grid.size()[0];
    for(std::int32_t i = 0; i < size;) {
      const Row_spans::Run run = next_run(i, j, k);
      if(run.first >= size)
        return;
      append_run({run.first, std::min(run.last, size)}, runs);
      i = run.last;
    }
  }

private:
  /// in preorder: the children of a node are the one after it and `right`.
  struct Node
  {
    std::array<float, 3> low, high; ///< in voxels, rounded outward
    std::uint32_t right = 0;        ///< of a leaf: the solid
    bool is_leaf = false;
  };

  void build(std::uint32_t* begin, std::uint32_t* end)
  {
    const std::size_t index = m_nodes.size();
    m_nodes.emplace_back();
    Bbox_3 box, centers;
    for(const std::uint32_t* solid = begin; solid != end; ++solid) {
      box += m_solids.bbox(*solid);
      centers += center(*solid).bbox();
    }
    set_box(box, m_nodes[index]);
    if(end - begin == 1) {
      m_nodes[index].is_leaf = true;
      m_nodes[index].right = *begin;
      return;
    }
    const std::array<double, 3> spans{centers.x_span(), centers.y_span(), centers.z_span()};
    const int axis = int(std::max_element(spans.begin(), spans.end()) - spans.begin());
    std::uint32_t* const middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
      return center(a)[axis] < center(b)[axis];
    });
    build(begin, middle);
    m_nodes[index].right = std::uint32_t(m_nodes.size());
    build(middle, end);
  }

  Point_3 center(std::uint32_t solid) const
  {
    const Bbox_3 box = m_solids.bbox(solid);
    return Point_3(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                   0.5 * (box.zmin() + box.zmax()));
  }

  void set_box(const Bbox_3& box, Node& node) const
  {
    const Vector_3 low = m_grid.lattice_coordinates({box.xmin(), box.ymin(), box.zmin()});
    const Vector_3 high = m_grid.lattice_coordinates({box.xmax(), box.ymax(), box.zmax()});
    // Two steps of a float are more than what doubles lose to rounding.
    const auto outward = [](double value, double direction) {
      const float limit = float(direction) * std::numeric_limits<float>::infinity();
      return std::nextafter(std::nextafter(float(value), limit), limit);
    };
    for(int axis = 0; axis < 3; ++axis) {
      node.low[std::size_t(axis)] = outward(low[axis], -1);
      node.high[std::size_t(axis)] = outward(high[axis], 1);
    }
  }

  /// a row, a voxel of it, and the best run so far: that of which `first` is the least from the voxel on,
  /// and among these the longest.
  struct Search
  {
    double j, k;
    Point_3 line; ///< the first voxel of the row
    std::int32_t voxel;
    Row_spans::Run best;

    bool improves(const Row_spans::Run& run) const
    {
      const std::int32_t first = std::max(run.first, voxel);
      return first < run.last &&
             (first < best.first || (first == best.first && run.last > best.last));
    }
  };

  /// the first run of voxels from `voxel` on that one solid covers; none is behind the end of the row.
  Row_spans::Run next_run(std::int32_t voxel, int j, int k) const
  {
    const std::int32_t size = m_grid.size()[0];
    Search search{double(j), double(k), m_grid.point(0, j, k), voxel, {size, size}};
    if(!m_nodes.empty() && search.improves(bound(m_nodes[0], search)))
      descend(0, search);
    return search.best;
  }

  void descend(std::uint32_t index, Search& search) const
  {
    const Node& node = m_nodes[index];
    if(node.is_leaf) {
      const Row_spans::Run run = run_of_solid(node.right, search);
      if(search.improves(run))
        search.best = {std::max(run.first, search.voxel), run.last};
      return;
    }
    std::array<std::uint32_t, 2> children{index + 1, node.right};
    std::array<Row_spans::Run, 2> bounds{bound(m_nodes[children[0]], search),
                                         bound(m_nodes[children[1]], search)};
    const auto key = [&](const Row_spans::Run& run) {
      return std::make_pair(std::max(run.first, search.voxel), -run.last);
    };
    if(key(bounds[1]) < key(bounds[0])) {
      std::swap(children[0], children[1]);
      std::swap(bounds[0], bounds[1]);
    }
    for(std::size_t i = 0; i < 2; ++i)
      if(search.improves(bounds[i]))
        descend(children[i], search);
  }

  /// the voxels between two places in a row, both included.
  Row_spans::Run voxels_between(double first, double last) const
  {
    const double size = m_grid.size()[0];
    // Truncation rounds positive numbers down.
    return {std::int32_t(size + 1) - std::int32_t(size + 1 - std::clamp(first, 0., size)),
            std::int32_t(std::clamp(last, -1., size - 1) + 1)};
  }

  Row_spans::Run run_of_solid(std::uint32_t solid, const Search& search) const
  {
    const Chord chord = m_solids.chord(solid, search.line);
    return chord.is_empty()
               ? Row_spans::Run{0, 0}
               : voxels_between(chord.first / m_grid.spacing(), chord.last / m_grid.spacing());
  }

  /// the voxels that the solids below a node may cover at most.
  Row_spans::Run bound(const Node& node, const Search& search) const
  {
    const double dy = std::max({node.low[1] - search.j, search.j - node.high[1], 0.});
    const double dz = std::max({node.low[2] - search.k, search.k - node.high[2], 0.});
    const double squared_half = m_distance * m_distance - dy * dy - dz * dz;
    if(squared_half < 0)
      return {0, 0};
    const double half = std::sqrt(squared_half);
    return voxels_between(node.low[0] - half, node.high[0] + half);
  }

  const Solids& m_solids;
  const Grid_3& m_grid;
  double m_distance; ///< in voxels
  std::vector<Node> m_nodes;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ROW_COVER_H
