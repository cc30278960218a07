// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// No include guard: the kernel of `Weighted_point_tree`, compiled for each instruction set by
// `for_each_instruction_set.h`.

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// adds the weights of the points of a leaf that are in the ball.
inline void add_leaf(const Weighted_point_tree_nodes::Leaf& leaf, const Weighted_points_ball& ball,
                     Longs& sum)
{
  for(std::size_t i = 0; i < Weighted_point_tree_nodes::leaf_size; i += double_lanes) {
    const Doubles x = load(leaf.position[0] + i) - ball.center[0];
    const Doubles y = load(leaf.position[1] + i) - ball.center[1];
    const Doubles z = load(leaf.position[2] + i) - ball.center[2];
    sum += load(leaf.weight + i) & (x * x + y * y + z * z <= ball.squared_radius);
  }
}

/// \brief adds the weights of the children that are inside the ball.
/// \return the children that the rim may pass through, as bits.
inline unsigned add_children(const Weighted_point_tree_nodes::Node& node,
                             const Weighted_points_ball& ball, Longs& sum)
{
  unsigned rim = 0;
  for(std::size_t i = 0; i < Weighted_point_tree_nodes::arity; i += double_lanes) {
    Doubles nearest{}, farthest{};
    for(int axis = 0; axis < 3; ++axis) {
      const Doubles below = load(node.low[axis] + i) - ball.center[axis];
      const Doubles above = ball.center[axis] - load(node.high[axis] + i);
      const Doubles outside = max(max(below, above), Doubles{}), through = min(below, above);
      nearest += outside * outside;
      farthest += through * through;
    }
    const Longs is_inside = farthest <= ball.squared_radius;
    const Longs is_cut = (nearest <= ball.squared_radius) & ~is_inside;
    sum += load(node.weight + i) & is_inside;
    rim |= mask(is_cut) << i;
  }
  return rim;
}

inline void add_node(const Weighted_point_tree_nodes& tree, std::size_t level, std::size_t number,
                     const Weighted_points_ball& ball, Longs& sum)
{
  for(unsigned rim = add_children(tree.levels[level][number], ball, sum); rim != 0;
      rim &= rim - 1) {
    const std::size_t child =
        number * Weighted_point_tree_nodes::arity + std::size_t(__builtin_ctz(rim));
    if(level == 0)
      add_leaf(tree.leaves[child], ball, sum);
    else
      add_node(tree, level - 1, child, ball, sum);
  }
}

inline std::int64_t sum_of_weights(const Weighted_point_tree_nodes& tree,
                                   const Weighted_points_ball& ball)
{
  Longs weights{};
  if(!tree.levels.empty())
    add_node(tree, tree.levels.size() - 1, 0, ball, weights);
  return sum(weights);
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
