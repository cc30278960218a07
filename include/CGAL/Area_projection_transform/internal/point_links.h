// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/internal/Heat_flow.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the flow of heat between neighbouring surfels.
///
/// Each surfel is linked with its nearest ones that face the same way, so that the two sides of a thin
/// sheet stay apart. Links are as strong as makes the second differences of the surfel and its
/// neighbours, on a plane, those of the Laplacian: `Σ w (u_j − u_i) = area Δu` for a quadratic `u`.
inline Heat_flow flow_between_elements(const Surfels& surfels)
{
  using Index_map = typename Pointer_property_map<Point_3>::const_type;
  using Traits = Search_traits_adapter<std::size_t, Index_map, Search_traits_3<Kernel>>;
  using Search = Orthogonal_k_neighbor_search<Traits>;
  constexpr unsigned number_of_neighbours = 8;

  const Index_map map = make_property_map(surfels.positions);
  const Traits traits(map);
  typename Search::Tree tree(boost::counting_iterator<std::size_t>(0),
                             boost::counting_iterator<std::size_t>(surfels.size()),
                             typename Search::Splitter(), traits);
  tree.build();
  Heat_flow::Links links(surfels.size());
  std::vector<std::size_t> neighbours;
  for(std::size_t i = 0; i < surfels.size(); ++i) {
    Search search(tree, surfels.positions[i], number_of_neighbours + 1, 0, true,
                  typename Search::Distance(map));
    neighbours.clear();
    double squared_distances = 0;
    for(const auto& [j, squared] : search)
      if(j != i && surfels.normals[i] * surfels.normals[j] > 0) {
        neighbours.push_back(j);
        squared_distances += squared;
      }
    // Half from either end, as links go both ways.
    if(squared_distances > 0)
      for(std::size_t j : neighbours)
        links.add(i, j, 2 * surfels.areas[i] / squared_distances);
  }
  return Heat_flow(surfels.areas, std::move(links));
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_LINKS_H
