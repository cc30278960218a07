// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ORIENTED_PLACES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ORIENTED_PLACES_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the different places of points with normals: at each position one, or two back to back. The
/// normal of a place is the mean of those of its points.
struct Oriented_places
{
  std::size_t number_of_positions = 0;
  std::vector<Point_3> positions;    ///< in lexicographic order
  std::vector<Vector_3> normals;     ///< unit vectors
  std::vector<std::size_t> copies;   ///< how many points each place stands for
  std::vector<std::size_t> index_of; ///< of each point among the places

  Oriented_places(const std::vector<Point_3>& points, const std::vector<Vector_3>& point_normals)
      : index_of(points.size())
  {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    // By the normals, too: sums must not depend on the order of the points.
    const auto key = [&](std::size_t i) {
      const Point_3& p = points[i];
      const Vector_3& n = point_normals[i];
      return std::make_tuple(p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
    for(std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      const Point_3& position = points[order[begin]];
      while(end < order.size() && points[order[end]] == position)
        ++end;
      add_position(order, begin, end, points, point_normals);
    }
  }

private:
  // The points `order[begin, end)` are at one position. The first of them tells the front from the back.
  void add_position(const std::vector<std::size_t>& order, std::size_t begin, std::size_t end,
                    const std::vector<Point_3>& points, const std::vector<Vector_3>& point_normals)
  {
    ++number_of_positions;
    const Vector_3& front = point_normals[order[begin]];
    for(const bool is_front : {true, false}) {
      Vector_3 sum(CGAL::NULL_VECTOR), last(CGAL::NULL_VECTOR);
      std::size_t number = 0;
      for(std::size_t o = begin; o < end; ++o) {
        const Vector_3& normal = point_normals[order[o]];
        if((normal * front > 0) != is_front)
          continue;
        index_of[order[o]] = positions.size();
        last = normal / std::sqrt(normal.squared_length());
        sum = sum + last;
        ++number;
      }
      if(number == 0)
        continue;
      const double length = std::sqrt(sum.squared_length());
      positions.push_back(points[order[begin]]);
      normals.push_back(length > 0.01 * double(number) ? sum / length : last); // do they cancel?
      copies.push_back(number);
    }
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ORIENTED_PLACES_H
