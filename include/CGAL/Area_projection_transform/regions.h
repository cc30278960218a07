// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_REGIONS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_REGIONS_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Ball_stencil.h>
#include <CGAL/Area_projection_transform/internal/signed_crossings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformInput
/// \brief the interior of a surface on a grid, and how sure it is.
struct Interior
{
  Row_spans region;
  /// \brief the mean fraction, over the voxels of the region, of the six axis-parallel rays that see
  /// the surface from inside: 1 for a closed surface, less where parts of it are missing.
  double coverage;
  /// the volume of the region: the number of its voxels times that of a voxel.
  double volume;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief whether the triangles form a closed, consistently oriented surface: every edge is passed
/// as often one way as the other.
inline bool is_closed(const Triangle_surface& surface)
{
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * surface.size());
  for(const Triangle_surface::Triangle& triangle : surface.triangles)
    for(int i = 0; i < 3; ++i)
      edges.push_back({triangle[i], triangle[(i + 1) % 3]});
  std::vector<std::array<std::uint32_t, 2>> reversed;
  reversed.reserve(edges.size());
  for(const auto& edge : edges)
    reversed.push_back({edge[1], edge[0]});
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  return edges == reversed;
}

/// calls `vote(u, v, first, last, number)` for the runs of each line whose points see the surface
/// from inside in `number` of the two directions of the axis.
template <class Vote>
void vote_along_axis(const Signed_crossings& crossings, const Grid_3& grid, int axis, Vote&& vote)
{
  const std::size_t size_u = std::size_t(grid.size()[(axis + 1) % 3]);
  for(std::size_t line = 0; line < crossings.number_of_lines(); ++line) {
    int behind = 0; // signed crossings between the point and the end of the line
    for(auto c = crossings.begin(line); c != crossings.end(line); ++c)
      behind -= c->sign;
    int before = 0; // signed crossings between the beginning of the line and the point
    std::int32_t first = 0;
    for(auto c = crossings.begin(line);; ++c) {
      const bool is_end = c == crossings.end(line);
      const std::int32_t last = is_end ? grid.size()[axis] : c->first_after;
      const int number = (before > 0) + (behind > 0);
      if(number > 0 && first < last)
        vote(int(line % size_u), int(line / size_u), first, last, number);
      if(is_end)
        break;
      before += c->sign;
      behind += c->sign;
      first = last;
    }
  }
}

/// the runs of a line of a closed surface with positive winding number, straight from the crossings.
inline Row_spans interior_of_closed(const Triangle_surface& surface, const Grid_3& grid)
{
  const Signed_crossings crossings(surface, grid, 0);
  return Row_spans(grid, [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    int winding = 0;
    std::int32_t first = 0;
    for(auto c = crossings.begin(row); c != crossings.end(row); ++c) {
      if(winding > 0 && first < c->first_after) {
        if(!runs.empty() && runs.back().last == first)
          runs.back().last = c->first_after;
        else
          runs.push_back({first, c->first_after});
      }
      winding += c->sign;
      first = c->first_after;
    }
  });
}

/// appends the runs of `size` voxels for which `is_inside(i)` holds.
template <class Predicate>
void append_runs(std::int32_t size, Predicate&& is_inside, std::vector<Row_spans::Run>& runs)
{
  for(std::int32_t i = 0; i < size; ++i)
    if(is_inside(i)) {
      if(!runs.empty() && runs.back().last == i)
        ++runs.back().last;
      else
        runs.push_back({i, i + 1});
    }
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns the voxels inside of a surface.
///
/// A voxel is inside if at least three of the six rays from its centre along the axes leave
/// the surface more often than they enter it. On a closed surface all six agree and this is the
/// positive winding number; with parts missing it is an approximation, and `coverage` tells how
/// much was missing. The triangles must face outward: the interior of a closed surface that faces inward is empty.
///
/// Complexity: linear in the number of grid lines through the bounding rectangles of the faces, and
/// `O(n log n)` for `n` faces; for surfaces that are not
/// closed one byte for each voxel of the grid, while it runs.
inline Interior interior(const Triangle_surface& surface, const Grid_3& grid)
{
  const double voxel_volume = grid.spacing() * grid.spacing() * grid.spacing();
  if(internal::is_closed(surface)) {
    Row_spans region = internal::interior_of_closed(surface, grid);
    const double volume = voxel_volume * double(region.number_of_voxels());
    return {std::move(region), 1., volume};
  }

  std::vector<std::uint8_t> votes(grid.number_of_voxels(), 0);
  const std::array<std::size_t, 3> step{1, std::size_t(grid.size()[0]),
                                        std::size_t(grid.size()[0]) * grid.size()[1]};
  for(int axis = 0; axis < 3; ++axis) {
    const internal::Signed_crossings crossings(surface, grid, axis);
    internal::vote_along_axis(
        crossings, grid, axis, [&](int u, int v, int first, int last, int number) {
          const std::size_t line = u * step[(axis + 1) % 3] + v * step[(axis + 2) % 3];
          for(int i = first; i < last; ++i)
            votes[line + i * step[axis]] += std::uint8_t(number);
        });
  }
  constexpr int majority = 3;
  std::size_t sum_of_votes = 0;
  Row_spans region(grid, [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    const std::uint8_t* of_row = votes.data() + row * step[1];
    internal::append_runs(
        grid.size()[0], [&](int i) { return of_row[i] >= majority; }, runs);
    for(const Row_spans::Run& run : runs)
      for(int i = run.first; i < run.last; ++i)
        sum_of_votes += of_row[i];
  });
  const std::size_t voxels = region.number_of_voxels();
  return {std::move(region), voxels == 0 ? 0. : double(sum_of_votes) / (6. * double(voxels)),
          voxel_volume * double(voxels)};
}

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns the voxels within `distance` of a surface, on either side.
///
/// \param distance in the units of the surface
///
/// The surface is sampled at half a voxel, so a voxel may be missed whose distance is less by up to
/// six tenths of a voxel. A point set is taken as it is.
/// \tparam Source a model of `SurfelSource`
/// \throw std::invalid_argument if `distance` is not positive.
template <class Source>
Row_spans band(const Source& surface, const Grid_3& grid, double distance)
{
  if(!(distance > 0) || !std::isfinite(distance))
    throw std::invalid_argument("distance is " + std::to_string(distance) +
                                ": must be positive and finite");
  const Row_spans everything(grid);
  const double radius = distance / grid.spacing();
  internal::Run_accumulator counts(everything, internal::Ball_stencil::padding(radius));
  const internal::Ball_stencil ball(radius, counts.stride());
  surface.for_each_batch(0.5 * grid.spacing(), [&](const Surfels& batch) {
    for(const Point_3& p : batch.positions) {
      const internal::Lattice_place place(grid, 1 / grid.spacing(), p,
                                          internal::Ball_stencil::margin(radius));
      if(!place.is_out_of_reach)
        internal::add_ball(counts, ball, place, 1);
    }
  });
  std::vector<float> row_counts(std::size_t(grid.size()[0]));
  return Row_spans(grid, [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    counts.take_row(row, 1., row_counts.data());
    internal::append_runs(
        grid.size()[0], [&](int i) { return row_counts[i] > 0; }, runs);
  });
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_REGIONS_H
