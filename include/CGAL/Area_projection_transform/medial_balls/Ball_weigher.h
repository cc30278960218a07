// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_BALL_WEIGHER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_BALL_WEIGHER_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_balls/Thinned_samples.h>

#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief weighs medial balls by the samples around them; its calls may run concurrently.
class Ball_weigher
{
public:
  using Vector = Eigen::Vector3d;

  struct Ball
  {
    Vector center;
    double radius;
  };

  struct Votes
  {
    double mapt, spread;
  };

  struct Contacts
  {
    double lambda, angle; ///< the angle in radians
  };

  explicit Ball_weigher(const Thinned_samples& samples) : m_samples(samples) {}

  Ball refitted(const Ball& ball) const;
  Votes votes(const Ball& ball, double sigma_ratio) const;
  Contacts contacts(const Ball& ball, const Vector& first, const Vector& second) const;

private:
  /// \brief the spacing of samples that count, in units of `σ`; several hundred of them are within a ball.
  static constexpr double sampling_ratio = 0.32;

  /// calls `function(level, sample, error)` for the samples that are projected to less than `sigma` from the centre,
  /// with their vectors from there.
  template <class Function>
  void for_each_voter(const Ball& ball, double sigma, double spacing, Function&& function) const
  {
    const Thinned_samples::Level& level = m_samples.at(spacing);
    level.cells.for_each_in_ball(ball.center, ball.radius + sigma, [&](std::size_t i, double) {
      const Vector error = level.positions[i] - ball.radius * level.normals[i] - ball.center;
      if(error.squaredNorm() <= sigma * sigma)
        function(level, i, error);
    });
  }

  /// whether the surface comes no nearer to the centre than a part of the radius.
  bool is_clear(const Ball& ball) const
  {
    constexpr double part = 1 / 1.1, spacing = 0.1;
    bool is_clear = true;
    m_samples.at(spacing * ball.radius)
        .cells.for_each_in_ball(ball.center, part * ball.radius,
                                [&is_clear](std::size_t, double) { is_clear = false; });
    return is_clear;
  }

  const Thinned_samples& m_samples;
};

/// \brief fits a ball to the samples that are projected near its centre: `p - r n = x` for all of them, by least squares,
/// some times over.
///
/// A mean shift towards the next maximum of the transform, for kernels that end at a quarter of the radius. A ball whose
/// voters do not tell where its centre is, all of them facing the same way, remains; so does one that would
/// move through the surface.
inline Ball_weigher::Ball Ball_weigher::refitted(const Ball& ball) const
{
  constexpr double sigma_ratio = 0.25, spacing = 0.07, least_variance = 0.03, rest = 1e-3;
  constexpr int rounds = 4;
  Ball fitted = ball;
  for(int round = 0; round < rounds; ++round) {
    const double sigma = sigma_ratio * fitted.radius;
    double weight = 0, mixed = 0;
    Vector position = Vector::Zero(), normal = Vector::Zero(); // from the centre
    for_each_voter(fitted, sigma, spacing * fitted.radius,
                   [&](const Thinned_samples::Level& level, std::size_t i, const Vector& error) {
                     const double w = level.areas[i] * (1 - error.squaredNorm() / (sigma * sigma));
                     const Vector p = level.positions[i] - fitted.center;
                     weight += w;
                     position += w * p;
                     normal += w * level.normals[i];
                     mixed += w * p.dot(level.normals[i]);
                   });
    if(!(weight > 0))
      return ball;
    position /= weight;
    normal /= weight;
    const double variance = 1 - normal.squaredNorm();
    if(!(variance >= least_variance))
      return ball;
    const double radius = (mixed / weight - position.dot(normal)) / variance;
    if(!(radius > 0.5 * ball.radius) || !(radius < 2 * ball.radius))
      return ball;
    const Vector step = position - radius * normal;
    fitted = {fitted.center + step, radius};
    if(step.norm() < rest * radius)
      break;
  }
  return is_clear(fitted) ? fitted : ball;
}

/// how much of the surface is projected into the ball of `sigma` around the centre, and how far it spreads.
inline Ball_weigher::Votes Ball_weigher::votes(const Ball& ball, double sigma_ratio) const
{
  const double sigma = sigma_ratio * ball.radius;
  double area = 0, squares = 0;
  Vector mean = Vector::Zero();
  for_each_voter(ball, sigma, sampling_ratio * sigma,
                 [&](const Thinned_samples::Level& level, std::size_t i, const Vector&) {
                   const Vector p = level.positions[i] - ball.center;
                   area += level.areas[i];
                   mean += level.areas[i] * p;
                   squares += level.areas[i] * p.squaredNorm();
                 });
  if(!(area > 0))
    return {0, 0};
  mean /= area;
  return {area * Scale{ball.radius, sigma}.normalization(),
          std::sqrt(std::max(squares / area - mean.squaredNorm(), 0.))};
}

/// \brief the smallest ball around the contacts, and the largest angle between the first and another one.
///
/// Contacts are the two given ones and samples that are hardly farther than they are. With those two only, a ball in
/// the middle of a tube would have whatever surface was next to the first.
inline Ball_weigher::Contacts Ball_weigher::contacts(const Ball& ball, const Vector& first,
                                                     const Vector& second) const
{
  constexpr double tolerance = 0.01, spacing = 0.16;
  constexpr std::size_t most = 100;
  const Thinned_samples::Level& level = m_samples.at(spacing * ball.radius);
  std::vector<std::size_t> contacts;
  level.cells.for_each_in_ball(ball.center, (1 + tolerance) * ball.radius,
                               [&contacts](std::size_t i, double) { contacts.push_back(i); });
  // The order of the cells depends on the axes, and some of many are taken.
  if(contacts.size() > most)
    std::sort(contacts.begin(), contacts.end());
  const Vector direction = (first - ball.center).normalized();
  const auto cosine = [&](const Vector& q) {
    return direction.dot((q - ball.center).normalized());
  };
  double least_cosine = cosine(second);
  std::vector<Point_3> points{Point_3(first.x(), first.y(), first.z()),
                              Point_3(second.x(), second.y(), second.z())};
  for(std::size_t i = 0; i < contacts.size(); ++i) {
    const Vector& contact = level.positions[contacts[i]];
    least_cosine = std::min(least_cosine, cosine(contact));
    if(i % (1 + contacts.size() / most) == 0)
      points.emplace_back(contact.x(), contact.y(), contact.z());
  }
  using Traits = Min_sphere_of_points_d_traits_3<Kernel, double>;
  Min_sphere_of_spheres_d<Traits> smallest(points.begin(), points.end());
  // Not larger than the ball itself, but for the tolerance.
  return {std::min(smallest.radius(), ball.radius), std::acos(std::clamp(least_cosine, -1., 1.))};
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_BALL_WEIGHER_H
