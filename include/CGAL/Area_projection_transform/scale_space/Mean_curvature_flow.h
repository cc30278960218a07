// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_MEAN_CURVATURE_FLOW_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_MEAN_CURVATURE_FLOW_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Heat_flow.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/internal/triangle_measures.h>
#include <CGAL/Area_projection_transform/internal/vertex_links.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformScaleSpace
/// \brief smooths the surface the more the larger the radius, by mean curvature flow, so that
/// structures much smaller than the radius are gone (paper, section 4.1, figure 4 D).
///
/// The paper smooths step by step from one radius to the next. Here the surface at radius `R`
/// depends on `R` alone: it is the original after the time `(smoothing_ratio · R)² / 2`, in which a
/// bump spreads to a standard deviation of `smoothing_ratio · R`. One implicit step is made, with
/// the cotangent Laplacian of the original, and two things are done about what it takes away too
/// much: what the step removed is smoothed in turn and added (twicing), so that a sphere of radius
/// `R` loses 0.7 % of its radius instead of 8 %; and vertices move along the normals of the
/// smoothed surface only, so that the rims of holes do not draw back.
///
/// Triangles keep their place in the order and their sources. They vote with the area that they
/// have when smoothed, but no more than before: under the flow no part of a surface grows, whereas
/// the normals along which vertices move are noise where a wire has shrunk to nothing. Where the
/// user gave a triangle an area, it shrinks by the same factor; triangles without extent do not
/// vote.
///
/// \cgalModels `SurfaceSmoother`
class Mean_curvature_flow
{
public:
  /// what is smoothed, and what it becomes.
  using Source = Triangle_surface;

  /// three tenths of the radius.
  static constexpr double default_smoothing_ratio = 0.3;

  /// \param source the surface; open or closed, a mesh or a soup
  /// \param smoothing_ratio the standard deviation to which a bump spreads, in units of the radius
  /// \throw std::invalid_argument if `smoothing_ratio` is not positive.
  ///
  /// Complexity: `O(n log n)` for `n` triangles or points.
  explicit Mean_curvature_flow(Triangle_surface source,
                               double smoothing_ratio = default_smoothing_ratio)
      : m_source(std::move(source))
      , m_smoothing_ratio(smoothing_ratio)
      , m_places(internal::joined_points(m_source))
      , m_flow(internal::flow_between_vertices(m_source, m_places))
      , m_positions(Eigen::Index(m_source.points.size()), 3)
  {
    internal::check_positive(smoothing_ratio, "smoothing_ratio");
    for(std::size_t i = 0; i < m_source.points.size(); ++i)
      internal::set_row(m_positions, i, m_source.points[m_places[i]] - CGAL::ORIGIN);
  }

  /// the surface before smoothing.
  const Triangle_surface& source() const { return m_source; }

  /// the standard deviation to which a bump spreads, in units of the radius.
  double smoothing_ratio() const { return m_smoothing_ratio; }

  /// \brief returns the surface as seen at `radius`: the same triangles in the same order, flat.
  /// \throw std::invalid_argument if `radius` is not positive.
  /// \throw std::runtime_error if the step does not converge, as may happen with needles.
  ///
  /// The surface is found up to a thousandth of the deviation, `smoothing_ratio · radius`, in the
  /// root of the mean square: so far it may depend on the order of the triangles.
  ///
  /// Complexity: linear in the number of triangles and points; the number of steps of the solver is
  /// about 10, and 20 to 40 where the radius is much larger than the surface. May be called
  /// concurrently.
  Triangle_surface operator()(double radius) const
  {
    internal::check_positive(radius, "radius");
    const double deviation = m_smoothing_ratio * radius;
    const double time = 0.5 * deviation * deviation;
    const double largest_error = 1e-3 * deviation;
    Vectors positions = m_flow.diffused(m_positions, time, largest_error);
    positions += m_flow.diffused(m_positions - positions, time, largest_error);

    Triangle_surface surface = m_source;
    surface.vertex_normals.clear();
    for(std::size_t i = 0; i < surface.points.size(); ++i)
      surface.points[i] = CGAL::ORIGIN + internal::row(positions, m_places[i]);
    move_back_along_surface(surface);
    measure(surface);
    return surface;
  }

private:
  using Vectors = internal::Heat_flow::Vectors;

  /// keeps of the way that each point has gone only the part along the normal there.
  void move_back_along_surface(Triangle_surface& surface) const
  {
    std::vector<Vector_3> normals(surface.points.size(), Vector_3(0, 0, 0));
    for(std::size_t t = 0; t < surface.size(); ++t) {
      const Vector_3 normal = internal::doubled_area_vector(surface, t);
      for(std::uint32_t i : surface.triangles[t])
        normals[m_places[i]] += normal;
    }
    for(std::size_t i = 0; i < surface.points.size(); ++i) {
      const Vector_3 normal = internal::normalized(normals[m_places[i]]);
      const Vector_3 way = surface.points[i] - m_source.points[i];
      surface.points[i] = m_source.points[i] + (way * normal) * normal;
    }
  }

  /// brings normals and areas up to date with the points.
  void measure(Triangle_surface& surface) const
  {
    for(std::size_t t = 0; t < surface.size(); ++t) {
      const Vector_3 normal = internal::doubled_area_vector(surface, t);
      const double doubled_area = std::sqrt(normal.squared_length());
      const double before = std::sqrt(internal::doubled_area_vector(m_source, t).squared_length());
      surface.areas[t] *= before > 0 ? std::min(1., doubled_area / before) : 0;
      if(doubled_area > 0)
        surface.normals[t] = normal / doubled_area;
    }
  }

  Triangle_surface m_source;
  double m_smoothing_ratio;
  std::vector<std::uint32_t> m_places;
  internal::Heat_flow m_flow;
  Vectors m_positions;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_MEAN_CURVATURE_FLOW_H
