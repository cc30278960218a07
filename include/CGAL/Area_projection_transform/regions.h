// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_REGIONS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_REGIONS_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Row_cover.h>
#include <CGAL/Area_projection_transform/internal/interior_by_votes.h>
#include <CGAL/Area_projection_transform/internal/is_closed.h>
#include <CGAL/Area_projection_transform/internal/offset_chords.h>
#include <CGAL/Area_projection_transform/internal/region_by_slabs.h>
#include <CGAL/Area_projection_transform/internal/signed_crossings.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformInput
/// \brief the interior of a surface on a grid, and how sure it is.
struct Interior
{
  Row_spans region; ///< the voxels inside
  /// \brief the mean fraction, over the voxels of the region, of the six axis-parallel rays that see
  /// the surface from inside: 1 for a closed surface, less where parts of it are missing.
  double coverage;
  /// the volume of the region: the number of its voxels times that of a voxel.
  double volume;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the voxels with a positive winding number, straight from the crossings of the rows.
template <class ConcurrencyTag>
Row_spans interior_of_closed(const Triangle_surface& surface, const Grid_3& grid)
{
  const Signed_crossings crossings(ConcurrencyTag(), surface, grid, 0);
  return Row_spans(grid, [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    int winding = 0;
    std::int32_t first = 0;
    for(auto c = crossings.begin(row); c != crossings.end(row); ++c) {
      if(winding > 0 && first < c->first_after)
        append_run({first, c->first_after}, runs);
      winding += c->sign;
      first = c->first_after;
    }
  });
}

/// the voxels that a model of `Solids` of `Row_cover` covers.
template <class ConcurrencyTag, class Solids>
Row_spans covered_region(const Solids& solids, const Grid_3& grid, double distance)
{
  const Row_cover<Solids> cover(solids, grid, distance);
  return region_by_slabs<ConcurrencyTag>(grid, [&](Slab& slab) {
    std::vector<Row_spans::Run> runs;
    for(int k = slab.first_layer(); k < slab.last_layer(); ++k)
      for(int j = 0; j < grid.size()[1]; ++j) {
        runs.clear();
        cover.append_runs(j, k, runs);
        slab.append_row(runs);
      }
  });
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns the voxels inside of a surface.
///
/// A voxel is inside if at least three of the six rays from its centre along the axes leave
/// the surface more often than they enter it. On a closed surface all six agree and this is the
/// positive winding number; with parts missing it is an approximation, and `coverage` tells how
/// much was missing. Where more than a quarter is, the rays of the neighbouring voxels count as
/// well, and fewer than half of them are enough: with half of the faces removed at random nearly
/// all voxels are right, unless the shape is no more than two or three voxels thick there. The
/// triangles must face outward: the interior of a closed surface that faces inward is empty.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \param surface triangles, facing outward
/// \param grid the lattice
///
/// Complexity: linear in the number of grid lines through the faces and in that of the faces, for
/// surfaces that are not closed also in the number of voxels of the grid. Memory: 50 bytes for each row
/// of voxels and 24 for each line through a face; for surfaces that are not closed three times
/// that, and 16 bytes more for each row and thread.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Interior interior(const Triangle_surface& surface, const Grid_3& grid)
{
  const auto find = [&]() -> Interior {
    if(internal::is_closed(surface))
      return {internal::interior_of_closed<ConcurrencyTag>(surface, grid), 1., 0.};
    internal::Voted_region found = internal::interior_by_votes<ConcurrencyTag>(surface, grid);
    const double coverage = found.coverage();
    return {std::move(found.region), coverage, 0.};
  };
  Interior result = find();
  const double voxel_volume = grid.spacing() * grid.spacing() * grid.spacing();
  result.volume = voxel_volume * double(result.region.number_of_voxels());
  return result;
}

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns the voxels within `distance` of the triangles of a surface, on either side.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \param surface the surface
/// \param grid the lattice
/// \param distance in the units of the surface
/// \throw std::invalid_argument if `distance` is not positive.
///
/// Complexity: for each row of voxels, a few searches among the faces for each of its runs. Memory: 60
/// bytes for each face and 70 for each row.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Row_spans band(const Triangle_surface& surface, const Grid_3& grid, double distance)
{
  internal::check_positive(distance, "distance");
  return internal::covered_region<ConcurrencyTag>(internal::Offset_triangles(surface, distance),
                                                  grid, distance);
}

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns the voxels within `distance` of a surface that is known by its surfels, on either
/// side.
///
/// The surface is sampled at half a voxel, so a voxel may be missed whose distance is less by up to
/// six tenths of a voxel. A point set is taken as it is.
/// \tparam Source a model of `SurfelSource`
/// \param surface the surface
/// \param grid the lattice
/// \param distance in the units of the surface
template <class ConcurrencyTag = CGAL::Sequential_tag, class Source>
Row_spans band(const Source& surface, const Grid_3& grid, double distance)
{
  internal::check_positive(distance, "distance");
  std::vector<Point_3> points;
  surface.for_each_batch(0.5 * grid.spacing(), [&](const Surfels& batch) {
    points.insert(points.end(), batch.positions.begin(), batch.positions.end());
  });
  return internal::covered_region<ConcurrencyTag>(
      internal::Offset_points(std::move(points), distance), grid, distance);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_REGIONS_H
