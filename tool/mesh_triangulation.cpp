// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <set>
#include <utility>

namespace mapt {

namespace {

using Corners = std::vector<std::uint32_t>;

// Newell's normal: twice the area of the polygon's shadow, also if it is not planar or not convex.
Vector_3 polygon_normal(const std::vector<Point_3>& points, const Corners& corners)
{
  Vector_3 normal(0, 0, 0);
  const Point_3& first = points[corners[0]];
  for(std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal =
        normal + CGAL::cross_product(points[corners[i]] - first, points[corners[i + 1]] - first);
  return normal;
}

// Returns the worst triangle of the fan from corner `apex`: its smallest normal component along the
// polygon's normal. If that is positive the fan is a triangulation.
double worst_of_fan(const std::vector<Point_3>& points, const Corners& corners,
                    const Vector_3& normal, std::size_t apex)
{
  const std::size_t n = corners.size();
  const Point_3& p = points[corners[apex]];
  double worst = std::numeric_limits<double>::infinity();
  for(std::size_t i = 1; i + 1 < n; ++i)
    worst = std::min(worst, CGAL::cross_product(points[corners[(apex + i) % n]] - p,
                                                points[corners[(apex + i + 1) % n]] - p) *
                                normal);
  return worst;
}

void add_fan(const Corners& corners, std::size_t apex, std::vector<Triangle>& triangles)
{
  const std::size_t n = corners.size();
  for(std::size_t i = 1; i + 1 < n; ++i)
    triangles.push_back({corners[apex], corners[(apex + i) % n], corners[(apex + i + 1) % n]});
}

// The constrained Delaunay triangulation of the shadow of a polygon.
class Shadow
{
  using K = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, K>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<K>;
  using Data_structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<K, Data_structure>;

public:
  // `normal` is counted along its largest coordinate: dropping that one rounds nothing
  Shadow(const std::vector<Point_3>& points, const Corners& corners, const Vector_3& normal)
      : m_corners(corners)
  {
    int axis = 0;
    for(int i = 1; i < 3; ++i)
      if(std::abs(normal[i]) > std::abs(normal[axis]))
        axis = i;
    const bool is_upward = normal[axis] > 0;
    const int u = (axis + (is_upward ? 1 : 2)) % 3;
    const int v = (axis + (is_upward ? 2 : 1)) % 3;
    std::vector<Delaunay::Vertex_handle> handles;
    for(std::size_t i = 0; i < corners.size(); ++i) {
      const Point_3& p = points[corners[i]];
      handles.push_back(m_delaunay.insert(K::Point_2(p[u], p[v])));
      handles.back()->info() = i;
    }
    // not if the shadow is a line or touches itself in a corner
    m_is_usable = m_delaunay.dimension() == 2 && m_delaunay.number_of_vertices() == corners.size();
    for(std::size_t i = 0; m_is_usable && i < handles.size(); ++i)
      m_delaunay.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
  }

  // the triangles that cannot be reached from outside without crossing the polygon
  std::vector<Triangle> triangles() const
  {
    if(!m_is_usable)
      return {};
    std::set<Delaunay::Face_handle> outside{m_delaunay.infinite_face()};
    std::vector<Delaunay::Face_handle> front(outside.begin(), outside.end());
    while(!front.empty()) {
      const Delaunay::Face_handle face = front.back();
      front.pop_back();
      for(int i = 0; i < 3; ++i)
        if(!face->is_constrained(i) && outside.insert(face->neighbor(i)).second)
          front.push_back(face->neighbor(i));
    }
    std::vector<Triangle> found;
    for(const Delaunay::Face_handle face : m_delaunay.finite_face_handles())
      if(outside.count(face) == 0)
        found.push_back({corner(face, 0), corner(face, 1), corner(face, 2)});
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  std::uint32_t corner(Delaunay::Face_handle face, int i) const
  {
    return m_corners[face->vertex(i)->info()];
  }

  const Corners& m_corners;
  Delaunay m_delaunay;
  bool m_is_usable = false;
};

// A simple polygon of n corners has n - 2 triangles, in any triangulation; anything else is none.
bool add_shadow(const std::vector<Point_3>& points, const Corners& corners, const Vector_3& normal,
                std::vector<Triangle>& triangles)
{
  try {
    const std::vector<Triangle> found = Shadow(points, corners, normal).triangles();
    if(found.size() != corners.size() - 2)
      return false;
    triangles.insert(triangles.end(), found.begin(), found.end());
    return true;
  } catch(const std::exception&) { // sides that cross
    return false;
  }
}

void add_polygon(const std::vector<Point_3>& points, const Corners& corners,
                 std::vector<Triangle>& triangles)
{
  if(corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  constexpr std::size_t most_fans = 8; // of small polygons take the best fan, of others any good
  const Vector_3 normal = polygon_normal(points, corners);
  std::size_t best_apex = 0;
  double best = 0;
  for(std::size_t apex = 0; apex < std::min(corners.size(), most_fans); ++apex) {
    const double worst = worst_of_fan(points, corners, normal, apex);
    if(worst > best) {
      best = worst;
      best_apex = apex;
    }
  }
  if(best > 0 || !add_shadow(points, corners, normal, triangles))
    add_fan(corners, best_apex, triangles);
}

// Leaves out corners that repeat the one before: exporters write triangles as such quads.
void copy_corners(const Polygons& polygons, std::size_t face, Corners& corners)
{
  corners.clear();
  for(std::size_t i = polygons.begin_of(face); i < polygons.ends[face]; ++i)
    if(corners.empty() || corners.back() != polygons.vertices[i])
      corners.push_back(polygons.vertices[i]);
  while(corners.size() > 1 && corners.front() == corners.back())
    corners.pop_back();
}

bool has_three_vertices(const Triangle& t)
{
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

} // namespace

Triangulation triangulate(const std::vector<Point_3>& points, const Polygons& polygons)
{
  Triangulation result;
  result.triangles.reserve(polygons.vertices.size() / 3);
  result.source_faces.reserve(polygons.vertices.size() / 3);
  Corners corners;
  for(std::size_t face = 0; face < polygons.size(); ++face) {
    copy_corners(polygons, face, corners);
    const std::size_t first = result.triangles.size();
    if(corners.size() >= 3)
      add_polygon(points, corners, result.triangles);
    result.polygons += corners.size() > 3 ? 1 : 0;
    result.triangles.erase(std::remove_if(result.triangles.begin() + std::ptrdiff_t(first),
                                          result.triangles.end(),
                                          [](const Triangle& t) { return !has_three_vertices(t); }),
                           result.triangles.end());
    result.source_faces.resize(result.triangles.size(), std::uint32_t(face));
  }
  return result;
}

} // namespace mapt
