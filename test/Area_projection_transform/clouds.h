// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_CLOUDS_H
#define AREA_PROJECTION_TRANSFORM_TEST_CLOUDS_H

#include "shapes.h"

#include <CGAL/Area_projection_transform/areas_from_density.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace clouds {

using CGAL::Area_projection::Point_3;
using CGAL::Area_projection::Vector_3;

/// points with their true normals.
struct Cloud
{
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;

  void push_back(const Point_3& point, const Vector_3& normal)
  {
    points.push_back(point);
    normals.push_back(normal);
  }

  std::vector<double> areas() const
  {
    return CGAL::Area_projection::areas_from_density(points, normals);
  }

  /// the sum of the areas of the points for which `is_counted(point)` holds.
  template <class Predicate>
  double area_where(Predicate is_counted) const
  {
    const std::vector<double> all = areas();
    double sum = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(is_counted(points[i]))
        sum += all[i];
    return sum;
  }

  double area() const
  {
    return area_where([](const Point_3&) { return true; });
  }
};

inline Cloud joined(Cloud a, const Cloud& b)
{
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  return a;
}

/// points of a sphere that are independent and uniform, but for the directions for which
/// `is_left_out(direction)` holds.
template <class Predicate>
Cloud sphere_without(int number, std::uint64_t seed, Predicate is_left_out,
                     const Point_3& center = Point_3(0, 0, 0), double radius = 1)
{
  shapes::Random random(seed);
  Cloud cloud;
  while(int(cloud.points.size()) < number) {
    const Vector_3 d = random.direction();
    if(!is_left_out(d))
      cloud.push_back(center + radius * d, d);
  }
  return cloud;
}

inline Cloud sphere(int number, std::uint64_t seed, const Point_3& center = Point_3(0, 0, 0),
                    double radius = 1)
{
  return sphere_without(
      number, seed, [](const Vector_3&) { return false; }, center, radius);
}

/// `n` by `n` points `i*a + j*b`, facing up.
inline Cloud lattice(int n, const Vector_3& a, const Vector_3& b)
{
  Cloud cloud;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      cloud.push_back(CGAL::ORIGIN + i * a + j * b, Vector_3(0, 0, 1));
  return cloud;
}

/// random points of the unit square at a height, facing up or down.
inline Cloud square(int number, std::uint64_t seed, double height, double up)
{
  shapes::Random random(seed);
  Cloud cloud;
  for(int i = 0; i < number; ++i)
    cloud.push_back(random.point_in(CGAL::Bbox_3(0, 0, height, 1, 1, height)), Vector_3(0, 0, up));
  return cloud;
}

/// few places and normals, so that copies, lines, planes and stacks abound.
inline Cloud rubble(int number, std::uint64_t seed)
{
  shapes::Random random(seed);
  const int width = 1 + int(random(0, 5));
  const auto coordinate = [&] { return std::floor(random(0, width)); };
  Cloud cloud;
  while(int(cloud.points.size()) < number) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const double u = coordinate(), v = coordinate();
    cloud.push_back(Point_3(x, y, z), Vector_3(u - 1, v - 1, coordinate() + 0.5));
  }
  return cloud;
}

} // namespace clouds

#endif // AREA_PROJECTION_TRANSFORM_TEST_CLOUDS_H
