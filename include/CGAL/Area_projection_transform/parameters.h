// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PARAMETERS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PARAMETERS_H

#include <CGAL/Area_projection_transform/Side.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the named parameters that \cgal does not have.
///
/// They are genuine packs of \cgal: they can start a chain that goes on with \cgal's own
/// (`face_area_map(m).vertex_point_map(v)`), or be joined in any order with `combine()`.
namespace parameters {

/// \cond SKIP_IN_MANUAL
namespace tags {

enum face_area_t { face_area };
enum use_interpolated_normals_t { use_interpolated_normals };
enum area_map_t { area };
enum side_t { side };
enum sigma_ratio_t { sigma_ratio };
enum radii_t { radii };
enum voxel_size_t { voxel_size };

} // namespace tags

template <class Tag, class T>
using Pack = Named_function_parameters<T, Tag>;
/// \endcond

/// the area that each face votes with (a readable property map from faces to numbers).
template <class FaceAreaMap>
Pack<tags::face_area_t, FaceAreaMap> face_area_map(const FaceAreaMap& map)
{
  return Pack<tags::face_area_t, FaceAreaMap>(map);
}

/// whether normals are interpolated between the vertices instead of constant on each face.
inline Pack<tags::use_interpolated_normals_t, bool> use_interpolated_normals(bool use)
{
  return Pack<tags::use_interpolated_normals_t, bool>(use);
}

/// the area of each point (a readable property map from the elements of the range to numbers).
template <class AreaMap>
Pack<tags::area_map_t, AreaMap> area_map(const AreaMap& map)
{
  return Pack<tags::area_map_t, AreaMap>(map);
}

/// the side of the surface.
inline Pack<tags::side_t, Side> side(Side value)
{
  return Pack<tags::side_t, Side>(value);
}

/// the ratio `σ/R`.
inline Pack<tags::sigma_ratio_t, double> sigma_ratio(double value)
{
  return Pack<tags::sigma_ratio_t, double>(value);
}

/// the radii of the scales, in the units of the mesh.
inline Pack<tags::radii_t, std::vector<double>> radii(const std::vector<double>& values)
{
  return Pack<tags::radii_t, std::vector<double>>(values);
}

/// the spacing of the grid, in the units of the mesh.
inline Pack<tags::voxel_size_t, double> voxel_size(double value)
{
  return Pack<tags::voxel_size_t, double>(value);
}

/// joins two packs; what `right` sets has precedence.
template <class Left, class T, class Tag>
auto combine(const Left& left,
             const Named_function_parameters<T, Tag, CGAL::internal_np::No_property>& right)
{
  return Named_function_parameters<T, Tag, Left>(right.v, left);
}

/// \cond SKIP_IN_MANUAL
// A chain on the right is taken apart and put on top of the left, link by link.
template <class Left, class T, class Tag, class Base>
auto combine(const Left& left, const Named_function_parameters<T, Tag, Base>& right)
{
  auto lower = combine(left, static_cast<const Base&>(right));
  return Named_function_parameters<T, Tag, decltype(lower)>(right.v, lower);
}
/// \endcond

/// joins any number of packs; later ones have precedence.
template <class First, class Second, class Third, class... More>
auto combine(const First& first, const Second& second, const Third& third, const More&... more)
{
  return combine(combine(first, second), third, more...);
}

} // namespace parameters

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PARAMETERS_H
