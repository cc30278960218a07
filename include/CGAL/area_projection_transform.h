// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_H
#define CGAL_AREA_PROJECTION_TRANSFORM_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/default_scales.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRef
/// \brief returns the area projection transform of a mesh at a point: the area that, moved by
/// `radius` along its normal, lands within `sigma` of `x` (paper, equation 1).
///
/// The value is exact up to rounding. For many points, make one `Exact_evaluator`.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh; open, holed, in several parts, as it is
/// \param x a point of any kernel
/// \param radius the distance of projection, positive, in the units of the mesh
/// \param sigma the radius of the collecting ball, positive, in the units of the mesh
/// \param np optional named parameters: those of `surface_from_mesh()` without interpolated normals,
/// and `side` (default: `Side::INSIDE`)
/// \throw std::invalid_argument if `radius` or `sigma` is not positive, normals are interpolated, a
/// face is not a triangle, or a vertex is not finite.
///
/// Complexity: linear in the number of faces.
template <class TriangleMesh, class Point,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
double area_projection_transform(const TriangleMesh& mesh, const Point& x, double radius,
                                 double sigma,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_positive(sigma, "sigma");
  internal::check_positive(radius, "radius");
  const Side side = choose_parameter(get_parameter(np, parameters::tags::side), Side(Side::INSIDE));
  const Point_3 center = internal::to_point(x);
  const Triangle_surface surface = surface_from_mesh(mesh, np);
  internal::check_flat(surface);
  const double distance = internal::signed_distance(side, radius);
  double area = 0;
  for(std::size_t t = 0; t < surface.size(); ++t)
    area += surface.areas[t] *
            internal::projected_triangle(surface, t, distance).fraction_within(center, sigma);
  return area;
}

/// \ingroup PkgAreaProjectionTransformRef
/// \brief returns the joint multiscale map of a mesh: at each voxel the largest value of
/// `APT / (4πR²)` over the scales, and the scale that attains it (paper, section 4).
///
/// With the default `sigma_ratio` of 1/2 the values read: 1/16 plane, 1/8 slab, 1/2 cylinder or
/// hemisphere, 1 sphere, each at its own radius. Over dense radii the maximum is attained at a
/// smaller radius than that of the shape (two thirds of it for a sphere, with the value 2.25).
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh, facing outward; open, holed, in several parts, as it is
/// \param np optional named parameters: those of `surface_from_mesh()`, `callback` and `visitor` of
/// `project_scales()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{side}
///     \cgalParamDescription{the side of the surface}
///     \cgalParamType{`Side`}
///     \cgalParamDefault{`Side::INSIDE`: the map covers the interior; on the outside it covers the
///                       bounding box and the largest radius around it}
///   \cgalParamNEnd
///   \cgalParamNBegin{sigma_ratio}
///     \cgalParamDescription{the ratio `σ/R`, in (0, 1)}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.5`}
///   \cgalParamNEnd
///   \cgalParamNBegin{voxel_size}
///     \cgalParamDescription{the spacing of the grid, in the units of the mesh}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_voxel_size()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{radii}
///     \cgalParamDescription{the radii, ascending, in the units of the mesh}
///     \cgalParamType{`std::vector<double>`}
///     \cgalParamDefault{`default_radii()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw std::invalid_argument if a parameter is out of range, the radii do not ascend, a face is not a
/// triangle, a vertex is not finite, or no face has an area.
///
/// Complexity: for each scale, linear in the number of voxels of the region and in the area of the
/// surface in voxels, divided by the square of `Grid_projector::default_sampling_ratio`; `O(n log n)` for `n` faces once.
/// Memory: 9 bytes for each voxel with storage (from the first to the last of the region in each row),
/// 4 more for each further thread that computes a scale of its own; and what `interior()` takes. For more
/// than one map of the same mesh, make a `Map_session`.
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Joint_map
joint_area_projection_transform(const TriangleMesh& mesh,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace tags = parameters::tags;

  Constant_scale_space surface(surface_from_mesh(mesh, np));
  if(surface.source().empty())
    throw std::invalid_argument("mesh has no face with an area");
  const Bbox_3 box = surface.bbox();
  const Side side = choose_parameter(get_parameter(np, tags::side), Side(Side::INSIDE));
  const double ratio = choose_parameter(get_parameter(np, tags::sigma_ratio), 0.5);
  const double voxel_size =
      choose_parameter(get_parameter(np, tags::voxel_size), default_voxel_size(box));
  const std::vector<Scale> scales = proportional_scales(
      choose_parameter(get_parameter(np, tags::radii), default_radii(box, voxel_size, ratio)),
      ratio);

  const double margin = side == Side::INSIDE || scales.empty() ? 0. : scales.back().radius;
  Map_session<Constant_scale_space<Triangle_surface>, ConcurrencyTag> session(std::move(surface),
                                                                              voxel_size, margin);
  return session.joint_map(scales, side, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_H
