// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_RECONSTRUCTION_ERROR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_RECONSTRUCTION_ERROR_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/is_closed.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Surface_distance.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/axis_distances.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/ball_volume.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/distances_from_balls.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/union_of_balls_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief how far a surface and the union of some balls are from each other.
struct Reconstruction_error
{
  /// of the surface, by its area: how far it is from the balls; 0 where one reaches it.
  Spread_of_values missing;
  /// \brief of the boundary of the union, by its area: how far it is outside of the surface; 0 where it is inside. Nothing
  /// if the surface is not closed.
  std::optional<Spread_of_values> protrusion;
  /// \brief how far apart samples are, in the units of the surface. Distances change by no more than one moves, so that
  /// somewhere between samples they may be larger than the largest by that.
  double spacing = 0;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// tells of places whether they are in the solid that a closed surface bounds; those of a row of places together.
template <class ConcurrencyTag>
std::vector<char> are_inside(const std::vector<Point_3>& places, const Triangle_surface& solid)
{
  constexpr std::size_t number_of_rows = 256;
  const Bbox_3 box = solid.bbox();
  const double height = (box.ymax() - box.ymin()) / double(number_of_rows),
               nudge = 1e-9 * (box.xmax() - box.xmin());
  std::vector<std::vector<std::size_t>> rows(number_of_rows);
  std::vector<char> result(places.size(), false);
  for(std::size_t i = 0; i < places.size(); ++i)
    if(do_overlap(places[i].bbox(), box))
      rows[std::min(std::size_t((places[i].y() - box.ymin()) / height), number_of_rows - 1)]
          .push_back(i);
  const Medial_representation no_balls;
  const Line_scene scene(no_balls, &solid);
  for_each_index<ConcurrencyTag>(number_of_rows, [&](std::size_t j) {
    if(rows[j].empty())
      return;
    // Wider than the row, so that rounding leaves no triangle out.
    const Line_scene::Row row = scene.row(box.ymin() + (double(j) - 0.01) * height,
                                          box.ymin() + (double(j) + 1.01) * height);
    for(const std::size_t i : rows[j]) {
      std::optional<Intervals> intervals;
      // Lines askew to the places: those through edges would be lost, and places are on lattices as corners may be.
      for(int attempt = 1; attempt <= 8 && !intervals; ++attempt)
        intervals = scene.in_solid(row, places[i].x() + 0.7317 * attempt * nudge,
                                   places[i].y() + 0.3389 * attempt * nudge);
      const double z = places[i].z();
      result[i] =
          intervals && std::any_of(intervals->begin(), intervals->end(),
                                   [z](const auto& p) { return p.first <= z && z <= p.second; });
    }
  });
  return result;
}

/// how far the points of a mesh are outside of a solid, weighted by the area around them.
template <class ConcurrencyTag>
Spread_of_values protrusion(const Triangle_surface& mesh, const Triangle_surface& solid,
                            const Surface_distance<Triangle_surface>& distance)
{
  std::vector<double> areas(mesh.points.size(), 0.), values(mesh.points.size(), 0.);
  for(std::size_t t = 0; t < mesh.size(); ++t)
    for(const std::uint32_t i : mesh.triangles[t])
      areas[i] += mesh.areas[t] / 3;
  const std::vector<char> is_inside = are_inside<ConcurrencyTag>(mesh.points, solid);
  for_each_index<ConcurrencyTag>(values.size(), [&](std::size_t i) {
    if(!is_inside[i])
      values[i] = distance(mesh.points[i]);
  });
  return spread_of(std::move(values), areas);
}

template <class ConcurrencyTag>
std::optional<Spread_of_values>
protrusion(const Medial_representation& axis, const Triangle_surface& surface,
           const Surface_distance<Triangle_surface>& distance, double spacing)
{
  if(surface.empty() || !is_closed(surface))
    return std::nullopt;
  return protrusion<ConcurrencyTag>(union_of_balls_mesh<ConcurrencyTag>(axis, spacing), surface,
                                    distance);
}

template <class ConcurrencyTag>
std::optional<Spread_of_values> protrusion(const Medial_representation&, const Surfels&,
                                           const Surface_distance<Surfels>&, double)
{
  return std::nullopt;
}

template <class ConcurrencyTag, class Source>
Reconstruction_error reconstruction_error(const Medial_representation& axis, const Source& surface,
                                          const Surface_distance<Source>& distance, double spacing)
{
  const Surfels samples = sample_surfels(surface, spacing);
  std::vector<double> missing = distances_from_balls<ConcurrencyTag>(samples.positions, axis);
  for(double& value : missing)
    value = std::max(value, 0.);
  Reconstruction_error result;
  result.missing = spread_of(std::move(missing), samples.areas);
  result.protrusion = protrusion<ConcurrencyTag>(axis, surface, distance, spacing);
  result.spacing = spacing;
  return result;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief tells how well the balls of a representation reconstruct a surface: how far it is from their union, and how far they
/// stick out of it.
///
/// The surface is sampled, and so is the boundary of the union, at the points of `union_of_balls_mesh()`, which are on it up to
/// a fiftieth of the spacing.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`; the
/// result does not depend on it, to the last bit
/// \tparam Source `Triangle_surface` or `Surfels`
/// \param axis the balls, in the units of the surface
/// \param surface facing outward
/// \param spacing of the samples, in the units of the surface
/// \throw std::invalid_argument if the spacing is not positive and finite, or too small for `union_of_balls_mesh()`
template <class ConcurrencyTag = CGAL::Sequential_tag, class Source>
Reconstruction_error reconstruction_error(const Medial_representation& axis, const Source& surface,
                                          double spacing)
{
  internal::check_positive(spacing, "spacing");
  return internal::reconstruction_error<ConcurrencyTag>(axis, surface,
                                                        Surface_distance<Source>(surface), spacing);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_RECONSTRUCTION_ERROR_H
