// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_MEASURES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_MEASURES_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Surface_distance.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/axis_distances.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/ball_volume.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/reconstruction_error.h>
#include <CGAL/Area_projection_transform/medial_balls/select_balls.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief what is measured of a representation of a surface, beside where others are.
struct Medial_measures
{
  double coverage =
      0;              ///< the part of the area that is no farther than the tolerance from the balls
  Ball_volume volume; ///< how much of the solid the balls fill
  Reconstruction_error reconstruction; ///< how far their union and the surface are from each other
  /// of all balls, `|r - d| / r`, where `d` is the distance of the centre from the surface.
  Spread_of_values radius_error;
  /// of all centres, `a / (a + d)`, where `a` is the distance from the unpruned axis: 0 on it, 1 on the surface.
  Spread_of_values off_centre;
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns the part of the area of a surface that is no farther than a tolerance from the balls of a
/// representation, in [0, 1].
/// \tparam Source `Triangle_surface` or `Surfels`
/// \throw std::invalid_argument if the tolerance is not positive and finite
template <class Source>
double covered_part(const Medial_representation& axis, const Source& surface, double tolerance)
{
  std::vector<Medial_ball> balls(axis.size());
  std::vector<std::size_t> all(axis.size());
  for(std::size_t i = 0; i < axis.size(); ++i) {
    balls[i].center = axis.centers[i];
    balls[i].radius = axis.radii[i];
    all[i] = i;
  }
  return covered_part(balls, all, surface, tolerance);
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief measures representations of a surface, one after the other.
/// \tparam Source `Triangle_surface` or `Surfels`
template <class Source>
class Medial_judge
{
public:
  /// \param surface must stay where it is
  /// \param unpruned the centres of all medial balls, to which centredness refers
  /// \param tolerance up to which the surface counts as covered, in its units
  /// \param seed of the lines by which volumes are measured
  /// \throw std::invalid_argument if the tolerance is not positive and finite
  Medial_judge(const Source& surface, const Medial_representation& unpruned, double tolerance,
               std::uint64_t seed = 0)
      : m_surface(surface)
      , m_tolerance(tolerance)
      , m_seed(seed)
      , m_distance(surface)
      , m_axis_distance(unpruned.centers)
  {
    internal::check_positive(tolerance, "tolerance");
    const Bbox_3 box = surface.bbox();
    const Point_3 low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
    m_spacing = low < high ? 0.005 * std::sqrt(squared_distance(low, high)) : tolerance;
  }

  /// \brief measures an axis.
  /// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  /// `CGAL::Parallel_if_available_tag`; the result does not depend on it, to the last bit
  /// \param axis in the units of the surface
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  Medial_measures measure(const Medial_representation& axis) const
  {
    Medial_measures result;
    result.coverage = covered_part(axis, m_surface, m_tolerance);
    result.volume = ball_volume<ConcurrencyTag>(axis, m_surface, m_seed);
    result.reconstruction = internal::reconstruction_error<ConcurrencyTag>(
        axis, m_surface, m_distance, std::max(m_spacing, internal::Ball_lattice::least_cell(axis)));
    std::vector<double> radius_errors(axis.size()), off_centre(axis.size());
    internal::for_each_index<ConcurrencyTag>(axis.size(), [&](std::size_t i) {
      const double depth = m_distance(axis.centers[i]), aside = m_axis_distance(axis.centers[i]);
      radius_errors[i] = std::abs(axis.radii[i] - depth) / axis.radii[i];
      off_centre[i] = aside > 0 ? aside / (aside + depth) : 0;
    });
    result.radius_error = spread_of(std::move(radius_errors));
    result.off_centre = spread_of(std::move(off_centre));
    return result;
  }

private:
  const Source& m_surface;
  double m_tolerance, m_spacing; // of samples
  std::uint64_t m_seed;
  Surface_distance<Source> m_distance;
  internal::Nearest_point m_axis_distance;
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns the distances from each representation (row) to each other one (column).
/// \throw std::invalid_argument if the spacing is not positive and finite
template <class ConcurrencyTag = CGAL::Sequential_tag>
std::vector<std::vector<Spread_of_values>>
axis_distance_matrix(const std::vector<Medial_representation>& axes, double spacing)
{
  std::vector<std::vector<Point_3>> samples;
  for(const Medial_representation& axis : axes)
    samples.push_back(axis_samples(axis, spacing));
  std::vector<std::vector<Spread_of_values>> matrix(axes.size(),
                                                    std::vector<Spread_of_values>(axes.size()));
  for(std::size_t j = 0; j < axes.size(); ++j) {
    const internal::Nearest_point nearest(samples[j]);
    for(std::size_t i = 0; i < axes.size(); ++i)
      matrix[i][j] = internal::distances_from<ConcurrencyTag>(samples[i], nearest);
  }
  return matrix;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_MEASURES_H
