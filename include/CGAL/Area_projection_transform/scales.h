// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SCALES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SCALES_H

#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/lengths.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformGround
/// \brief one scale of the transform: the distance of projection and the radius of the ball that
/// collects, both in the units of the mesh.
struct Scale
{
  double radius; ///< the distance `R` between the surface and its parallel surface
  double sigma;  ///< the radius `σ` of the collecting ball

  /// the factor `1/(4πR²)` that makes the transform 1 at the centre of a sphere of this radius.
  double normalization() const { return 1. / (4. * 3.14159265358979323846 * radius * radius); }
};

/// \ingroup PkgAreaProjectionTransformGround
/// \brief the default spacing of surfels that count as points, in units of `σ`.
///
/// It keeps the error of sampling below 1.5 % of the root mean square of the map, half the spacing
/// keeps it below 0.5 %, measured for the ball kernel against the exact map; a narrow kernel asks
/// for less. The work grows with the inverse square of the spacing, the error about with its power
/// 1.5.
inline constexpr double default_sampling_ratio = 0.15;

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_sigma_ratio(double ratio)
{
  if(!(ratio > 0) || !(ratio < 1))
    throw std::invalid_argument("sigma_ratio is " + internal::to_text(ratio) +
                                ": must be greater than 0 and less than 1");
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformGround
/// \brief returns the scales of the multiscale transform: `σ = sigma_ratio · R` for each radius.
/// \param radii the radii, positive, in the units of the surface
/// \param sigma_ratio the ratio `σ/R`, in (0, 1)
/// \throw std::invalid_argument if a radius is not positive or `sigma_ratio` is not in (0, 1).
inline std::vector<Scale> proportional_scales(const std::vector<double>& radii,
                                              double sigma_ratio = 0.5)
{
  internal::check_sigma_ratio(sigma_ratio);
  std::vector<Scale> scales;
  for(std::size_t k = 0; k < radii.size(); ++k) {
    internal::check_positive(radii[k], "radii[" + std::to_string(k) + "]");
    scales.push_back({radii[k], sigma_ratio * radii[k]});
  }
  return scales;
}

/// \ingroup PkgAreaProjectionTransformGround
/// \brief returns the scales that share one collecting radius.
/// \param radii the radii, positive, in the units of the surface
/// \param sigma `σ`, positive, in the same units
/// \throw std::invalid_argument if a radius or `sigma` is not positive.
inline std::vector<Scale> fixed_sigma_scales(const std::vector<double>& radii, double sigma)
{
  internal::check_positive(sigma, "sigma");
  std::vector<Scale> scales;
  for(std::size_t k = 0; k < radii.size(); ++k) {
    internal::check_positive(radii[k], "radii[" + std::to_string(k) + "]");
    scales.push_back({radii[k], sigma});
  }
  return scales;
}

/// \ingroup PkgAreaProjectionTransformGround
/// \brief returns `number` radii `first`, `first + step`, `first + 2 step`, …
/// \param first the smallest radius, positive, in the units of the surface
/// \param step the difference of neighbours, positive, in the same units
/// \param number how many
/// \throw std::invalid_argument if `first` or `step` is not positive.
inline std::vector<double> uniform_radii(double first, double step, std::size_t number)
{
  internal::check_positive(first, "first");
  internal::check_positive(step, "step");
  std::vector<double> radii;
  for(std::size_t k = 0; k < number; ++k)
    radii.push_back(first + double(k) * step);
  return radii;
}

/// \ingroup PkgAreaProjectionTransformGround
/// \brief returns `number` radii from `first` to `last`, both included, each the same multiple of
/// the one before. For `number == 1` this is `first` alone.
/// \param first the first radius, positive, in the units of the surface
/// \param last the last one, positive, in the same units
/// \param number how many
/// \throw std::invalid_argument if `first` or `last` is not positive.
inline std::vector<double> geometric_radii(double first, double last, std::size_t number)
{
  internal::check_positive(first, "first");
  internal::check_positive(last, "last");
  std::vector<double> radii;
  for(std::size_t k = 0; k < number; ++k)
    radii.push_back(k == 0            ? first
                    : k + 1 == number ? last
                                      : first * std::pow(last / first, double(k) / (number - 1)));
  return radii;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SCALES_H
