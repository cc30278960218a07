// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_orientation.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <utility>

namespace mapt {

namespace {

using Component = Mesh_topology::Component;

bool bounds_a_volume(const Component& c)
{
  return c.is_closed && c.is_consistently_oriented;
}

bool is_inside(const CGAL::Bbox_3& inner, const CGAL::Bbox_3& outer)
{
  for(int axis = 0; axis < 3; ++axis)
    if(!(outer.min(axis) < inner.min(axis) && inner.max(axis) < outer.max(axis)))
      return false;
  return true;
}

bool may_be_a_cavity(const Component& wall, const std::vector<Component>& components)
{
  return std::any_of(components.begin(), components.end(), [&wall](const Component& c) {
    return bounds_a_volume(c) && is_inside(wall.box, c.box);
  });
}

} // namespace

std::size_t orient_consistently(const std::vector<Point_3>& points,
                                const std::vector<std::uint32_t>& joined,
                                std::vector<Triangle>& triangles)
{
  // a copy, because vertices of non-manifold edges are duplicated where faces cannot agree
  std::vector<Point_3> soup_points = points;
  std::vector<std::vector<std::size_t>> soup;
  soup.reserve(triangles.size());
  for(const Triangle& t : triangles)
    soup.push_back({joined[t[0]], joined[t[1]], joined[t[2]]});
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup_points, soup);

  std::size_t turned = 0;
  for(std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle& v = triangles[t];
    const auto first = std::find_if(soup[t].begin(), soup[t].end(),
                                    [&](std::size_t i) { return soup_points[i] == points[v[0]]; });
    const std::size_t next = (std::size_t(first - soup[t].begin()) + 1) % 3;
    if(soup_points[soup[t][next]] != points[v[1]]) {
      std::swap(v[1], v[2]);
      ++turned;
    }
  }
  return turned;
}

void flip(std::vector<Triangle>& triangles)
{
  for(Triangle& t : triangles)
    std::swap(t[1], t[2]);
}

std::vector<bool> find_inward_components(const Mesh_topology& topology)
{
  double total = 0;
  for(const Component& c : topology.components)
    total += bounds_a_volume(c) ? c.volume : 0;
  const double sign = total < 0 ? -1 : 1;
  std::vector<bool> is_inward;
  for(const Component& c : topology.components) {
    const bool is_against_the_rest =
        sign * c.volume < 0 && !may_be_a_cavity(c, topology.components);
    is_inward.push_back(bounds_a_volume(c) && (sign < 0) != is_against_the_rest);
  }
  return is_inward;
}

std::size_t count_open_inward_components(const Mesh_topology& topology)
{
  // The isoperimetric quotient of the closed-up shape: 1 for a ball, 0.1 for a tube 20 times as
  // long as wide, and about 0 for a sheet, which has no inside. Nor has what is mostly hole.
  constexpr double least_quotient = 0.003;
  constexpr double largest_hole = 0.3; // of the area
  return std::size_t(
      std::count_if(topology.components.begin(), topology.components.end(), [](const Component& c) {
        const double quotient = 36 * CGAL_PI * c.volume * c.volume / (c.area * c.area * c.area);
        return !c.is_closed && c.is_consistently_oriented && c.volume < 0 &&
               quotient > least_quotient && c.hole_area < largest_hole * c.area;
      }));
}

void flip_components(const Mesh_topology& topology, const std::vector<bool>& is_chosen,
                     std::vector<Triangle>& triangles)
{
  for(std::size_t t = 0; t < triangles.size(); ++t)
    if(is_chosen[topology.component[t]])
      std::swap(triangles[t][1], triangles[t][2]);
}

} // namespace mapt
