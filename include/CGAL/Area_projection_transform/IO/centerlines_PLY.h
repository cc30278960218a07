// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_PLY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_PLY_H

#include <CGAL/Area_projection_transform/IO/labelled_PLY.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a colour (red, green, blue) for a branch of centrelines. Neighbours in the list differ clearly.
/// \param index the position of the branch in `branches()`
inline std::array<std::uint8_t, 3> colour_of_branch(std::size_t index)
{
  return internal::colour_of_rank({0, 360}, index);
}

/// \cond SKIP_IN_MANUAL
namespace internal {

inline Labels branch_labels(const std::vector<std::uint32_t>& sources,
                            const Centerline_graph& graph)
{
  Labels labels{"branch", branch_of_each(graph, sources), {}};
  for(std::size_t b = 0; b < branches(graph).size(); ++b)
    labels.colours.push_back(colour_of_branch(b));
  return labels;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a mesh cut into the tubes of its centrelines, for `write_PLY()`.
///
/// The elements are `vertex`, with `x`, `y`, `z`, and `face`, with `vertex_indices`, `red`, `green`, `blue`
/// and `branch`: the branch of `graph` that the face surrounds, or -1. All vertices and triangles of the surface are
/// there, in its order. Faces of a branch have the same colour, `colour_of_branch()`; those of none are grey.
/// \param surface the surface of which they are the lines
/// \param graph the lines
inline std::vector<PLY_element> centerlines_PLY(const Triangle_surface& surface,
                                                const Centerline_graph& graph)
{
  return internal::labelled_PLY(surface, internal::branch_labels(surface.sources, graph));
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns points that show the branch they surround, for `write_PLY()`.
///
/// As for meshes, but everything is in the element `vertex`, which has the normals `nx`, `ny`, `nz`, too.
/// \param surfels the points of which they are the lines
/// \param graph the lines
inline std::vector<PLY_element> centerlines_PLY(const Surfels& surfels,
                                                const Centerline_graph& graph)
{
  return internal::labelled_PLY(surfels, internal::branch_labels(surfels.sources, graph));
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_PLY_H
