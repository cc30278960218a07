// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_POLAR_BALLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_POLAR_BALLS_H

#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_samples.h>
#include <CGAL/Area_projection_transform/medial_balls/touching_ball.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the polar balls of samples: for each the largest of the balls that pass through it and three others, have none
/// inside, and have their centre behind all four (N. Amenta, S. Choi, R. K. Kolluri, *The power crust*, 2001).
///
/// These are the inner vertices of the Voronoi diagram. Inside is where the normals say; so there is no need of a closed
/// surface, and balls that would leave through a hole and touch the surface from its other side are no candidates.
class Polar_balls
{
public:
  using Vector = Eigen::Vector3d;

  /// \param samples those that are at the same place have one ball, which is that of the first
  /// \param largest no ball of a larger radius is taken
  Polar_balls(const Medial_samples& samples, double largest) : m_samples(samples)
  {
    m_balls.resize(samples.size());
    const Triangulation triangulation = triangulated(samples);
    for(auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
      const Corners corners{c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(),
                            c->vertex(3)->info()};
      const Vector center = circumcenter(corners);
      const double radius = (center - samples.positions[corners[0]]).norm();
      if(radius <= largest && is_behind(center, corners))
        for(const std::uint32_t corner : corners)
          propose(corner, {center, radius, farthest(corner, corners)});
    }
  }

  const std::optional<Touching_ball>& operator[](std::size_t sample) const
  {
    return m_balls[sample];
  }

private:
  using Exact_predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Exact_predicates>;
  using Cell_base = CGAL::Delaunay_triangulation_cell_base_3<Exact_predicates>;
  using Triangulation =
      CGAL::Delaunay_triangulation_3<Exact_predicates,
                                     CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
  using Corners = std::array<std::uint32_t, 4>;

  /// sequential, so that the balls are the same whatever the number of threads.
  static Triangulation triangulated(const Medial_samples& samples)
  {
    std::vector<std::uint32_t> order(samples.size());
    std::iota(order.begin(), order.end(), std::uint32_t(0));
    const auto key = [&samples](std::uint32_t i) {
      const Vector& p = samples.positions[i];
      return std::tuple(p.x(), p.y(), p.z(), i);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    order.erase(std::unique(order.begin(), order.end(),
                            [&samples](std::uint32_t i, std::uint32_t j) {
                              return samples.positions[i] == samples.positions[j];
                            }),
                order.end());
    std::vector<std::pair<Exact_predicates::Point_3, std::uint32_t>> points;
    for(const std::uint32_t i : order) {
      const Vector& p = samples.positions[i];
      points.emplace_back(Exact_predicates::Point_3(p.x(), p.y(), p.z()), i);
    }
    return Triangulation(points.begin(), points.end());
  }

  /// \brief the centre of the ball through four samples.
  ///
  /// Of flat cells, which samples in a plane have by rounding, the usual formula gives anything up to infinity, and where
  /// the four are on a circle too, any centre on its axis looks right. Theirs is computed exactly: it exists, as no
  /// cell is without volume.
  Vector circumcenter(const Corners& corners) const
  {
    constexpr double flat = 1e-6; // errors are up to 2^-52 divided by that, in units of the edges
    const auto corner = [this, &corners](int i) -> const Vector& {
      return m_samples.positions[corners[std::size_t(i)]];
    };
    const Vector a = corner(1) - corner(0), b = corner(2) - corner(0), c = corner(3) - corner(0);
    const Vector ab = a.cross(b), bc = b.cross(c), ca = c.cross(a);
    const double volume = a.dot(bc);
    if(!(std::abs(volume) > flat * a.norm() * b.norm() * c.norm()))
      return exact_circumcenter(corners);
    return corner(0) +
           (a.squaredNorm() * bc + b.squaredNorm() * ca + c.squaredNorm() * ab) / (2 * volume);
  }

  Vector exact_circumcenter(const Corners& corners) const
  {
    using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
    const auto corner = [this, &corners](int i) {
      const Vector& p = m_samples.positions[corners[std::size_t(i)]];
      return Exact::Point_3(p.x(), p.y(), p.z());
    };
    const Exact::Point_3 center = CGAL::circumcenter(corner(0), corner(1), corner(2), corner(3));
    return Vector(CGAL::to_double(center.x()), CGAL::to_double(center.y()),
                  CGAL::to_double(center.z()));
  }

  bool is_behind(const Vector& center, const Corners& corners) const
  {
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t i) {
      return (center - m_samples.positions[i]).dot(m_samples.normals[i]) < 0;
    });
  }

  /// the corner that is farthest from another one, which the centre sees under the largest angle from it.
  std::uint32_t farthest(std::uint32_t from, const Corners& corners) const
  {
    const auto key = [&](std::uint32_t i) {
      return std::pair(-(m_samples.positions[i] - m_samples.positions[from]).squaredNorm(), i);
    };
    return *std::min_element(corners.begin(), corners.end(),
                             [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  }

  /// keeps the largest; of equal ones, as samples on a sphere have, that which comes first by value.
  void propose(std::uint32_t sample, const Touching_ball& ball)
  {
    const auto key = [](const Touching_ball& b) {
      return std::tuple(-b.radius, b.center.x(), b.center.y(), b.center.z(), b.contact);
    };
    std::optional<Touching_ball>& best = m_balls[sample];
    if(!best || key(ball) < key(*best))
      best = ball;
  }

  const Medial_samples& m_samples;
  std::vector<std::optional<Touching_ball>> m_balls;
};

/// \brief whether a ball through a sample is near another one that counts as stopping it, as for `touching_ball()`.
///
/// Balls that lie in the gaps between neighbours, even of a convex surface seen from outside, see all of them along the surface.
/// In the middle of a sphere the corners of the cell may be neighbours, too, but samples all around are as near.
inline bool is_stopped(const Thinned_samples& samples, const Eigen::Vector3d& position,
                       const Eigen::Vector3d& normal, const Touching_ball& ball, double least_sine)
{
  constexpr double tolerance = 0.01, spacing = 0.16; // in units of the radius
  bool result = false;
  const Thinned_samples::Level& level = samples.at(spacing * ball.radius);
  level.cells.for_each_in_ball(ball.center, (1 + tolerance) * ball.radius,
                               [&](std::size_t i, double) {
                                 const Eigen::Vector3d chord = position - level.positions[i];
                                 result |= chord.dot(normal) > least_sine * chord.norm();
                               });
  return result;
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_POLAR_BALLS_H
