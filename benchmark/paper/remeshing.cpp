// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remeshing.h"

#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <stdexcept>

namespace Paper {

Soup remeshed(const Soup& soup, double edge_length)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.triangles))
    throw std::invalid_argument("a surface that is no manifold cannot be remeshed");
  CGAL::Surface_mesh<Point_3> mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  PMP::isotropic_remeshing(mesh.faces(), edge_length, mesh,
                           CGAL::parameters::number_of_iterations(3));
  Soup result;
  PMP::polygon_mesh_to_polygon_soup(mesh, result.points, result.triangles);
  return result;
}

Point_3 turned(const Point_3& p, bool is_back)
{
  // Rodrigues' formula.
  const Vector_3 axis(2. / 3, 1. / 3, 2. / 3), v = p - CGAL::ORIGIN;
  const double angle = is_back ? -1.1 : 1.1, c = std::cos(angle), s = std::sin(angle);
  return CGAL::ORIGIN + (c * v + s * CGAL::cross_product(axis, v) + (1 - c) * (axis * v) * axis);
}

} // namespace Paper
