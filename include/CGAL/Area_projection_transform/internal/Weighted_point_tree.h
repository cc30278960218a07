// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WEIGHTED_POINT_TREE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WEIGHTED_POINT_TREE_H

#include <CGAL/Area_projection_transform/internal/Weighted_points.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <iterator>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the nodes of a `Weighted_point_tree` as its kernel reads them.
///
/// All leaves but the last are full, and so are all nodes but the last of a level: the children of node
/// `i` are the nodes `i · arity`, `i · arity + 1`, … of the level below, so that there are no pointers.
struct Weighted_point_tree_nodes
{
  static constexpr std::size_t leaf_size = 32;
  static constexpr std::size_t arity = 16;

  struct alignas(64) Leaf
  {
    double position[3][leaf_size];
    std::int64_t weight[leaf_size]; ///< 0 where the last leaf is not full
  };

  /// the boxes of the children of a node, and the sums of their weights.
  struct alignas(64) Node
  {
    double low[3][arity], high[3][arity]; ///< an empty box where the last node is not full
    std::int64_t weight[arity];
  };

  std::vector<Leaf> leaves;
  std::vector<std::vector<Node>> levels; ///< the parents of leaves first, the root last
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#define CGAL_AREA_PROJECTION_KERNEL                                                                \
<CGAL/Area_projection_transform/internal/weighted_point_tree_impl.h>
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief sums the weights of the points in a ball, whatever its radius.
///
/// A k-d tree with many children at each node: their boxes are compared with the ball side by side.
/// The weight of a subtree is known, and it is entered only if its box has points on either side of the
/// rim, as far as the box can tell. The sums are integers, so that they depend neither on the shape of
/// the tree nor on the order of the points.
///
/// Distances to the corners of boxes are computed like those to points. Since rounding keeps the order of
/// numbers, no point of a box comes out nearer or farther than the box does: every point is judged as if
/// its own distance had been computed, without any tolerance.
///
/// There is no rule that chooses another structure, since none was needed: the benchmark `ball_sums` compares
/// it with cells of `σ/3` to `σ/8` with prefix sums of the weights along rows of cells, for balls that all
/// have the same `σ`. Among 10^6 points, a sum over 10^2, 2600, 10^4 and 9·10^4 points takes 0.7, 3.2, 5.6
/// and 17 µs here and 1.0, 6.7, 12 and 64 µs at best there, where the points of whole cells along the rim
/// are looked at. Cells are built in 60 to 110 ms instead of 260: they would pay for fewer than about
/// 30 000 queries, each with a `σ` known beforehand.
class Weighted_point_tree
{
public:
  /// \tparam ConcurrencyTag says how the tree is built
  /// \pre the coordinates are finite.
  ///
  /// Complexity: `O(n log n)` for `n` points; 34 bytes for each, 66 while it builds.
  template <class ConcurrencyTag>
  Weighted_point_tree(std::vector<Weighted_point> points, ConcurrencyTag)
  {
    if(points.empty())
      return;
    arrange<ConcurrencyTag>(points.data(), points.size());
    fill_leaves(points);
    m_nodes.levels.push_back(parents(m_nodes.leaves));
    while(m_nodes.levels.back().size() > 1)
      m_nodes.levels.push_back(parents(m_nodes.levels.back()));
  }

  /// Complexity: linear in the number of leaves that the rim passes through.
  std::int64_t sum(const Weighted_points_ball& ball) const
  {
    return CGAL_AREA_PROJECTION_DISPATCHED(sum_of_weights, m_nodes, ball);
  }

private:
  using Nodes = Weighted_point_tree_nodes;

  /// sorts the points such that those of each leaf and of each node follow each other.
  template <class ConcurrencyTag>
  static void arrange(Weighted_point* points, std::size_t number)
  {
    if(number <= Nodes::leaf_size)
      return;
    std::size_t left = Nodes::leaf_size; // a power of two of leaves
    while(2 * left < number)
      left *= 2;
    const int axis = widest_axis(points, number);
    std::nth_element(points, points + left, points + number,
                     [axis](const Weighted_point& a, const Weighted_point& b) {
                       return a.position[axis] < b.position[axis];
                     });
    const auto arrange_left = [=] { arrange<ConcurrencyTag>(points, left); };
    const auto arrange_right = [=] { arrange<ConcurrencyTag>(points + left, number - left); };
    constexpr std::size_t worth_a_task = 10000;
    if(number < worth_a_task)
      run_both<Sequential_tag>(arrange_left, arrange_right);
    else
      run_both<ConcurrencyTag>(arrange_left, arrange_right);
  }

  /// the axis along which points spread most, as about a hundred of them tell.
  static int widest_axis(const Weighted_point* points, std::size_t number)
  {
    double low[3], high[3];
    std::copy_n(points->position, 3, low);
    std::copy_n(points->position, 3, high);
    for(std::size_t i = 0; i < number; i += 1 + number / 128)
      for(int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], points[i].position[axis]);
        high[axis] = std::max(high[axis], points[i].position[axis]);
      }
    int widest = 0;
    for(int axis = 1; axis < 3; ++axis)
      if(high[axis] - low[axis] > high[widest] - low[widest])
        widest = axis;
    return widest;
  }

  void fill_leaves(const std::vector<Weighted_point>& points)
  {
    const std::size_t size = Nodes::leaf_size;
    m_nodes.leaves.resize((points.size() + size - 1) / size);
    for(std::size_t i = 0; i < m_nodes.leaves.size() * size; ++i) {
      const Weighted_point& point = points[std::min(i, points.size() - 1)];
      Nodes::Leaf& leaf = m_nodes.leaves[i / size];
      for(int axis = 0; axis < 3; ++axis)
        leaf.position[axis][i % size] = point.position[axis];
      leaf.weight[i % size] = i < points.size() ? point.weight : 0;
    }
  }

  template <class Child>
  static std::vector<Nodes::Node> parents(const std::vector<Child>& children)
  {
    std::vector<Nodes::Node> nodes((children.size() + Nodes::arity - 1) / Nodes::arity);
    for(std::size_t i = 0; i < nodes.size() * Nodes::arity; ++i) {
      Nodes::Node& node = nodes[i / Nodes::arity];
      if(i < children.size())
        enclose(children[i], node, i % Nodes::arity);
      else
        for(int axis = 0; axis < 3; ++axis) {
          node.low[axis][i % Nodes::arity] = std::numeric_limits<double>::infinity();
          node.high[axis][i % Nodes::arity] = -std::numeric_limits<double>::infinity();
        }
    }
    return nodes;
  }

  static void enclose(const Nodes::Leaf& leaf, Nodes::Node& node, std::size_t child)
  {
    for(int axis = 0; axis < 3; ++axis) {
      const auto& x = leaf.position[axis];
      node.low[axis][child] = *std::min_element(std::begin(x), std::end(x));
      node.high[axis][child] = *std::max_element(std::begin(x), std::end(x));
    }
    node.weight[child] =
        std::accumulate(std::begin(leaf.weight), std::end(leaf.weight), std::int64_t(0));
  }

  static void enclose(const Nodes::Node& below, Nodes::Node& node, std::size_t child)
  {
    for(int axis = 0; axis < 3; ++axis) {
      const auto &low = below.low[axis], &high = below.high[axis];
      node.low[axis][child] = *std::min_element(std::begin(low), std::end(low));
      node.high[axis][child] = *std::max_element(std::begin(high), std::end(high));
    }
    node.weight[child] =
        std::accumulate(std::begin(below.weight), std::end(below.weight), std::int64_t(0));
  }

  Nodes m_nodes;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_WEIGHTED_POINT_TREE_H
