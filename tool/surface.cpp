// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface.h"

#include <CGAL/Area_projection_transform/surfels_from_points.h>

#include <algorithm>
#include <numeric>

namespace mapt {

namespace {

// The files may leave the areas out: then they come from the density of the points.
std::vector<double> areas_of_points(const Input& input)
{
  if(!input.areas.empty())
    return input.areas;
  constexpr std::size_t neighbours = 12;
  if(input.points.size() < 2)
    throw Input_error(input.file + ": has one point, without an area: give it one, or give more "
                                   "points");
  const std::size_t k = std::min(neighbours, input.points.size() - 1);
  std::vector<double> areas = AP::areas_from_density(input.points, unsigned(k));
  if(!(std::accumulate(areas.begin(), areas.end(), 0.) > 0))
    throw Input_error(input.file + ": its points coincide, so that they have no density: give them "
                                   "areas, or remove the copies");
  return areas;
}

AP::Surfels surfels_of(const Input& input)
{
  AP::Surfels surfels;
  surfels.positions = input.points;
  surfels.normals = input.normals;
  surfels.areas = areas_of_points(input);
  surfels.sources.resize(input.points.size());
  std::iota(surfels.sources.begin(), surfels.sources.end(), 0u);
  return surfels;
}

} // namespace

Surface make_surface(const Input& input, bool use_interpolated_normals)
{
  if(input.is_point_set)
    return std::make_shared<const AP::Constant_scale_space<AP::Surfels>>(surfels_of(input));
  return std::make_shared<const AP::Constant_scale_space<AP::Triangle_surface>>(
      AP::surface_from_triangle_soup(
          input.points, input.triangles,
          AP::parameters::use_interpolated_normals(use_interpolated_normals)));
}

double area_of(const Surface& surface)
{
  return std::visit([](const auto& s) { return s->area(0); }, surface);
}

} // namespace mapt
