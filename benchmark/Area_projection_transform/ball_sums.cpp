// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums of weights in balls at arbitrary points, on the parallel surface of a bumpy sphere.

#include "Weighted_point_cells.h"
#include "benchmark_suite.h"

#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>

#include <CGAL/Random.h>
#include <CGAL/point_generators_3.h>

#ifdef AREA_PROJECTION_TRANSFORM_NANOFLANN
#include <nanoflann.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Benchmarks {

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Vector_3;

/// the sum in the ball of a radius around a point.
using Sum = std::function<double(const Point_3&, double)>;

/// \brief points of the surface `r(d) = 1 + 0.1 b(d)`, moved inward by 0.3, where the normal is taken from
/// the gradient of the bumps `b`; all of the same weight, 1 in total.
AP::Projected_surfels offset_of_bumpy_sphere(std::size_t number)
{
  CGAL::Random random(1);
  CGAL::Random_points_on_sphere_3<Point_3> direction(1., random);
  AP::Projected_surfels points;
  points.reserve(number);
  for(std::size_t i = 0; i < number; ++i, ++direction) {
    const Vector_3 d = *direction - CGAL::ORIGIN;
    const double x = std::sin(5 * d.x()), y = std::sin(4 * d.y() + 1), z = std::cos(6 * d.z());
    const Vector_3 gradient(5 * std::cos(5 * d.x()) * y * z, 4 * x * std::cos(4 * d.y() + 1) * z,
                            -6 * x * y * std::sin(6 * d.z()));
    const double radius = 1 + 0.1 * x * y * z;
    const Vector_3 normal = d - (0.1 / radius) * (gradient - (gradient * d) * d);
    points.push_back(CGAL::ORIGIN + radius * d -
                         (0.3 / std::sqrt(normal.squared_length())) * normal,
                     1. / double(number));
  }
  return points;
}

std::vector<Point_3> places_near(const AP::Projected_surfels& points, double distance,
                                 std::size_t number)
{
  CGAL::Random random(2);
  const auto offset = [&] { return random.get_double(-distance, distance); };
  std::vector<Point_3> places;
  for(std::size_t i = 0; i < number; ++i)
    places.push_back(points.positions[std::size_t(random.get_int(0, int(points.size())))] +
                     Vector_3(offset(), offset(), offset()));
  return places;
}

/// the radius of balls half a radius off the surface at most that have so many points in the mean.
double radius_of_balls(const AP::Projected_surfels& points, const Sum& sum, double points_in_ball)
{
  double low = 0, high = 2;
  for(int step = 0; step < 20; ++step) {
    const double middle = (low + high) / 2;
    double found = 0;
    const std::vector<Point_3> places = places_near(points, middle / 2, 200);
    for(const Point_3& x : places)
      found += sum(x, middle) * double(points.size()) / double(places.size());
    (found < points_in_ball ? low : high) = middle;
  }
  return high;
}

/// hands its points out as they are.
struct As_they_are
{
  const AP::Projected_surfels& points;

  template <class BatchSink>
  void project(double, AP::Side, double, BatchSink&& sink) const
  {
    sink(points);
  }
};

#ifdef AREA_PROJECTION_TRANSFORM_NANOFLANN
struct Nanoflann_points
{
  const std::vector<Point_3>& positions;
  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return positions[i][int(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

struct Nanoflann_sums
{
  using Metric = nanoflann::L2_Simple_Adaptor<double, Nanoflann_points>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Nanoflann_points, 3, std::size_t>;

  /// what nanoflann calls a result set: adds as points are found.
  struct Result
  {
    const std::vector<double>& areas;
    double worst, sum;
    double worstDist() const { return worst; }
    bool full() const { return true; }
    bool addPoint(double squared_distance, std::size_t i)
    {
      if(squared_distance <= worst)
        sum += areas[i];
      return true;
    }
  };

  explicit Nanoflann_sums(const AP::Projected_surfels& points)
      : adaptor{points.positions}
      , areas(points.areas)
      , tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(32))
  {
    tree.buildIndex();
  }

  double operator()(const Point_3& x, double sigma) const
  {
    const double query[3] = {x.x(), x.y(), x.z()};
    Result result{areas, sigma * sigma, 0};
    tree.findNeighbors(result, query, nanoflann::SearchParams());
    return result.sum;
  }

  Nanoflann_points adaptor;
  const std::vector<double>& areas;
  Tree tree;
};
#endif

struct Cell_sums
{
  Cell_sums(const AP::Projected_surfels& points, double size)
      : quantum(points.areas), cells(AP::internal::weighted_points(points, quantum), size)
  {}

  double operator()(const Point_3& x, double sigma) const
  {
    return quantum.weight(cells.sum(AP::internal::ball_around(x, sigma)));
  }

  AP::internal::Weight_quantum quantum;
  AP::internal::Weighted_point_cells cells;
};

/// a way to sum: `make` builds what answers.
struct Method
{
  std::string name;
  std::function<Sum()> make;
};

template <class Make>
Method method(const std::string& name, Make make)
{
  return {name, [make] {
            return [sums = make()](const Point_3& x, double sigma) { return (*sums)(x, sigma); };
          }};
}

/// The points must outlive the methods and what they make.
std::vector<Method> methods_for_all_radii(const AP::Projected_surfels& points)
{
  std::vector<Method> methods;
  methods.push_back(method("CGAL Fuzzy_sphere", [&points] {
    return std::make_shared<AP::Kd_tree_evaluator>(As_they_are{points}, 1, AP::Side::INSIDE, 1);
  }));
#ifdef AREA_PROJECTION_TRANSFORM_NANOFLANN
  methods.push_back(
      method("nanoflann", [&points] { return std::make_shared<Nanoflann_sums>(points); }));
#endif
  methods.push_back(method("Sampled_evaluator",
                           [&points] { return std::make_shared<AP::Sampled_evaluator>(points); }));
  return methods;
}

std::vector<Method> methods_for_radius(const AP::Projected_surfels& points, double sigma)
{
  std::vector<Method> methods;
  for(int division : {3, 5, 8})
    methods.push_back(
        method("cells of σ/" + std::to_string(division), [&points, size = sigma / division] {
          return std::make_shared<Cell_sums>(points, size);
        }));
  return methods;
}

std::vector<double> sums_at(const std::vector<Point_3>& places, double sigma, const Sum& sum)
{
  std::vector<double> sums;
  sums.reserve(places.size());
  for(const Point_3& x : places)
    sums.push_back(sum(x, sigma));
  return sums;
}

/// the largest difference, relative to the largest sum.
double error_of(const std::vector<double>& sums, const std::vector<double>& expected)
{
  double difference = 0;
  for(std::size_t i = 0; i < sums.size(); ++i)
    difference = std::max(difference, std::abs(sums[i] - expected[i]));
  return difference / *std::max_element(expected.begin(), expected.end());
}

struct Named_sum
{
  std::string name;
  Sum sum;
};

std::vector<Named_sum> made(const std::vector<Method>& methods)
{
  std::vector<Named_sum> sums;
  for(const Method& m : methods)
    sums.push_back({m.name, m.make()});
  return sums;
}

void compare_sums(Group& group, const AP::Projected_surfels& points, std::vector<Named_sum> sums,
                  double points_in_ball)
{
  const double sigma = radius_of_balls(points, sums.back().sum, points_in_ball);
  const std::vector<Point_3> places = places_near(
      points, sigma / 2, group.pick(std::size_t(50), std::size_t(500), std::size_t(2000)));
  for(Named_sum& cells : made(methods_for_radius(points, sigma)))
    sums.push_back(std::move(cells));
  const std::vector<double> expected = sums_at(places, sigma, sums.front().sum);

  Comparison comparison = group.comparison(
      "sums",
      {{"points", points.size()}, {"points in ball", points_in_ball}, {"sums", places.size()}});
  for(const Named_sum& s : sums) {
    Row& row = comparison.add(s.name, [&] { keep(sums_at(places, sigma, s.sum).data()); });
    row.measures.emplace_back("error", error_of(sums_at(places, sigma, s.sum), expected));
  }
  comparison.run();
}

void compare_building(Group& group, const AP::Projected_surfels& points,
                      const std::vector<Method>& methods, double sigma)
{
  Comparison comparison = group.comparison("building", {{"points", points.size()}});
  const auto add = [&comparison](const Method& m) {
    comparison.add(m.name, [make = m.make] { keep(bool(make())); });
  };
  for(const Method& m : methods)
    add(m);
  for(const Method& m : methods_for_radius(points, sigma))
    add(m);
  comparison.run();
}

void ball_sums(Group& group)
{
  const std::size_t most = group.pick(std::size_t(2000), std::size_t(100000), std::size_t(1000000));
  for(std::size_t number = std::min(most, std::size_t(100000)); number <= most; number *= 10) {
    const AP::Projected_surfels points = offset_of_bumpy_sphere(number);
    const std::vector<Method> methods = methods_for_all_radii(points);
    const std::vector<Named_sum> sums = made(methods);
    compare_building(group, points, methods, radius_of_balls(points, sums.back().sum, 100));
    for(double points_in_ball : {100., 2600., 10000., 90000.})
      if(points_in_ball < 0.5 * double(number))
        compare_sums(group, points, sums, points_in_ball);
  }
}

const Registered_group registered(
    "ball_sums",
    "Sums of the weights of points in balls at arbitrary places, on the parallel surface "
    "of a bumpy sphere. The baseline is the search of CGAL; the errors are the largest "
    "differences from it, relative to the largest sum. Cells are for one radius σ of the "
    "balls, the others for any; in the table of building, it is that of balls of 100 "
    "points."
#ifndef AREA_PROJECTION_TRANSFORM_NANOFLANN
    " Built without nanoflann: its rows are missing."
#endif
    ,
    ball_sums);

} // namespace

} // namespace Benchmarks
