// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MISSING_AREA_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MISSING_AREA_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/areas_from_density.h>
#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_samples.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// tells of each triangle whether one of its edges is on no other.
inline std::vector<bool> triangles_at_gaps(const Triangle_surface& surface)
{
  const std::vector<std::uint32_t> joined = joined_points(surface);
  std::vector<bool> is_at_gap(surface.size(), false);
  Edges_by_vertex(surface, [&joined](std::uint32_t i) {
    return joined[i];
  }).all_edges([&is_at_gap](std::uint32_t, const auto* begin, const auto* end) {
    if(end - begin == 1)
      is_at_gap[begin->face] = true;
    return true;
  });
  return is_at_gap;
}

/// \brief lets the samples beside gaps stand for what is missing there, too: each for the cell of what is nearer to it than
/// to the others.
///
/// Where single faces are missing the sum of areas is what it was. Of a hole that is larger than samples are apart
/// only a rim is filled, as wide as they are: what was there is not known. Samples that are not at a gap keep their areas.
template <class ConcurrencyTag>
void add_missing_area(Medial_samples& samples, const Triangle_surface& surface)
{
  const std::vector<bool> is_at_gap = triangles_at_gaps(surface);
  const auto differs = [&](const auto& p) { return p != samples.positions.front(); };
  if(std::find(is_at_gap.begin(), is_at_gap.end(), true) == is_at_gap.end() ||
     std::none_of(samples.positions.begin(), samples.positions.end(), differs))
    return;
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;
  for(std::size_t i = 0; i < samples.size(); ++i) {
    const Medial_samples::Vector &p = samples.positions[i], &n = samples.normals[i];
    points.emplace_back(p.x(), p.y(), p.z());
    normals.emplace_back(n.x(), n.y(), n.z());
  }
  const std::vector<double> cells = areas_from_density<ConcurrencyTag>(points, normals);
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(is_at_gap[samples.triangles[i]])
      samples.areas[i] = cells[i];
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MISSING_AREA_H
