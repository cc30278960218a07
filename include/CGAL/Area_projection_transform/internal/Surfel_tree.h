// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SURFEL_TREE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SURFEL_TREE_H

#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the first and second moments of a piece of surface, from which follow those of its projection.
///
/// A point `p` with normal `n` is projected to `p + d n`. The mean of the projections is
/// `mean position + d · mean normal`, and their covariance is `var(p) + 2 d cov(p, n) + d² var(n)`
/// (with the symmetric part of `cov(p, n)`), for every `d` and either side.
struct Surfel_moments
{
  double area = 0;
  Point_3 position = Point_3(0, 0, 0);
  Vector_3 normal = Vector_3(0, 0, 0); ///< the mean of unit vectors: shorter where they differ
  Covariance_3 of_positions, mixed, of_normals;

  void add(const Vector_3& position_difference, const Vector_3& normal_difference, double weight)
  {
    of_positions.add(position_difference, position_difference, weight);
    mixed.add(position_difference, normal_difference, weight);
    of_normals.add(normal_difference, normal_difference, weight);
  }
};

inline Surfel_moments combine(const Surfel_moments& a, const Surfel_moments& b)
{
  Surfel_moments sum;
  sum.area = a.area + b.area;
  const double t = sum.area > 0 ? b.area / sum.area : 0.5, s = 1 - t;
  const Vector_3 between = b.position - a.position, turn = b.normal - a.normal;
  sum.position = a.position + t * between;
  sum.normal = a.normal + t * turn;
  sum.of_positions = s * a.of_positions + t * b.of_positions;
  sum.mixed = s * a.mixed + t * b.mixed;
  sum.of_normals = s * a.of_normals + t * b.of_normals;
  sum.add(between, turn, s * t);
  return sum;
}

inline Surfel_moments moments_of_element(const Surfels& surfels, std::size_t i)
{
  Surfel_moments moments;
  moments.area = surfels.areas[i];
  moments.position = surfels.positions[i];
  moments.normal = surfels.normals[i];
  return moments;
}

/// the normals of a triangle at its corners.
inline std::array<Vector_3, 3> corner_normals(const Triangle_surface& surface, std::size_t t)
{
  std::array<Vector_3, 3> normals;
  for(int i = 0; i < 3; ++i)
    normals[i] = surface.has_interpolated_normals()
                     ? surface.vertex_normals[surface.triangles[t][i]]
                     : surface.normals[t];
  return normals;
}

inline Surfel_moments moments_of_element(const Triangle_surface& surface, std::size_t t)
{
  const std::array<Vector_3, 3> normals = corner_normals(surface, t);
  Surfel_moments moments;
  moments.area = surface.areas[t];
  moments.position =
      CGAL::centroid(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
  moments.normal = surface.has_interpolated_normals() ? (normals[0] + normals[1] + normals[2]) / 3
                                                      : surface.normals[t];
  // The moments of linear functions over a triangle, from their values at the corners.
  for(int i = 0; i < 3; ++i)
    moments.add(surface.corner(t, i) - moments.position, normals[i] - moments.normal, 1. / 12);
  return moments;
}

/// a surfel cannot be divided.
template <class Sink>
void subdivide_element(const Surfels& surfels, std::size_t i, double distance, double, Sink& sink)
{
  sink.push_back(surfels.positions[i] + distance * surfels.normals[i], surfels.areas[i],
                 Covariance_3());
}

/// \brief cuts a triangle into pieces of about `spacing` by `spacing` and projects them.
///
/// Where normals are interpolated, the covariance of a piece is that of a flat one between the projected
/// corners; its mean is projected along the normal there.
template <class Sink>
void subdivide_element(const Triangle_surface& surface, std::size_t t, double distance,
                       double spacing, Sink& sink)
{
  const std::array<Vector_3, 3> normals = corner_normals(surface, t);
  std::array<Vector_3, 3> corners, projected;
  for(int i = 0; i < 3; ++i) {
    corners[i] = surface.corner(t, i) - CGAL::ORIGIN;
    projected[i] = corners[i] + distance * normals[i];
  }
  const auto mix = [](const std::array<double, 3>& weights, const std::array<Vector_3, 3>& of) {
    return weights[0] * of[0] + weights[1] * of[1] + weights[2] * of[2];
  };
  const auto sample = [&](const Triangle_piece& piece) {
    const std::array<double, 3> weights = piece.centroid();
    const Vector_3 normal =
        surface.has_interpolated_normals() ? normalized(mix(weights, normals)) : normals[0];
    const Vector_3 mean = mix(weights, projected);
    Covariance_3 covariance;
    for(const auto& corner : piece.corners) {
      const Vector_3 difference = mix(corner, projected) - mean;
      covariance.add(difference, difference, 1. / 12);
    }
    sink.push_back(CGAL::ORIGIN + (mix(weights, corners) + distance * normal),
                   piece.fraction * surface.areas[t], covariance);
  };
  for_each_piece(whole_triangle(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)),
                 largest_variance(spacing), sample);
}

/// an order in which only elements that are equal, and so interchangeable, have no fixed place.
inline bool precedes(const Surfel_moments& a, const Surfel_moments& b)
{
  const auto key = [](const Surfel_moments& m) {
    const Covariance_3 &p = m.of_positions, &pn = m.mixed, &n = m.of_normals;
    return std::array<double, 25>{
        m.position.x(), m.position.y(), m.position.z(), m.normal.x(), m.normal.y(),
        m.normal.z(),   m.area,         p.xx,           p.xy,         p.xz,
        p.yy,           p.yz,           p.zz,           pn.xx,        pn.xy,
        pn.xz,          pn.yy,          pn.yz,          pn.zz,        n.xx,
        n.xy,           n.xz,           n.yy,           n.yz,         n.zz};
  };
  return key(a) < key(b);
}

/// \brief a hierarchy of the elements of a surface, which answers with as few projected surfels as
/// an accuracy asks for.
///
/// What counts for the transform is where area lands. Pieces of surface whose projection is small
/// are represented by the mean and the covariance of their projections; others are divided. So the cost
/// depends on the size of the parallel surface and on the spacing, not on how finely the surface was
/// meshed: a sphere projected onto its centre is one point.
///
/// The tree depends on the elements but not on their order.
template <class Source>
class Surfel_tree
{
public:
  explicit Surfel_tree(const Source& source)
  {
    if(source.empty())
      return;
    const Bbox_3 box = source.bbox();
    for(int axis = 0; axis < 3; ++axis)
      m_unit = std::max(m_unit, box.max(axis) - box.min(axis));
    if(!(m_unit > 0))
      m_unit = 1;
    std::vector<Placed> elements;
    elements.reserve(source.size());
    for(std::size_t i = 0; i < source.size(); ++i)
      elements.push_back(placed(source, box, i));
    m_nodes.reserve(2 * source.size() - 1);
    build(source, elements.data(), elements.data() + elements.size());
  }

  /// \brief a tree of the shape of another, over a surface with the same elements that may have changed
  /// their places, normals and areas. It is the better the less they did.
  Surfel_tree(const Surfel_tree& shape, const Source& changed)
      : m_unit(shape.m_unit), m_nodes(shape.m_nodes)
  {
    if(!m_nodes.empty())
      refit(changed, 0);
  }

  double area() const { return m_nodes.empty() ? 0 : m_nodes.front().area; }

  /// \brief hands the projection at signed `distance` to `sink(const Projected_surfels&)`, batch by
  /// batch; no surfel stands for more than a square of side `spacing` does, by its variance.
  template <class BatchSink>
  void project(const Source& source, double distance, double spacing, BatchSink&& batch_sink) const
  {
    Batcher<Projected_surfels, BatchSink> batcher(batch_sink);
    const float d = float(distance / m_unit);
    const double largest = largest_variance(spacing / m_unit);
    for(std::size_t i = 0; i < m_nodes.size();) {
      const Node& node = m_nodes[i];
      if(!(node.area > 0)) {
        i = node.next;
      } else if(node.projected(Node::trace, d) <= largest) {
        batcher.push_back(node.position + distance * node.normal, node.area,
                          (m_unit * m_unit) * node.projected_covariance(d));
        i = node.next;
      } else {
        if(node.is_element())
          subdivide_element(source, node.element, distance, spacing, batcher);
        ++i;
      }
    }
    batcher.flush();
  }

private:
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  /// \brief in preorder: children follow their parent, and `next` is the node after the whole subtree.
  ///
  /// The second moments are floats, with `m_unit` as unit of length so that they do not underflow.
  struct Node
  {
    enum Moment { trace, xx, xy, xz, yy, yz };
    using Moments = std::array<float, 6>;

    Point_3 position;
    Vector_3 normal;
    double area = 0;
    Moments of_positions, mixed, of_normals;
    std::uint32_t next = 0;
    std::uint32_t element = none;

    bool is_element() const { return element != none; }

    float projected(Moment m, float d) const
    {
      return of_positions[m] + d * (2 * mixed[m] + d * of_normals[m]);
    }

    Covariance_3 projected_covariance(float d) const
    {
      const double a = projected(xx, d), b = projected(yy, d);
      return {a, projected(xy, d), projected(xz, d),
              b, projected(yz, d), projected(trace, d) - a - b};
    }
  };

  static typename Node::Moments rounded(const Covariance_3& c, double factor)
  {
    return {float(factor * c.trace()), float(factor * c.xx), float(factor * c.xy),
            float(factor * c.xz),      float(factor * c.yy), float(factor * c.yz)};
  }

  /// \brief an element as the tree divides them: by place and by direction.
  ///
  /// Pieces that are close and face the same way stay close when they are projected. How much a normal
  /// counts against a position depends on the distance; a tenth of the extent suits common radii.
  struct Placed
  {
    std::array<float, 6> key;
    std::uint32_t element;
  };

  static constexpr double reach_of_normals = 0.1;

  Placed placed(const Source& source, const Bbox_3& box, std::size_t i) const
  {
    const Surfel_moments moments = moments_of_element(source, i);
    Placed result;
    for(int axis = 0; axis < 3; ++axis) {
      result.key[axis] = float((moments.position[axis] - box.min(axis)) / m_unit);
      result.key[3 + axis] = float(reach_of_normals * moments.normal[axis]);
    }
    result.element = std::uint32_t(i);
    return result;
  }

  /// halves the longest axis of the box around the keys; the order of the elements does not matter.
  static Placed* split(const Source& source, Placed* first, Placed* last)
  {
    std::array<float, 6> low = first->key, high = first->key;
    for(const Placed* e = first + 1; e != last; ++e)
      for(int axis = 0; axis < 6; ++axis) {
        low[axis] = std::min(low[axis], e->key[axis]);
        high[axis] = std::max(high[axis], e->key[axis]);
      }
    int longest = 0;
    for(int axis = 1; axis < 6; ++axis)
      if(high[axis] - low[axis] > high[longest] - low[longest])
        longest = axis;
    const float middle = low[longest] + 0.5f * (high[longest] - low[longest]);
    Placed* const split =
        std::partition(first, last, [=](const Placed& e) { return e.key[longest] <= middle; });
    if(split != last)
      return split;
    // All keys are equal.
    std::sort(first, last, [&source](const Placed& a, const Placed& b) {
      return precedes(moments_of_element(source, a.element), moments_of_element(source, b.element));
    });
    return first + (last - first) / 2;
  }

  Surfel_moments build(const Source& source, Placed* first, Placed* last)
  {
    const std::size_t index = m_nodes.size();
    m_nodes.emplace_back();
    Surfel_moments moments;
    if(last - first == 1) {
      m_nodes[index].element = first->element;
      moments = moments_of_element(source, first->element);
    } else {
      Placed* const middle = split(source, first, last);
      moments = build(source, first, middle);
      moments = combine(moments, build(source, middle, last));
    }
    m_nodes[index].next = std::uint32_t(m_nodes.size());
    store(moments, m_nodes[index]);
    return moments;
  }

  Surfel_moments refit(const Source& source, std::size_t index)
  {
    const Node& node = m_nodes[index];
    const Surfel_moments moments =
        node.is_element()
            ? moments_of_element(source, node.element)
            : combine(refit(source, index + 1), refit(source, m_nodes[index + 1].next));
    store(moments, m_nodes[index]);
    return moments;
  }

  void store(const Surfel_moments& moments, Node& node) const
  {
    node.position = moments.position;
    node.normal = moments.normal;
    node.area = moments.area;
    node.of_positions = rounded(moments.of_positions, 1 / (m_unit * m_unit));
    node.mixed = rounded(moments.mixed, 1 / m_unit);
    node.of_normals = rounded(moments.of_normals, 1);
  }

  double m_unit = 0;
  std::vector<Node> m_nodes;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SURFEL_TREE_H
