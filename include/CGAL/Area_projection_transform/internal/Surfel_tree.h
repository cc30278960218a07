// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SURFEL_TREE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SURFEL_TREE_H

#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/morton_code.h>

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the first moments of a piece of surface, and the second moments that tell how large the
/// piece is once it has been projected.
///
/// A point `p` with normal `n` is projected to `p + d n`. The mean of the projections is
/// `mean position + d · mean normal`, and their mean squared distance from it is
/// `var(p) + 2 d cov(p, n) + d² var(n)`: both follow from a few sums, for every `d` and either side.
struct Surfel_moments
{
  double area = 0;
  Point_3 position = Point_3(0, 0, 0);
  Vector_3 normal = Vector_3(0, 0, 0); ///< the mean of unit vectors: shorter where they differ
  float position_variance = 0;
  float covariance = 0;
  float normal_variance = 0;

  double projected_variance(double d) const
  {
    return position_variance + d * (2. * covariance + d * normal_variance);
  }
};

/// an order in which only elements that are equal, and so interchangeable, have no fixed place.
inline bool precedes(const Surfel_moments& a, const Surfel_moments& b)
{
  const auto key = [](const Surfel_moments& m) {
    return std::make_tuple(m.position.x(), m.position.y(), m.position.z(), m.normal.x(),
                           m.normal.y(), m.normal.z(), m.area, m.position_variance, m.covariance,
                           m.normal_variance);
  };
  return key(a) < key(b);
}

inline Surfel_moments combine(const Surfel_moments& a, const Surfel_moments& b)
{
  Surfel_moments sum;
  sum.area = a.area + b.area;
  const double t = sum.area > 0 ? b.area / sum.area : 0.5, s = 1 - t;
  const Vector_3 between = b.position - a.position, turn = b.normal - a.normal;
  sum.position = a.position + t * between;
  sum.normal = a.normal + t * turn;
  const auto mix = [&](float of_a, float of_b, double of_means) {
    return float(s * of_a + t * of_b + s * t * of_means);
  };
  sum.position_variance = mix(a.position_variance, b.position_variance, between.squared_length());
  sum.covariance = mix(a.covariance, b.covariance, between * turn);
  sum.normal_variance = mix(a.normal_variance, b.normal_variance, turn.squared_length());
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

inline Surfel_moments moments_of_element(const Triangle_surface& surface, std::size_t t)
{
  const Point_3 &a = surface.corner(t, 0), &b = surface.corner(t, 1), &c = surface.corner(t, 2);
  Surfel_moments moments;
  moments.area = surface.areas[t];
  moments.position = CGAL::centroid(a, b, c);
  moments.normal = surface.normals[t];
  moments.position_variance =
      float(((b - a).squared_length() + (c - b).squared_length() + (a - c).squared_length()) / 36);
  if(surface.has_interpolated_normals()) {
    // The moments of linear functions over a triangle, from their values at the corners.
    const std::array<Vector_3, 3> n{surface.vertex_normals[surface.triangles[t][0]],
                                    surface.vertex_normals[surface.triangles[t][1]],
                                    surface.vertex_normals[surface.triangles[t][2]]};
    moments.normal = (n[0] + n[1] + n[2]) / 3;
    double normal_variance = 0, covariance = 0;
    for(int i = 0; i < 3; ++i) {
      normal_variance += (n[i] - moments.normal).squared_length() / 12;
      covariance += (surface.corner(t, i) - moments.position) * (n[i] - moments.normal) / 12;
    }
    moments.normal_variance = float(normal_variance);
    moments.covariance = float(covariance);
  }
  return moments;
}

/// a surfel cannot be divided.
template <class Sink>
void subdivide_element(const Surfels& surfels, std::size_t i, double distance, double, Sink& sink)
{
  sink.push_back(surfels.positions[i] + distance * surfels.normals[i], surfels.areas[i]);
}

/// cuts a triangle into pieces of about `spacing` by `spacing` on its parallel surface.
template <class Sink>
void subdivide_element(const Triangle_surface& surface, std::size_t t, double distance,
                       double spacing, Sink& sink)
{
  surface.for_each_surfel_of_triangle(
      t, spacing, [&](const Point_3& position, const Vector_3& normal, double area) {
        sink.push_back(position + distance * normal, area);
      });
}

/// \brief a hierarchy of the elements of a surface, which answers with as few projected surfels as
/// an accuracy asks for.
///
/// What counts for the transform is where area lands. Pieces of surface whose projection is small
/// are represented by one point, the mean of their projections; others are divided. So the cost
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
    std::vector<Surfel_moments> elements;
    elements.reserve(source.size());
    for(std::size_t i = 0; i < source.size(); ++i)
      elements.push_back(moments_of_element(source, i));
    const std::vector<Morton_code> codes = sorted_morton_codes(elements);
    m_nodes.reserve(2 * source.size() - 1);
    build(elements, codes, 0, codes.size());
  }

  double area() const { return m_nodes.empty() ? 0 : m_nodes.front().moments.area; }

  /// \brief hands the projection at signed `distance` to `sink(const Projected_surfels&)`, batch by
  /// batch; no surfel stands for more than a square of side `spacing` does, by its variance.
  template <class BatchSink>
  void project(const Source& source, double distance, double spacing, BatchSink&& batch_sink) const
  {
    Batcher<Projected_surfels, BatchSink> batcher(batch_sink);
    const double largest = largest_variance(spacing);
    for(std::size_t i = 0; i < m_nodes.size();) {
      const Node& node = m_nodes[i];
      if(node.moments.projected_variance(distance) <= largest) {
        batcher.push_back(node.moments.position + distance * node.moments.normal,
                          node.moments.area);
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

  /// in preorder: children follow their parent, and `next` is the node after the whole subtree.
  struct Node
  {
    Surfel_moments moments;
    std::uint32_t next = 0;
    std::uint32_t element = none;
    bool is_element() const { return element != none; }
  };

  void build(const std::vector<Surfel_moments>& elements, const std::vector<Morton_code>& codes,
             std::size_t first, std::size_t last)
  {
    const std::size_t index = m_nodes.size();
    m_nodes.emplace_back();
    if(last - first == 1) {
      m_nodes[index].element = codes[first].element;
      m_nodes[index].moments = elements[codes[first].element];
    } else {
      const std::size_t middle = split_of_morton_range(codes, first, last);
      build(elements, codes, first, middle);
      const std::size_t right = m_nodes.size();
      build(elements, codes, middle, last);
      m_nodes[index].moments = combine(m_nodes[index + 1].moments, m_nodes[right].moments);
    }
    m_nodes[index].next = std::uint32_t(m_nodes.size());
  }

  std::vector<Node> m_nodes;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SURFEL_TREE_H
