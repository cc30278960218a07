// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How do I use what my mesh already knows? Named parameters hand over points, normals and areas as
// property maps, of any mesh that models the concepts of the Boost Graph Library.

#include <CGAL/area_projection_transform.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <map>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using Face = boost::graph_traits<Mesh>::face_descriptor;
namespace AP = CGAL::Area_projection;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1.);

  // Normals that point from the centre, and areas that leave out what is below.
  std::map<Face, Kernel::Vector_3> normals;
  std::map<Face, double> areas;
  for(const Face f : faces(mesh)) {
    const auto h = f->halfedge();
    const Kernel::Point_3 center = CGAL::centroid(
        h->vertex()->point(), h->next()->vertex()->point(), h->next()->next()->vertex()->point());
    normals[f] = center - CGAL::ORIGIN;
    areas[f] = center.z() < 0 ? 0 : 1;
  }
  const auto own_normals =
      CGAL::parameters::face_normal_map(boost::make_assoc_property_map(normals));
  const auto own_areas = AP::parameters::face_area_map(boost::make_assoc_property_map(areas));

  const Kernel::Point_3 center(0, 0, 0);
  std::cout << "area at the centre: " << AP::area_projection_transform(mesh, center, 0.8, 0.7)
            << "\nwith own areas, one for each face above: "
            << AP::area_projection_transform(mesh, center, 0.8, 0.7,
                                             AP::parameters::combine(own_normals, own_areas))
            << "\non the outside: "
            << AP::area_projection_transform(
                   mesh, center, 0.8, 0.7,
                   AP::parameters::combine(own_areas, AP::parameters::side(AP::Side::OUTSIDE)))
            << '\n';
}
