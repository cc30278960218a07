// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shapes that are fitted to points: against geometry in closed form, and derivatives against differences.

#include "shapes.h"

#include <CGAL/Area_projection_transform/fitting/Ellipsoid.h>
#include <CGAL/Area_projection_transform/fitting/Sphere.h>
#include <CGAL/Area_projection_transform/fitting/Tube.h>
#include <CGAL/Area_projection_transform/salient_points/refine_shape.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace {

namespace in = CGAL::Area_projection::internal;
using in::Ellipsoid;
using in::Sphere;
using in::Tube;
using shapes::pi;
using shapes::Random;
using Vector = Eigen::Vector3d;

Vector random_vector(Random& random, double size = 1)
{
  const double x = random(-size, size), y = random(-size, size);
  return {x, y, random(-size, size)};
}

Eigen::Matrix3d random_rotation(Random& random)
{
  const Vector axis = random_vector(random).normalized();
  return Eigen::AngleAxisd(random(0, 2 * pi), axis).toRotationMatrix();
}

/// a tube bent to a ring of radius 1 / `k`, somewhere.
Tube random_tube(Random& random, double radius, double k, double slope)
{
  const Eigen::Matrix3d turn = random_rotation(random);
  Tube tube;
  tube.center = random_vector(random);
  tube.axis = turn.col(0);
  tube.curvature = k * turn.col(1);
  tube.radius = radius;
  tube.slope = slope;
  return tube;
}

Vector point_on(const Tube& tube, double along, double angle)
{
  const Vector tangent = tube.tangent_at(along).normalized();
  const Vector e = tangent.unitOrthogonal();
  const Vector radial = std::cos(angle) * e + std::sin(angle) * tangent.cross(e);
  return tube.point_at(along) + tube.radius_at(along) * radial;
}

// The distance of (x, y, z) from the circle of radius R in the plane z = 0 is |(|(x, y)| − R, z)|.
TEST(Tube, of_a_bend_is_a_torus)
{
  Random random(1);
  for(const double ring : {1., 3., 40.}) {
    Tube tube;
    tube.center = {ring, 0, 0};
    tube.axis = {0, 1, 0};
    tube.curvature = {-1 / ring, 0, 0};
    tube.radius = 0.4;
    for(int i = 0; i < 200; ++i) {
      const Vector p = random_vector(random, 1.5 * ring);
      const Tube::Place place = tube.place(p);
      const double beside = std::hypot(p.x(), p.y()) - ring;
      const double distance = std::hypot(beside, p.z());
      EXPECT_NEAR(place.distance, distance, 1e-13 * ring);
      EXPECT_NEAR(place.along, ring * std::atan2(p.y(), p.x()), 1e-13 * ring);
      EXPECT_NEAR(tube.residual(p), distance - 0.4, 1e-13 * ring);
      // The normal is the gradient of the distance.
      const Vector outward(beside * p.x() / (beside + ring), beside * p.y() / (beside + ring),
                           p.z());
      EXPECT_NEAR((tube.normal_at(place) - outward / distance).norm(), 0, 1e-11);
    }
  }
}

// A straight line and one that is bent by k are no farther apart than k s²/2 at the length s. A bend of less than 1e-9
// along s counts as none.
TEST(Tube, is_exact_where_it_is_hardly_bent)
{
  Random random(2);
  constexpr double limit = 1e-9;
  for(const double k : {0., 1e-14, 1e-11, 1e-9, 1e-8, 1e-6, 1e-4}) {
    const Tube bent = random_tube(random, 0.5, k, 0);
    Tube straight = bent;
    straight.curvature.setZero();
    for(int i = 0; i < 100; ++i) {
      const Vector p = bent.center + random_vector(random, 3);
      const double bound = 0.5 * k * (p - bent.center).squaredNorm();
      const double difference = bent.residual(p) - straight.residual(p);
      EXPECT_LE(std::abs(difference), 1.01 * bound + 1e-14) << k;
      // To first order it is what the bend moves the axis by.
      const Tube::Place place = straight.place(p);
      const double expected = -0.5 * place.along * place.along * bent.curvature.dot(place.radial);
      const double second = 100 * k * k / std::max(place.distance, 0.01);
      const double straightened = 0.5 * limit * std::abs(place.along);
      EXPECT_NEAR(difference, expected, second + straightened + 1e-14) << k;
    }
  }
}

TEST(Tube, of_a_slope_is_a_cone)
{
  // The distance from the line of the cone with slope s through (z, ρ) = (0, r): (ρ − r − s z) / √(1 + s²).
  Random random(3);
  Tube cone;
  cone.axis = Vector::UnitZ();
  cone.radius = 0.7;
  cone.slope = 0.3;
  for(int i = 0; i < 100; ++i) {
    const Vector p = random_vector(random);
    const double rho = std::hypot(p.x(), p.y());
    const double expected = (rho - 0.7 - 0.3 * p.z()) / std::sqrt(1.09);
    EXPECT_NEAR(cone.residual(p), expected, 1e-15);
    const Vector normal = Vector(p.x() / rho, p.y() / rho, -0.3) / std::sqrt(1.09);
    EXPECT_NEAR((cone.normal_at(cone.place(p)) - normal).norm(), 0, 1e-14);
  }
}

TEST(Tube, is_the_same_seen_from_elsewhere)
{
  Random random(4);
  for(const double k : {0., 1e-7, 0.2, 1.}) {
    const Tube tube = random_tube(random, 0.4, k, 0.1);
    for(const double along : {-0.8, 1e-3, 0.5, 1.2}) {
      const Tube other = tube.seen_from(along);
      EXPECT_NEAR(other.axis.norm(), 1, 1e-15);
      EXPECT_NEAR(other.curvature.norm(), k, 1e-15);
      EXPECT_NEAR(other.curvature.dot(other.axis), 0, 1e-15);
      for(int i = 0; i < 30; ++i) {
        const Vector p =
            point_on(tube, random(-1, 1), random(0, 2 * pi)) + random_vector(random, 0.1);
        EXPECT_NEAR(other.residual(p), tube.residual(p), 1e-12);
        EXPECT_NEAR(other.place(p).along + along, tube.place(p).along, 1e-12);
      }
      const Tube back = other.seen_from(-along);
      EXPECT_NEAR((back.center - tube.center).norm() + (back.axis - tube.axis).norm() +
                      (back.curvature - tube.curvature).norm() +
                      std::abs(back.radius - tube.radius),
                  0, 1e-12); // what a bend of 1e-9 moves it by
    }
  }
}

TEST(Tube, has_an_axis_of_unit_speed)
{
  Random random(5);
  for(const double k : {0., 1e-8, 0.3, 1.}) {
    const Tube tube = random_tube(random, 0.4, k, 0.1);
    for(const double s : {-1.5, -1e-3, 0., 0.7}) {
      const double h = 1e-4; // the central difference is off by k² h² / 6
      const Vector difference = (tube.point_at(s + h) - tube.point_at(s - h)) / (2 * h);
      EXPECT_NEAR((difference - tube.tangent_at(s)).norm(), 0, 2e-9);
      EXPECT_NEAR(tube.place(tube.point_at(s)).distance, 0, 1e-14);
      EXPECT_NEAR(tube.place(tube.point_at(s)).along, s, 1e-13);
      const Vector p = point_on(tube, s, 2);
      EXPECT_NEAR(tube.residual(p), 0, 1e-14);
    }
  }
}

/// \brief the row of the equations for one point, from their step: with a ridge λ, large against the row `J`, it is
/// `−r J / (λ + |J|²)`.
template <class Equations>
typename Equations::Row row_of(const Equations& equations, double residual)
{
  const double lambda = 1e9;
  return equations.step(Equations::Row::Constant(lambda)) * (-lambda / residual);
}

/// compares the rows of `model` at `p` with central differences of the residual, for the first `number` parameters.
template <class Model, class EquationsOf>
void expect_derivatives(const Model& model, const Vector& p, EquationsOf equations_of, int number)
{
  const auto residual = [&](const Model& m) {
    if constexpr(std::is_same_v<Model, Ellipsoid>)
      return m.place(p).residual;
    else
      return m.residual(p);
  };
  const double h = 1e-5; // differences are off by some h² and by some 1e-16 / h
  const auto row = row_of(equations_of(model, std::vector<Vector>{p}), residual(model));
  using Row = std::decay_t<decltype(row)>;
  for(int i = 0; i < number; ++i) {
    Model above = model, below = model;
    above.move(h * Row::Unit(i));
    below.move(-h * Row::Unit(i));
    EXPECT_NEAR(row[i], (residual(above) - residual(below)) / (2 * h), 1e-6) << "parameter " << i;
  }
}

// Next to the surface only: there the rows are exact. A residual of 1e-7 takes that much away from it, and rounding
// leaves 1e-9 of it.
constexpr double near_by = 1e-7;

TEST(Sphere, has_the_derivatives_of_its_residual)
{
  Random random(6);
  const auto equations = [](const Sphere& sphere, const std::vector<Vector>& points) {
    return sphere.equations(points, 1e9);
  };
  const Sphere sphere{random_vector(random), 0.8};
  for(int i = 0; i < 20; ++i)
    expect_derivatives(sphere, sphere.center + random_vector(random), equations, 4);
}

TEST(Tube, has_the_derivatives_of_its_residual)
{
  Random random(7);
  const auto equations = [](const Tube& tube, const std::vector<Vector>& points) {
    return tube.equations(points, 1e9, {true, true});
  };
  const Tube tube = random_tube(random, 0.6, 0, 0);
  for(int i = 0; i < 20; ++i) {
    const Vector p = point_on(tube, random(-1, 1), random(0, 2 * pi));
    expect_derivatives(tube, p + near_by * random_vector(random), equations, Tube::size);
  }
}

TEST(Tube, keeps_what_is_not_fitted)
{
  Random random(8);
  const Tube tube = random_tube(random, 0.6, 0, 0);
  const Vector p = tube.center + tube.axis + 0.7 * tube.axis.unitOrthogonal();
  const Tube::Equations::Row row = row_of(tube.equations({p}, 1e9, {}), tube.residual(p));
  EXPECT_EQ(row[Tube::SLOPE], 0);
  EXPECT_EQ(row[Tube::CURVATURE], 0);
  EXPECT_EQ(row[Tube::CURVATURE + 1], 0);
}

Ellipsoid random_ellipsoid(Random& random, const Vector& lengths)
{
  const Eigen::Matrix3d turn = random_rotation(random);
  Ellipsoid ellipsoid;
  ellipsoid.center = random_vector(random);
  ellipsoid.matrix = turn * lengths.cwiseInverse().asDiagonal() * turn.transpose();
  return ellipsoid;
}

Vector point_on(const Ellipsoid& ellipsoid, const Vector& direction)
{
  return ellipsoid.center + ellipsoid.matrix.inverse() * direction.normalized();
}

TEST(Ellipsoid, has_the_derivatives_of_its_residual)
{
  Random random(9);
  const auto equations = [](const Ellipsoid& ellipsoid, const std::vector<Vector>& points) {
    return ellipsoid.equations(points, 1e9);
  };
  const Ellipsoid ellipsoid = random_ellipsoid(random, {0.5, 0.8, 1.3});
  for(int i = 0; i < 20; ++i) {
    const Vector p = point_on(ellipsoid, random_vector(random));
    expect_derivatives(ellipsoid, p + near_by * random_vector(random), equations, 9);
  }
}

TEST(Ellipsoid, tells_its_axes_and_its_size)
{
  Random random(10);
  const Ellipsoid ellipsoid = random_ellipsoid(random, {1.3, 0.5, 0.8});
  const Ellipsoid::Axes axes = ellipsoid.axes();
  EXPECT_NEAR((axes.lengths - Vector(0.5, 0.8, 1.3)).norm(), 0, 1e-14);
  for(int i = 0; i < 3; ++i) {
    const Vector end = ellipsoid.center + axes.lengths[i] * axes.directions.col(i);
    EXPECT_NEAR(ellipsoid.place(end).residual, 0, 1e-14);
    EXPECT_NEAR((ellipsoid.place(end).normal - axes.directions.col(i)).norm(), 0, 1e-13);
  }
  EXPECT_NEAR(ellipsoid.radius(), std::cbrt(0.5 * 0.8 * 1.3), 1e-14);
}

// On a sphere the distance to first order is the distance; elsewhere it is off by the square of it over the smallest
// radius of curvature, c²/a for the half axes a ≥ b ≥ c.
TEST(Ellipsoid, measures_distances_to_first_order)
{
  Random random(11);
  const Ellipsoid sphere = random_ellipsoid(random, {0.7, 0.7, 0.7});
  const Ellipsoid ellipsoid = random_ellipsoid(random, {0.5, 0.8, 1.3});
  for(int i = 0; i < 50; ++i) {
    const Vector p = random_vector(random, 2);
    EXPECT_NEAR(sphere.place(p).residual, (p - sphere.center).norm() - 0.7, 1e-14);
    const Vector q = point_on(ellipsoid, random_vector(random));
    const Vector normal = ellipsoid.place(q).normal;
    for(const double d : {-0.01, 0.01})
      EXPECT_NEAR(ellipsoid.place(q + d * normal).residual, d, d * d / (0.25 / 1.3));
  }
}

TEST(Ellipsoid, is_found_from_points_and_normals)
{
  // Its normals are the gradients of one quadratic function only if they are as long as those: on a sphere.
  Random random(12);
  const Ellipsoid sphere = random_ellipsoid(random, {0.7, 0.7, 0.7});
  std::vector<Vector> points, normals;
  for(int i = 0; i < 60; ++i) {
    points.push_back(point_on(sphere, random_vector(random)));
    normals.push_back(sphere.place(points.back()).normal);
  }
  const auto found =
      in::ellipsoid_with_normals(points, normals, sphere.center + Vector(0.2, 0, 0), 1);
  ASSERT_TRUE(found);
  // The ridge of 1e-9 is what there is of an error.
  EXPECT_NEAR((found->center - sphere.center).norm(), 0, 1e-7);
  EXPECT_NEAR((found->axes().lengths - Vector(0.7, 0.7, 0.7)).norm(), 0, 1e-7);
}

TEST(Ellipsoid, is_not_found_in_a_saddle)
{
  std::vector<Vector> points, normals;
  for(int i = -4; i <= 4; ++i)
    for(int j = -4; j <= 4; ++j) {
      const double x = 0.1 * i, y = 0.1 * j;
      points.emplace_back(x, y, x * x - y * y);
      normals.push_back(Vector(-2 * x, 2 * y, 1).normalized());
    }
  EXPECT_FALSE(in::ellipsoid_with_normals(points, normals, Vector(0, 0, -0.5), 1));
}

/// where the steps of a fit end.
template <class Model, class EquationsOf>
Model fitted(Model model, EquationsOf equations_of)
{
  for(int round = 0; round < 60; ++round) {
    const auto equations = equations_of(model);
    using Row = std::decay_t<decltype(equations.step({}))>;
    model.move(equations.step(Row::Constant(1e-12)));
  }
  return model;
}

TEST(Fit, ends_at_the_shape_that_points_lie_on)
{
  Random random(13);
  for(const double k : {0., 0.3, 1.})
    for(const double slope : {0., 0.2}) {
      const Tube truth = random_tube(random, 0.4, k, slope);
      std::vector<Vector> points;
      for(int i = 0; i < 200; ++i)
        points.push_back(point_on(truth, random(-0.8, 0.8), random(0, 2 * pi)));
      Tube start = truth;
      start.center += random_vector(random, 0.05);
      start.axis = (start.axis + random_vector(random, 0.1)).normalized();
      start.curvature.setZero();
      start.slope = 0;
      start.radius = 0.45;
      const Tube tube = fitted(start, [&](const Tube& now) {
        return now.equations(points, 1, {true, true});
      });
      const double along = tube.place(truth.center).along;
      EXPECT_NEAR(tube.place(truth.center).distance, 0, 1e-10);
      EXPECT_NEAR(tube.radius_at(along), 0.4, 1e-10);
      EXPECT_NEAR(tube.curvature.norm(), k, 1e-9);
      EXPECT_NEAR(tube.slope, slope, 1e-10);
    }
}

TEST(Fit, of_an_ellipsoid_ends_at_the_one_that_points_lie_on)
{
  Random random(14);
  const Ellipsoid truth = random_ellipsoid(random, {0.5, 0.8, 1.1});
  std::vector<Vector> points;
  for(int i = 0; i < 200; ++i)
    points.push_back(point_on(truth, random_vector(random)));
  Ellipsoid start = truth;
  start.center += random_vector(random, 0.05);
  start.matrix += 0.1 * Eigen::Matrix3d::Identity();
  const Ellipsoid found =
      fitted(start, [&](const Ellipsoid& now) { return now.equations(points, 1); });
  EXPECT_NEAR((found.center - truth.center).norm(), 0, 1e-10);
  EXPECT_NEAR((found.matrix - truth.matrix).norm(), 0, 1e-9);
}

// One point in ten is anywhere; without weights it would move the radius by a tenth of the distance.
TEST(Fit, leaves_outliers_out)
{
  Random random(15);
  std::vector<Vector> points;
  for(int i = 0; i < 300; ++i)
    points.push_back(random_vector(random).normalized() * (i % 10 == 0 ? 1.5 : 1));
  const Sphere found = fitted(Sphere{Vector(0.01, 0, 0), 1.01}, [&](const Sphere& now) {
    return now.equations(points, 0.1); // beyond 0.47 there is no weight
  });
  EXPECT_NEAR(found.radius, 1, 1e-9);
  EXPECT_NEAR(found.center.norm(), 0, 1e-9);
}

// Of n points all around, displaced by s, the mean of the distances is the radius: its variance is s²/n, but for
// what the weights lose, 1/0.95; the mean over 200 seeds of the estimate is near it, and so is what is seen.
TEST(Fit, knows_the_variance_of_the_radius)
{
  const int n = 100, seeds = 200;
  const double s = 0.01;
  double estimates = 0, squares = 0;
  for(int seed = 0; seed < seeds; ++seed) {
    Random random{std::uint64_t(seed)};
    std::vector<Vector> points;
    for(int i = 0; i < n; ++i) {
      double gauss = -6; // of variance 1
      for(int k = 0; k < 12; ++k)
        gauss += random();
      const CGAL::Area_projection::Vector_3 d = random.direction();
      points.push_back((1 + s * gauss) * Vector(d.x(), d.y(), d.z()));
    }
    const Sphere found = fitted(Sphere{Vector::Zero(), 1},
                                [&](const Sphere& now) { return now.equations(points, s); });
    estimates += found.equations(points, s).covariance({0, 1, 2, 3})(3, 3) / seeds;
    squares += (found.radius - 1) * (found.radius - 1) / seeds;
  }
  const double expected = s * s / n / 0.95;
  EXPECT_NEAR(estimates, expected, 0.1 * expected);
  EXPECT_NEAR(squares, expected, 3 * std::sqrt(2. / seeds) * expected);
}

TEST(Tukey, falls_from_one_to_nothing_at_its_limit)
{
  const in::Tukey tukey(0.5);
  const double limit = 4.685 * 0.5;
  EXPECT_EQ(tukey.weight(0), 1);
  EXPECT_EQ(tukey.weight(limit), 0);
  EXPECT_EQ(tukey.weight(-2 * limit), 0);
  EXPECT_EQ(tukey.slope(2 * limit), 0);
  EXPECT_NEAR(tukey.weight(limit / 2), 0.5625, 1e-15); // (3/4)²
  const double h = 1e-5;
  const auto psi = [&](double r) { return r * tukey.weight(r); };
  for(double r = -2.2; r < 2.3; r += 0.1)
    EXPECT_NEAR(tukey.slope(r), (psi(r + h) - psi(r - h)) / (2 * h), 1e-9);
}

// That is what the constant 4.685 is known for.
TEST(Tukey, has_an_efficiency_of_95_percent_for_normal_residuals)
{
  const in::Tukey tukey(1);
  double slopes = 0, squares = 0;
  const double h = 1e-3;
  for(double x = -10; x < 10; x += h) {
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * pi);
    slopes += h * density * tukey.slope(x);
    squares += h * density * x * x * tukey.weight(x) * tukey.weight(x);
  }
  EXPECT_NEAR(slopes * slopes / squares, 0.95, 1e-4);
}

TEST(Robust_deviation, is_the_standard_deviation_of_normal_residuals)
{
  // The quantiles of the half normal distribution: half of it is below 0.67449 = 1/1.4826.
  std::vector<double> residuals;
  const int n = 1001;
  double x = 0, probability = 0;
  for(int i = 0; i < n; ++i) {
    for(; probability < (i + 0.5) / n; x += 1e-4)
      probability += 1e-4 * 2 * std::exp(-0.5 * x * x) / std::sqrt(2 * pi);
    residuals.push_back(i % 2 ? -x : x);
  }
  EXPECT_NEAR(in::robust_deviation(residuals), 1, 1e-3);
  EXPECT_EQ(in::robust_deviation({}), 0);
  EXPECT_DOUBLE_EQ(in::robust_deviation({0, -1, 100}), 1.4826);
}

TEST(Student_quantile, is_right_to_one_percent_from_five_degrees_of_freedom_on)
{
  // of any table of the distribution, at 0.975
  const std::map<double, double> table = {{5, 2.5706},  {6, 2.4469},  {8, 2.3060},
                                          {10, 2.2281}, {15, 2.1314}, {20, 2.0860},
                                          {30, 2.0423}, {60, 2.0003}, {1e9, 1.95996}};
  for(const auto& [degrees, quantile] : table)
    EXPECT_NEAR(in::student_quantile(degrees), quantile, 0.01 * quantile) << degrees;
}

} // namespace
