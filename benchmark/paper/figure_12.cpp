// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "line_methods.h"
#include "shapes.h"

#include <cmath>
#include <utility>

namespace Paper {

namespace {

using Benchmarks::Row;

/// a straight tube with flat ends.
struct Limb
{
  Point_3 start, end;
  double radius;

  Line axis() const { return {{start, end}, {radius, radius}}; }
  Vector_3 direction() const { return (end - start) / std::sqrt((end - start).squared_length()); }

  bool contains(const Point_3& p) const
  {
    const Vector_3 v = p - start;
    const double along = v * direction();
    return along > 0 && v * (end - start) < (end - start).squared_length() &&
           v.squared_length() - along * along < radius * radius;
  }

  /// with faces whose edges are about `edge` long.
  Soup soup(double edge) const
  {
    const double length = std::sqrt((end - start).squared_length());
    Soup tube = cylinder(radius, length, int(std::ceil(2 * 3.14159265358979 * radius / edge)),
                         int(std::ceil(length / edge)));
    const Vector_3 up = direction();
    const Vector_3 across = CGAL::cross_product(Vector_3(0, 1, 0), up);
    const Vector_3 u = across / std::sqrt(across.squared_length());
    const Point_3 middle = CGAL::midpoint(start, end);
    for(Point_3& p : tube.points)
      p = middle + p.x() * u + p.y() * CGAL::cross_product(up, u) + p.z() * up;
    return tube;
  }
};

/// \brief a body with an arm, attached to it along half of its length.
///
/// Their axes are 1.07 apart at the shoulder, where a third of the thickness of the arm is within the body, 1.4 in the
/// middle, where they touch, and 1.74 at the hand. None is along the lattice.
const Limb body{{-0.6, -5, 0.3}, {0.5, 5, -0.4}, 1};
const Limb arm{{1.44, 4, -0.13}, {1.21, -4, 0.58}, 0.4};

/// what of a limb is outside of another: faces are left out, so that the seam is open by some edges.
Soup outside_of(const Limb& other, Soup limb)
{
  std::vector<Soup::Triangle> kept;
  for(const Soup::Triangle& t : limb.triangles)
    if(!other.contains(CGAL::centroid(limb.points[t[0]], limb.points[t[1]], limb.points[t[2]])))
      kept.push_back(t);
  limb.triangles = std::move(kept);
  return limb;
}

Soup body_with_arm(double edge)
{
  return joined(outside_of(arm, body.soup(edge)), outside_of(body, arm.soup(edge)));
}

void find_lines_in_a_hand(const Options& options, Benchmarks::Report& report)
{
  std::vector<Row> rows;
  for(const Mesh& mesh : read_meshes(options, {"hand.obj"}))
    for(const Line_method& method : line_methods(options)) {
      const Line_run run = find_lines(method, mesh.soup);
      rows.push_back(row("figure 12", "A: lines", method.name,
                         {{"mesh", mesh.name}, {"faces", mesh.soup.triangles.size()}},
                         summarise(run, mesh.soup)));
      write_picture_of_lines(options, "figure_12_A_" + mesh.name + "_" + method.name + ".png",
                             mesh.soup, run.lines);
    }
  publish(rows, report);
}

void find_an_attached_arm(const Options& options, Benchmarks::Report& report)
{
  const Soup soup = body_with_arm(options.pick(0.15, 0.08));
  std::vector<Row> rows, all;
  for(const Line_method& method : line_methods(options)) {
    const Line_run run = find_lines(method, soup);
    all.push_back(row("figure 12", "B: lines", method.name, {{"faces", soup.triangles.size()}},
                      summarise(run, soup)));
    for(const auto& [name, limb] : {std::make_pair("body", body), std::make_pair("arm", arm)}) {
      const Line_agreement agreement = compare_lines({limb.axis()}, run.lines, 0.5);
      rows.push_back(row("figure 12", "B: attached arm", method.name, {{"line", name}},
                         {{"found", agreement.found},
                          {"distance / R", agreement.distance},
                          {"radius / R", agreement.radius}}));
    }
    write_picture_of_lines(options, "figure_12_B_" + method.name + ".png", soup, run.lines);
  }
  publish(all, report);
  publish(rows, report);
}

} // namespace

void figure_12(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 12",
      "Lines in the middle of tubes, A: in a hand, and B: in a body with an arm that is partly "
      "attached to it, where methods that follow the topology of the surface fail. Lengths are in "
      "units of the longest side. The axis of a limb is found where a line is no "
      "farther from it than half of the radius of the limb, R; distance and radius are means over "
      "that.");
  find_lines_in_a_hand(options, report);
  find_an_attached_arm(options, report);
}

} // namespace Paper
