// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A kernel, included once for each instruction set; see Exact_tree.h.
//
// Each of the eight places of the blocks has a sum of its own, and these are added in the end: so the
// order of the additions does not depend on the number of lanes.

#include <CGAL/Area_projection_transform/internal/triangle_disk_impl.h>

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

constexpr int doubles = Lanes_traits<Doubles>::size;

class Ball_in_tree
{
public:
  Ball_in_tree(const Exact_tree& tree, const Point_3& center, double radius)
      : m_tree(tree), m_center{center.x(), center.y(), center.z()}, m_radius(radius)
  {}

  /// adds what the ball holds of the children of a node.
  void add_node(std::size_t level, std::size_t node)
  {
    const Box_block& boxes = m_tree.levels[level][node];
    const Doubles squared_radius = all(m_radius * m_radius);
    unsigned cut = 0; // the children that the rim of the ball meets
    for(int i = 0; i < int(block_size); i += doubles) {
      Doubles nearest{}, farthest{};
      for(std::size_t axis = 0; axis < 3; ++axis) {
        const Doubles below = load(&boxes.low[axis][std::size_t(i)]) - m_center[axis];
        const Doubles above = m_center[axis] - load(&boxes.high[axis][std::size_t(i)]);
        const Doubles gap = max(max(below, above), Doubles{}), reach = max(-below, -above);
        nearest += gap * gap;
        farthest += reach * reach;
      }
      const auto is_held = farthest <= squared_radius;
      add(is_held ? load(&boxes.area[std::size_t(i)]) : Doubles{}, i);
      cut |= mask((nearest < squared_radius) & (farthest > squared_radius)) << i;
    }
    for(std::size_t child = block_size * node; cut != 0; cut >>= 1, ++child)
      if(cut & 1)
        level == 0 ? add_leaf(m_tree.leaves[child]) : add_node(level - 1, child);
  }

  double sum() const
  {
    return ((m_sums[0] + m_sums[1]) + (m_sums[2] + m_sums[3])) +
           ((m_sums[4] + m_sums[5]) + (m_sums[6] + m_sums[7]));
  }

private:
  void add(Doubles areas, int place) { store(load(m_sums + place) + areas, m_sums + place); }

  void add_leaf(const Triangle_block& leaf)
  {
    for(int i = 0; i < int(block_size); i += doubles) {
      const auto of = [i](const Block& block) { return load(block.data() + i); };
      const auto dot = [&](const std::array<Block, 3>& axis, const Doubles* v) {
        return of(axis[0]) * v[0] + of(axis[1]) * v[1] + of(axis[2]) * v[2];
      };
      const Doubles corner[3] = {of(leaf.corner[0]) - m_center[0], of(leaf.corner[1]) - m_center[1],
                                 of(leaf.corner[2]) - m_center[2]};
      const Doubles height = dot(leaf.normal, corner);
      const Doubles squared_disk = m_radius * m_radius - height * height;
      if(mask(squared_disk > Doubles{}) == 0)
        continue;
      const Doubles x = dot(leaf.x_axis, corner), y = dot(leaf.y_axis, corner);
      add(of(leaf.factor) * (m_radius > m_tree.longest_edge
                                 ? doubled_area<Along_the_edges>(leaf, i, x, y, squared_disk)
                                 : doubled_area<Between_the_ends>(leaf, i, x, y, squared_disk)),
          i);
    }
  }

  /// \tparam Way how the boundary is followed: what suits the size of the ball
  /// \param x, y the first corners relative to the centres of the disks, in the planes of the triangles
  template <class Way>
  static Doubles doubled_area(const Triangle_block& leaf, int i, Doubles x, Doubles y,
                              Doubles squared_disk)
  {
    const auto of = [i](const Block& block) { return load(block.data() + i); };
    Edges<Doubles> edges;
    for(std::size_t e = 0; e < 3; ++e) {
      edges.length[e] = of(leaf.length[e]);
      edges.cosine[e] = of(leaf.cosine[e]);
      edges.sine[e] = of(leaf.sine[e]);
    }
    // The first edge points along the axis, the second one begins at its end, the third one ends where
    // it begins.
    const Doubles second_x = x + edges.length[0];
    const Doubles along[2] = {of(leaf.along[0]), of(leaf.along[1])};
    const Doubles across[2] = {of(leaf.across[0]), of(leaf.across[1])};
    Seen_edges<Doubles> seen;
    seen.start[0] = x;
    seen.end[0] = second_x;
    seen.height[0] = -y;
    seen.start[1] = second_x * along[0] + y * across[0];
    seen.end[1] = seen.start[1] + edges.length[1];
    seen.height[1] = second_x * across[0] - y * along[0];
    seen.end[2] = x * along[1] + y * across[1];
    seen.start[2] = seen.end[2] - edges.length[2];
    seen.height[2] = x * across[1] - y * along[1];
    return min(doubled_area_within_disk<Way>(edges, seen, squared_disk),
               edges.length[0] * edges.length[1] * edges.sine[0]);
  }

  const Exact_tree& m_tree;
  double m_center[3];
  double m_radius;
  double m_sums[block_size] = {};
};

inline double sum_of_tree(const Exact_tree& tree, const Point_3& center, double radius)
{
  Ball_in_tree ball(tree, center, radius);
  if(!tree.levels.empty())
    ball.add_node(tree.levels.size() - 1, 0);
  return ball.sum();
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
