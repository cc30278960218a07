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
#include <CGAL/Area_projection_transform/internal/Fixed_point.h>
#include <CGAL/Area_projection_transform/internal/add_patches.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the default computation of the transform on a grid: every piece of surface, moved by `R`, adds
/// to each voxel the share of its area that lies within `σ` of the voxel's centre.
///
/// The surface is cut into pieces no larger than a square of side `sampling_ratio · σ` on the parallel
/// surface. Of a piece, its mean and covariance are known: where the piece lies across the rim of a
/// ball, its share follows from how far it spreads towards the centre of the ball. (The paper's
/// algorithm counts a piece in full or not at all, and rounds its place to a voxel.) The error is about
/// half a percent of the root mean square of the exact map, and falls with the square of the ratio.
///
/// Areas are summed as integers: the map has the same bits for any order of the faces, any number of
/// threads and any instruction set.
///
/// \cgalModels `GridProjector`
class Grid_projector
{
public:
  /// the default spacing of the pieces, in units of `σ`.
  static constexpr double default_sampling_ratio = 0.45;

  /// \param region the voxels to compute; must outlive the projector
  /// \param kernel the nested balls of a model of `ProjectionKernel_3`
  /// \param sampling_ratio the size of the pieces, in units of `σ`, in (0, 1]
  /// \throw std::invalid_argument if a ball of the kernel or `sampling_ratio` is out of range, or the
  /// region has more than 2^31 voxels, or 2^16 in a row.
  explicit Grid_projector(const Row_spans& region,
                          std::vector<Nested_ball> kernel = Ball_kernel_3().nested_balls(),
                          double sampling_ratio = default_sampling_ratio)
      : m_region(region)
      , m_kernel(std::move(kernel))
      , m_sampling_ratio(sampling_ratio)
      , m_accumulator(region)
  {
    internal::check_kernel(m_kernel);
    internal::check_positive(sampling_ratio, "sampling_ratio");
    if(sampling_ratio > 1)
      throw std::invalid_argument("sampling_ratio is " + internal::to_text(sampling_ratio) +
                                  ": must be at most 1");
  }

  /// \brief computes the transform at one scale.
  /// \param surface the surface
  /// \param scale the radius and `σ`, in the units of the surface
  /// \param side the side on which it is projected
  /// \param cancelled asked now and then whether to stop
  /// \pre the rows of the scale before have all been taken
  /// \return the area of the pieces whose mean falls outside of the grid
  /// \throw std::invalid_argument if `σ` is less than 0.01 voxels or more than 1000
  /// \tparam ScaleSpace a model of `SurfelScaleSpace`
  /// \tparam Cancelled a nullary predicate; once it returns `true`, the rest of the surface is left out
  template <class ScaleSpace, class Cancelled>
  double project(const ScaleSpace& surface, const Scale& scale, Side side, Cancelled&& cancelled);

  /// writes the values (areas) of the hull of a row to `out`, and clears the row.
  void take_row(std::size_t row, float* out) { m_accumulator.take_row(row, m_quantum, out); }

  Grid_projector(const Row_spans&& region, std::vector<Nested_ball> = {}, double = 0) = delete;

private:
  double add(const Projected_surfels& surfels, const internal::Patch_maker& maker, double weight,
             const internal::Fixed_point& fixed);

  const Row_spans& m_region;
  std::vector<Nested_ball> m_kernel;
  double m_sampling_ratio;
  double m_quantum = 0;
  internal::Row_accumulator m_accumulator;
  std::vector<internal::Patch> m_patches;
};

template <class ScaleSpace, class Cancelled>
double Grid_projector::project(const ScaleSpace& surface, const Scale& scale, Side side,
                               Cancelled&& cancelled)
{
  const double voxels = scale.sigma / m_region.grid().spacing();
  if(!(voxels >= 0.01 && voxels <= 1000))
    throw std::invalid_argument("sigma is " + internal::to_text(voxels) +
                                " voxels: must be at least 0.01 and at most 1000");
  const internal::Fixed_point fixed(surface.area(scale.radius));
  m_quantum = fixed.quantum();
  double area_outside = 0;
  // Smaller balls need smaller pieces; so each ball of the kernel has its own.
  for(const Nested_ball& ball : m_kernel) {
    const internal::Patch_maker maker(m_region.grid(), voxels * ball.relative_radius);
    area_outside = 0;
    surface.project(scale.radius, side, m_sampling_ratio * scale.sigma * ball.relative_radius,
                    [&](const Projected_surfels& batch) {
                      if(!cancelled())
                        area_outside += add(batch, maker, ball.weight, fixed);
                    });
  }
  return area_outside;
}

inline double Grid_projector::add(const Projected_surfels& surfels,
                                  const internal::Patch_maker& maker, double weight,
                                  const internal::Fixed_point& fixed)
{
  m_patches.clear();
  double area_outside = 0;
  internal::Patch patch;
  for(std::size_t s = 0; s < surfels.size(); ++s) {
    const auto place = maker.place(surfels.positions[s]);
    if(maker.is_outside(place))
      area_outside += surfels.areas[s];
    if(maker.make(place, surfels.covariances[s], patch)) {
      patch.amount = float(fixed.dithered(weight * surfels.areas[s], surfels.positions[s]));
      m_patches.push_back(patch);
    }
  }
  internal::add_patches(m_accumulator, m_patches);
  return area_outside;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_GRID_PROJECTOR_H
