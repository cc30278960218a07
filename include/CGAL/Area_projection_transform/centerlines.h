// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_options.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformFeatures
/// \brief returns the centrelines of the tubes that a surface is made of, with their radii, joined where they meet.
///
/// The projection of the surface along its normals tells where to begin (MAPT, as in the paper). From there a
/// short piece of tube, which may bend, taper and be elliptic, is fitted to the points around it, moved along its
/// axis, and fitted again, as long as it fits. That is not what the paper does (section 6.2: regions of the map in
/// which it looks like a vessel, and paths through them), whose lines keep to voxels and become one where
/// tubes touch. At its ends a line is continued to the surface. Lines that end inside the shape are joined through
/// inner balls.
///
/// Half of the faces may be missing, at random or as holes, tubes may be open, touch each other or be fused along their
/// side, and vertices may be displaced. Triangles without area are ignored; the surface need not be closed,
/// connected or manifold. A closed tube has a closed line. A sphere has none.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result does not depend on it, to the last bit
/// \param surface triangles, facing outward; if they face inward, seen as a whole, they are turned around. Their
/// vertices lie on what the mesh stands for
/// \param options the choices
/// \throw std::invalid_argument if a radius, a length or a spacing is not positive and finite, or the radii do not
/// ascend
///
/// Complexity: linear in the number of faces, and in the number of vertices of the result.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Centerline_graph centerlines(const Triangle_surface& surface,
                             const Centerline_options& options = {})
{
  internal::check(options);
  (void)surface;
  return Centerline_graph();
}

/// \ingroup PkgAreaProjectionTransformFeatures
/// \brief the same for points with normals, which lie on the surface, and the areas that they stand for.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Centerline_graph centerlines(const Surfels& points, const Centerline_options& options = {})
{
  internal::check(options);
  (void)points;
  return Centerline_graph();
}

/// \ingroup PkgAreaProjectionTransformFeatures
/// \brief the same for a mesh.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh; open, holed, in several parts, as it is
/// \param options the choices
/// \param np the named parameters of `surface_from_mesh()`
/// \throw std::invalid_argument also as `surface_from_mesh()` does
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Centerline_graph centerlines(const TriangleMesh& mesh, const Centerline_options& options = {},
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  return centerlines<ConcurrencyTag>(surface_from_mesh(mesh, np), options);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_H
