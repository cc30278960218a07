// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "line_methods.h"

namespace Paper {

namespace {

using Benchmarks::Row;

Measures compare(const Line_run& clean, const Line_run& other)
{
  constexpr double reach = 0.5; // of the radius of a line
  const Line_agreement found = compare_lines(clean.lines, other.lines, reach);
  const Line_agreement known = compare_lines(other.lines, clean.lines, reach);
  return {{"lines", double(other.lines.size())},
          {"lines before", double(clean.lines.size())},
          {"found again", found.found},
          {"distance / R", found.distance},
          {"radius ratio", found.radius},
          {"new", other.lines.empty() ? 0. : 1 - known.found},
          {"seconds", other.seconds}};
}

} // namespace

void figure_13(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 13",
      "Lines before and after half of the faces are removed at random. Found again is the share "
      "of the length before that has a line no farther than half of its radius R; distance and "
      "radius are means over that. New is the share of the length after that has no line before.");
  std::vector<Row> rows;
  for(const Mesh& mesh :
      read_meshes(options, {"human_woman.obj", "scorpion_low.obj", "hand.obj"})) {
    const Damage damage = removed_faces(0.5);
    const Soup half = damage.apply(mesh.soup, options.seed);
    for(const Line_method& method : line_methods(options)) {
      const Line_run clean = find_lines(method, mesh.soup), other = find_lines(method, half);
      rows.push_back(row("figure 13", "lines found again", method.name,
                         {{"mesh", mesh.name}, {"faces removed", damage.amount}},
                         compare(clean, other)));
      const std::string stem = "figure_13_" + mesh.name + "_" + method.name;
      write_picture_of_lines(options, stem + "_before.png", mesh.soup, clean.lines);
      write_picture_of_lines(options, stem + "_after.png", half, other.lines);
    }
  }
  publish(rows, report);
}

} // namespace Paper
