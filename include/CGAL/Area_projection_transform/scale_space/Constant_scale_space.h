// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_CONSTANT_SCALE_SPACE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_CONSTANT_SCALE_SPACE_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/Surfel_tree.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformScaleSpace
/// \brief the surface as it is, at every radius.
/// \tparam Source `Triangle_surface` or `Surfels`
/// \cgalModels `SurfelScaleSpace`, and `TriangleScaleSpace` if `Source` is `Triangle_surface`
template <class Source>
class Constant_scale_space
{
public:
  /// Complexity: `O(n log n)` for `n` elements; 360 bytes for each triangle, 400 while it builds.
  /// \param source the surface
  explicit Constant_scale_space(Source source)
      : m_source(std::make_shared<const Source>(std::move(source))), m_tree(*m_source)
  {}

  /// the surface.
  const Source& source() const { return *m_source; }

  /// the total area of the surface as seen at `radius`.
  double area(double /* radius */) const { return m_tree.area(); }

  /// the bounding box of the surface.
  Bbox_3 bbox() const { return m_source->bbox(); }

  /// \brief hands the parallel surface at `radius`, as points about `spacing` apart, to
  /// `sink(const Projected_surfels&)`, batch by batch.
  ///
  /// Pieces of surface that land close together are merged, large triangles are divided; of each piece
  /// the mean and the covariance are told. The areas sum to the area of the surface. May be called
  /// concurrently.
  ///
  /// \param radius the distance of projection, in the units of the surface
  /// \param side the side on which it is projected
  /// \param spacing the distance of the points, positive, in the same units
  /// \param sink receives them
  /// \throw std::invalid_argument if `spacing` is not positive.
  ///
  /// Complexity: linear in the number of points handed over.
  template <class BatchSink>
  void project(double radius, Side side, double spacing, BatchSink&& sink) const
  {
    internal::check_positive(spacing, "spacing");
    m_tree.project(*m_source, internal::signed_distance(side, radius), spacing, sink);
  }

  /// the triangles of the surface as seen at `radius`, for exact evaluation.
  std::shared_ptr<const Triangle_surface> triangles(double /* radius */) const
  {
    static_assert(std::is_same_v<Source, Triangle_surface>,
                  "exact evaluation needs triangles; a point set has none");
    return m_source;
  }

private:
  std::shared_ptr<const Source> m_source;
  internal::Surfel_tree<Source> m_tree;
};

template <class Source>
Constant_scale_space(Source) -> Constant_scale_space<Source>;

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_CONSTANT_SCALE_SPACE_H
