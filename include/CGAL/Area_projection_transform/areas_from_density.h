// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_AREAS_FROM_DENSITY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_AREAS_FROM_DENSITY_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/Oriented_places.h>
#include <CGAL/Area_projection_transform/internal/Tangent_cells.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_oriented_points(const std::vector<Point_3>& points,
                                  const std::vector<Vector_3>& normals)
{
  if(normals.size() != points.size())
    throw std::invalid_argument("normals has " + std::to_string(normals.size()) +
                                " elements: must have one for each of " +
                                std::to_string(points.size()) + " points");
  for(std::size_t i = 0; i < points.size(); ++i) {
    const std::string name = "point " + std::to_string(i);
    if(!std::isfinite(points[i].x() + points[i].y() + points[i].z()))
      throw std::invalid_argument(name + " is not finite");
    const double squared_length = normals[i].squared_length();
    if(!(squared_length > 0) || !std::isfinite(squared_length))
      throw std::invalid_argument(name + " has no normal: must be a finite vector other than zero");
  }
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns an estimate of the area around each point: that of its Voronoi cell in its tangent
/// plane.
///
/// Neighbours whose normal makes a right angle or more with that of the point do not count, so that the
/// two sides of a thin plate do not mix; the others are projected along the normal of the point, at
/// the distance that they would have on a sphere with the two normals. Where points end, at borders and
/// at gaps, a cell is cut off by a disk of the median area of the cells nearby: an outlier stands for
/// no more than a point of the surface. Copies of a point share one area, those that look to either side
/// apart.
///
/// Measured on points that are random and independent: the areas of 1000 points of a sphere sum to
/// its own up to 0.01 %, of 100 up to 0.2 %; of 2000 that are ten times as dense on one half
/// up to 0.2 %, and on either half, off the jump, up to 0.6 %; of 1000 points of a square, with its
/// borders, up to 0.3 %. Within lattices each cell is exact, at the border of a square one it reads
/// 7 % low. Noise along the normals is harmless up to the spacing of the points, where areas read 2 %
/// high; beyond that the points fill a layer, whose cells are not those of a surface. Fewer than about 40
/// points of a closed surface do not show its area: 20 of a sphere read a quarter low.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \param points the positions
/// \param normals their normals, of any length but zero, to the same side of the surface
/// \param k the number of neighbours that are looked at; four times and sixteen times as many where these
/// leave a cell open
/// \return the areas in the order of the points, in the squared unit of the positions
/// \throw std::invalid_argument if `k` is less than 3, there is not one normal for each point, a position
/// is not finite, a normal is null or not finite, or there are not two different positions.
///
/// Complexity: `O(n log n)`, for a fixed `k`; measured: 4 µs for each point, 70 µs for one at a border.
template <class ConcurrencyTag = CGAL::Sequential_tag>
std::vector<double> areas_from_density(const std::vector<Point_3>& points,
                                       const std::vector<Vector_3>& normals, unsigned k = 24)
{
  if(k < 3)
    throw std::invalid_argument("k is " + std::to_string(k) + ": must be at least 3");
  internal::check_oriented_points(points, normals);
  const internal::Oriented_places places(points, normals);
  if(places.number_of_positions < 2)
    throw std::invalid_argument("points has " + std::to_string(places.number_of_positions) +
                                " different positions: an estimate of areas needs at least 2");

  const internal::Tangent_cells cells(places, k);
  std::vector<double> areas_of_places(places.positions.size());
  const auto for_each_place = [&](const auto& work) {
    internal::run_workers<ConcurrencyTag>(
        areas_of_places.size(), [&](std::size_t worker, std::size_t workers) {
          internal::Tangent_cells::Scratch scratch;
          for(std::size_t p = worker; p < areas_of_places.size(); p += workers)
            work(p, scratch);
        });
  };
  for_each_place(
      [&](std::size_t p, auto& scratch) { areas_of_places[p] = cells.closed_area(p, scratch); });
  const std::vector<double> closed_areas = areas_of_places;
  for_each_place([&](std::size_t p, auto& scratch) {
    if(std::isnan(closed_areas[p]))
      areas_of_places[p] = cells.open_area(p, closed_areas, scratch);
  });

  std::vector<double> areas;
  areas.reserve(points.size());
  for(const std::size_t place : places.index_of)
    areas.push_back(areas_of_places[place] / double(places.copies[place]));
  return areas;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_AREAS_FROM_DENSITY_H
