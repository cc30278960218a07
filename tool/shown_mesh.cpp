// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shown_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace mapt {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Numbers the points that triangles use from 0 on, in the order in which they are met.
class Renumbering
{
public:
  explicit Renumbering(std::size_t points) : m_number(points, unused) {}

  std::uint32_t operator()(std::uint32_t point)
  {
    if(m_number[point] == unused) {
      m_number[point] = std::uint32_t(m_points.size());
      m_points.push_back(point);
    }
    return m_number[point];
  }

  const std::vector<std::uint32_t>& points() const { return m_points; }

private:
  static constexpr std::uint32_t unused = std::uint32_t(-1);
  std::vector<std::uint32_t> m_number, m_points;
};

// For each point the first one in its cube.
std::vector<std::uint32_t> first_in_cube(const Input& input, double side)
{
  const CGAL::Bbox_3& box = input.report.bounding_box;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for(std::uint32_t i = 0; i < input.points.size(); ++i) {
    std::array<std::int64_t, 3> cube;
    for(int axis = 0; axis < 3; ++axis)
      cube[axis] = std::int64_t(std::floor((input.points[i][axis] - box.min(axis)) / side));
    result.push_back(first.emplace(cube, i).first->second);
  }
  return result;
}

// What is left of the triangles when points are replaced: those that do not collapse, once each.
std::vector<Triangle> joined_triangles(const Input& input, const std::vector<std::uint32_t>& joined)
{
  std::set<Triangle> seen;
  std::vector<Triangle> result;
  for(const Triangle& triangle : input.triangles) {
    const Triangle t{joined[triangle[0]], joined[triangle[1]], joined[triangle[2]]};
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if(sorted[0] != sorted[1] && sorted[1] != sorted[2] && seen.insert(sorted).second)
      result.push_back(t);
  }
  return result;
}

Shown_mesh thinned_points(const Input& input, std::size_t most)
{
  const std::size_t stride = (input.points.size() + most - 1) / most;
  Shown_mesh mesh;
  for(std::size_t i = 0; i < input.points.size(); i += stride)
    mesh.points.push_back(input.points[i]);
  return mesh;
}

} // namespace

Shown_mesh shown_mesh(const Input& input, std::size_t most_faces)
{
  if(input.triangles.empty())
    return thinned_points(input, most_faces);
  Shown_mesh mesh;
  mesh.triangles = input.triangles;
  if(mesh.triangles.size() > most_faces) {
    // A cube holds about two triangles when its side is that of a face of the coarse mesh. Of slivers all area may
    // be next to nothing.
    const CGAL::Bbox_3& box = input.report.bounding_box;
    mesh.joined_within = std::max(std::sqrt(input.report.area / double(most_faces)),
                                  1e-5 * std::max({box.x_span(), box.y_span(), box.z_span()}));
    while((mesh.triangles = joined_triangles(input, first_in_cube(input, mesh.joined_within)))
              .size() > most_faces)
      mesh.joined_within *= 1.2;
  }
  Renumbering renumbering(input.points.size());
  for(Triangle& triangle : mesh.triangles)
    for(std::uint32_t& point : triangle)
      point = renumbering(point);
  for(const std::uint32_t point : renumbering.points())
    mesh.points.push_back(input.points[point]);
  return mesh;
}

} // namespace mapt
