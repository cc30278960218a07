// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_location.h"

#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace Paper {

namespace AP = CGAL::Area_projection;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh_3 = CGAL::Surface_mesh<Point_3>;
using Shortest_path =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh_3>>;

Mesh_3 mesh_of(const Soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.triangles))
    throw std::invalid_argument("mesh is not a manifold: has no geodesic distances");
  Mesh_3 mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  return mesh;
}

/// the distances of the centroids of all faces from that of one, in the order of the faces, with the areas.
std::vector<std::pair<double, double>> distances_from(Mesh_3::Face_index source, const Mesh_3& mesh,
                                                      const std::vector<double>& areas,
                                                      Shortest_path& paths)
{
  const Shortest_path::Barycentric_coordinates centroid{1 / 3., 1 / 3., 1 / 3.};
  paths.remove_all_source_points();
  paths.add_source_point(source, centroid);
  std::vector<std::pair<double, double>> distances;
  for(const Mesh_3::Face_index face : mesh.faces()) {
    const double distance = paths.shortest_distance_to_source_points(face, centroid).first;
    if(!(distance >= 0))
      throw std::invalid_argument("mesh is in several parts: has no distances between them");
    distances.emplace_back(distance, areas[std::size_t(face)]);
  }
  return distances;
}

/// \param distances with the areas that they hold for
Distance_profile profile(std::vector<std::pair<double, double>> distances, double area)
{
  std::sort(distances.begin(), distances.end());
  Distance_profile quantiles;
  std::size_t next = 0;
  double nearer = distances[0].second;
  for(std::size_t q = 0; q < quantiles.size(); ++q) {
    const double wanted = area * (double(q) + 0.5) / double(quantiles.size());
    while(nearer < wanted && next + 1 < distances.size())
      nearer += distances[++next].second;
    quantiles[q] = distances[next].first / std::sqrt(area);
  }
  return quantiles;
}

} // namespace

double difference(const Distance_profile& a, const Distance_profile& b)
{
  double sum = 0;
  for(std::size_t q = 0; q < a.size(); ++q)
    sum += std::abs(a[q] - b[q]);
  return sum / double(a.size());
}

Surface_locations::Surface_locations(const Soup& soup)
    : m_surface(AP::surface_from_triangle_soup(soup.points, soup.triangles))
{
  const Mesh_3 mesh = mesh_of(soup);
  std::vector<double> areas;
  for(const Soup::Triangle& t : soup.triangles)
    areas.push_back(
        std::sqrt(CGAL::squared_area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]])));
  Shortest_path paths(mesh);
  for(const Mesh_3::Face_index face : mesh.faces())
    m_of_faces.push_back(profile(distances_from(face, mesh, areas, paths), area(soup)));
}

Distance_profile Surface_locations::of_point(const AP::Salient_point& point) const
{
  const double radius = point.scale, sigma = 0.5 * radius;
  Distance_profile mean{};
  double sum = 0;
  m_surface.for_each_batch(0.3 * sigma, [&](const AP::Surfels& batch) {
    for(std::size_t i = 0; i < batch.size(); ++i) {
      const Point_3 projected = batch.positions[i] - radius * batch.normals[i];
      if(CGAL::squared_distance(projected, point.position) > sigma * sigma)
        continue;
      sum += batch.areas[i];
      for(std::size_t q = 0; q < mean.size(); ++q)
        mean[q] += batch.areas[i] * m_of_faces[batch.sources[i]][q];
    }
  });
  if(!(sum > 0)) // the Gaussian alone made the point
    return m_of_faces[nearest_face(point.position)];
  for(double& quantile : mean)
    quantile /= sum;
  return mean;
}

std::size_t Surface_locations::nearest_face(const Point_3& p) const
{
  const auto distance = [&](std::size_t t) {
    return CGAL::squared_distance(
        p, CGAL::centroid(m_surface.corner(t, 0), m_surface.corner(t, 1), m_surface.corner(t, 2)));
  };
  std::size_t nearest = 0;
  for(std::size_t t = 1; t < m_surface.size(); ++t)
    if(distance(t) < distance(nearest))
      nearest = t;
  return m_surface.sources[nearest];
}

} // namespace Paper
