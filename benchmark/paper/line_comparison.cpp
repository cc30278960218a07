// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "line_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Paper {

namespace {

double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

struct Nearest
{
  double squared_distance = std::numeric_limits<double>::infinity();
  double radius = 0;
};

/// the nearest place of a segment, with its radius.
void look_at(const Line& line, std::size_t i, const Point_3& p, Nearest& nearest)
{
  const std::size_t j = std::min(i + 1, line.points.size() - 1);
  const Vector_3 along = line.points[j] - line.points[i];
  const double squared_length = along.squared_length();
  const double t =
      squared_length > 0 ? std::clamp((p - line.points[i]) * along / squared_length, 0., 1.) : 0.;
  const double squared = CGAL::squared_distance(p, line.points[i] + t * along);
  if(squared < nearest.squared_distance)
    nearest = {squared, (1 - t) * line.radii[i] + t * line.radii[j]};
}

Nearest nearest_of(const std::vector<Line>& lines, const Point_3& p)
{
  Nearest nearest;
  for(const Line& line : lines)
    for(std::size_t i = 0; i < line.points.size(); ++i)
      look_at(line, i, p, nearest);
  return nearest;
}

/// calls `function(place, radius, length)` for each piece of a line.
template <class Function>
void for_each_piece(const Line& line, Function&& function)
{
  for(std::size_t i = 1; i < line.points.size(); ++i) {
    const Point_3 &a = line.points[i - 1], &b = line.points[i];
    const double length = distance(a, b);
    const double smallest = std::min(line.radii[i - 1], line.radii[i]);
    const int pieces = std::max(int(std::ceil(8 * length / smallest)), 1);
    for(int piece = 0; piece < pieces; ++piece) {
      const double t = (piece + 0.5) / pieces;
      function(a + t * (b - a), (1 - t) * line.radii[i - 1] + t * line.radii[i], length / pieces);
    }
  }
}

} // namespace

double length_of(const Line& line)
{
  double length = 0;
  for(std::size_t i = 1; i < line.points.size(); ++i)
    length += distance(line.points[i - 1], line.points[i]);
  return length;
}

double mean_radius(const Line& line)
{
  double sum = 0;
  for(std::size_t i = 1; i < line.points.size(); ++i)
    sum += 0.5 * (line.radii[i - 1] + line.radii[i]) * distance(line.points[i - 1], line.points[i]);
  const double length = length_of(line);
  return length > 0 ? sum / length : 0;
}

Line_agreement compare_lines(const std::vector<Line>& lines, const std::vector<Line>& others,
                             double reach)
{
  double all = 0, found = 0;
  Line_agreement sums;
  for(const Line& line : lines)
    for_each_piece(line, [&](const Point_3& place, double radius, double length) {
      all += length;
      const Nearest nearest = nearest_of(others, place);
      const double relative = std::sqrt(nearest.squared_distance) / radius;
      if(!(relative <= reach))
        return;
      found += length;
      sums.distance += length * relative;
      sums.radius += length * nearest.radius / radius;
    });
  if(!(found > 0))
    return {};
  return {found / all, sums.distance / found, sums.radius / found};
}

} // namespace Paper
