// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_PLY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_PLY_H

#include <CGAL/Area_projection_transform/IO/labelled_PLY.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \cond SKIP_IN_MANUAL
namespace internal {

inline Hues hues_of(Salient_shape shape)
{
  switch(shape) {
  case Salient_shape::SPHERE:
    return {335, 85}; // crimson to yellow
  case Salient_shape::TUBE:
  case Salient_shape::CONE:
    return {165, 100}; // turquoise to blue
  case Salient_shape::OTHER:
    break;
  }
  return {280, 40}; // violet
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a colour (red, green, blue) for the salient point of that rank in a list: warm for spheres,
/// cool for tubes and cones, violet for others. Neighbours in the list differ clearly.
/// \param shape the kind of the point
/// \param rank its position in the list
inline std::array<std::uint8_t, 3> colour_of_salient_point(Salient_shape shape, std::size_t rank)
{
  return internal::colour_of_rank(internal::hues_of(shape), rank);
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns for each element of an input, a face or a point, the position in `points` of the first one
/// that it supports, or -1.
/// \param sources the elements that are asked for, as `Triangle_surface::sources`
/// \param points the salient points
template <class SalientPointRange>
std::vector<std::int32_t> supported_points(const std::vector<std::uint32_t>& sources,
                                           const SalientPointRange& points)
{
  return internal::labels_of(sources, points);
}

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class SalientPointRange>
Labels salient_labels(const std::vector<std::uint32_t>& sources, const SalientPointRange& points)
{
  Labels labels{"salient_point", supported_points(sources, points), {}};
  for(const Salient_point& point : points)
    labels.colours.push_back(colour_of_salient_point(point.shape, labels.colours.size()));
  return labels;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a mesh of which the faces show what they support, for `write_PLY()`.
///
/// The elements are `vertex`, with `x`, `y`, `z`, and `face`, with `vertex_indices`, `red`, `green`, `blue`
/// and `salient_point`: the position in `points` of the one that the face supports (the first, if there are
/// several), or -1. All vertices and triangles of the surface are there, in its order. Faces that support the
/// same point have the same colour, `colour_of_salient_point()`; those that support none are grey.
/// \param surface the surface on which they were found
/// \param points a range of salient points
template <class SalientPointRange>
std::vector<PLY_element> salient_points_PLY(const Triangle_surface& surface,
                                            const SalientPointRange& points)
{
  return internal::labelled_PLY(surface, internal::salient_labels(surface.sources, points));
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a point set that shows what its points support, for `write_PLY()`.
///
/// As for meshes, but everything is in the element `vertex`, which has the normals `nx`, `ny`, `nz`, too.
/// \param surfels the points among which they were found
/// \param points a range of salient points
template <class SalientPointRange>
std::vector<PLY_element> salient_points_PLY(const Surfels& surfels, const SalientPointRange& points)
{
  return internal::labelled_PLY(surfels, internal::salient_labels(surfels.sources, points));
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_PLY_H
