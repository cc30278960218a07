// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_TREE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_TREE_H

#include <CGAL/Area_projection_transform/internal/Flat_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief eight of something side by side; places that are not used have empty boxes and no area.
constexpr std::size_t block_size = 8;
using Block = std::array<double, block_size>;

/// the bounding boxes and the areas of the children of a node.
struct Box_block
{
  std::array<Block, 3> low, high;
  Block area;
};

/// triangles; see `Flat_triangle`.
struct Triangle_block
{
  std::array<Block, 3> corner; ///< the first one
  std::array<Block, 3> x_axis, y_axis, normal;
  std::array<Block, 3> length, cosine, sine; ///< by edge
  std::array<Block, 2> along, across;        ///< the directions of the second and the third edge
  Block factor;                              ///< what twice the area is multiplied by
};

/// \brief a tree of triangles, eight children to a node and eight triangles to a leaf.
///
/// `levels[0]` has the boxes of the leaves, and each level above those of the nodes of the one below: the
/// children of node `n` have the nodes, or leaves, `8 n`, …, `8 n + 7`. The last level is one node.
struct Exact_tree
{
  std::vector<Triangle_block> leaves;
  std::vector<std::vector<Box_block>> levels;
  double longest_edge = 0;
};

/// builds an `Exact_tree` of a surface that is projected by `distance`.
class Exact_tree_builder
{
public:
  Exact_tree_builder(const Triangle_surface& surface, double distance)
      : m_surface(surface), m_distance(distance), m_order(surface.size())
  {
    std::iota(m_order.begin(), m_order.end(), 0u);
  }

  Exact_tree build()
  {
    Exact_tree tree;
    if(m_order.empty())
      return tree;
    std::size_t size_of_child = block_size;
    while(size_of_child * block_size < m_order.size())
      size_of_child *= block_size;
    sort(0, m_order.size(), size_of_child);
    tree.leaves.assign((m_order.size() - 1) / block_size + 1, Triangle_block());
    tree.levels.emplace_back((tree.leaves.size() - 1) / block_size + 1, empty_boxes());
    for(std::size_t i = 0; i < m_order.size(); ++i)
      add(m_order[i], i, tree);
    while(tree.levels.back().size() > 1)
      tree.levels.push_back(parents(tree.levels.back()));
    return tree;
  }

private:
  static Box_block empty_boxes()
  {
    Box_block boxes{};
    for(std::size_t axis = 0; axis < 3; ++axis) {
      boxes.low[axis].fill(std::numeric_limits<double>::infinity());
      boxes.high[axis].fill(-std::numeric_limits<double>::infinity());
    }
    return boxes;
  }

  /// three times the centroid of a projected triangle.
  std::array<double, 3> position(std::uint32_t t) const
  {
    const Vector_3 shift = 3 * m_distance * m_surface.normals[t];
    std::array<double, 3> sum{shift.x(), shift.y(), shift.z()};
    for(int corner = 0; corner < 3; ++corner)
      for(int axis = 0; axis < 3; ++axis)
        sum[std::size_t(axis)] += m_surface.corner(t, corner)[axis];
    return sum;
  }

  /// \brief orders the triangles `first`, …, `last - 1` such that runs of `size_of_child` lie close
  /// together, and so on for the children.
  void sort(std::size_t first, std::size_t last, std::size_t size_of_child)
  {
    if(last - first <= block_size)
      return;
    const std::size_t children = (last - first - 1) / size_of_child + 1;
    if(children == 1)
      return sort(first, last, size_of_child / block_size);
    Bbox_3 box;
    for(std::size_t i = first; i < last; ++i) {
      const auto p = position(m_order[i]);
      box += Point_3(p[0], p[1], p[2]).bbox();
    }
    int axis = 0;
    for(int other = 1; other < 3; ++other)
      if(box.max(other) - box.min(other) > box.max(axis) - box.min(axis))
        axis = other;
    const std::size_t middle = first + children / 2 * size_of_child;
    const auto place = [this](std::size_t i) { return m_order.begin() + std::ptrdiff_t(i); };
    std::nth_element(place(first), place(middle), place(last),
                     [&](std::uint32_t s, std::uint32_t t) {
                       return position(s)[std::size_t(axis)] < position(t)[std::size_t(axis)];
                     });
    sort(first, middle, size_of_child);
    sort(middle, last, size_of_child);
  }

  /// puts triangle `t` at the place `i` of the leaves, and enlarges the box of its leaf.
  void add(std::uint32_t t, std::size_t i, Exact_tree& tree) const
  {
    const Flat_triangle triangle = projected_triangle(m_surface, t, m_distance);
    const std::size_t leaf = i / block_size, lane = i % block_size;
    Triangle_block& block = tree.leaves[leaf];
    Box_block& boxes = tree.levels.front()[leaf / block_size];
    for(std::size_t k = 0; k < 3; ++k) {
      const int axis = int(k);
      block.corner[k][lane] = triangle.corners[0][axis];
      block.x_axis[k][lane] = triangle.x_axis[axis];
      block.y_axis[k][lane] = triangle.y_axis[axis];
      block.normal[k][lane] = triangle.normal[axis];
      block.length[k][lane] = triangle.lengths[k];
      block.cosine[k][lane] = triangle.cosines[k];
      block.sine[k][lane] = triangle.sines[k];
      for(const Point_3& corner : triangle.corners) {
        double& low = boxes.low[k][leaf % block_size];
        double& high = boxes.high[k][leaf % block_size];
        low = std::min(low, corner[axis]);
        high = std::max(high, corner[axis]);
      }
    }
    for(std::size_t edge = 0; edge < 2; ++edge) {
      block.along[edge][lane] = triangle.directions[edge + 1][0];
      block.across[edge][lane] = triangle.directions[edge + 1][1];
    }
    tree.longest_edge = std::max(tree.longest_edge, triangle.longest_edge());
    block.factor[lane] = m_surface.areas[t] / triangle.doubled_area;
    boxes.area[leaf % block_size] += m_surface.areas[t];
  }

  static std::vector<Box_block> parents(const std::vector<Box_block>& children)
  {
    std::vector<Box_block> result((children.size() - 1) / block_size + 1, empty_boxes());
    for(std::size_t c = 0; c < children.size(); ++c) {
      Box_block& boxes = result[c / block_size];
      const std::size_t lane = c % block_size;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        const Block &low = children[c].low[axis], &high = children[c].high[axis];
        boxes.low[axis][lane] = *std::min_element(low.begin(), low.end());
        boxes.high[axis][lane] = *std::max_element(high.begin(), high.end());
      }
      boxes.area[lane] = std::accumulate(children[c].area.begin(), children[c].area.end(), 0.);
    }
    return result;
  }

  const Triangle_surface& m_surface;
  double m_distance;
  std::vector<std::uint32_t> m_order;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#define CGAL_AREA_PROJECTION_KERNEL <CGAL/Area_projection_transform/internal/exact_tree_impl.h>
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// the area of the triangles of a tree within a ball; the same bits for every instruction set.
inline double area_within_ball(const Exact_tree& tree, const Point_3& center, double radius)
{
  return CGAL_AREA_PROJECTION_DISPATCHED(sum_of_tree, tree, center, radius);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_EXACT_TREE_H
