// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FEATURE_SURFACE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FEATURE_SURFACE_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a surface as detectors of shapes want it: patches that vote, and points to which shapes are fitted.
///
/// Two samplings on purpose. What votes is area, so patches cover the faces. What is fitted must lie on the
/// surface that the mesh stands for: those are its vertices, since the inner points of faces lie on the
/// hollow side of a round surface.
class Feature_surface
{
public:
  using Vector = Eigen::Vector3d;

  /// a piece of the surface that votes.
  struct Patch
  {
    Vector position;
    Vector area_vector; ///< the area times the unit normal
    Vector normal;      ///< averaged over the neighbours; tells the two sides of thin walls apart
    double area;
  };

  /// a point that shapes are fitted to.
  struct Points
  {
    std::vector<Vector> positions;
    std::vector<Vector> normals;
    std::vector<double> spacings; ///< the mean length of the edges
    /// the first ones are those of the input; others lie between them, and share their errors.
    std::size_t number_of_independent = 0;
  };

  Feature_surface(const Triangle_surface& surface, Side side);
  Feature_surface(const Surfels& surfels, Side side);

  const Points& points() const { return m_points; }

  /// the patches as they are: the faces, or the points of a point set.
  const std::vector<Patch>& patches() const { return m_patches; }

  /// calls `function(patch)` for pieces that spread no more than a square of side `spacing`.
  template <class Function>
  void for_each_patch(double spacing, Function&& function) const;

  /// the same for the faces that may have something within `distance` of a place.
  template <class Function>
  void for_each_patch_near(const Vector& place, double distance, double spacing,
                           Function&& function) const;

  /// \brief about how many pieces `for_each_patch()` makes.
  ///
  /// A needle that is halved along its longest edge, again and again, leaves three pieces for each half of its length.
  double number_of_patches(double spacing) const
  {
    constexpr double needle = 1.585; // log2 of 3
    double number = double(m_patches.size());
    for(std::size_t t = 0; t < m_corners.size(); ++t) {
      const double lengths = std::min(longest_edge(t) / spacing, double(most_pieces_along));
      if(lengths > 1)
        number +=
            std::min(m_patches[t].area / (spacing * spacing) + lengths, std::pow(lengths, 2.)) +
            0.1 * std::pow(lengths, needle);
    }
    return number;
  }

  /// the length below which there is nothing to see: few edges are shorter.
  double resolution() const { return m_resolution; }
  double area() const { return m_area; }
  /// the sides of the bounding box.
  const Vector& extent() const { return m_extent; }

private:
  /// pieces are no shorter than that part of a face, however long it is.
  static constexpr int most_pieces_along = 500;

  double longest_edge(std::size_t t) const
  {
    const Vector &a = m_corners[t][0], &b = m_corners[t][1], &c = m_corners[t][2];
    return std::sqrt(
        std::max({(b - c).squaredNorm(), (c - a).squaredNorm(), (a - b).squaredNorm()}));
  }

  template <class Function>
  void cut_patch(std::size_t index, double variance, Function& function) const;
  void add_points_on_creases(const Triangle_surface& surface,
                             const std::vector<std::uint32_t>& joined, double sign);
  void finish();

  Points m_points;
  std::vector<Patch> m_patches;
  std::vector<std::array<Vector, 3>> m_corners; ///< of the patches that are triangles
  double m_resolution = 0, m_area = 0;
  Vector m_extent = Vector::Zero();
};

inline Feature_surface::Feature_surface(const Triangle_surface& surface, Side side)
{
  const double sign = side == Side::INSIDE ? 1 : -1;
  const std::vector<std::uint32_t> joined = joined_points(surface);
  std::vector<Vector> normals(surface.points.size(), Vector::Zero());
  std::vector<double> lengths(surface.points.size(), 0);
  std::vector<std::uint32_t> numbers(surface.points.size(), 0);
  m_patches.resize(surface.size());
  m_corners.resize(surface.size());
  std::vector<double> shortest(surface.size());
  for(std::size_t t = 0; t < surface.size(); ++t) {
    std::array<Vector, 3>& corners = m_corners[t];
    for(int i = 0; i < 3; ++i)
      corners[i] = to_eigen(surface.corner(t, i));
    const Vector area_vector = sign * surface.areas[t] * to_eigen(surface.normals[t]);
    m_patches[t] = {(corners[0] + corners[1] + corners[2]) / 3, area_vector, Vector::Zero(),
                    surface.areas[t]};
    shortest[t] = std::numeric_limits<double>::max();
    for(int i = 0; i < 3; ++i) {
      const double length = (corners[(i + 1) % 3] - corners[i]).norm();
      shortest[t] = std::min(shortest[t], length);
      const std::uint32_t a = joined[surface.triangles[t][i]];
      const std::uint32_t b = joined[surface.triangles[t][(i + 1) % 3]];
      normals[a] += area_vector;
      lengths[a] += length;
      lengths[b] += length;
      numbers[a] += 1;
      numbers[b] += 1;
    }
  }
  for(std::size_t v = 0; v < normals.size(); ++v)
    if(numbers[v] > 0) {
      m_points.positions.push_back(to_eigen(surface.points[v]));
      m_points.normals.push_back(normals[v].normalized());
      m_points.spacings.push_back(lengths[v] / numbers[v]);
    }
  for(std::size_t t = 0; t < surface.size(); ++t) {
    Vector sum = Vector::Zero();
    for(const std::uint32_t v : surface.triangles[t])
      sum += normals[joined[v]].normalized();
    m_patches[t].normal = sum.normalized();
  }
  m_points.number_of_independent = m_points.positions.size();
  add_points_on_creases(surface, joined, sign);
  if(!shortest.empty()) {
    const auto tenth = shortest.begin() + std::ptrdiff_t(shortest.size() / 10);
    std::nth_element(shortest.begin(), tenth, shortest.end());
    m_resolution = *tenth;
  }
  finish();
}

inline Feature_surface::Feature_surface(const Surfels& surfels, Side side)
{
  const double sign = side == Side::INSIDE ? 1 : -1;
  std::vector<double> spacings;
  for(std::size_t i = 0; i < surfels.size(); ++i) {
    const Vector position = to_eigen(surfels.positions[i]);
    const Vector normal = sign * to_eigen(surfels.normals[i]);
    const double area = surfels.areas[i];
    m_patches.push_back({position, area * normal, normal, area});
    m_points.positions.push_back(position);
    m_points.normals.push_back(normal);
    m_points.spacings.push_back(std::sqrt(area));
    spacings.push_back(std::sqrt(area));
  }
  m_points.number_of_independent = m_points.positions.size();
  if(!spacings.empty()) {
    const auto tenth = spacings.begin() + std::ptrdiff_t(spacings.size() / 10);
    std::nth_element(spacings.begin(), tenth, spacings.end());
    m_resolution = *tenth;
  }
  finish();
}

/// \brief adds points on long creases: the tubes of engineers have vertices at their ends only.
///
/// Of the two long edges of a thin triangle, the one along which the surface bends more lies on it, and the
/// other crosses a facet.
inline void Feature_surface::add_points_on_creases(const Triangle_surface& surface,
                                                   const std::vector<std::uint32_t>& joined,
                                                   double sign)
{
  constexpr double thin = 3;      // the length of an edge, in units of the height above it
  constexpr double spacing = 1.5; // of the points, in the same units
  constexpr double most_points = 200;

  struct Edge
  {
    std::uint32_t lower, higher;
    std::array<std::uint32_t, 2> faces;
    double length, height, bend;
  };
  std::vector<Edge> edges;
  std::vector<double> largest_bend(surface.size(), -1);
  Edges_by_vertex(surface, [&](std::uint32_t v) {
    return joined[v];
  }).all_edges([&](std::uint32_t lower, const auto* begin, const auto* end) {
    if(end - begin != 2)
      return true;
    const double length =
        std::sqrt(squared_distance(surface.points[lower], surface.points[begin->higher]));
    const std::uint32_t f = begin[0].face, g = begin[1].face;
    const double height = 2 * std::max(surface.areas[f], surface.areas[g]) / length;
    if(!(length > thin * height))
      return true;
    const double bend = 1 - surface.normals[f] * surface.normals[g];
    edges.push_back({lower, begin->higher, {f, g}, length, height, bend});
    for(const std::uint32_t face : {f, g})
      largest_bend[face] = std::max(largest_bend[face], bend);
    return true;
  });
  for(const Edge& edge : edges) {
    const auto [f, g] = edge.faces;
    if(!(edge.bend > 1e-6) || edge.bend < largest_bend[f] || edge.bend < largest_bend[g])
      continue;
    const double step = spacing * edge.height;
    const double number = std::min(std::ceil(edge.length / step), most_points);
    const Vector a = to_eigen(surface.points[edge.lower]);
    const Vector b = to_eigen(surface.points[edge.higher]);
    const Vector normal =
        sign * (to_eigen(surface.normals[f]) + to_eigen(surface.normals[g])).normalized();
    for(int i = 1; i < int(number); ++i) {
      m_points.positions.push_back(a + (i / number) * (b - a));
      m_points.normals.push_back(normal);
      m_points.spacings.push_back(edge.length / number);
    }
  }
}

inline void Feature_surface::finish()
{
  for(const Patch& patch : m_patches)
    m_area += patch.area;
  if(m_points.positions.empty())
    return;
  Vector low = m_points.positions.front(), high = low;
  for(const Vector& p : m_points.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  m_extent = high - low;
}

/// hands on a patch in pieces, if it is a triangle that varies more than that.
template <class Function>
void Feature_surface::cut_patch(std::size_t t, double variance, Function& function) const
{
  const Patch& patch = m_patches[t];
  if(m_corners.empty()) {
    function(patch);
    return;
  }
  const Vector &a = m_corners[t][0], &b = m_corners[t][1], &c = m_corners[t][2];
  const std::array<double, 3> opposite{(b - c).squaredNorm(), (c - a).squaredNorm(),
                                       (a - b).squaredNorm()};
  const double largest = std::max(variance, largest_variance(longest_edge(t) / most_pieces_along));
  if((opposite[0] + opposite[1] + opposite[2]) / 36 <= largest) {
    function(patch);
    return;
  }
  const auto sample = [&](const Triangle_piece& piece) {
    const std::array<double, 3> w = piece.centroid();
    function(Patch{w[0] * a + w[1] * b + w[2] * c, piece.fraction * patch.area_vector, patch.normal,
                   piece.fraction * patch.area});
  };
  for_each_piece({{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, opposite, 1}, largest, sample);
}

template <class Function>
void Feature_surface::for_each_patch(double spacing, Function&& function) const
{
  for(std::size_t t = 0; t < m_patches.size(); ++t)
    cut_patch(t, largest_variance(spacing), function);
}

template <class Function>
void Feature_surface::for_each_patch_near(const Vector& place, double distance, double spacing,
                                          Function&& function) const
{
  for(std::size_t t = 0; t < m_patches.size(); ++t) {
    double reach = distance;
    if(!m_corners.empty())
      for(const Vector& corner : m_corners[t])
        reach = std::max(reach, distance + (corner - m_patches[t].position).norm());
    if((m_patches[t].position - place).squaredNorm() <= reach * reach)
      cut_patch(t, largest_variance(spacing), function);
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_FEATURE_SURFACE_H
