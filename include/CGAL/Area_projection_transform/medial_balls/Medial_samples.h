// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MEDIAL_SAMPLES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MEDIAL_SAMPLES_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_balls/bounded_spacing.h>
#include <CGAL/Area_projection_transform/medial_balls/crease_normals.h>

#include <Eigen/Core>

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
namespace internal {

/// \brief the samples of a surface that have medial balls: positions, areas, and smooth normals that point away from the
/// side on which the balls lie.
struct Medial_samples
{
  using Vector = Eigen::Vector3d;

  std::vector<Vector> positions, normals;
  std::vector<double> areas;
  std::vector<std::uint32_t> sources;
  std::vector<std::uint32_t> triangles; ///< that they are on; none of points

  Medial_samples(const Triangle_surface& surface, const Medial_ball_options& options);
  Medial_samples(const Surfels& surfels, const Medial_ball_options& options);

  std::size_t size() const { return positions.size(); }

  /// \brief 1.2 times the largest distance of a sample from the centroid: no ball within the surface is larger.
  ///
  /// One that fits into the surface is no larger than the smallest ball around it. The rest is for what normals err.
  double largest_radius() const
  {
    double area = 0, largest = 0;
    Vector centroid = Vector::Zero();
    for(std::size_t i = 0; i < size(); ++i) {
      area += areas[i];
      centroid += areas[i] * (positions[i] - positions.front());
    }
    if(!(area > 0))
      return 0;
    centroid = positions.front() + centroid / area;
    for(const Vector& p : positions)
      largest = std::max(largest, (p - centroid).norm());
    return 1.2 * largest;
  }

private:
  void push_back(const Vector& position, const Vector& normal, double area, std::uint32_t source)
  {
    positions.push_back(position);
    normals.push_back(normal);
    areas.push_back(area);
    sources.push_back(source);
  }
};

/// \brief the spacing at which a surface is sampled: that of its faces, but for those that are much larger than others.
inline double medial_spacing(const Triangle_surface& surface)
{
  const double number = std::max(double(surface.size()), 8000.);
  return bounded_spacing(surface, 1.5 * std::sqrt(surface.total_area() / number), 6 * number);
}

/// about how many balls there will be.
inline double forecast_medial_balls(const Triangle_surface& surface,
                                    const Medial_ball_options& options)
{
  const double spacing = options.spacing ? *options.spacing : medial_spacing(surface);
  return std::isnormal(spacing) ? number_of_samples(surface, spacing) : 0;
}

inline double forecast_medial_balls(const Surfels& surfels, const Medial_ball_options&)
{
  return double(surfels.size());
}

inline Medial_samples::Medial_samples(const Triangle_surface& surface,
                                      const Medial_ball_options& options)
{
  const double spacing = options.spacing ? *options.spacing : medial_spacing(surface);
  if(!std::isnormal(spacing)) // nothing there
    return;
  const double sign = options.side == Side::INSIDE ? 1 : -1;
  const Crease_normals normals_of(surface, options.crease_angle);
  for(std::size_t t = 0; t < surface.size(); ++t) {
    const Vector a = to_eigen(surface.corner(t, 0)), b = to_eigen(surface.corner(t, 1)),
                 c = to_eigen(surface.corner(t, 2));
    const std::array<Vector, 3> corner = normals_of(t);
    const auto sample = [&](const Triangle_piece& piece) {
      const std::array<double, 3> w = piece.centroid();
      const Vector normal = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2];
      const double length = normal.norm();
      if(!(length > 0))
        return;
      push_back(w[0] * a + w[1] * b + w[2] * c, sign / length * normal,
                piece.fraction * surface.areas[t], surface.sources[t]);
      triangles.push_back(std::uint32_t(t));
    };
    for_each_piece(whole_triangle(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)),
                   largest_variance(spacing), sample);
  }
}

inline Medial_samples::Medial_samples(const Surfels& surfels, const Medial_ball_options& options)
{
  const double sign = options.side == Side::INSIDE ? 1 : -1;
  for(std::size_t i = 0; i < surfels.size(); ++i) {
    const Vector position = to_eigen(surfels.positions[i]), normal = to_eigen(surfels.normals[i]);
    const double length = normal.norm(), area = surfels.areas[i];
    if(!position.allFinite())
      throw std::invalid_argument("positions[" + std::to_string(i) + "] is not finite");
    if(!(std::abs(length - 1) < 1e-3))
      throw std::invalid_argument("normals[" + std::to_string(i) + "] has the length " +
                                  internal::to_text(length) + ": must be 1");
    if(!(area >= 0) || !std::isfinite(area))
      throw std::invalid_argument("areas[" + std::to_string(i) + "] is " + internal::to_text(area) +
                                  ": must be finite and not negative");
    push_back(position, sign / length * normal, area, surfels.sources[i]);
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_MEDIAL_SAMPLES_H
