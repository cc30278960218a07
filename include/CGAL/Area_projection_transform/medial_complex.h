// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_complex/Betti_numbers.h>
#include <CGAL/Area_projection_transform/medial_complex/Dual_complex.h>
#include <CGAL/Area_projection_transform/medial_complex/collapse_tetrahedra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief how balls are connected: the edges and triangles of a medial axis.
///
/// Indices name the balls in the list that was given; those of a simplex ascend, as the simplices do.
struct Medial_complex
{
  std::vector<std::uint32_t> vertices; ///< the balls that are not within the union of others
  std::vector<std::array<std::uint32_t, 2>> edges;     ///< those of the triangles included
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< the sheets
  Betti_numbers topology; ///< of the union of the balls, and of the complex
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_selected(std::size_t i, const std::vector<Medial_ball>& balls)
{
  if(i >= balls.size())
    throw std::invalid_argument("selected names ball " + std::to_string(i) + " of " +
                                std::to_string(balls.size()));
}

/// the power of two that numbers are multiplied with, which rounds nothing, for the largest to be from 1 to 2.
inline int exponent_to_unit(const std::vector<Point_3>& centers, const std::vector<double>& radii)
{
  double largest = 0;
  for(std::size_t i = 0; i < centers.size(); ++i)
    largest = std::max({largest, std::abs(centers[i].x()), std::abs(centers[i].y()),
                        std::abs(centers[i].z()), std::abs(radii[i])});
  return largest > 0 ? -std::ilogb(largest) : 0;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns how balls are connected, so that the complex has the topology of their union, whatever they are.
///
/// Two or three balls are joined if they have a point in common that is as near to each, as the power of a point measures
/// it, as to any other ball: the dual complex of the union (H. Edelsbrunner, *The union of balls and its dual shape*, 1995).
/// Where more than three meet it has tetrahedra; these are collapsed, which does not change the topology, so that
/// sheets are left. Whether the union has the topology of the shape is another question, which
/// `Medial_complex::topology` answers: with few balls it falls apart, and near the surface there are cracks between balls
/// that touch it at samples which are apart. Balls that grow a little close them; see `crack_width()`.
///
/// \param centers of the balls
/// \param radii of the balls; those without a positive radius have no part in it
/// \param growth is added to each of these radii; not negative
/// \throw std::invalid_argument if there are not as many radii as centres, one of all these numbers is not finite, also
/// after growth, or `growth` is negative
///
/// Complexity: that of the regular triangulation, `O(n log n)` for balls along an axis; 100 000 balls take some
/// seconds.
inline Medial_complex medial_complex(const std::vector<Point_3>& centers,
                                     const std::vector<double>& radii, double growth = 0)
{
  if(!(growth >= 0) || !std::isfinite(growth))
    throw std::invalid_argument("growth is " + internal::to_text(growth) +
                                ": must be finite and not negative");
  if(centers.size() != radii.size())
    throw std::invalid_argument("radii has " + std::to_string(radii.size()) + " numbers for " +
                                std::to_string(centers.size()) + " centers");
  std::vector<Point_3> places = centers;
  std::vector<double> grown = radii;
  for(std::size_t i = 0; i < centers.size(); ++i) {
    if(radii[i] > 0)
      grown[i] += growth;
    for(const double number : {centers[i].x(), centers[i].y(), centers[i].z(), grown[i]})
      if(!std::isfinite(number))
        throw std::invalid_argument("ball " + std::to_string(i) + " is not finite");
  }
  // Fourth powers of lengths must be numbers, whatever the unit.
  const int exponent = internal::exponent_to_unit(places, grown);
  for(std::size_t i = 0; i < centers.size(); ++i) {
    const Point_3& c = centers[i];
    places[i] = Point_3(std::ldexp(c.x(), exponent), std::ldexp(c.y(), exponent),
                        std::ldexp(c.z(), exponent));
    grown[i] = std::ldexp(grown[i], exponent);
  }
  internal::Dual_complex dual(places, grown);
  internal::collapse_tetrahedra(dual, places, grown);
  return {dual.vertices, dual.edges, dual.triangles, dual.topology};
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns how some medial balls are connected.
/// \param balls all of them
/// \param selected positions in `balls`, which the indices of the result are, too
/// \param growth is added to each radius, in the units of the surface; not negative
/// \throw std::invalid_argument if one of `selected` is out of range, or `growth` negative or not finite
inline Medial_complex medial_complex(const std::vector<Medial_ball>& balls,
                                     const std::vector<std::size_t>& selected, double growth = 0)
{
  std::vector<Point_3> centers(balls.size(), Point_3(0, 0, 0));
  std::vector<double> radii(balls.size(), 0.); // what is not selected has none
  for(const std::size_t i : selected) {
    internal::check_selected(i, balls);
    centers[i] = balls[i].center;
    radii[i] = balls[i].radius;
  }
  return medial_complex(centers, radii, growth);
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns by how much the balls of a surface must grow to close the cracks between them: 0.3 of the spacing of
/// their samples.
///
/// Balls that touch a plane at the corners of squares of the side `s` leave its middles by up to `s² / 4r`, small ones along
/// edges and at tips more. With 0.1 cracks are left in meshes with thin parts; much more closes gaps of the shape.
/// \param area of the surface
/// \param number of all its balls, whichever are selected
inline double crack_width(double area, std::size_t number)
{
  return number > 0 ? 0.3 * std::sqrt(area / double(number)) : 0;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_H
