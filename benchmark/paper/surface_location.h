// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SURFACE_LOCATION_H
#define AREA_PROJECTION_PAPER_SURFACE_LOCATION_H

#include "damage.h"

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Paper {

/// \brief how far all of a surface is from a place on it, along the surface: quantiles of the geodesic
/// distance, each for the same area, in units of the square root of the area of the surface.
///
/// It does not change when the surface is bent, moved or scaled. Those of two places differ, at each
/// quantile, by no more than the places are apart (what lies within `r` of one lies within `r + d` of the
/// other): so a difference tells the places apart, and none leaves it open whether they are the same, as for
/// the two hands of a body.
using Distance_profile = std::array<double, 32>;

/// the mean difference over the quantiles: at most the geodesic distance of the places.
double difference(const Distance_profile& a, const Distance_profile& b);

/// the profiles of the places of a closed mesh in one part.
class Surface_locations
{
public:
  /// \throw std::invalid_argument if the mesh is not a manifold in one part.
  explicit Surface_locations(const Soup& soup);

  /// those of the centroids of the faces.
  const std::vector<Distance_profile>& of_faces() const { return m_of_faces; }

  /// \brief the mean over the voters of a salient point: the pieces of surface that land within `R/2` of it at
  /// its scale `R`, by their areas.
  Distance_profile of_point(const CGAL::Area_projection::Salient_point& point) const;

private:
  std::size_t nearest_face(const Point_3& p) const;

  CGAL::Area_projection::Triangle_surface m_surface;
  std::vector<Distance_profile> m_of_faces;
};

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SURFACE_LOCATION_H
