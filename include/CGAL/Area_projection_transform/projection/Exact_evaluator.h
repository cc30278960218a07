// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_EVALUATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_EVALUATOR_H

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/internal/Projected_triangles.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the exact transform of a triangulated surface at arbitrary points, for one radius.
///
/// Each flat triangle, moved by `R`, contributes the area of its intersection with a disk, in closed
/// form. A tree of boxes skips triangles out of reach and adds whole subtrees that the ball holds.
/// The only errors are those of rounding. Queries are `const` and may run concurrently.
///
/// \cgalModels `ProjectionEvaluator`
class Exact_evaluator
{
public:
  /// \tparam ScaleSpace a model of `TriangleScaleSpace`
  /// \param surface is read by the constructor only
  /// \throw std::invalid_argument if the radius is not positive or normals are interpolated.
  ///
  /// Complexity: `O(n log n)` for `n` triangles; 210 bytes for each, 370 while it builds.
  template <class ScaleSpace>
  Exact_evaluator(const ScaleSpace& surface, double radius, Side side)
  {
    internal::check_positive(radius, "radius");
    m_triangles = internal::project_triangles(surface.triangles(radius),
                                              internal::signed_distance(side, radius));
    build();
  }

  /// \brief returns the area that is projected into the ball of radius `sigma` around `x`.
  ///
  /// Complexity: proportional to the number of triangles that meet the rim of the ball.
  template <class Point>
  double operator()(const Point& x, double sigma) const
  {
    return m_nodes.empty() ? 0. : area_within(0, internal::to_point(x), sigma);
  }

  /// the same for another kernel.
  template <class Point>
  double operator()(const Point& x, double sigma, const std::vector<Nested_ball>& kernel) const
  {
    double sum = 0;
    for(const Nested_ball& ball : kernel)
      sum += ball.weight * (*this)(x, sigma * ball.relative_radius);
    return sum;
  }

private:
  static constexpr std::size_t leaf_size = 4;

  /// the triangles `first`, …, `last - 1`; the left child follows its parent, the right one is at
  /// `right`, or 0 in a leaf.
  struct Node
  {
    Bbox_3 box;
    double area = 0;
    std::uint32_t first = 0, last = 0, right = 0;
  };

  void build()
  {
    if(m_triangles.empty())
      return;
    std::vector<std::uint32_t> order(m_triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    build_node(order, 0, order.size());
    std::vector<internal::Projected_triangle> sorted;
    sorted.reserve(order.size());
    for(std::uint32_t t : order)
      sorted.push_back(m_triangles[t]);
    m_triangles = std::move(sorted);
  }

  std::uint32_t build_node(std::vector<std::uint32_t>& order, std::size_t first, std::size_t last)
  {
    const std::uint32_t index = std::uint32_t(m_nodes.size());
    Node node;
    node.first = std::uint32_t(first);
    node.last = std::uint32_t(last);
    for(std::size_t i = first; i < last; ++i) {
      for(int corner = 0; corner < 3; ++corner)
        node.box += m_triangles[order[i]].corner(corner).bbox();
      node.area += m_triangles[order[i]].voting_area();
    }
    m_nodes.push_back(node);
    if(last - first > leaf_size) {
      int axis = 0;
      for(int other = 1; other < 3; ++other)
        if(node.box.max(other) - node.box.min(other) > node.box.max(axis) - node.box.min(axis))
          axis = other;
      const std::size_t middle = first + (last - first) / 2;
      const auto position = [&](std::uint32_t t) {
        const auto& triangle = m_triangles[t];
        return triangle.corner(0)[axis] + triangle.corner(1)[axis] + triangle.corner(2)[axis];
      };
      std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                       [&](std::uint32_t s, std::uint32_t t) { return position(s) < position(t); });
      build_node(order, first, middle);
      const std::uint32_t right = build_node(order, middle, last);
      m_nodes[index].right = right;
    }
    return index;
  }

  double area_within(std::uint32_t index, const Point_3& x, double sigma) const
  {
    const Node& node = m_nodes[index];
    double nearest = 0, farthest = 0;
    for(int axis = 0; axis < 3; ++axis) {
      const double below = node.box.min(axis) - x[axis], above = x[axis] - node.box.max(axis);
      const double gap = std::max({below, above, 0.});
      const double reach = std::max(-below, -above);
      nearest += gap * gap;
      farthest += reach * reach;
    }
    if(nearest >= sigma * sigma)
      return 0;
    if(farthest <= sigma * sigma)
      return node.area;
    if(node.right != 0)
      return area_within(index + 1, x, sigma) + area_within(node.right, x, sigma);
    double sum = 0;
    for(std::uint32_t t = node.first; t < node.last; ++t)
      sum += m_triangles[t].area_within(x, sigma);
    return sum;
  }

  std::vector<internal::Projected_triangle> m_triangles;
  std::vector<Node> m_nodes;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_EVALUATOR_H
