// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_NEIGHBOURS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_NEIGHBOURS_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the positions among points, each once and in lexicographic order.
///
/// A tree of many equal points, such as the zeros that scanners return, is deep and slow; and what
/// is computed in this order does not depend on that of the input.
struct Distinct_points
{
  std::vector<Point_3> positions;
  std::vector<std::size_t> index_of; ///< of each point among the positions

  explicit Distinct_points(const std::vector<Point_3>& points) : index_of(points.size())
  {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
    for(std::size_t i : order) {
      if(positions.empty() || positions.back() != points[i])
        positions.push_back(points[i]);
      index_of[i] = positions.size() - 1;
    }
  }
};

/// \brief finds the nearest neighbours of points among themselves, in several threads if need be.
///
/// The points must stay where they are for as long as they are asked for.
class Point_neighbours
{
  using Index_map = typename Pointer_property_map<Point_3>::const_type;
  using Traits = Search_traits_adapter<std::size_t, Index_map, Search_traits_3<Kernel>>;
  using Search = Orthogonal_k_neighbor_search<Traits>;

public:
  struct Neighbour
  {
    double squared_distance;
    std::size_t index;
  };

  explicit Point_neighbours(const std::vector<Point_3>& points)
      : m_points(points)
      , m_tree(boost::counting_iterator<std::size_t>(0),
               boost::counting_iterator<std::size_t>(points.size()), typename Search::Splitter(),
               Traits(make_property_map(points)))
  {
    m_tree.build(); // now, because a search that builds it cannot share it with another
  }

  /// finds the `number` points nearest to the point `index` other than itself, or all if there are
  /// fewer, from near to far.
  void find(std::size_t index, std::size_t number, std::vector<Neighbour>& found) const
  {
    // One more, because the point itself is found too.
    const unsigned number_with_itself = unsigned(std::min(number, m_points.size() - 1) + 1);
    Search search(m_tree, m_points[index], number_with_itself, 0, true,
                  typename Search::Distance(make_property_map(m_points)));
    found.clear();
    for(const auto& [other, squared_distance] : search)
      if(other != index && found.size() < number)
        found.push_back({squared_distance, other});
    std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
      return std::tie(a.squared_distance, a.index) < std::tie(b.squared_distance, b.index);
    });
  }

private:
  const std::vector<Point_3>& m_points;
  typename Search::Tree m_tree;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_POINT_NEIGHBOURS_H
