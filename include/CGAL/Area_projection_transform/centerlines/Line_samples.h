// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_SAMPLES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_SAMPLES_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_options.h>
#include <CGAL/Area_projection_transform/internal/Edges_by_vertex.h>
#include <CGAL/Area_projection_transform/internal/eigen_vectors.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief a surface as those who follow tubes want it: points that have an area, points that are fitted to, or both.
///
/// Points of fits must lie on the surface that the mesh stands for: those are its vertices, and places on the creases
/// between long facets. Area is everywhere. So the area of small faces is given to their vertices; large faces are
/// cut into pieces that have the area, and are fitted to only where there is nothing better.
class Line_samples
{
public:
  using Vector = Eigen::Vector3d;

  struct Sample
  {
    Vector position;
    Vector normal; ///< out of the side on which lines are sought
    double area;
    double weight; ///< in fits
  };

  Line_samples(const Triangle_surface& surface, const Centerline_options& options);
  Line_samples(const Surfels& surfels, const Centerline_options& options);

  std::size_t size() const { return m_samples.size(); }
  const Sample& operator[](std::size_t i) const { return m_samples[i]; }

  double smallest_radius() const { return m_smallest_radius; }
  double largest_radius() const { return m_largest_radius; }
  bool is_turned_over() const { return m_is_turned_over; }

  /// \brief calls `function(begin, end)` for each face, or point of a point set, with the samples that stand for it.
  ///
  /// In the order of the input, without what was skipped there.
  template <class Function>
  void for_each_element(Function&& function) const
  {
    for(std::size_t e = 0; e + 1 < m_begin.size(); ++e)
      function(m_of_element.data() + m_begin[e], m_of_element.data() + m_begin[e + 1]);
  }

private:
  class Mesh_sampler;

  /// samples of pieces of large faces count so much in fits, for their area.
  static constexpr double weight_of_pieces = 0.02;

  void set_radii(const Vector& centroid, double area, const Centerline_options& options);
  void orient(const Vector& centroid, Side side);

  std::vector<Sample> m_samples;
  std::vector<std::size_t> m_begin{0};
  std::vector<std::uint32_t> m_of_element;
  double m_smallest_radius = 0, m_largest_radius = 0;
  bool m_is_turned_over = false;
};

/// \brief sets the radii that the user did not.
///
/// They depend on the distance from the centroid, not on a bounding box, which turns with the axes.
inline void Line_samples::set_radii(const Vector& centroid, double area,
                                    const Centerline_options& options)
{
  constexpr double smallest = 0.003, largest = 0.25; // of the extent
  double extent = 0;
  for(const Sample& sample : m_samples)
    extent = std::max(extent, 2 * (sample.position - centroid).norm());
  // A tube as long as that, of all of the area, has three times this radius.
  const double thin = extent > 0 ? area / (6 * 3.14159265358979323846 * extent) : 0;
  m_largest_radius = options.largest_radius.value_or(
      std::max(largest * extent, 2 * options.smallest_radius.value_or(0)));
  m_smallest_radius =
      options.smallest_radius.value_or(std::min({smallest * extent, thin, m_largest_radius}));
  m_smallest_radius = // what is thinner is noise of the places
      std::max(m_smallest_radius, std::min(1e-9 * extent, m_largest_radius));
  m_largest_radius = std::min(m_largest_radius, std::max(extent, m_smallest_radius));
}

/// turns all normals around if they point into the shape.
inline void Line_samples::orient(const Vector& centroid, Side side)
{
  double volume = 0;
  for(const Sample& sample : m_samples)
    volume += sample.area * sample.normal.dot(sample.position - centroid);
  m_is_turned_over = side == Side::INSIDE && volume < 0;
  if(m_is_turned_over || side == Side::OUTSIDE)
    for(Sample& sample : m_samples)
      sample.normal = -sample.normal;
}

/// makes samples of a mesh: vertices first, then points on creases and in faces.
class Line_samples::Mesh_sampler
{
public:
  Mesh_sampler(const Triangle_surface& surface, std::vector<Sample>& samples)
      : m_surface(surface)
      , m_joined(joined_points(surface))
      , m_samples(samples)
      , m_sample_of(surface.points.size(), none)
  {}

  /// the vertices, with their normals; places of the input that are the same are one sample.
  void add_vertices()
  {
    for(std::size_t t = 0; t < m_surface.size(); ++t)
      for(const std::uint32_t v : m_surface.triangles[t]) {
        std::uint32_t& index = m_sample_of[m_joined[v]];
        if(index == none) {
          index = std::uint32_t(m_samples.size());
          m_samples.push_back({to_eigen(m_surface.points[v]), Vector::Zero(), 0, 0});
        }
        m_samples[index].normal += m_surface.areas[t] * to_eigen(m_surface.normals[t]);
      }
    for(Sample& sample : m_samples)
      sample.normal.normalize();
  }

  /// \brief hands out the weights of fits: a third of each face to each edge.
  ///
  /// An edge has points at its ends, and if it is a long crease in between. Of the two long edges of a thin triangle,
  /// the one along which the surface bends more lies on what the mesh stands for, and the other crosses a facet.
  void add_edges()
  {
    std::vector<double> largest_bend(m_surface.size(), 0);
    const Edges_by_vertex edges(m_surface, [&](std::uint32_t v) { return m_joined[v]; });
    edges.all_edges([&](std::uint32_t lower, const auto* begin, const auto* end) {
      if(end - begin == 2 && is_long(lower, begin))
        for(const auto* side = begin; side != end; ++side)
          largest_bend[side->face] = std::max(largest_bend[side->face], bend(begin));
      return true;
    });
    edges.all_edges([&](std::uint32_t lower, const auto* begin, const auto* end) {
      double weight = 0;
      for(const auto* side = begin; side != end; ++side)
        weight += m_surface.areas[side->face] / 3;
      const bool is_crease =
          end - begin == 2 && is_long(lower, begin) && bend(begin) > 1e-6 &&
          !(bend(begin) <
            std::max(largest_bend[begin[0].face], largest_bend[begin[1].face]) * (1 - 1e-9));
      add_edge(lower, begin, weight, is_crease);
      return true;
    });
  }

  /// the area of the faces: to their corners, or to pieces; calls `done()` after each face.
  template <class Done>
  void add_faces(double smallest_radius, std::vector<std::uint32_t>& of_element, Done&& done)
  {
    for(std::size_t t = 0; t < m_surface.size(); ++t) {
      const Triangle_piece whole =
          whole_triangle(m_surface.corner(t, 0), m_surface.corner(t, 1), m_surface.corner(t, 2));
      const double variance = largest_variance(std::max(spacing(t), 0.3 * smallest_radius));
      if((whole.opposite[0] + whole.opposite[1] + whole.opposite[2]) / 36 <= variance)
        for(const std::uint32_t v : m_surface.triangles[t]) {
          of_element.push_back(m_sample_of[m_joined[v]]);
          m_samples[of_element.back()].area += m_surface.areas[t] / 3;
        }
      else
        add_pieces(t, whole, variance, of_element);
      done();
    }
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr double most_pieces_along = 200;

  double height(std::size_t t) const
  {
    double longest = 0;
    for(int i = 0; i < 3; ++i)
      longest = std::max(
          longest, squared_distance(m_surface.corner(t, i), m_surface.corner(t, (i + 1) % 3)));
    return longest > 0 ? 2 * m_surface.areas[t] / std::sqrt(longest) : 0;
  }

  /// needles are cut into pieces as long as they are wide; others not at all.
  double spacing(std::size_t t) const
  {
    const double h = height(t), area = m_surface.areas[t];
    return std::max(1.25 * h, h > 0 ? 2 * area / h / most_pieces_along : 0);
  }

  double bend(const Edges_by_vertex::Side* sides) const
  {
    return 1 - m_surface.normals[sides[0].face] * m_surface.normals[sides[1].face];
  }

  /// the larger one of the heights of two faces above their common edge, along which they are thin.
  double height(const Edges_by_vertex::Side* sides) const
  {
    return std::max(height(sides[0].face), height(sides[1].face));
  }

  double length(std::uint32_t lower, const Edges_by_vertex::Side* sides) const
  {
    return std::sqrt(squared_distance(m_surface.points[lower], m_surface.points[sides->higher]));
  }

  bool is_long(std::uint32_t lower, const Edges_by_vertex::Side* sides) const
  {
    constexpr double thin = 3;
    return length(lower, sides) > thin * height(sides);
  }

  void add_edge(std::uint32_t lower, const Edges_by_vertex::Side* sides, double weight,
                bool is_crease)
  {
    constexpr double apart = 1.5; // in units of the height of the faces
    const std::uint32_t first = m_sample_of[lower], last = m_sample_of[sides->higher];
    if(first == last)
      return;
    const Vector a = m_samples[first].position, b = m_samples[last].position;
    const double number =
        is_crease
            ? std::min(std::ceil(length(lower, sides) / (apart * height(sides))), most_pieces_along)
            : 1;
    m_samples[first].weight += weight / (2 * number);
    m_samples[last].weight += weight / (2 * number);
    if(number == 1)
      return;
    const Vector normal =
        (to_eigen(m_surface.normals[sides[0].face]) + to_eigen(m_surface.normals[sides[1].face]))
            .normalized();
    for(int i = 1; i < int(number); ++i)
      m_samples.push_back({a + (i / number) * (b - a), normal, 0, weight / number});
  }

  void add_pieces(std::size_t t, const Triangle_piece& whole, double variance,
                  std::vector<std::uint32_t>& of_element)
  {
    const Vector a = to_eigen(m_surface.corner(t, 0)), b = to_eigen(m_surface.corner(t, 1)),
                 c = to_eigen(m_surface.corner(t, 2));
    const auto sample = [&](const Triangle_piece& piece) {
      const std::array<double, 3> w = piece.centroid();
      const double area = piece.fraction * m_surface.areas[t];
      of_element.push_back(std::uint32_t(m_samples.size()));
      m_samples.push_back({w[0] * a + w[1] * b + w[2] * c, to_eigen(m_surface.normals[t]), area,
                           weight_of_pieces * area});
    };
    for_each_piece(whole, variance, sample);
  }

  const Triangle_surface& m_surface;
  std::vector<std::uint32_t> m_joined;
  std::vector<Sample>& m_samples;
  std::vector<std::uint32_t> m_sample_of;
};

inline Line_samples::Line_samples(const Triangle_surface& surface,
                                  const Centerline_options& options)
{
  double area = 0;
  Vector centroid = Vector::Zero();
  for(std::size_t t = 0; t < surface.size(); ++t) {
    area += surface.areas[t];
    for(int i = 0; i < 3; ++i)
      centroid += surface.areas[t] / 3 * to_eigen(surface.corner(t, i));
  }
  if(!(area > 0))
    return;
  centroid /= area;
  Mesh_sampler sampler(surface, m_samples);
  sampler.add_vertices();
  set_radii(centroid, area, options);
  sampler.add_edges();
  sampler.add_faces(m_smallest_radius, m_of_element,
                    [this] { m_begin.push_back(m_of_element.size()); });
  orient(centroid, options.side);
}

inline Line_samples::Line_samples(const Surfels& surfels, const Centerline_options& options)
{
  double area = 0;
  Vector centroid = Vector::Zero();
  for(std::size_t i = 0; i < surfels.size(); ++i) {
    const Vector position = to_eigen(surfels.positions[i]);
    m_samples.push_back(
        {position, to_eigen(surfels.normals[i]), surfels.areas[i], surfels.areas[i]});
    m_of_element.push_back(std::uint32_t(i));
    m_begin.push_back(m_of_element.size());
    area += surfels.areas[i];
    centroid += surfels.areas[i] * position;
  }
  if(!(area > 0)) {
    m_samples.clear();
    return;
  }
  centroid /= area;
  set_radii(centroid, area, options);
  orient(centroid, options.side);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_LINE_SAMPLES_H
