// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "salient.h"
#include "salient_picture.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Paper {

namespace {

using Benchmarks::Row;

struct Ball
{
  const char* name;
  Point_3 centre;
  double radius;
};

/// the radii are those of the paper; places, and the length of the cylinder, are not told there.
const std::array<Ball, 3> balls{{{"sphere 1", {0, 0, 0}, 1},
                                 {"sphere 0.5", {1.8, 0, 0}, 0.5},
                                 {"sphere 0.25", {2.8, 0, 0}, 0.25}}};
constexpr double tube_radius = 0.4, tube_length = 3;
const Point_3 tube_centre(5, 0, 0);
/// askew, so that no voxels lie along it; a unit vector.
const Vector_3 tube_axis = Vector_3(6, 2, 1) / std::sqrt(41.);

/// moves the `z` axis to the axis of the tube.
Point_3 placed_on_tube(const Point_3& p)
{
  const Vector_3 across = CGAL::cross_product(Vector_3(0, 0, 1), tube_axis);
  const Vector_3 u = across / std::sqrt(across.squared_length());
  return tube_centre + p.x() * u + p.y() * CGAL::cross_product(tube_axis, u) + p.z() * tube_axis;
}

Soup toy(int levels)
{
  Soup scene;
  for(const Ball& ball : balls) {
    Soup sphere = icosphere(levels);
    for(Point_3& p : sphere.points)
      p = ball.centre + ball.radius * (p - CGAL::ORIGIN);
    scene = joined(std::move(scene), sphere);
  }
  Soup tube = cylinder(tube_radius, tube_length, 4 << levels, 1 << levels);
  for(Point_3& p : tube.points)
    p = placed_on_tube(p);
  return joined(std::move(scene), tube);
}

/// \brief what a point is in the middle of: no farther off than 0.15 of the radius, or than a point of the
/// lattice may have to be.
///
/// Within a diameter of its ends, lids add to the map of a tube: that is not the map of a cylinder.
std::string object_at(const Point_3& p, double voxel)
{
  const double half_diagonal = 0.5 * std::sqrt(3.) * voxel;
  const auto tolerance = [&](double radius) {
    return std::pow(std::max(0.15 * radius, half_diagonal), 2);
  };
  for(const Ball& ball : balls)
    if(CGAL::squared_distance(p, ball.centre) <= tolerance(ball.radius))
      return ball.name;
  const Vector_3 v = p - tube_centre;
  const double along = std::abs(v * tube_axis);
  const double across = CGAL::cross_product(v, tube_axis).squared_length();
  if(across > tolerance(tube_radius) || along > 0.5 * tube_length)
    return "elsewhere";
  return along < 0.5 * tube_length - 2 * tube_radius ? "tube" : "end of tube";
}

double radius_of(const std::string& object)
{
  for(const Ball& ball : balls)
    if(object == ball.name)
      return ball.radius;
  return tube_radius;
}

/// how many points there are on each object, and radius and sphericity of the strongest.
Measures count(const Salient_run& run)
{
  std::map<std::string, std::vector<const Salient_point*>> found;
  for(const Salient_point& p : run.points)
    found[object_at(p.position, run.reference_length)].push_back(&p);
  Measures measures{{"points", double(run.points.size())}};
  for(const std::string object : {"sphere 1", "sphere 0.5", "sphere 0.25", "tube"}) {
    measures.emplace_back("on " + object, double(found[object].size()));
    if(found[object].empty())
      continue;
    measures.emplace_back("R/R0, " + object, found[object][0]->scale / radius_of(object));
    measures.emplace_back("sphericity, " + object, found[object][0]->sphericity);
  }
  measures.emplace_back("on ends of tube", double(found["end of tube"].size()));
  measures.emplace_back("elsewhere", double(found["elsewhere"].size()));
  measures.emplace_back("seconds", run.seconds);
  return measures;
}

void compare_readings(const Soup& scene, const std::vector<double>& reference_lengths,
                      Benchmarks::Report& report)
{
  std::vector<Row> rows;
  for(double s : reference_lengths)
    for(double smoothing : {1., 0.})
      for(Salient_mode mode : salient_modes()) {
        mode.reference_length = s;
        mode.smoothing = smoothing;
        rows.push_back(row("figure 9", "points on objects", mode.name,
                           {{"faces", scene.triangles.size()}, {"s", s}, {"smoothing", smoothing}},
                           count(find_salient_points(scene, mode))));
      }
  publish(rows, report);
}

void list_points(const Options& options, const Soup& scene, double s, Benchmarks::Report& report)
{
  for(Salient_mode mode : salient_modes()) {
    mode.reference_length = s;
    const Salient_run run = find_salient_points(scene, mode);
    std::vector<Row> rows;
    for(const Salient_point& p : run.points)
      rows.push_back(row("figure 9", "points, " + mode.name, object_at(p.position, s), {{"s", s}},
                         describe(p)));
    publish(rows, report);
    write_picture_of_points(options, "figure_9_" + mode.name + ".png", scene, run.points);
  }
}

} // namespace

void figure_9(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 9",
      "Three spheres and a cylinder, with the reference length s of the paper in its two readings, "
      "√A / 80π and √(A / 80π), and in between. A point belongs to an object if it is no farther "
      "from the centre, or the axis, than 0.15 of the radius, or half the diagonal of a voxel. "
      "R/R0 and sphericity are those of the "
      "strongest point of the object. Over dense radii the map of a sphere is largest at R/R0 = "
      "0.667, that of a cylinder at 0.845; the Gaussian moves that upwards.");
  const Soup scene = toy(options.pick(4, 5));
  const double short_s = short_reference_length(scene), long_s = long_reference_length(scene);
  compare_readings(scene,
                   options.pick<std::vector<double>>({0.1, long_s}, {short_s, 0.05, 0.1, long_s}),
                   report);
  list_points(options, scene, options.pick(0.1, short_s), report);
}

} // namespace Paper
