// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_GRID_PROJECTOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_GRID_PROJECTOR_H

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/internal/exact_grid.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the exact transform of a triangulated surface on a grid.
///
/// A projected triangle counts fully in the voxels whose balls hold it, and with the area of its
/// intersection, in closed form, in those whose rim it may meet: for fine meshes that takes about as long
/// as `Grid_projector` needs for its samples. The map errs by some 1e-6 of its root mean square: areas are
/// integers of 30 bits, and the parts of triangles are computed with floats (or doubles, where these
/// would not do): each errs by less than 1e-4 of its triangle.
///
/// The map has the same bits for any order of the triangles, any number of threads, and on every processor.
///
/// \cgalModels `GridProjector`
class Exact_grid_projector
{
public:
  /// \param region the voxels to compute; must outlive the projector
  /// \param kernel the nested balls of a model of `ProjectionKernel_3`
  /// \throw std::invalid_argument if a ball of the kernel is out of range.
  explicit Exact_grid_projector(const Row_spans& region,
                                std::vector<Nested_ball> kernel = Ball_kernel_3().nested_balls())
      : m_region(region), m_kernel(std::move(kernel)), m_accumulator(region)
  {
    internal::check_kernel(m_kernel);
  }

  Exact_grid_projector(const Row_spans&& region, std::vector<Nested_ball> = {}) = delete;

  /// \brief computes the transform at one scale.
  /// \param surface the surface
  /// \param scale the radius and `σ`, in the units of the surface
  /// \param side the side on which it is projected
  /// \param cancelled asked now and then whether to stop
  /// \pre the rows of the scale before have all been taken
  /// \return the area of the triangles whose projected centroids fall outside of the grid
  /// \tparam ScaleSpace a model of `TriangleScaleSpace`
  /// \tparam Cancelled a nullary predicate; once it returns `true`, the rest of the surface is left out
  template <class ScaleSpace, class Cancelled>
  double project(const ScaleSpace& surface, const Scale& scale, Side side, Cancelled&& cancelled)
  {
    const auto kept = surface.triangles(scale.radius);
    const Triangle_surface& triangles = *kept;
    internal::check_flat(triangles);
    const internal::Fixed_point fixed(surface.area(scale.radius));
    m_quantum = fixed.quantum();
    const double distance = internal::signed_distance(side, scale.radius);
    double area_outside = 0;
    std::vector<internal::Voting_triangle> batch;
    batch.reserve(size_of_batch);
    for(std::size_t t = 0; t < triangles.size() && !cancelled(); t += size_of_batch) {
      const std::size_t end = std::min(t + size_of_batch, triangles.size());
      area_outside += collect(triangles, t, end, distance, fixed, batch);
      for(const Nested_ball& ball : m_kernel)
        internal::add_to_grid(
            batch.data(), batch.data() + batch.size(),
            {scale.sigma * ball.relative_radius / m_region.grid().spacing(), ball.weight},
            m_accumulator.target());
    }
    return area_outside;
  }

  /// writes the values (areas) of the hull of a row to `out`, and clears the row.
  void take_row(std::size_t row, float* out) { m_accumulator.take_row(row, m_quantum, out); }

private:
  static constexpr std::size_t size_of_batch = 32;

  /// \brief makes `batch` hold the triangles `begin`, …, `end - 1`, in the coordinates of the lattice.
  /// \return the area of those whose centroids fall outside of the grid
  double collect(const Triangle_surface& triangles, std::size_t begin, std::size_t end,
                 double distance, const internal::Fixed_point& fixed,
                 std::vector<internal::Voting_triangle>& batch) const
  {
    double area_outside = 0;
    batch.clear();
    for(std::size_t t = begin; t < end; ++t) {
      batch.emplace_back(triangles, t, distance, m_region.grid(), fixed);
      if(!grid_holds(batch.back().shape.centroid()))
        area_outside += triangles.areas[t];
    }
    return area_outside;
  }

  /// whether the voxel nearest to a point, in the coordinates of the lattice, belongs to the grid.
  bool grid_holds(const Point_3& p) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(!(p[axis] >= -0.5 && p[axis] <= m_region.grid().size()[axis] - 0.5))
        return false;
    return true;
  }

  const Row_spans& m_region;
  std::vector<Nested_ball> m_kernel;
  internal::Exact_accumulator m_accumulator;
  double m_quantum = 0;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_GRID_PROJECTOR_H
