// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SHAPE_DIAMETER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SHAPE_DIAMETER_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns how thick a shape is behind each of its triangles, by \cgal's shape diameter function: a mean over rays
/// in a cone of 120 degrees; NaN where no ray meets the surface again.
///
/// Rays need no connections: any triangles will do, open or not, if they face outward. Not smoothed or normalized.
/// \return the diameters in the order of the triangles, in the units of the surface
///
/// Complexity: 25 rays for each triangle; 16 000 triangles take half a second.
inline std::vector<double> shape_diameters(const Triangle_surface& surface)
{
  using Mesh = CGAL::Surface_mesh<Point_3>;
  Mesh mesh;
  for(std::size_t t = 0; t < surface.size(); ++t)
    mesh.add_face(mesh.add_vertex(surface.corner(t, 0)), mesh.add_vertex(surface.corner(t, 1)),
                  mesh.add_vertex(surface.corner(t, 2)));
  std::vector<double> diameters(surface.size(), std::numeric_limits<double>::quiet_NaN());
  if(surface.empty())
    return diameters;
  const auto map = mesh.add_property_map<Mesh::Face_index, double>("f:diameter", 0).first;
  constexpr double cone = 2. / 3 * 3.14159265358979323846;
  CGAL::sdf_values(mesh, map, cone, 25, false);
  for(const Mesh::Face_index f : mesh.faces())
    if(map[f] > 0)
      diameters[std::size_t(f)] = map[f];
  return diameters;
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns Spearman's correlation of ranks, in [-1, 1]: 1 if both lists have the same order. Equal numbers share
/// their ranks; pairs of which one is NaN are left out. NaN if all numbers of a list are equal.
/// \throw std::invalid_argument if the lists are not of the same length
inline double rank_correlation(const std::vector<double>& first, const std::vector<double>& second)
{
  if(first.size() != second.size())
    throw std::invalid_argument("second has " + std::to_string(second.size()) + " numbers for " +
                                std::to_string(first.size()) + " of first");
  std::vector<std::size_t> known;
  for(std::size_t i = 0; i < first.size(); ++i)
    if(!std::isnan(first[i]) && !std::isnan(second[i]))
      known.push_back(i);
  const double middle = 0.5 * (double(known.size()) - 1);
  const auto centred_ranks = [&](const std::vector<double>& values) {
    std::vector<std::size_t> order = known;
    std::sort(order.begin(), order.end(),
              [&values](std::size_t i, std::size_t j) { return values[i] < values[j]; });
    std::vector<double> ranks(values.size(), 0.);
    for(std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      while(end < order.size() && !(values[order[begin]] < values[order[end]]))
        ++end;
      for(std::size_t k = begin; k < end; ++k)
        ranks[order[k]] = 0.5 * double(begin + end - 1) - middle;
    }
    return ranks;
  };
  const std::vector<double> a = centred_ranks(first), b = centred_ranks(second);
  const auto product = [](const std::vector<double>& x, const std::vector<double>& y) {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
  };
  return product(a, b) / std::sqrt(product(a, a) * product(b, b));
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns whether a representation is thick where the surface says it is: the correlation of the ranks of shape
/// diameters with the diameters of the balls that come nearest to the triangles. NaN if either are all the same.
/// \param axis the balls, in the units of the surface
/// \param surface facing outward
/// \param diameters what `shape_diameters()` returns for it
/// \throw std::invalid_argument if there is not a diameter for each triangle
///
/// Complexity: at most 2000 triangles, at equal steps of their order, are compared with all balls.
inline double shape_diameter_correlation(const Medial_representation& axis,
                                         const Triangle_surface& surface,
                                         const std::vector<double>& diameters)
{
  constexpr std::size_t most = 2000;
  if(diameters.size() != surface.size())
    throw std::invalid_argument("diameters has " + std::to_string(diameters.size()) +
                                " numbers for " + std::to_string(surface.size()) + " triangles");
  std::vector<double> of_surface, of_balls;
  for(std::size_t t = 0; t < surface.size(); t += 1 + surface.size() / most) {
    const Point_3 place =
        centroid(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
    double nearest = std::numeric_limits<double>::infinity();
    double diameter = std::numeric_limits<double>::quiet_NaN();
    for(std::size_t i = 0; i < axis.size(); ++i) {
      const double distance = std::sqrt(squared_distance(axis.centers[i], place)) - axis.radii[i];
      if(axis.radii[i] > 0 && distance < nearest) {
        nearest = distance;
        diameter = 2 * axis.radii[i];
      }
    }
    of_surface.push_back(diameters[t]);
    of_balls.push_back(diameter);
  }
  return rank_correlation(of_surface, of_balls);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SHAPE_DIAMETER_H
