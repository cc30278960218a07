// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far a small bump on a cylinder moves its medial axis, pruned by one weight or another.

#include "body_view.h"
#include "canvas.h"
#include "figures.h"
#include "marks.h"
#include "shapes.h"
#include "transform.h"
#include "views.h"

#include <CGAL/Area_projection_transform/medial_balls.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace Paper {

namespace {

namespace AP = CGAL::Area_projection;
using AP::Medial_ball;
using AP::Medial_weight;
using Tag = CGAL::Parallel_if_available_tag;

constexpr double tolerance = 0.02; // up to which the surface counts as covered

struct Shape
{
  AP::Triangle_surface surface;
  std::vector<Medial_ball> balls;
};

/// pulls the points around (1, 0, 0) out onto a small ball there, each away from the axis.
Soup with_bump(Soup soup, double radius)
{
  for(Point_3& p : soup.points) {
    const double rho = std::hypot(p.x(), p.y());
    if(!(rho > 0.5) || !(p.x() > 0))
      continue;
    const double cosine = p.x() / rho, sine = p.y() / rho;
    const double root = radius * radius - sine * sine - p.z() * p.z();
    const double out = root > 0 ? cosine + std::sqrt(root) : 0;
    if(out > rho)
      p = Point_3(out * cosine, out * sine, p.z());
  }
  return soup;
}

Shape shape_of(const Soup& soup, double stop_angle)
{
  AP::Medial_ball_options options;
  options.stop_angle = stop_angle;
  Shape shape{AP::surface_from_triangle_soup(soup.points, soup.triangles), {}};
  shape.balls = AP::medial_balls<Tag>(shape.surface, options);
  return shape;
}

/// the distances of the centres of some balls from the nearest centres of others.
struct Distances
{
  std::vector<double> all;

  void add(const std::vector<Point_3>& from, const std::vector<Point_3>& to)
  {
    using Traits = CGAL::Search_traits_3<AP::Kernel>;
    CGAL::Kd_tree<Traits> tree(to.begin(), to.end());
    for(const Point_3& p : from) {
      const CGAL::Orthogonal_k_neighbor_search<Traits> search(tree, p, 1);
      all.push_back(std::sqrt(search.begin()->second));
    }
  }

  double largest() const { return *std::max_element(all.begin(), all.end()); }

  double mean() const
  {
    double sum = 0;
    for(double d : all)
      sum += d;
    return sum / double(all.size());
  }

  double quantile(double part) const
  {
    std::vector<double> sorted = all;
    const auto place = sorted.begin() + std::ptrdiff_t(part * double(sorted.size() - 1));
    std::nth_element(sorted.begin(), place, sorted.end());
    return *place;
  }
};

std::vector<Point_3> centres(const Shape& shape, Medial_weight weight, double threshold)
{
  std::vector<Point_3> points;
  for(const std::size_t i : AP::select_by_weight(shape.balls, weight, threshold))
    points.push_back(shape.balls[i].refitted_center);
  return points;
}

/// both ways, between the balls that are left of two shapes.
Distances distances(const Shape& a, const Shape& b, Medial_weight weight, double threshold)
{
  const std::vector<Point_3> of_a = centres(a, weight, threshold),
                             of_b = centres(b, weight, threshold);
  Distances result;
  if(of_a.empty() || of_b.empty())
    return {{std::numeric_limits<double>::infinity()}};
  result.add(of_a, of_b);
  result.add(of_b, of_a);
  return result;
}

/// the largest thresholds at which what is kept covers these parts of the surface, in descending order of the parts.
std::vector<double> thresholds(const Shape& shape, Medial_weight weight,
                               const std::vector<double>& parts)
{
  std::vector<std::pair<double, std::size_t>> order;
  for(std::size_t i = 0; i < shape.balls.size(); ++i)
    order.emplace_back(-AP::weight_of(shape.balls[i], weight), i);
  std::sort(order.begin(), order.end());
  const AP::internal::Covered_surface places(shape.surface, 10000, tolerance);
  std::vector<bool> is_covered(places.size(), false);
  const double total = places.total_area();
  double covered = 0;
  std::vector<double> result(parts.size(), -std::numeric_limits<double>::infinity());
  std::size_t next = parts.size(); // one more than that which is reached next
  for(const auto& [negative, ball] : order) {
    places.for_each_covered(shape.balls[ball], [&](std::size_t i) {
      if(!is_covered[i])
        covered += places.area(i);
      is_covered[i] = true;
    });
    for(; next > 0 && covered >= parts[next - 1] * total; --next)
      result[next - 1] = -negative;
    if(next == 0)
      break;
  }
  return result;
}

constexpr std::pair<const char*, Medial_weight> weights[] = {
    {"importance", Medial_weight::IMPORTANCE}, {"MAPT", Medial_weight::MAPT},
    {"R MAPT", Medial_weight::RADIAL_MAPT},    {"lambda", Medial_weight::LAMBDA},
    {"scale axis", Medial_weight::SCALE_AXIS}, {"angle", Medial_weight::ANGLE},
    {"radius", Medial_weight::RADIUS}};

std::vector<Benchmarks::Row> compare(const Shape& plain, const Shape& bumpy, double bump,
                                     double noise)
{
  const Medial_weight any = Medial_weight::RADIUS;
  const double unpruned = distances(plain, bumpy, any, 0).largest();
  const std::vector<double> parts{0.99, 0.97, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.6, 0.5};
  std::vector<Benchmarks::Row> rows;
  for(const auto& [name, weight] : weights) {
    const std::vector<double> least = thresholds(plain, weight, parts);
    for(std::size_t k = 0; k < parts.size(); ++k) {
      if(!std::isfinite(least[k]) || (weight == Medial_weight::IMPORTANCE && !(least[k] > 0)))
        continue; // infinitely many, or all
      const Distances moved = distances(plain, bumpy, weight, least[k]);
      if(!std::isfinite(moved.largest()))
        continue;
      rows.push_back(row(
          "figure 5",
          noise > 0     ? "bump and noise"
          : bump < 0.25 ? "small bump"
                        : "bump",
          name,
          {{"coverage", parts[k]}, {"bump", bump}, {"noise", noise}, {"balls", plain.balls.size()}},
          {{"Hausdorff", moved.largest()},
           {"95 %", moved.quantile(0.95)},
           {"mean", moved.mean()},
           {"unpruned", unpruned},
           {"gain", unpruned / std::max(moved.largest(), 1e-9)}}));
    }
  }
  return rows;
}

/// \brief writes a picture of the centres near the plane y = 0, of all balls and of what weights keep at 85 % coverage,
/// of the cylinder at the left and with the bump at the right.
void write_picture_of_axes(const Options& options, const Shape& plain, const Shape& bumpy)
{
  using namespace mapt::palette;
  constexpr int margin = 20, oversampling = 2;
  constexpr double scale = 80, thickness = 0.1; // pixels, and length, in units of the radius
  constexpr std::pair<const char*, Medial_weight> shown[] = {
      {"all balls", Medial_weight::RADIUS},
      {"lambda", Medial_weight::LAMBDA},
      {"scale axis", Medial_weight::SCALE_AXIS},
      {"importance, by mapt", Medial_weight::IMPORTANCE}};
  const CGAL::Bbox_3 box = bumpy.surface.bbox();
  const mapt::View lying{2, 0};
  const mapt::Camera size(lying, box, scale), camera(lying, box, oversampling * scale);
  mapt::Canvas canvas(2 * size.width() + 3 * margin, 4 * (size.height() + 2 * margin), ground);
  int y = 2 * margin - margin / 2;
  for(const auto& [name, weight] : shown) {
    const double least =
        weight == Medial_weight::RADIUS ? 0 : thresholds(plain, weight, {0.85}).front();
    int x = margin;
    for(const Shape* shape : {&plain, &bumpy}) {
      mapt::Canvas page(camera.width(), camera.height(), ground);
      mapt::draw_body(page, camera, &shape->surface);
      for(const Point_3& p : centres(*shape, weight, least))
        if(std::abs(p.y()) < thickness)
          mapt::draw_ball(page, camera, p, 0, ink);
      canvas.draw_halved(page, x, y);
      x += size.width() + margin;
    }
    canvas.write(margin, y - margin, name, font_size, ink);
    y += size.height() + 2 * margin;
  }
  std::filesystem::create_directories(options.pictures);
  canvas.write_PNG(options.pictures + "/figure_5_axes.png");
}

/// the joint maps of both, as the paper has them.
void write_pictures_of_maps(const Options& options, const Soup& plain, const Soup& bumpy)
{
  std::vector<AP::Scale> scales;
  for(double radius = 0.2; radius < 1.05; radius += 0.1)
    scales.push_back({radius, 0.5 * radius});
  for(const auto& [name, soup] : {std::pair("plain", &plain), {"bump", &bumpy}}) {
    const Inside interior = inside(*soup, grid_of(*soup, options.pick(64, 160)));
    const Maps maps = compute_maps("face", *soup, interior.region, scales);
    write_picture_of_joint_map(options.pictures + "/figure_5_" + name + "_joint.png", maps, *soup);
  }
}

} // namespace

void figure_5(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 5",
      "A cylinder (radius 1, length 6, flat ends) without and with a small ball on its side: how "
      "far the centres of medial balls move, both ways, if those are kept whose weight is at "
      "least what leaves a part of the cylinder covered (up to 0.02). All weights are of the "
      "same balls, at their refitted centres. Hausdorff, 95 % and mean are distances; gain is how "
      "much less that is than without pruning. Where a weight cannot cover that much, or has so "
      "many infinite values, there is no row.");
  const int sides = options.pick(48, 96), rows = options.pick(60, 160);
  const Soup plain = cylinder(1, 6, sides, rows);
  const Shape axis = shape_of(plain, 20);
  for(const double bump : options.pick<std::vector<double>>({0.25}, {0.125, 0.25})) {
    const Soup soup = with_bump(plain, bump);
    const Shape bumpy = shape_of(soup, 20);
    publish(compare(axis, bumpy, bump, 0), report);
    if(bump == 0.25 && !options.pictures.empty()) {
      write_picture_of_axes(options, axis, bumpy);
      write_pictures_of_maps(options, plain, soup);
    }
  }
  // Displaced within balls of 0.3 edges, about.
  const double noise = 0.3 / std::sqrt(5.);
  const Shape noisy = shape_of(add_noise(plain, noise, options.seed), 45);
  const Shape noisy_bump = shape_of(add_noise(with_bump(plain, 0.25), noise, options.seed + 1), 45);
  publish(compare(noisy, noisy_bump, 0.25, 0.3), report);
}

} // namespace Paper
