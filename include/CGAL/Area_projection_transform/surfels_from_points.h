// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_POINTS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/parameters.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformInput
/// \brief returns an estimate of the area around each point, from the local density.
///
/// The `k` nearest neighbours of a point lie within a disk of the radius of the farthest of them;
/// that disk holds the point, `k - 1` neighbours, and the farthest on its rim, which counts half:
/// each has `π d_k² / (k + 1/2)` to itself. On a plane with uniformly random points the disk of
/// the `k`-th neighbour has on average the area of `k` points, and this reads `1/(2k + 1)` too low; on
/// regular lattices it reads up to an eighth too low at `k = 12`. Copies of a point share one area.
///
/// \param points the positions
/// \param k the number of neighbours: larger values smooth more
/// \throw std::invalid_argument if `k` is zero or there are not more than `k` different points.
///
/// Complexity: `O(n log n)`.
inline std::vector<double> areas_from_density(const std::vector<Point_3>& points, unsigned k = 12)
{
  using Index_map = typename Pointer_property_map<Point_3>::const_type;
  using Traits = Search_traits_adapter<std::size_t, Index_map, Search_traits_3<Kernel>>;
  using Search = Orthogonal_k_neighbor_search<Traits>;

  if(k == 0)
    throw std::invalid_argument("k is 0: must be at least 1");
  // Copies of a point, such as the zeros that scanners return, share the area of one: a tree of many
  // equal points is deep and slow.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
  std::vector<Point_3> places;
  std::vector<std::size_t> copies, place_of(points.size());
  for(std::size_t i : order) {
    if(places.empty() || places.back() != points[i]) {
      places.push_back(points[i]);
      copies.push_back(0);
    }
    place_of[i] = places.size() - 1;
    ++copies.back();
  }
  if(places.size() <= k)
    throw std::invalid_argument("points has " + std::to_string(places.size()) +
                                " different positions: an estimate of areas needs more than " +
                                std::to_string(k));

  const Index_map map = make_property_map(std::as_const(places));
  const Traits traits(map);
  typename Search::Tree tree(boost::counting_iterator<std::size_t>(0),
                             boost::counting_iterator<std::size_t>(places.size()),
                             typename Search::Splitter(), traits);
  tree.build();
  std::vector<double> areas_of_places;
  areas_of_places.reserve(places.size());
  for(const Point_3& p : places) {
    // One more than k, because the point itself is found too.
    Search search(tree, p, k + 1, 0, true, typename Search::Distance(map));
    double farthest = 0;
    for(const auto& found : search)
      farthest = std::max(farthest, found.second);
    areas_of_places.push_back(3.14159265358979323846 * farthest / (k + 0.5));
  }
  std::vector<double> areas;
  areas.reserve(points.size());
  for(std::size_t place : place_of)
    areas.push_back(areas_of_places[place] / double(copies[place]));
  return areas;
}

/// \ingroup PkgAreaProjectionTransformInput
/// \brief reads an oriented point set into surfels, one for each point.
///
/// \tparam PointRange a range whose elements are the keys of the maps
/// \param points the elements
/// \param np optional named parameters among:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the positions}
///     \cgalParamDefault{`CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{normal_map}
///     \cgalParamDescription{the outward normals, of any length but zero}
///     \cgalParamExtra{required}
///   \cgalParamNEnd
///   \cgalParamNBegin{area_map}
///     \cgalParamDescription{the area of the surface that each point stands for}
///     \cgalParamDefault{`areas_from_density()`}
///     \cgalParamExtra{a parameter of `CGAL::Area_projection::parameters`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw std::invalid_argument if a position is not finite, a normal is null, an area is negative, or
/// areas are to be estimated from no more than 12 different points. The message names the first such point.
///
/// Complexity: linear with `area_map`, `O(n log n)` without.
template <class PointRange, class NamedParameters>
Surfels surfels_from_points(const PointRange& points, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Element = typename std::iterator_traits<decltype(std::begin(points))>::value_type;

  const auto point_map = choose_parameter(get_parameter(np, internal_np::point_map),
                                          CGAL::Identity_property_map<Element>());
  const auto normal_map = get_parameter(np, internal_np::normal_map);
  const auto area_map = get_parameter(np, parameters::tags::area);
  static_assert(!std::is_same_v<std::decay_t<decltype(normal_map)>, internal_np::Param_not_found>,
                "surfels_from_points() needs the named parameter normal_map");
  constexpr bool has_areas =
      !std::is_same_v<std::decay_t<decltype(area_map)>, internal_np::Param_not_found>;

  Surfels surfels;
  constexpr std::size_t largest = std::numeric_limits<std::int32_t>::max();
  std::size_t index = 0;
  for(const auto& element : points) {
    const Point_3 position = internal::to_point(get(point_map, element));
    const Vector_3 normal = internal::to_vector(get(normal_map, element));
    const double length = std::sqrt(normal.squared_length());
    double area = 0;
    if constexpr(has_areas)
      area = CGAL::to_double(get(area_map, element));
    const std::string name = "point " + std::to_string(index);
    if(index == largest)
      throw std::invalid_argument(name + " is one too many: at most 2^31 - 1 are supported");
    if(!std::isfinite(position.x() + position.y() + position.z()))
      throw std::invalid_argument(name + " is not finite");
    if(!(length > 0) || !std::isfinite(length))
      throw std::invalid_argument(name + " has no normal: must be a finite vector other than zero");
    if(!(area >= 0) || !std::isfinite(area))
      throw std::invalid_argument(name + " has the area " + std::to_string(area) +
                                  ": must be finite and not negative");
    surfels.push_back(position, normal / length, area, std::uint32_t(index));
    ++index;
  }
  if constexpr(!has_areas)
    surfels.areas = areas_from_density(surfels.positions);
  return surfels;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_POINTS_H
