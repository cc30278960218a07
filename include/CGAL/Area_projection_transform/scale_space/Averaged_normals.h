// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_AVERAGED_NORMALS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_AVERAGED_NORMALS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Heat_flow.h>
#include <CGAL/Area_projection_transform/internal/face_links.h>
#include <CGAL/Area_projection_transform/internal/point_links.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

inline std::vector<Vector_3> normals_of_elements(const Surfels& surfels)
{
  return surfels.normals;
}

/// of each triangle the mean of its normal, where that varies.
inline std::vector<Vector_3> normals_of_elements(const Triangle_surface& surface)
{
  if(!surface.has_interpolated_normals())
    return surface.normals;
  std::vector<Vector_3> normals;
  normals.reserve(surface.size());
  for(const auto& [a, b, c] : surface.triangles)
    normals.push_back(normalized(surface.vertex_normals[a] + surface.vertex_normals[b] +
                                 surface.vertex_normals[c]));
  return normals;
}

inline void drop_interpolated_normals(Surfels&) {}

inline void drop_interpolated_normals(Triangle_surface& surface)
{
  surface.vertex_normals.clear();
}

} // namespace internal

/// \ingroup PkgAreaProjectionTransformScaleSpace
/// \brief averages normals over a neighbourhood that grows with the radius, so that structures much
/// smaller than the radius do not scatter what is projected (paper, section 4.1, figure 4 C).
///
/// The normal of each element at radius `R` is the average over a neighbourhood *on the surface*, of the
/// standard deviation `averaging_ratio · R` along either direction, so that its area grows with `R²`. The
/// two sides of a thin plate, or two fingers that touch, are far from each other on the surface and do
/// not mix. An element votes with its area times the cosine between its own normal and the averaged
/// one, or not at all if that is negative: as much as it covers of the smooth surface that it is a part of.
///
/// The paper leaves the form of the average open. Here it is one implicit step of the flow of heat, from
/// triangle to triangle across edges (and across the gaps where faces are missing, so that a mesh that
/// lost faces at random averages as far as it did before), or between the surfels of a point set and their
/// nearest neighbours that face the same way; copies of a surfel share one normal. Normals that the user
/// gave are averaged like any others. Positions stay as they are; on a sphere, a cylinder or a plane so
/// do normals.
///
/// \tparam Source_ `Triangle_surface` or `Surfels`
/// \cgalModels `SurfaceSmoother`
template <class Source_ = Triangle_surface>
class Averaged_normals
{
public:
  /// what is seen, and what it is seen as.
  using Source = Source_;

  /// a quarter of the radius.
  static constexpr double default_averaging_ratio = 0.25;

  /// \param source the surface; where its normals are interpolated, the mean of each triangle counts
  /// \param averaging_ratio the standard deviation of the neighbourhood, in units of the radius
  /// \throw std::invalid_argument if `averaging_ratio` is not positive.
  ///
  /// Complexity: `O(n log n)` for `n` triangles or surfels.
  explicit Averaged_normals(Source source, double averaging_ratio = default_averaging_ratio)
      : m_source(std::move(source))
      , m_averaging_ratio(averaging_ratio)
      , m_flow(internal::flow_between_elements(m_source))
      , m_normals(Eigen::Index(m_source.size()), 3)
  {
    internal::check_positive(averaging_ratio, "averaging_ratio");
    const std::vector<Vector_3> normals = internal::normals_of_elements(m_source);
    for(std::size_t i = 0; i < normals.size(); ++i)
      internal::set_row(m_normals, i, normals[i]);
  }

  /// the surface with its own normals.
  const Source& source() const { return m_source; }

  /// the standard deviation of the neighbourhood, in units of the radius.
  double averaging_ratio() const { return m_averaging_ratio; }

  /// \brief returns the surface as seen at `radius`: the same elements in the same order, each with a
  /// constant normal.
  /// \throw std::invalid_argument if `radius` is not positive.
  /// \throw std::runtime_error if the average does not converge, as may happen with needles.
  ///
  /// Averages are found up to a tenth of a degree in the root of the mean square: so far they may depend on
  /// the order of the elements.
  ///
  /// Complexity: linear in the number of elements; the number of steps of the solver is at most about 5 for
  /// common radii, 25 where the radius is much larger than the surface. May be called concurrently.
  Source operator()(double radius) const
  {
    internal::check_positive(radius, "radius");
    const double deviation = m_averaging_ratio * radius;
    constexpr double largest_error = 2e-3; // of unit vectors: a tenth of a degree
    const auto averages = m_flow.diffused(m_normals, 0.5 * deviation * deviation, largest_error);
    Source surface = m_source;
    internal::drop_interpolated_normals(surface);
    for(std::size_t i = 0; i < surface.size(); ++i) {
      const Vector_3 average = internal::row(averages, i);
      const double length = std::sqrt(average.squared_length());
      if(!(length > 0))
        continue; // nothing to go by but its own
      surface.normals[i] = average / length;
      surface.areas[i] *= std::max(0., surface.normals[i] * internal::row(m_normals, i));
    }
    return surface;
  }

private:
  Source m_source;
  double m_averaging_ratio;
  internal::Heat_flow m_flow;
  internal::Heat_flow::Vectors m_normals;
};

template <class Source>
Averaged_normals(Source) -> Averaged_normals<Source>;
template <class Source>
Averaged_normals(Source, double) -> Averaged_normals<Source>;

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SCALE_SPACE_AVERAGED_NORMALS_H
