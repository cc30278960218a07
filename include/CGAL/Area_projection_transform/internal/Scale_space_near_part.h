// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SCALE_SPACE_NEAR_PART_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SCALE_SPACE_NEAR_PART_H

#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/Region_parts.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief what a part of a region sees of a scale space at one scale: the surfels that land within its
/// reach.
///
/// The first part gets those that leave the grid as well, so that the area outside, as it is told by the
/// projector of this part, is that of the whole surface. Order and batches are kept, and with them the
/// bits of all sums.
/// \cgalModels `SurfelScaleSpace`, and `TriangleScaleSpace` if `ScaleSpace` is one
template <class ScaleSpace>
class Scale_space_near_part
{
public:
  Scale_space_near_part(const ScaleSpace& surface, const Region_part& part, const Scale& scale)
      : m_surface(surface)
      , m_grid(part.region->grid())
      , m_is_first(part.is_first)
      // Two voxels to spare, for projectors that round to voxels.
      , m_low(layer(part.first_layer - 2) - scale.sigma)
      , m_high(layer(part.last_layer + 1) + scale.sigma)
  {}

  double area(double radius) const { return m_surface.area(radius); }
  Bbox_3 bbox() const { return m_surface.bbox(); }

  template <class BatchSink>
  void project(double radius, Side side, double spacing, BatchSink&& sink) const
  {
    Projected_surfels near;
    m_surface.project(radius, side, spacing, [&](const Projected_surfels& batch) {
      near.clear();
      for(std::size_t s = 0; s < batch.size(); ++s)
        if(is_wanted(batch.positions[s], batch.covariances[s]))
          near.push_back(batch.positions[s], batch.areas[s], batch.covariances[s]);
      sink(static_cast<const Projected_surfels&>(near));
    });
  }

  /// all of them: projectors of triangles find out by themselves.
  auto triangles(double radius) const { return m_surface.triangles(radius); }

private:
  double layer(int k) const { return m_grid.origin().z() + m_grid.spacing() * k; }

  bool is_wanted(const Point_3& p, const Covariance_3& covariance) const
  {
    // No ramp at the rim of a ball is longer on either side: see Patch.h.
    const double ramp = std::sqrt(6 * covariance.trace());
    if(p.z() >= m_low - ramp && p.z() <= m_high + ramp)
      return true;
    if(!m_is_first)
      return false;
    const Vector_3 c = m_grid.lattice_coordinates(p);
    for(int axis = 0; axis < 3; ++axis)
      if(!(c[axis] >= 0 && c[axis] <= m_grid.size()[std::size_t(axis)] - 1))
        return true;
    return false;
  }

  const ScaleSpace& m_surface;
  const Grid_3& m_grid;
  bool m_is_first;
  double m_low, m_high;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_SCALE_SPACE_NEAR_PART_H
