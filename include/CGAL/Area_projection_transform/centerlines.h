// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/centerlines/Ball_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_options.h>
#include <CGAL/Area_projection_transform/centerlines/Draft_line.h>
#include <CGAL/Area_projection_transform/centerlines/Line_joiner.h>
#include <CGAL/Area_projection_transform/centerlines/assign_branches.h>
#include <CGAL/Area_projection_transform/centerlines/drop_loops.h>
#include <CGAL/Area_projection_transform/centerlines/find_lines.h>
#include <CGAL/Area_projection_transform/centerlines/finish_graph.h>
#include <CGAL/Area_projection_transform/centerlines/inner_balls.h>
#include <CGAL/Area_projection_transform/centerlines/tidy_graph.h>
#include <CGAL/Area_projection_transform/internal/Progress_report.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// lines, joined if that is wanted, without twigs.
template <class ConcurrencyTag>
Draft_graph draft_graph(const Sample_levels& levels, const Line_samples& samples,
                        const Claims& claims, const std::vector<Draft_line>& lines,
                        const Centerline_options& options)
{
  std::vector<Inner_ball> balls;
  if(options.do_join && lines.size() > 1)
    balls = inner_balls<ConcurrencyTag>(levels, samples, claims, lines);
  Draft_graph graph = options.do_join
                          ? Line_joiner<ConcurrencyTag>(lines, Ball_graph(lines, std::move(balls)),
                                                        options.vertex_spacing)
                                .join()
                          : Draft_graph(lines);
  drop_narrow_loops(graph);
  if(options.do_extend)
    extend_ends(graph, lines, options.vertex_spacing);
  prune_twigs(graph, options.least_length);
  merge_nodes(graph);
  return graph;
}

template <class ConcurrencyTag>
Centerline_graph
centerlines_of(const Line_samples& samples, const std::vector<std::uint32_t>& sources,
               const Centerline_options& options, const std::function<bool(double)>& callback)
{
  if(samples.size() == 0)
    return Centerline_graph();
  const Sample_levels levels(samples);
  Progress_report progress(callback);
  Line_finder<ConcurrencyTag> finder(samples, levels, progress);
  std::vector<Draft_line> lines;
  for(Traced_line& line : finder.find(options.least_length))
    lines.push_back(draft_line<ConcurrencyTag>(levels, std::move(line), options.vertex_spacing));
  const Draft_graph draft =
      draft_graph<ConcurrencyTag>(levels, samples, finder.claims(), lines, options);
  Graph_finisher finisher(draft);
  std::vector<std::int32_t> branch_of_sample(samples.size(), -1);
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(finder.claims()[i] >= 0) {
      const std::size_t l = std::size_t(finder.claims()[i]);
      branch_of_sample[i] = finisher.branch_of(
          draft.first_of_line[l] + lines[l].vertex_of_point[finder.claimed_points()[i]]);
    }
  Centerline_graph graph = std::move(finisher.graph());
  assign_branches(samples, branch_of_sample, sources, graph[boost::graph_bundle].branches);
  graph[boost::graph_bundle].is_turned_over = samples.is_turned_over();
  return graph;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformCenterlines
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
/// \param np an optional named parameter:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is told the progress of the search, in [0, 1], and answers whether to go on; is called
///                           some times a second. If it answers `false`, the lines found by then are joined and
///                           returned.}
///     \cgalParamType{an instance of `std::function<bool(double)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw std::invalid_argument if a radius, a length or a spacing is not positive and finite, or the radii do not
/// ascend
///
/// Complexity: linear in the number of faces, and in the number of vertices of the result.
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Centerline_graph centerlines(const Triangle_surface& surface,
                             const Centerline_options& options = {},
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  return internal::centerlines_of<ConcurrencyTag>(internal::Line_samples(surface, options),
                                                  surface.sources, options,
                                                  internal::callback_of(np));
}

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief the same for points with normals, which lie on the surface, and the areas that they stand for.
/// \param points the points, with normals and areas
/// \param options the choices
/// \param np the named parameters of the function for triangles
/// \throw std::invalid_argument as for triangles
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Centerline_graph centerlines(const Surfels& points, const Centerline_options& options = {},
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  return internal::centerlines_of<ConcurrencyTag>(
      internal::Line_samples(points, options), points.sources, options, internal::callback_of(np));
}

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief the same for a mesh.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh; open, holed, in several parts, as it is
/// \param options the choices
/// \param np the named parameters of `surface_from_mesh()`, and `callback`
/// \throw std::invalid_argument also as `surface_from_mesh()` does
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Centerline_graph centerlines(const TriangleMesh& mesh, const Centerline_options& options = {},
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  return centerlines<ConcurrencyTag>(surface_from_mesh(mesh, np), options, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_H
