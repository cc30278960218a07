// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SOLID_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SOLID_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/is_closed.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Surface_moments.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// a surface in the frame of its principal axes, and the volume that it encloses.
struct Solid
{
  Triangle_surface surface;
  bool is_closed = false;
  double volume = 0; ///< positive
};

/// \brief refuses a volume that is nothing, or next to nothing for the area around it: a sheet of that area would be cut
/// into thousands of voxels along each side.
inline double checked_volume(double volume, double area)
{
  constexpr double least = 1e-7;
  if(!(volume > least * area * std::sqrt(area)) || !std::isfinite(volume))
    throw std::invalid_argument(
        "surface encloses no volume, or next to none of its box: must face outward, and have an "
        "inside to be described");
  return volume;
}

/// a lattice around a surface, unless its parts are so far from each other that it would have no end.
inline Grid_3 checked_grid(const Bbox_3& box, double spacing)
{
  constexpr double most_rows = 1 << 24, most_voxels = 1u << 31;
  const double rows = (box.y_span() / spacing + 2) * (box.z_span() / spacing + 2);
  if(!(rows < most_rows && rows * (box.x_span() / spacing + 2) < most_voxels))
    throw std::invalid_argument("surface is too wide for the volume that it encloses: would be cut "
                                "into more than 2^24 rows or 2^31 voxels");
  return grid_around(box, spacing);
}

/// \brief the volume of a surface of which parts are missing: that of its interior on a lattice of a fortieth of the
/// cube root of the volume that a coarser lattice finds.
template <class ConcurrencyTag>
double volume_seen(const Triangle_surface& surface)
{
  const Bbox_3 box = surface.bbox();
  const double extent = std::max({box.x_span(), box.y_span(), box.z_span()});
  const double area = surface.total_area();
  const auto on_lattice = [&](double spacing) {
    const Grid_3 grid = checked_grid(box, spacing);
    return checked_volume(interior<ConcurrencyTag>(surface, grid).volume, area);
  };
  return on_lattice(std::cbrt(on_lattice(extent / 64)) / 40);
}

template <class ConcurrencyTag>
Solid make_solid(const Triangle_surface& surface)
{
  if(surface.empty())
    throw std::invalid_argument("surface has no face with an area");
  const Surface_moments moments = surface_moments(surface);
  // Of a closed surface this is the volume. Where parts are missing its sign still tells which way the rest faces.
  const double volume = checked_volume(moments.signed_volume, moments.area);
  Solid solid;
  solid.surface = along_principal_axes(surface, moments.covariance);
  solid.is_closed = is_closed(surface);
  solid.volume = solid.is_closed ? volume : volume_seen<ConcurrencyTag>(solid.surface);
  return solid;
}

/// the voxels inside.
template <class ConcurrencyTag>
Interior interior_of(const Solid& solid, double spacing)
{
  const Grid_3 grid = checked_grid(solid.surface.bbox(), spacing);
  if(!solid.is_closed)
    return interior<ConcurrencyTag>(solid.surface, grid);
  return {interior_of_closed<ConcurrencyTag>(solid.surface, grid), 1., solid.volume};
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief returns the volume that a surface encloses, also if parts of it are missing.
///
/// Of a closed surface, which must face outward, it is exact up to rounding; where it overlaps itself, space counts
/// as often as it is enclosed. Otherwise it is the volume of the voxels of `interior()`, which sees through holes,
/// along the principal axes of the surface.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \param surface triangles, facing outward
/// \throw std::invalid_argument if the surface has no faces, encloses nothing, or faces inward.
template <class ConcurrencyTag = CGAL::Sequential_tag>
double enclosed_volume(const Triangle_surface& surface)
{
  return internal::make_solid<ConcurrencyTag>(surface).volume;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SOLID_H
