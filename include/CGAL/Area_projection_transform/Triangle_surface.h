// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_TRIANGLE_SURFACE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_TRIANGLE_SURFACE_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformInput
/// \brief triangles with a normal and an area each: the flat form of every mesh and soup.
///
/// The triangles need not be connected, closed, manifold or free of intersections. `areas` is what
/// each triangle votes with; it is its geometric area unless the user or a scale space says
/// otherwise. With `vertex_normals` the normal varies linearly over a triangle (Phong
/// interpolation) wherever the surface is sampled; `normals` is then the mean direction.
/// \cgalModels `SurfelSource`
struct Triangle_surface
{
  /// three indices of points, counter-clockwise when seen from outside.
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Point_3> points;             ///< the vertices, used or not
  std::vector<Triangle> triangles;         ///< by the indices of their points
  std::vector<Vector_3> normals;           ///< per triangle, unit vectors that point outward
  std::vector<double> areas;               ///< per triangle, not negative
  std::vector<std::uint32_t> sources;      ///< per triangle, the face of the input
  std::vector<Vector_3> vertex_normals;    ///< per point, unit vectors; empty: flat triangles
  std::size_t number_of_skipped_faces = 0; ///< faces of the input without extent or normal

  /// the number of triangles.
  std::size_t size() const { return triangles.size(); }
  /// whether there are none.
  bool empty() const { return triangles.empty(); }
  /// whether normals vary over a triangle: there are `vertex_normals`.
  bool has_interpolated_normals() const { return !vertex_normals.empty(); }

  /// the corner `i`, from 0 to 2, of a triangle.
  const Point_3& corner(std::size_t triangle, int i) const
  {
    return points[triangles[triangle][i]];
  }

  /// the sum of the areas with which the triangles vote.
  double total_area() const { return std::accumulate(areas.begin(), areas.end(), 0.); }

  /// the bounding box of the triangles; points that no triangle uses do not count.
  Bbox_3 bbox() const
  {
    Bbox_3 box;
    for(const Triangle& triangle : triangles)
      for(std::uint32_t v : triangle)
        box += points[v].bbox();
    return box;
  }

  /// \brief samples the triangles and hands the surfels to `sink(const Surfels&)`, batch by batch.
  ///
  /// Each triangle is cut into pieces that spread no more than a square of side `spacing`, at least
  /// one, and each piece is represented by its centroid. The areas of the surfels of a triangle sum to its area.
  /// The samples depend on the triangle and on `spacing` only, not on other triangles or batches.
  /// \throw std::invalid_argument if `spacing` is not positive.
  template <class BatchSink>
  void for_each_batch(double spacing, BatchSink&& sink) const;

  /// calls `surfel(position, normal, area)` for each sample of a triangle.
  template <class SurfelSink>
  void for_each_surfel_of_triangle(std::size_t triangle, double spacing, SurfelSink&& surfel) const;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// collects elements and hands them on whenever a batch is full.
template <class Batch, class BatchSink>
class Batcher
{
public:
  explicit Batcher(BatchSink& sink) : m_sink(sink) { m_batch.reserve(capacity); }

  template <class... Element>
  void push_back(const Element&... element)
  {
    if(m_batch.size() == capacity)
      flush();
    m_batch.push_back(element...);
  }

  void flush()
  {
    if(!m_batch.empty())
      m_sink(std::as_const(m_batch));
    m_batch.clear();
  }

private:
  static constexpr std::size_t capacity = 4096; // stays in the second-level cache
  BatchSink& m_sink;
  Batch m_batch;
};

/// \brief the squared distance, in the mean, from the centroid of a square of side `spacing`: pieces of
/// surface that vary no more than this are represented by one point.
inline double largest_variance(double spacing)
{
  return spacing * spacing / 6;
}

/// a piece of a triangle: the barycentric coordinates of its corners in the triangle, the squared
/// lengths of the edges opposite to them, and its share of the area.
struct Triangle_piece
{
  std::array<std::array<double, 3>, 3> corners;
  std::array<double, 3> opposite;
  double fraction;

  /// the barycentric coordinates of the centroid.
  std::array<double, 3> centroid() const
  {
    std::array<double, 3> weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = (corners[0][i] + corners[1][i] + corners[2][i]) / 3;
    return weights;
  }
};

/// the whole of a triangle as a piece.
inline Triangle_piece whole_triangle(const Point_3& a, const Point_3& b, const Point_3& c)
{
  return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
          {squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)},
          1};
}

/// \brief calls `sample(piece)` for each of the pieces into which a piece is cut, until none varies more
/// than `largest_variance`.
///
/// The longest edge is halved each time, which keeps good pieces good and makes slivers better.
/// At most `depth` times: the last bit of a double is no place to cut.
template <class Sample>
void for_each_piece(const Triangle_piece& piece, double largest_variance, Sample& sample,
                    int depth = 48)
{
  const auto& opposite = piece.opposite;
  if((opposite[0] + opposite[1] + opposite[2]) / 36 <= largest_variance || depth == 0) {
    sample(piece);
    return;
  }
  const int i = int(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  std::array<double, 3> middle;
  for(int m = 0; m < 3; ++m)
    middle[m] = 0.5 * (piece.corners[j][m] + piece.corners[k][m]);
  const double median = std::max(0.5 * (opposite[j] + opposite[k]) - 0.25 * opposite[i], 0.);
  for_each_piece({{piece.corners[i], piece.corners[j], middle},
                  {0.25 * opposite[i], median, opposite[k]},
                  0.5 * piece.fraction},
                 largest_variance, sample, depth - 1);
  for_each_piece({{piece.corners[i], middle, piece.corners[k]},
                  {0.25 * opposite[i], opposite[j], median},
                  0.5 * piece.fraction},
                 largest_variance, sample, depth - 1);
}

inline Vector_3 normalized(const Vector_3& v)
{
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : v;
}

} // namespace internal
/// \endcond

template <class SurfelSink>
void Triangle_surface::for_each_surfel_of_triangle(std::size_t t, double spacing,
                                                   SurfelSink&& surfel) const
{
  const Triangle& triangle = triangles[t];
  const Point_3 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
  const auto sample = [&](const internal::Triangle_piece& piece) {
    const std::array<double, 3> weights = piece.centroid();
    const Point_3 position(weights[0] * a.x() + weights[1] * b.x() + weights[2] * c.x(),
                           weights[0] * a.y() + weights[1] * b.y() + weights[2] * c.y(),
                           weights[0] * a.z() + weights[1] * b.z() + weights[2] * c.z());
    const Vector_3 normal = has_interpolated_normals()
                                ? internal::normalized(weights[0] * vertex_normals[triangle[0]] +
                                                       weights[1] * vertex_normals[triangle[1]] +
                                                       weights[2] * vertex_normals[triangle[2]])
                                : normals[t];
    surfel(position, normal, piece.fraction * areas[t]);
  };
  internal::for_each_piece(internal::whole_triangle(a, b, c), internal::largest_variance(spacing),
                           sample);
}

template <class BatchSink>
void Triangle_surface::for_each_batch(double spacing, BatchSink&& sink) const
{
  internal::check_positive(spacing, "spacing");
  internal::Batcher<Surfels, BatchSink> batcher(sink);
  for(std::size_t t = 0; t < size(); ++t)
    for_each_surfel_of_triangle(t, spacing,
                                [&](const Point_3& position, const Vector_3& normal, double area) {
                                  batcher.push_back(position, normal, area, sources[t]);
                                });
  batcher.flush();
}

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns the samples of `source` at `spacing` in one piece.
/// \tparam Source a model of `SurfelSource`
/// \param source the surface
/// \param spacing the distance of samples, in the units of the surface, positive
template <class Source>
Surfels sample_surfels(const Source& source, double spacing)
{
  Surfels surfels;
  source.for_each_batch(spacing, [&surfels](const Surfels& batch) { surfels.append(batch); });
  return surfels;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_TRIANGLE_SURFACE_H
