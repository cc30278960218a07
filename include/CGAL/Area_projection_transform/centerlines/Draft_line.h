// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DRAFT_LINE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DRAFT_LINE_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Line_ends.h>
#include <CGAL/Area_projection_transform/centerlines/measure_canal.h>
#include <CGAL/Area_projection_transform/centerlines/refine_chain.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a line of the result before it is joined with others.
struct Draft_line
{
  std::vector<Centerline_vertex> vertices; ///< a closed one does not repeat the first
  bool is_closed = false;
  std::array<Line_end, 2> ends; ///< at the front and at the back; of closed lines nothing
  /// for each point that was traced the vertex that is nearest.
  std::vector<std::uint32_t> vertex_of_point;

  /// the vertex in which an end is.
  std::size_t vertex_of_end(int end) const { return end == 0 ? 0 : vertices.size() - 1; }
};

/// measures a line that was traced, with vertices as dense as is wanted, and finds its ends.
template <class ConcurrencyTag>
Draft_line draft_line(const Sample_levels& levels, Traced_line line, double vertex_spacing)
{
  Draft_line draft;
  draft.is_closed = line.is_closed;
  const std::size_t number = line.points.size();
  const std::array<End_trimmer::Dropped, 2> dropped = End_trimmer::trim(line);
  std::vector<Centerline_vertex> measured(line.points.size());
  for_each_index<ConcurrencyTag>(
      measured.size(), [&](std::size_t i) { measured[i] = measure_canal(levels, line.points[i]); });
  draft.vertex_of_point.assign(dropped[0].points + 1, 0);
  draft.vertices.push_back(measured.front());
  for(std::size_t i = 1; i < measured.size(); ++i) {
    append_curve(measured[i - 1], measured[i], vertex_spacing, draft.vertices);
    draft.vertex_of_point.push_back(std::uint32_t(draft.vertices.size() - 1));
  }
  draft.vertex_of_point.resize(number, draft.vertex_of_point.back());
  if(line.is_closed) {
    append_curve(measured.back(), measured.front(), vertex_spacing, draft.vertices);
    draft.vertices.pop_back();
    return draft;
  }
  draft.ends[0] = End_finder::find(levels, line.points.front().canal.reversed(), dropped[0].length);
  draft.ends[1] = End_finder::find(levels, line.points.back().canal, dropped[1].length);
  return draft;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_DRAFT_LINE_H
