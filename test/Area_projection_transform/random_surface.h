// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_RANDOM_SURFACE_H
#define AREA_PROJECTION_TRANSFORM_TEST_RANDOM_SURFACE_H

// Random surfaces with the defects that meshes of users have.

#include "shapes.h"

namespace shapes {

inline Soup random_shape(Random& random)
{
  switch(int(random(0, 6))) {
  case 0:
    return blob(int(random(0, 3)), std::uint64_t(random(0, 1e9)));
  case 1:
    return cylinder(int(random(3, 16)), random(0.1, 0.8), random(0.5, 3), random() < 0.5, 4);
  case 2:
    return torus(1, random(0.1, 0.9), int(random(3, 20)), int(random(3, 12)));
  case 3:
    return cone(int(random(3, 16)), random(0.2, 1), random(0.2, 2), 4);
  case 4:
    return plane_patch(random(0.5, 2), random(-1, 1));
  default:
    return fine_box({random(0.1, 2), random(0.1, 2), random(0.1, 2)}, 0.5);
  }
}

inline std::uint32_t random_point_of(const Soup& soup, Random& random)
{
  return std::uint32_t(random(0, double(soup.points.size())));
}

/// \name Defects
/// @{

/// faces that are turned over: neighbours disagree.
inline Soup with_mixed_orientation(Soup soup, Random& random)
{
  for(Triangle& t : soup.triangles)
    if(random() < 0.3)
      std::swap(t[0], t[1]);
  return soup;
}

/// faces without extent: points named twice, at the same place, or on a line.
inline Soup with_degenerate_faces(Soup soup, Random& random)
{
  for(int i = 0; i < 5; ++i) {
    const std::uint32_t a = random_point_of(soup, random), b = random_point_of(soup, random);
    const std::uint32_t next = std::uint32_t(soup.points.size());
    soup.points.push_back(soup.points[a]);
    soup.points.push_back(CGAL::midpoint(soup.points[a], soup.points[b]));
    soup.triangles.insert(soup.triangles.end(), {{a, a, b}, {a, next, b}, {a, next + 1, b}});
  }
  return soup;
}

/// edges with three faces and more, and faces that are there twice.
inline Soup with_nonmanifold_edges(Soup soup, Random& random)
{
  for(int i = 0; i < 5; ++i) {
    const Triangle t = soup.triangles[std::size_t(random(0, double(soup.triangles.size())))];
    soup.triangles.push_back(t);
    soup.triangles.push_back({t[0], t[1], random_point_of(soup, random)});
  }
  return soup;
}

/// points that no face uses, some of them far away.
inline Soup with_unused_points(Soup soup, Random& random)
{
  for(int i = 0; i < 5; ++i)
    soup.points.push_back(CGAL::ORIGIN + std::exp(random(0, 20)) * random.direction());
  return soup;
}

/// @}

/// a shape with about two of the seven defects: holes, another part that may intersect the first, noise, and those above.
inline Soup random_surface(Random& random)
{
  Soup soup = random_shape(random);
  const auto has = [&] { return random() < 0.3; };
  if(has())
    soup = joined(soup, translated(random_shape(random), random(0, 1.5) * random.direction()));
  if(has())
    soup = displaced(soup, 0.1, std::uint64_t(random(0, 1e9)));
  if(has())
    soup = with_nonmanifold_edges(soup, random);
  if(has())
    soup = with_mixed_orientation(soup, random);
  if(has())
    soup = with_degenerate_faces(soup, random);
  if(has())
    soup = with_unused_points(soup, random);
  if(has()) {
    const Soup holed = thinned(soup, 0.6, std::uint64_t(random(0, 1e9)));
    soup = holed.triangles.empty() ? soup : holed;
  }
  return soup;
}

} // namespace shapes

#endif // AREA_PROJECTION_TRANSFORM_TEST_RANDOM_SURFACE_H
