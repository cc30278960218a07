// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_ENCLOSED_VOLUME_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_ENCLOSED_VOLUME_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/is_closed.h>
#include <CGAL/Area_projection_transform/regions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief returns the volume that a closed surface encloses, by the theorem of Gauss; negative if it faces inward.
///
/// Terms are rounded to a common quantum and summed as integers: the order of the triangles has no effect.
inline double signed_volume(const Triangle_surface& surface)
{
  const Bbox_3 box = surface.bbox();
  const Point_3 origin(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                       0.5 * (box.zmin() + box.zmax()));
  std::vector<double> terms(surface.size());
  double largest = 0;
  for(std::size_t t = 0; t < terms.size(); ++t) {
    const Vector_3 a = surface.corner(t, 0) - origin;
    terms[t] = cross_product(a, surface.corner(t, 1) - origin) * (surface.corner(t, 2) - origin);
    largest = std::max(largest, std::abs(terms[t]));
  }
  if(!(largest > 0) || !std::isfinite(largest))
    return 0;
  const int exponent = 61 - std::ilogb(largest * double(terms.size()));
  std::int64_t sum = 0;
  for(double term : terms)
    sum += std::int64_t(std::ldexp(term, exponent));
  return std::ldexp(double(sum), -exponent) / 6;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformFeatures
/// \brief returns the volume that a surface encloses, also if parts of it are missing.
///
/// Of a closed surface, which must face outward, it is exact up to rounding; where it overlaps itself, space counts
/// as often as it is enclosed. Otherwise it is that of the voxels of `interior()`, which sees through
/// holes, on a lattice of a fortieth of the cube root of the volume that a coarser one finds.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \throw std::invalid_argument if the surface has no faces, encloses nothing, or faces inward.
template <class ConcurrencyTag = CGAL::Sequential_tag>
double enclosed_volume(const Triangle_surface& surface)
{
  if(surface.empty())
    throw std::invalid_argument("surface has no face with an area");
  const auto fail = [] {
    throw std::invalid_argument(
        "surface encloses no volume: must face outward, and have an inside to be described");
  };
  if(internal::is_closed(surface)) {
    const double volume = internal::signed_volume(surface);
    if(!(volume > 0))
      fail();
    return volume;
  }
  const Bbox_3 box = surface.bbox();
  double spacing = std::max({box.x_span(), box.y_span(), box.z_span()}) / 64, volume = 0;
  for(int pass = 0; pass < 2; ++pass) {
    volume = interior<ConcurrencyTag>(surface, grid_around(box, spacing)).volume;
    if(!(volume > 0))
      fail();
    spacing = std::cbrt(volume) / 40;
  }
  return volume;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_ENCLOSED_VOLUME_H
