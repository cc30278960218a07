// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ORIENT_NORMALS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ORIENT_NORMALS_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/areas_from_density.h>
#include <CGAL/Area_projection_transform/internal/Signed_sets.h>
#include <CGAL/Area_projection_transform/internal/point_neighbours.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// two points that are neighbours, and how much speaks against carrying the side of the surface over
/// from one to the other.
struct Normal_edge
{
  double doubt;
  std::size_t first, second;
  bool are_opposite;
};

/// \brief compares two unit normals across the chord between their points.
///
/// An arc of a circle over the chord has normals that are mirror images in the plane between the points:
/// what is left of the second normal, mirrored, is the doubt. Added is how steeply the chord stands on
/// both tangent planes, since then the points lie on sheets opposite to each other.
inline Normal_edge compare_normals(const std::vector<Point_3>& positions,
                                   const std::vector<Vector_3>& normals, std::size_t i,
                                   std::size_t j)
{
  const Vector_3 offset = positions[j] - positions[i];
  const Vector_3 chord = offset / std::sqrt(offset.squared_length());
  const double at_i = chord * normals[i], at_j = chord * normals[j];
  const double cosine = normals[i] * (normals[j] - 2 * at_j * chord);
  return {1 - std::abs(cosine) + at_i * at_i + at_j * at_j, i, j, cosine < 0};
}

/// \brief returns the sets of points whose normals agree with each other once those that are opposite
/// are turned over: the forest of the least doubts. Null normals are left alone.
inline Signed_sets carry_sides(const std::vector<Point_3>& positions,
                               const std::vector<Vector_3>& normals,
                               const Point_neighbours& neighbours, std::size_t k)
{
  constexpr double sheets =
      1.5; // faces that meet in a right angle have 1, sheets back to back have 2
  std::vector<Normal_edge> edges;
  std::vector<Point_neighbours::Neighbour> found;
  for(std::size_t i = 0; i < positions.size(); ++i) {
    if(normals[i] == CGAL::NULL_VECTOR)
      continue;
    neighbours.find(i, k, found);
    for(const Point_neighbours::Neighbour& neighbour : found) {
      if(normals[neighbour.index] == CGAL::NULL_VECTOR)
        continue;
      edges.push_back(compare_normals(positions, normals, i, neighbour.index));
      if(!(edges.back().doubt < sheets))
        edges.pop_back();
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Normal_edge& a, const Normal_edge& b) {
    return std::tie(a.doubt, a.first, a.second) < std::tie(b.doubt, b.first, b.second);
  });
  Signed_sets sets(positions.size());
  for(const Normal_edge& edge : edges)
    sets.join(edge.first, edge.second, edge.are_opposite);
  return sets;
}

/// \brief whether points face the side to which they are hollow: where their volume about their
/// centroid is negative. Flat ones have no such side: whether they face down.
template <class ConcurrencyTag>
bool faces_inward(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals)
{
  const std::vector<double> areas = areas_from_density<ConcurrencyTag>(points, normals);
  double area = 0, volume = 0, extent = 0;
  Vector_3 moment(CGAL::NULL_VECTOR), direction(CGAL::NULL_VECTOR);
  for(std::size_t i = 0; i < points.size(); ++i) {
    area += areas[i];
    moment = moment + areas[i] * (points[i] - points[0]);
    direction = direction + areas[i] * normals[i];
  }
  const Point_3 centroid = points[0] + moment / area;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Vector_3 arm = points[i] - centroid;
    volume += areas[i] * (arm * normals[i]);
    extent += areas[i] * std::sqrt(arm.squared_length());
  }
  if(std::abs(volume) > 0.01 * extent) // noise bends a plane less
    return volume < 0;
  const Vector_3 up(0.01, 0.1, 1); // no axis is level, so that rounding does not decide
  return direction * up < 0;
}

/// the points of each set, in ascending order, but for those with a null normal.
inline std::vector<std::vector<std::size_t>> parts_of(Signed_sets& sets,
                                                      const std::vector<Vector_3>& normals)
{
  std::vector<std::vector<std::size_t>> parts;
  std::vector<std::size_t> part_of(normals.size(), normals.size());
  for(std::size_t i = 0; i < normals.size(); ++i) {
    if(normals[i] == CGAL::NULL_VECTOR)
      continue;
    std::size_t& part = part_of[sets.find(i).set];
    if(part == normals.size()) {
      part = parts.size();
      parts.emplace_back();
    }
    parts[part].push_back(i);
  }
  return parts;
}

/// \brief turns unit normals outward, part by part, and returns the number of parts. Null normals are
/// left alone; those of parts of less than four points, which have no inside, become null.
template <class ConcurrencyTag>
std::size_t orient_normals(const std::vector<Point_3>& positions,
                           const Point_neighbours& neighbours, std::size_t k,
                           std::vector<Vector_3>& normals)
{
  Signed_sets sets = carry_sides(positions, normals, neighbours, k);
  std::size_t number_of_parts = 0;
  for(const std::vector<std::size_t>& part : parts_of(sets, normals)) {
    std::vector<Point_3> part_positions;
    std::vector<Vector_3> part_normals;
    for(const std::size_t i : part) {
      part_positions.push_back(positions[i]);
      part_normals.push_back(sets.find(i).is_opposite ? -normals[i] : normals[i]);
    }
    const bool has_inside = part.size() >= 4;
    const bool is_inward = has_inside && faces_inward<ConcurrencyTag>(part_positions, part_normals);
    for(std::size_t p = 0; p < part.size(); ++p)
      normals[part[p]] = !has_inside ? Vector_3(CGAL::NULL_VECTOR)
                         : is_inward ? -part_normals[p]
                                     : part_normals[p];
    number_of_parts += has_inside ? 1 : 0;
  }
  return number_of_parts;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ORIENT_NORMALS_H
