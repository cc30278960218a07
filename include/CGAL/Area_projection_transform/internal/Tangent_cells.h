// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TANGENT_CELLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TANGENT_CELLS_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/Oriented_places.h>
#include <CGAL/Area_projection_transform/internal/Tangent_cell.h>
#include <CGAL/Area_projection_transform/internal/point_neighbours.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the areas of the Voronoi cells of places, each in its tangent plane.
///
/// They are asked for in two rounds, each of which may share the work among threads.
class Tangent_cells
{
public:
  /// what a thread works with.
  struct Scratch
  {
    Tangent_cell cell;
    std::vector<Point_neighbours::Neighbour> found;
    std::vector<double> areas;
  };

  /// \param places at two positions at least; they must stay where they are
  /// \param k the number of neighbours, at least 3
  Tangent_cells(const Oriented_places& places, std::size_t k)
      : m_places(places)
      , m_neighbours(places.positions)
      , m_number(std::min(k, places.positions.size() - 1))
  {}

  /// returns the area of the cell of a place, or NaN if its neighbours do not close it.
  double closed_area(std::size_t place, Scratch& scratch) const
  {
    // Where the density changes, and along the lines of scanners, the nearest are all to one side. What
    // closes a cell then must not be two points of a border, which meet in a spike far outside.
    constexpr double spike =
        3; // 2 takes cells of random points for spikes, 4 takes spikes for cells
    for(const std::size_t times : {1, 4, 16}) {
      m_neighbours.find(place, times * m_number, scratch.found);
      // Who is not among them takes away nothing that is nearer than half the way to the last.
      const double squared_radius = scratch.found.back().squared_distance / 4;
      cut(place, std::sqrt(squared_radius), scratch);
      if(scratch.cell.squared_reach() <= squared_radius &&
         (times == 1 || !scratch.cell.has_spike(spike)))
        return scratch.cell.area();
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// returns the area of the cell of a place within a disk that is as large as the closed cells nearby
  /// are in the median.
  /// \param closed_areas what `closed_area()` returned for all places
  double open_area(std::size_t place, const std::vector<double>& closed_areas,
                   Scratch& scratch) const
  {
    m_neighbours.find(place, m_number, scratch.found);
    cut(place, Tangent_cell::radius_of_area(area_nearby(place, closed_areas, scratch)), scratch);
    return scratch.cell.area();
  }

private:
  // Edges often have a right angle: rounding must not decide.
  bool is_on_same_side(std::size_t place, std::size_t other) const
  {
    return m_places.normals[place] * m_places.normals[other] > 1e-6;
  }

  void cut(std::size_t place, double radius, Scratch& scratch) const
  {
    const Vector_3& normal = m_places.normals[place];
    scratch.cell.begin(normal, radius);
    for(const Point_neighbours::Neighbour& neighbour : scratch.found)
      if(is_on_same_side(place, neighbour.index)) {
        const Vector_3 offset = m_places.positions[neighbour.index] - m_places.positions[place];
        // A chord over the angle a of a circle makes the angle a/2 with the tangent: the projection
        // would shorten it by the cosine.
        const double cosine = std::min(1., normal * m_places.normals[neighbour.index]);
        scratch.cell.cut(offset / std::sqrt((1 + cosine) / 2));
      }
  }

  // Counts neighbours on the same side, or all where nobody else looks to that side; but not who is back
  // to back with the place.
  double area_nearby(std::size_t place, const std::vector<double>& closed_areas,
                     Scratch& scratch) const
  {
    std::vector<Point_neighbours::Neighbour>& found = scratch.found;
    const auto drop = [&](const auto& predicate) {
      found.erase(std::remove_if(found.begin(), found.end(), predicate), found.end());
    };
    const auto is_other_side = [&](const Point_neighbours::Neighbour& neighbour) {
      return !is_on_same_side(place, neighbour.index);
    };
    drop([](const Point_neighbours::Neighbour& n) { return n.squared_distance == 0; });
    if(!std::all_of(found.begin(), found.end(), is_other_side))
      drop(is_other_side);
    if(found.empty()) // all are nearer than the square of a number can tell
      return 0;
    scratch.areas.clear();
    for(const Point_neighbours::Neighbour& neighbour : found)
      if(!std::isnan(closed_areas[neighbour.index]))
        scratch.areas.push_back(closed_areas[neighbour.index]);
    if(2 * scratch.areas.size() < found.size()) // the closed ones are the small ones
      return area_by_count(found);
    const auto median = scratch.areas.begin() + std::ptrdiff_t(scratch.areas.size() / 2);
    std::nth_element(scratch.areas.begin(), median, scratch.areas.end());
    return *median;
  }

  // A disk up to the sixth neighbour holds the point, five of them, and half of the last.
  static double area_by_count(const std::vector<Point_neighbours::Neighbour>& found)
  {
    const std::size_t number = std::min(found.size(), std::size_t(6));
    return 3.14159265358979323846 * found[number - 1].squared_distance / (double(number) + 0.5);
  }

  const Oriented_places& m_places;
  Point_neighbours m_neighbours;
  std::size_t m_number;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TANGENT_CELLS_H
