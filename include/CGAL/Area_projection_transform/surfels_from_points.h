// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_POINTS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/areas_from_density.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/lengths.h>
#include <CGAL/Area_projection_transform/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Area_projection {

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
/// \throw std::invalid_argument if a position is not finite or has a coordinate beyond
/// `largest_coordinate`, a normal is null, an area is negative, or areas are to be estimated from fewer
/// than two different positions. The message names the first such point.
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
    internal::check_coordinates(position, "point", index);
    if(!(length > 0) || !std::isfinite(length))
      throw std::invalid_argument(name + " has no normal: must be a finite vector other than zero");
    if(!(area >= 0) || !std::isfinite(area))
      throw std::invalid_argument(name + " has the area " + internal::to_text(area) +
                                  ": must be finite and not negative");
    surfels.push_back(position, normal / length, area, std::uint32_t(index));
    ++index;
  }
  if constexpr(!has_areas)
    surfels.areas = areas_from_density(surfels.positions, surfels.normals);
  return surfels;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_POINTS_H
