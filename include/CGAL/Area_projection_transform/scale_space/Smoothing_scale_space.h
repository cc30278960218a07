// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_SMOOTHING_SCALE_SPACE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_SMOOTHING_SCALE_SPACE_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Recent_values.h>
#include <CGAL/Area_projection_transform/internal/Surfel_tree.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformScaleSpace
/// \brief a surface that a smoother makes for each radius.
///
/// The surface at a radius is made when it is asked for first, and kept until some others have been
/// asked for: a few, because each takes as much memory as the original.
///
/// \tparam Smoother a model of `SurfaceSmoother`, such as `Averaged_normals` or `Mean_curvature_flow`
/// \cgalModels `SurfelScaleSpace`, and `TriangleScaleSpace` if the smoother makes a `Triangle_surface`
template <class Smoother>
class Smoothing_scale_space
{
public:
  /// the type of the surface, `Triangle_surface` or `Surfels`.
  using Source = typename Smoother::Source;

  /// \brief how many surfaces are kept if the constructor is not told: as many as threads may work at.
  static std::size_t default_number_kept()
  {
    return std::max<std::size_t>(2, std::thread::hardware_concurrency());
  }

  /// \param smoother makes the surfaces
  /// \param number_kept how many of them are kept; at least as many as threads use the scale space
  ///
  /// Complexity: `O(n log n)` for `n` elements; 360 bytes for each, and 350 for each in every surface
  /// that is kept.
  explicit Smoothing_scale_space(Smoother smoother, std::size_t number_kept = default_number_kept())
      : m_smoother(std::move(smoother))
      , m_tree(m_smoother.source())
      , m_surfaces(std::make_unique<internal::Recent_values<Seen_surface>>(
            std::max<std::size_t>(1, number_kept)))
  {}

  /// what makes the surfaces.
  const Smoother& smoother() const { return m_smoother; }

  /// the surface before smoothing.
  const Source& source() const { return m_smoother.source(); }

  /// the bounding box of the surface before smoothing.
  Bbox_3 bbox() const { return source().bbox(); }

  /// the total area that votes at `radius`.
  double area(double radius) const { return seen_at(radius)->tree.area(); }

  /// \brief hands the parallel surface at `radius` to `sink(const Projected_surfels&)`, as
  /// `Constant_scale_space::project()` does.
  /// \param radius the distance of projection, positive, in the units of the surface
  /// \param side the side on which it is projected
  /// \param spacing the distance of the points, positive, in the same units
  /// \param sink receives them
  /// \throw std::invalid_argument if `radius` or `spacing` is not positive; and as the smoother does.
  template <class BatchSink>
  void project(double radius, Side side, double spacing, BatchSink&& sink) const
  {
    internal::check_positive(spacing, "spacing");
    const auto seen = seen_at(radius);
    seen->tree.project(seen->surface, internal::signed_distance(side, radius), spacing, sink);
  }

  /// the triangles of the surface as seen at `radius`, for exact evaluation.
  std::shared_ptr<const Triangle_surface> triangles(double radius) const
  {
    static_assert(std::is_same_v<Source, Triangle_surface>,
                  "exact evaluation needs triangles; a point set has none");
    const auto seen = seen_at(radius);
    return {seen, &seen->surface};
  }

private:
  /// \cond SKIP_IN_MANUAL
  struct Seen_surface
  {
    Seen_surface(Source smoothed, const internal::Surfel_tree<Source>& original)
        : surface(std::move(smoothed)), tree(original, surface)
    {}

    Source surface;
    internal::Surfel_tree<Source> tree;
  };

  std::shared_ptr<const Seen_surface> seen_at(double radius) const
  {
    internal::check_positive(radius, "radius");
    return m_surfaces->get(radius, [&] { return Seen_surface(m_smoother(radius), m_tree); });
  }

  Smoother m_smoother;
  internal::Surfel_tree<Source> m_tree; // of the original; those of the others have its shape
  std::unique_ptr<internal::Recent_values<Seen_surface>> m_surfaces;
  /// \endcond
};

template <class Smoother>
Smoothing_scale_space(Smoother) -> Smoothing_scale_space<Smoother>;
template <class Smoother>
Smoothing_scale_space(Smoother, std::size_t) -> Smoothing_scale_space<Smoother>;

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_SMOOTHING_SCALE_SPACE_H
