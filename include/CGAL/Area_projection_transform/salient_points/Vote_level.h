// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_VOTE_LEVEL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_VOTE_LEVEL_H

#include <CGAL/Area_projection_transform/internal/Cell_index.h>
#include <CGAL/Area_projection_transform/internal/Cell_list.h>
#include <CGAL/Area_projection_transform/salient_points/Feature_surface.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// a place that may be the centre of something.
struct Candidate
{
  Eigen::Vector3d position;
  double score;
  std::uint32_t level;
};

/// \brief a surface at one radius: clusters of its patches with normals averaged over them, and the places
/// where their projections meet.
///
/// Clusters are a fifth of the radius wide, so there are no more of them than the radius asks for.
class Vote_level
{
public:
  using Vector = Eigen::Vector3d;

  /// \name What a level is made of, in units of the radius
  /// @{
  static constexpr double cluster_size = 0.2;
  static constexpr double patch_spacing = 0.5;
  static constexpr double averaging_radius = 0.35;
  static constexpr double sigma_ratio = 0.5;
  static constexpr double lattice_spacing = 0.5;
  static constexpr double search_size = 0.75;
  /// @}

  Vote_level(const Feature_surface& surface, double radius)
      : m_radius(radius), m_sigma(sigma_ratio * radius)
  {
    const Cell_index clusters = cluster(surface);
    average_normals();
    m_neighbours = Cell_list(m_positions, search_size * radius);
    choose_points(surface.points(), clusters);
    m_point_cells = Cell_list(m_points, search_size * radius);
  }

  // The search refers to the positions.
  Vote_level(const Vote_level&) = delete;
  Vote_level& operator=(const Vote_level&) = delete;

  double radius() const { return m_radius; }
  double sigma() const { return m_sigma; }

  /// \name Clusters
  /// @{
  std::size_t size() const { return m_positions.size(); }
  const Vector& position(std::size_t i) const { return m_positions[i]; }
  /// averaged over the neighbours on the same side of the surface.
  const Vector& normal(std::size_t i) const { return m_normals[i]; }
  /// of the cluster alone; shorter than a unit vector if its faces point elsewhere.
  Vector own_normal(std::size_t i) const { return m_area_vectors[i] / m_full_areas[i]; }
  /// of the surface across its averaged normal, not negative.
  double area(std::size_t i) const { return m_areas[i]; }
  Vector projection(std::size_t i) const { return m_positions[i] - m_radius * m_normals[i]; }

  template <class Function>
  void for_each_in_ball(const Vector& center, double radius, Function&& function) const
  {
    m_neighbours.for_each_in_ball(center, radius, function);
  }
  /// @}

  /// \name Points that shapes are fitted to, no denser than clusters
  /// @{
  std::size_t number_of_points() const { return m_points.size(); }
  const Vector& point(std::size_t i) const { return m_points[i]; }
  /// the length of the edges there.
  double point_spacing(std::size_t i) const { return m_point_spacings[i]; }
  /// averaged as those of the clusters are.
  const Vector& point_normal(std::size_t i) const { return m_point_normals[i]; }

  template <class Function>
  void for_each_point_in_ball(const Vector& center, double radius, Function&& function) const
  {
    m_point_cells.for_each_in_ball(center, radius, function);
  }
  /// @}

  /// \brief the weight of a vote: the part of the full solid angle that a cluster covers, less the farther
  /// its projection is from `x`. A sphere of any radius has 1 at its centre.
  double vote(std::size_t i, const Vector& x) const
  {
    const double squared = (projection(i) - x).squaredNorm() / (m_sigma * m_sigma);
    if(!(squared < 1))
      return 0;
    constexpr double full = 4 * 3.14159265358979323846;
    return m_areas[i] * (1 - squared) / (full * (m_positions[i] - x).squaredNorm());
  }

  /// \brief appends the local maxima of the votes on a lattice which are at least `threshold` and come from
  /// at least `least_voters` clusters.
  void append_candidates(double threshold, std::uint32_t least_voters, std::uint32_t level,
                         std::vector<Candidate>& candidates) const;

private:
  Cell_index cluster(const Feature_surface& surface);
  void average_normals();
  void choose_points(const Feature_surface::Points& points, const Cell_index& clusters);
  Vector normal_near(const Vector& position, const Vector& normal) const;

  static unsigned octant(const Vector& n)
  {
    return unsigned(n.x() > 0) | unsigned(n.y() > 0) << 1 | unsigned(n.z() > 0) << 2;
  }

  std::array<std::int32_t, 3> cell(const Vector& p, double size) const
  {
    const Vector c = ((p - m_origin) / size).array().floor();
    return {std::int32_t(c.x()), std::int32_t(c.y()), std::int32_t(c.z())};
  }

  double m_radius, m_sigma;
  Vector m_origin = Vector::Zero();
  std::vector<Vector> m_positions, m_area_vectors, m_side_normals, m_normals;
  std::vector<double> m_areas, m_full_areas;
  Cell_list m_neighbours;
  std::vector<Vector> m_points, m_point_normals;
  std::vector<double> m_point_spacings;
  Cell_list m_point_cells;
};

/// \return where the clusters are
inline Cell_index Vote_level::cluster(const Feature_surface& surface)
{
  const double size = cluster_size * m_radius;
  if(!surface.patches().empty())
    m_origin = surface.patches().front().position;
  Cell_index cells(surface.patches().size() / 2);
  surface.for_each_patch(patch_spacing * m_radius, [&](const Feature_surface::Patch& patch) {
    if(!(patch.area > 0))
      return;
    const std::uint32_t i =
        cells.insert(Cell_index::key(cell(patch.position, size), octant(patch.normal)));
    if(i == m_positions.size()) {
      m_positions.push_back(Vector::Zero());
      m_area_vectors.push_back(Vector::Zero());
      m_side_normals.push_back(Vector::Zero());
      m_areas.push_back(0);
    }
    m_positions[i] += patch.area * patch.position;
    m_area_vectors[i] += patch.area_vector;
    m_side_normals[i] += patch.area * patch.normal;
    m_areas[i] += patch.area;
  });
  for(std::size_t i = 0; i < m_positions.size(); ++i) {
    m_positions[i] /= m_areas[i];
    m_side_normals[i].normalize();
  }
  return cells;
}

/// \brief sums area vectors over the neighbourhood of each cluster, as far as they belong to the same side of
/// the surface.
///
/// The sum of the area vectors of a patch depends on its rim only: so noise of the vertices within it
/// has no effect, however rough the faces are.
inline void Vote_level::average_normals()
{
  const double reach = averaging_radius * m_radius;
  m_normals.assign(size(), Vector::Zero());
  Cell_list(m_positions, reach)
      .for_each_pair(reach, [&](std::size_t i, std::size_t j, double squared) {
        if(m_side_normals[i].dot(m_side_normals[j]) > 0)
          m_normals[i] += (1 - squared / (reach * reach)) * m_area_vectors[j];
      });
  for(Vector& normal : m_normals)
    normal.normalize();
  m_full_areas = m_areas;
  for(std::size_t i = 0; i < size(); ++i)
    m_areas[i] = std::max(m_area_vectors[i].dot(m_normals[i]), 0.);
}

/// the averaged normal of the clusters around a point that are on its side of the surface.
inline Eigen::Vector3d Vote_level::normal_near(const Vector& position, const Vector& normal) const
{
  const double reach = 1.5 * averaging_radius * m_radius;
  Vector sum = Vector::Zero();
  m_neighbours.for_each_in_ball(position, reach, [&](std::size_t j, double squared) {
    if(m_side_normals[j].dot(normal) > 0)
      sum += (1 - squared / (reach * reach)) * m_area_vectors[j];
  });
  return sum.squaredNorm() > 0 ? Vector(sum.normalized()) : normal;
}

/// \brief the first point of each cell, with the normal of the cluster there.
///
/// Vertices have patches around them, so there is one, unless its faces point elsewhere.
inline void Vote_level::choose_points(const Feature_surface::Points& points,
                                      const Cell_index& clusters)
{
  Cell_index cells(size());
  for(std::size_t v = 0; v < points.positions.size(); ++v) {
    const std::uint64_t key = Cell_index::key(cell(points.positions[v], cluster_size * m_radius),
                                              octant(points.normals[v]));
    if(cells.insert(key) != m_points.size())
      continue;
    m_points.push_back(points.positions[v]);
    m_point_spacings.push_back(points.spacings[v]);
    const std::uint32_t i = clusters.find(key);
    m_point_normals.push_back(
        i != Cell_index::none ? m_normals[i] : normal_near(points.positions[v], points.normals[v]));
  }
}

inline void Vote_level::append_candidates(double threshold, std::uint32_t least_voters,
                                          std::uint32_t level,
                                          std::vector<Candidate>& candidates) const
{
  const double spacing = lattice_spacing * m_radius;
  Cell_index index(size());
  std::vector<double> scores;
  std::vector<std::uint32_t> voters;
  std::vector<std::array<std::int32_t, 3>> places;
  const auto lattice_point = [&](const std::array<std::int32_t, 3>& c) {
    return Vector(m_origin + spacing * Vector(c[0], c[1], c[2]));
  };
  for(std::size_t i = 0; i < size(); ++i) {
    if(!(m_areas[i] > 0))
      continue;
    const Vector q = projection(i);
    const auto low = cell(q - Vector::Constant(m_sigma - spacing), spacing);
    const auto high = cell(q + Vector::Constant(m_sigma), spacing);
    for(std::int32_t z = low[2]; z <= high[2]; ++z)
      for(std::int32_t y = low[1]; y <= high[1]; ++y)
        for(std::int32_t x = low[0]; x <= high[0]; ++x) {
          const double v = vote(i, lattice_point({x, y, z}));
          if(!(v > 0))
            continue;
          const std::uint32_t place = index.insert(Cell_index::key({x, y, z}));
          if(place == scores.size()) {
            scores.push_back(0);
            voters.push_back(0);
            places.push_back({x, y, z});
          }
          scores[place] += v;
          ++voters[place];
        }
  }
  // Of equal neighbours the first one counts.
  const auto is_maximum = [&](std::uint32_t place) {
    const auto& [x, y, z] = places[place];
    for(std::int32_t dz = -1; dz <= 1; ++dz)
      for(std::int32_t dy = -1; dy <= 1; ++dy)
        for(std::int32_t dx = -1; dx <= 1; ++dx) {
          const std::uint32_t other = index.find(Cell_index::key({x + dx, y + dy, z + dz}));
          if(other != Cell_index::none &&
             (scores[other] > scores[place] || (scores[other] == scores[place] && other < place)))
            return false;
        }
    return true;
  };
  for(std::uint32_t place = 0; place < scores.size(); ++place)
    if(scores[place] >= threshold && voters[place] >= least_voters && is_maximum(place))
      candidates.push_back({lattice_point(places[place]), scores[place], level});
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_VOTE_LEVEL_H
