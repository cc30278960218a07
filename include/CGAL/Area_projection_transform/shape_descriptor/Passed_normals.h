// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_PASSED_NORMALS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_PASSED_NORMALS_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/joined_points.h>
#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief normals averaged over a part of the surface that grows from radius to radius, as `Averaged_normals` has them, but
/// found in little time: they are passed from the triangles to their corners and back, some times for each radius, so that
/// a radius goes on where the one before has ended.
///
/// A pass takes the normal of a triangle as far as its corners are and as far again: it spreads it by the variance
/// `(a² + b² + c²)/9` along either direction. Where that is more than what is wanted the triangle takes only a part of what
/// comes back. Corners join what shares an edge and what shares a point, also around missing triangles.
class Passed_normals
{
public:
  /// \brief how many passes for all radii are worth while: on a mesh that is so fine that it takes more, equations are
  /// solved faster (`Averaged_normals`).
  static constexpr std::size_t most_passes = 60;

  using Normal = std::array<float, 3>;

  /// what is seen at a radius: for each triangle the averaged normal, and how much of its area votes, from 0 to 1.
  struct Seen
  {
    std::vector<Vector_3> normals;
    std::vector<float> shares;
  };

  /// \param surface must outlive this
  explicit Passed_normals(const Triangle_surface& surface)
      : m_surface(surface), m_corners(surface.triangles), m_variances(surface.size())
  {
    const std::vector<std::uint32_t> places = joined_points(surface);
    double sum = 0, area = 0;
    for(std::size_t t = 0; t < surface.size(); ++t) {
      double squares = 0;
      for(std::size_t i = 0; i < 3; ++i) {
        m_corners[t][i] = places[surface.triangles[t][i]];
        squares += squared_distance(surface.corner(t, int(i)), surface.corner(t, int(i + 1) % 3));
      }
      m_variances[t] = float(squares / 9);
      sum += surface.areas[t] * squares / 9;
      area += surface.areas[t];
    }
    m_mean_variance = area > 0 ? sum / area : 0;
  }

  /// \brief how many passes spread normals to a deviation, from one before. Triangles that are much smaller than others
  /// do not count as much as their number.
  std::size_t number_of_passes(double before, double deviation) const
  {
    const double passes = (deviation * deviation - before * before) / m_mean_variance;
    return passes < double(most_passes) ? std::size_t(std::ceil(std::max(passes, 0.)))
                                        : most_passes + 1;
  }

  /// \param deviations ascending; of the neighbourhood, along either direction
  std::vector<Seen> operator()(const std::vector<double>& deviations) const
  {
    std::vector<Normal> normals;
    for(const Vector_3& n : normals_of_elements(m_surface))
      normals.push_back({float(n.x()), float(n.y()), float(n.z())});
    const std::vector<Normal> own = normals;
    std::vector<Seen> all;
    double before = 0;
    for(double deviation : deviations) {
      const std::size_t passes = number_of_passes(before, deviation);
      const double variance = deviation * deviation - before * before;
      for(std::size_t p = 0; p < passes; ++p)
        pass(variance / double(passes), normals);
      all.push_back(seen(own, normals));
      before = deviation;
    }
    return all;
  }

private:
  void pass(double variance, std::vector<Normal>& normals) const
  {
    std::vector<std::array<float, 4>> corners(m_surface.points.size(), {{0, 0, 0, 0}});
    for(std::size_t t = 0; t < normals.size(); ++t) {
      const float area =
          float(m_surface.areas[t] / m_mean_variance); // in units that floats can hold
      for(std::uint32_t v : m_corners[t]) {
        for(std::size_t i = 0; i < 3; ++i)
          corners[v][i] += area * normals[t][i];
        corners[v][3] += area;
      }
    }
    for(auto& corner : corners)
      for(std::size_t i = 0; i < 3; ++i)
        corner[i] /= std::max(corner[3], 1e-30f);
    for(std::size_t t = 0; t < normals.size(); ++t) {
      const float share = std::min(1.f, float(variance) / std::max(m_variances[t], 1e-30f));
      const auto &a = corners[m_corners[t][0]], &b = corners[m_corners[t][1]],
                 &c = corners[m_corners[t][2]];
      for(std::size_t i = 0; i < 3; ++i)
        normals[t][i] += share * ((a[i] + b[i] + c[i]) / 3 - normals[t][i]);
    }
  }

  Seen seen(const std::vector<Normal>& own, const std::vector<Normal>& averages) const
  {
    Seen result;
    result.normals.reserve(own.size());
    result.shares.reserve(own.size());
    for(std::size_t t = 0; t < own.size(); ++t) {
      const Vector_3 n(own[t][0], own[t][1], own[t][2]);
      const Vector_3 average = normalized(Vector_3(averages[t][0], averages[t][1], averages[t][2]));
      const bool is_there =
          average.squared_length() > 0; // or there is nothing to go by but its own
      result.normals.push_back(is_there ? average : n);
      result.shares.push_back(is_there ? std::max(0.f, float(average * n)) : 1.f);
    }
    return result;
  }

  const Triangle_surface& m_surface;
  std::vector<Triangle_surface::Triangle> m_corners;
  std::vector<float> m_variances;
  double m_mean_variance = 0;
};

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_PASSED_NORMALS_H
