// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_SOUP_H
#define AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_SOUP_H

// Small triangle soups from bytes: of nothing but bytes, or known shapes that bytes have damaged.

#include "../Area_projection_transform/shapes.h"
#include "fuzz.h"

namespace fuzz {

/// how the coordinates of a soup are made: on a lattice (much coincides), in a cube, or of any size.
enum class Coordinates { LATTICE, CUBE, ANY };

inline double coordinate(Bytes& bytes, Coordinates kind)
{
  switch(kind) {
  case Coordinates::LATTICE:
    return int(bytes.byte() % 16) - 8;
  case Coordinates::CUBE:
    return 8 * bytes.fraction();
  case Coordinates::ANY:
    break;
  }
  // Most of what is larger would be refused.
  const double any = bytes.any();
  return std::abs(any) > 1e80 ? any * 1e-230 : any;
}

inline shapes::Point_3 point(Bytes& bytes, Coordinates kind)
{
  const double x = coordinate(bytes, kind), y = coordinate(bytes, kind);
  return {x, y, coordinate(bytes, kind)};
}

/// up to 16 points and 32 triangles, which may be degenerate or name a point that there is not.
inline shapes::Soup raw_soup(Bytes& bytes, Coordinates kind)
{
  shapes::Soup soup;
  const std::size_t points = bytes.choice(16) + 1, triangles = bytes.choice(32) + 1;
  for(std::size_t i = 0; i < points; ++i)
    soup.points.push_back(point(bytes, kind));
  for(std::size_t t = 0; t < triangles; ++t) {
    shapes::Triangle triangle;
    for(std::uint32_t& v : triangle) {
      const std::uint8_t index = bytes.byte();
      v = index == 255 ? std::uint32_t(points) : std::uint32_t(index % points);
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

inline shapes::Soup known_shape(Bytes& bytes)
{
  switch(bytes.choice(6)) {
  case 0:
    return shapes::icosphere(1);
  case 1:
    return shapes::icosphere(2);
  case 2:
    return shapes::cylinder(8, 1, 6, bytes.choice(2) == 1, 6);
  case 3:
    return shapes::torus(2, 0.7, 12, 8);
  case 4:
    return shapes::joined(shapes::icosphere(1), shapes::icosphere(1, {0.8, 0.3, 0.1}, 0.7));
  default:
    return shapes::fine_box({1, 2, 3}, 1);
  }
}

/// a shape from which faces are taken, turned over or doubled, and points moved a little, far or together.
inline shapes::Soup damaged_soup(Bytes& bytes)
{
  shapes::Soup soup = known_shape(bytes);
  while(!bytes.empty() && !soup.triangles.empty()) {
    const std::size_t damage = bytes.choice(8);
    shapes::Triangle& face =
        soup.triangles[(bytes.byte() + 256u * bytes.byte()) % soup.triangles.size()];
    shapes::Point_3& corner = soup.points[face[0]];
    if(damage == 0)
      soup.triangles.push_back(face);
    else if(damage == 1)
      std::swap(face[0], face[1]);
    else if(damage == 2)
      corner = soup.points[face[1]];
    else if(damage == 3)
      corner = corner + 0.2 * (point(bytes, Coordinates::CUBE) - CGAL::ORIGIN);
    else if(damage == 4)
      corner = point(bytes, Coordinates::LATTICE);
    else if(damage == 5)
      face[2] = std::uint32_t(bytes.byte() % soup.points.size());
    else {
      std::swap(face, soup.triangles.back());
      soup.triangles.pop_back();
    }
  }
  return soup;
}

} // namespace fuzz

#endif // AREA_PROJECTION_TRANSFORM_FUZZ_FUZZ_SOUP_H
