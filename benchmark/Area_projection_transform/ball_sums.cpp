// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums of weights in balls at arbitrary points: CGAL's search, nanoflann, the tree of the library, and cells
// with prefix sums, on the parallel surface of a bumpy sphere. CPU times of one thread.

#include "Weighted_point_cells.h"

#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>

#include <CGAL/Random.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#if __has_include(<nanoflann.hpp>)
#include <nanoflann.hpp>
#define AREA_PROJECTION_TRANSFORM_HAS_NANOFLANN
#endif

namespace AP = CGAL::Area_projection;

namespace {

using AP::Point_3;
using AP::Vector_3;

/// sums for the balls of one radius.
using Sum = std::function<double(const Point_3&, double)>;

double seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

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

#ifdef AREA_PROJECTION_TRANSFORM_HAS_NANOFLANN
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

struct Method
{
  std::string name;
  Sum sum;
  double build; // milliseconds
};

template <class Make>
Method built(const std::string& name, Make make)
{
  const double start = seconds();
  const auto sums = make();
  return {name, [sums](const Point_3& x, double sigma) { return (*sums)(x, sigma); },
          1e3 * (seconds() - start)};
}

std::vector<Method> methods_for_all_radii(const AP::Projected_surfels& points)
{
  std::vector<Method> methods;
  methods.push_back(built("CGAL Fuzzy_sphere", [&] {
    return std::make_shared<AP::Kd_tree_evaluator>(As_they_are{points}, 1, AP::Side::INSIDE, 1);
  }));
#ifdef AREA_PROJECTION_TRANSFORM_HAS_NANOFLANN
  methods.push_back(built("nanoflann", [&] { return std::make_shared<Nanoflann_sums>(points); }));
#endif
  methods.push_back(built("tree", [&] { return std::make_shared<AP::Sampled_evaluator>(points); }));
  return methods;
}

/// microseconds for each sum, the least of three runs.
double time_of_sums(const Sum& sum, const std::vector<Point_3>& places, double sigma, double& total)
{
  double least = HUGE_VAL;
  for(int run = 0; run < 3; ++run) {
    total = 0;
    const double start = seconds();
    for(const Point_3& x : places)
      total += sum(x, sigma);
    least = std::min(least, 1e6 * (seconds() - start) / double(places.size()));
  }
  return least;
}

void print_rows(const AP::Projected_surfels& points, const std::vector<Method>& methods,
                double points_in_ball, std::ostream& out)
{
  const double sigma = radius_of_balls(points, methods.back().sum, points_in_ball);
  const std::vector<Point_3> places = places_near(points, sigma / 2, 2000);
  std::vector<Method> all = methods;
  for(int division : {3, 4, 6, 8})
    all.push_back(built("cells of sigma / " + std::to_string(division),
                        [&] { return std::make_shared<Cell_sums>(points, sigma / division); }));
  double of_search = 0, sum_of_search = 0;
  for(const Method& method : all) {
    double sum = 0;
    const double time = time_of_sums(method.sum, places, sigma, sum);
    if(of_search == 0) {
      of_search = time;
      sum_of_search = sum;
    }
    out << std::defaultfloat << std::setprecision(6) << std::setw(9) << points.size()
        << std::setw(9) << points_in_ball << "  " << std::left << std::setw(20) << method.name
        << std::right << std::fixed << std::setprecision(1) << std::setw(9) << method.build
        << std::setprecision(2) << std::setw(10) << time << std::setprecision(1) << std::setw(9)
        << of_search / time << std::scientific << std::setw(11) << std::abs(sum / sum_of_search - 1)
        << "\n";
  }
}

void benchmark_ball_sums(std::ostream& out)
{
  out << "instructions: " << name(AP::internal::instruction_set()) << "\n"
      << "   points  in ball  method               build ms    sum us  CGAL/it  difference\n";
  for(std::size_t number : {100000, 1000000}) {
    const AP::Projected_surfels points = offset_of_bumpy_sphere(number);
    const std::vector<Method> methods = methods_for_all_radii(points);
    for(double points_in_ball : {100., 2600., 10000., 90000.})
      if(points_in_ball < 0.5 * double(number))
        print_rows(points, methods, points_in_ball, out);
  }
}

} // namespace

int main()
{
  benchmark_ball_sums(std::cout);
}
