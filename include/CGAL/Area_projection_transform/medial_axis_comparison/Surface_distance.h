// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SURFACE_DISTANCE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SURFACE_DISTANCE_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/aabb_traits.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// distances from some points; any thread may ask.
class Nearest_point
{
public:
  explicit Nearest_point(const std::vector<Point_3>& points) : m_tree(points.begin(), points.end())
  {
    if(!points.empty())
      m_tree.build();
  }

  /// infinite if there are no points.
  double operator()(const Point_3& place) const
  {
    if(m_tree.empty())
      return std::numeric_limits<double>::infinity();
    const CGAL::Orthogonal_k_neighbor_search<Traits> search(m_tree, place, 1);
    return std::sqrt(search.begin()->second);
  }

private:
  using Traits = CGAL::Search_traits_3<Kernel>;
  CGAL::Kd_tree<Traits> m_tree;
};

/// a triangle of a surface, for trees of boxes.
class Triangle_primitive
{
public:
  using Id = std::uint32_t;
  using Point = Point_3;
  using Point_reference = const Point_3&;
  using Datum = Kernel::Triangle_3;
  using Datum_reference = Datum;

  Triangle_primitive(Id id, const Triangle_surface& surface) : m_id(id), m_surface(&surface) {}

  Id id() const { return m_id; }
  Datum_reference datum() const
  {
    return Datum(m_surface->corner(m_id, 0), m_surface->corner(m_id, 1),
                 m_surface->corner(m_id, 2));
  }
  Point_reference reference_point() const { return m_surface->corner(m_id, 0); }

private:
  Id m_id;
  const Triangle_surface* m_surface;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief distances from a surface: from its triangles, exactly, or from the nearest point of a point set.
///
/// \tparam Source `Triangle_surface` or `Surfels`, which must stay where it is
template <class Source>
class Surface_distance;

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief distances from the triangles of a surface, by an AABB tree.
template <>
class Surface_distance<Triangle_surface>
{
public:
  /// \param surface must stay where it is; its triangles are sorted into a tree, in `O(n log n)`
  explicit Surface_distance(const Triangle_surface& surface)
  {
    for(std::size_t t = 0; t < surface.size(); ++t)
      m_tree.insert(internal::Triangle_primitive(std::uint32_t(t), surface));
    m_tree.build();
    if(!surface.empty())
      m_tree.accelerate_distance_queries();
  }

  /// the distance of a place, in the units of the surface; infinite if that is empty.
  double operator()(const Point_3& place) const
  {
    return m_tree.empty() ? std::numeric_limits<double>::infinity()
                          : std::sqrt(m_tree.squared_distance(place));
  }

private:
  CGAL::AABB_tree<internal::Aabb_traits<Kernel, internal::Triangle_primitive>> m_tree;
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief distances from the nearest of some points, by a k-d tree.
template <>
class Surface_distance<Surfels>
{
public:
  /// \param points are copied into a tree, in `O(n log n)`
  explicit Surface_distance(const Surfels& points) : m_nearest(points.positions) {}

  /// the distance of a place, in the units of the points; infinite if there are none.
  double operator()(const Point_3& place) const { return m_nearest(place); }

private:
  internal::Nearest_point m_nearest;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_SURFACE_DISTANCE_H
