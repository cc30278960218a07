// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_GRID_PROJECTOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_GRID_PROJECTOR_H

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/internal/Fixed_point.h>
#include <CGAL/Area_projection_transform/internal/Projected_triangles.h>
#include <CGAL/Area_projection_transform/internal/Run_accumulator.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the exact transform of a triangulated surface on a grid.
///
/// A projected triangle counts fully in the voxels whose balls hold it, and with the area of its
/// intersection, in closed form, in those whose rim it may meet. About ten times the work of
/// `Grid_projector`, for an error of rounding only (areas are integers of 30 bits).
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
      : m_region(region)
      , m_kernel(std::move(kernel))
      , m_accumulator(region, internal::Run_accumulator::rows_of_group)
  {
    internal::check_kernel(m_kernel);
  }

  Exact_grid_projector(const Row_spans&& region, std::vector<Nested_ball> = {}) = delete;

  /// \brief computes the transform at one scale.
  /// \pre the rows of the scale before have all been taken
  /// \return the area of the triangles whose projected centroids fall outside of the grid
  /// \tparam ScaleSpace a model of `TriangleScaleSpace`
  /// \tparam Cancelled a nullary predicate; once it returns `true`, the rest of the surface is left out
  template <class ScaleSpace, class Cancelled>
  double project(const ScaleSpace& surface, const Scale& scale, Side side, Cancelled&& cancelled)
  {
    const Triangle_surface& triangles = surface.triangles(scale.radius);
    const internal::Fixed_point fixed(surface.area(scale.radius));
    m_quantum = fixed.quantum();
    double area_outside = 0;
    const auto projected =
        internal::project_triangles(triangles, internal::signed_distance(side, scale.radius));
    for(std::size_t t = 0; t < projected.size() && (t % 64 != 0 || !cancelled()); ++t) {
      for(const Nested_ball& ball : m_kernel)
        add(projected[t], scale.sigma * ball.relative_radius, ball.weight, fixed);
      if(!grid_holds(projected[t].centroid()))
        area_outside += projected[t].voting_area();
    }
    return area_outside;
  }

  /// writes the values (areas) of the hull of a row to `out`, and clears the row.
  void take_row(std::size_t row, float* out) { m_accumulator.take_row(row, m_quantum, out); }

private:
  bool grid_holds(const Point_3& p) const
  {
    const Vector_3 c = m_region.grid().lattice_coordinates(p);
    for(int axis = 0; axis < 3; ++axis)
      if(!(c[axis] >= -0.5 && c[axis] <= m_region.grid().size()[axis] - 0.5))
        return false;
    return true;
  }

  /// the voxels of a row within the root of `squared_half` (in voxels) of the place `x`.
  static Row_spans::Run chord(double x, double squared_half, const Row_spans::Hull& hull)
  {
    if(squared_half < 0)
      return {hull.last, hull.last};
    const double half = std::sqrt(squared_half);
    const double first = std::clamp(std::ceil(x - half), double(hull.first), double(hull.last));
    const double last = std::clamp(std::floor(x + half) + 1, first, double(hull.last));
    return {std::int32_t(first), std::int32_t(last)};
  }

  void add(const internal::Projected_triangle& triangle, double sigma, double weight,
           const internal::Fixed_point& fixed)
  {
    const Grid_3& grid = m_region.grid();
    const Vector_3 center = grid.lattice_coordinates(triangle.centroid());
    const double size = triangle.circumscribed_radius();
    const double outer = (sigma + size) / grid.spacing();
    const double inner = (sigma - size) / grid.spacing();
    const auto range = [&](int axis) {
      const double first = std::max(std::ceil(center[axis] - outer), 0.);
      const double last =
          std::clamp(std::floor(center[axis] + outer) + 1, 0., double(grid.size()[axis]));
      return std::make_pair(int(std::min(first, last)), int(last));
    };
    const auto [first_z, last_z] = range(2);
    const auto [first_y, last_y] = range(1);
    for(int k = first_z; k < last_z; ++k)
      for(int j = first_y; j < last_y; ++j) {
        const double squared =
            (j - center.y()) * (j - center.y()) + (k - center.z()) * (k - center.z());
        const Row_spans::Hull& hull = m_region.hull(grid.row(j, k));
        const Row_spans::Run reached = chord(center.x(), outer * outer - squared, hull);
        Row_spans::Run held{reached.last, reached.last};
        if(inner > 0 && inner * inner >= squared)
          held = chord(center.x(), inner * inner - squared, hull);

        const std::int32_t place = m_accumulator.place()[m_accumulator.padded_row(j, k)];
        m_accumulator.add(place + held.first, place + held.last,
                          fixed.dithered(weight * triangle.voting_area(), triangle.centroid()));
        const auto evaluate = [&](int first, int last) {
          for(int i = first; i < last; ++i) {
            const double area = triangle.area_within(grid.point(i, j, k), sigma);
            if(area > 0)
              m_accumulator.add(place + i, place + i + 1,
                                fixed.dithered(weight * area, triangle.centroid()));
          }
        };
        evaluate(reached.first, std::min(held.first, reached.last));
        evaluate(std::max(held.last, reached.first), reached.last);
      }
  }

  const Row_spans& m_region;
  std::vector<Nested_ball> m_kernel;
  internal::Run_accumulator m_accumulator;
  double m_quantum = 0;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_EXACT_GRID_PROJECTOR_H
