// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_GRID_PROJECTOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_GRID_PROJECTOR_H

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/internal/Ball_stencil.h>
#include <CGAL/Area_projection_transform/internal/Fixed_point.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <memory>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the default computation of the transform on a grid: every surfel, moved by `R`, adds its
/// area to the voxels whose centres lie within `σ` of it.
///
/// The position of the projected surfel between the voxels is kept, so the value at a voxel is the
/// sum that `Kd_tree_evaluator` finds at its centre for the same surfels. A surfel costs two
/// additions for each row of voxels that its ball meets. Areas are summed as integers: the map has
/// the same bits for any order of the surfels and any number of threads.
///
/// \cgalModels `GridProjector`
class Grid_projector
{
public:
  /// \param region the voxels to compute; must outlive the projector
  /// \param kernel the nested balls of a model of `ProjectionKernel_3`
  /// \param sampling_ratio the spacing of the surfels, in units of `σ`
  /// \throw std::invalid_argument if a ball of the kernel is out of range, or `sampling_ratio` is not
  /// positive.
  explicit Grid_projector(const Row_spans& region,
                          std::vector<Nested_ball> kernel = Ball_kernel_3().nested_balls(),
                          double sampling_ratio = default_sampling_ratio)
      : m_region(region), m_kernel(std::move(kernel)), m_sampling_ratio(sampling_ratio)
  {
    internal::check_kernel(m_kernel);
    internal::check_positive(sampling_ratio, "sampling_ratio");
  }

  /// \brief computes the transform at one scale.
  /// \pre the rows of the scale before have all been taken
  /// \return the area whose projection falls outside of the grid
  /// \throw std::invalid_argument if `σ` is less than 0.01 voxels or more than 1000
  /// \tparam ScaleSpace a model of `SurfelScaleSpace`
  /// \tparam Cancelled a nullary predicate; once it returns `true`, the rest of the surface is left out
  template <class ScaleSpace, class Cancelled>
  double project(const ScaleSpace& surface, const Scale& scale, Side side, Cancelled&& cancelled);

  /// writes the values (areas) of the hull of a row to `out`, and clears the row.
  void take_row(std::size_t row, float* out) { m_accumulator->take_row(row, m_quantum, out); }

  Grid_projector(const Row_spans&& region, std::vector<Nested_ball> = {}, double = 0) = delete;

private:
  void prepare(const Scale& scale);
  double add(const Projected_surfels& surfels, const internal::Fixed_point& fixed);

  const Row_spans& m_region;
  std::vector<Nested_ball> m_kernel;
  double m_sampling_ratio;
  double m_quantum = 0;
  int m_margin = 0;
  std::vector<internal::Ball_stencil> m_stencils;
  std::unique_ptr<internal::Run_accumulator> m_accumulator;
};

template <class ScaleSpace, class Cancelled>
double Grid_projector::project(const ScaleSpace& surface, const Scale& scale, Side side,
                               Cancelled&& cancelled)
{
  prepare(scale);
  const internal::Fixed_point fixed(surface.area(scale.radius));
  m_quantum = fixed.quantum();
  double area_outside = 0;
  surface.project(scale.radius, side, m_sampling_ratio * scale.sigma,
                  [&](const Projected_surfels& batch) {
                    if(!cancelled())
                      area_outside += add(batch, fixed);
                  });
  return area_outside;
}

inline void Grid_projector::prepare(const Scale& scale)
{
  // The accumulator is kept from scale to scale: it is clean once all rows have been taken.
  const double radius = scale.sigma / m_region.grid().spacing();
  if(!(radius >= 0.01 && radius <= 1000))
    throw std::invalid_argument("sigma is " + std::to_string(radius) +
                                " voxels: must be at least 0.01 and at most 1000");
  m_margin = internal::Ball_stencil::margin(radius);
  const int padding = internal::Ball_stencil::padding(radius);
  if(!m_accumulator || m_accumulator->padding() < padding)
    m_accumulator = std::make_unique<internal::Run_accumulator>(m_region, padding);
  m_stencils.clear();
  for(const Nested_ball& ball : m_kernel)
    m_stencils.emplace_back(radius * ball.relative_radius, m_accumulator->stride());
}

inline double Grid_projector::add(const Projected_surfels& surfels,
                                  const internal::Fixed_point& fixed)
{
  const double voxels_per_unit = 1 / m_region.grid().spacing();
  double area_outside = 0;
  for(std::size_t s = 0; s < surfels.size(); ++s) {
    const Point_3& p = surfels.positions[s];
    const internal::Lattice_place place(m_region.grid(), voxels_per_unit, p, m_margin);
    if(place.is_outside)
      area_outside += surfels.areas[s];
    if(!place.is_out_of_reach)
      for(std::size_t b = 0; b < m_kernel.size(); ++b)
        internal::add_ball(*m_accumulator, m_stencils[b], place,
                           fixed.dithered(surfels.areas[s] * m_kernel[b].weight, p));
  }
  return area_outside;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_GRID_PROJECTOR_H
