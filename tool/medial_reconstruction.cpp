// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "medial_reconstruction.h"

#include "errors.h"
#include "progress.h"
#include "text.h"

#include <CGAL/Area_projection_transform/internal/diagonal_of.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/axis_distances.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/union_of_balls_mesh.h>

#include <algorithm>
#include <utility>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

using Json = nlohmann::ordered_json;
using Tag = CGAL::Parallel_if_available_tag;

// Balls outside may be much larger than the shape, which bounds what --cell can ask for.
double cell_of(const AP::Medial_representation& axis, double diagonal,
               const Medial_options& options)
{
  const double least = std::max(0.0005 * diagonal, AP::internal::Ball_lattice::least_cell(axis));
  if(options.cell && !(*options.cell >= least && *options.cell <= diagonal))
    throw Usage_error("--cell is " + to_text(*options.cell) + ": must be from " +
                      to_text(least, 9) + " to the diagonal of the bounding box, " +
                      to_text(diagonal));
  return options.cell.value_or(std::max(0.005 * diagonal, least));
}

// As measured, with the other mesh that tells what sticks out. The area is that of the shape or, of balls outside of it, no
// more than that of a sphere around them, to within what was seen.
void check_memory(const AP::Medial_representation& axis, double area, double diagonal, double cell,
                  const Medial_options& options)
{
  constexpr double bytes_of_square = 3000; // as large as a cell
  constexpr double pi = 3.14159265358979323846;
  const double extent = AP::internal::Ball_lattice::extent(axis);
  if(options.computation.side == AP::Side::OUTSIDE || extent > diagonal)
    area = std::max(area, pi * extent * extent);
  double area_of_balls = 0;
  for(const double radius : axis.radii)
    area_of_balls += 4 * pi * radius * radius;
  const double bytes = bytes_of_square * std::min(area, area_of_balls) / (cell * cell);
  if(bytes > options.common.max_memory)
    throw Input_error(options.mesh + ": the mesh of the balls in cells of " + to_text(cell) +
                      " needs " + bytes_to_text(bytes) + "; raise --cell or raise --max-memory (" +
                      bytes_to_text(options.common.max_memory) + ")");
}

template <class Source>
Reconstruction reconstruct(const Medial_result& result, const Source& source,
                           const Medial_options& options)
{
  Reconstruction reconstruction;
  reconstruction.diagonal = AP::internal::diagonal_of(source.bbox());
  if(result.kept.empty())
    return reconstruction;
  AP::Medial_representation axis =
      AP::medial_representation("kept", result.balls, result.kept, result.growth);
  const double cell = cell_of(axis, reconstruction.diagonal, options);
  check_memory(axis, source.total_area(), reconstruction.diagonal, cell, options);
  if(options.is_interpolated)
    axis = AP::interpolated_balls(axis, cell);
  Signal_watch::check();
  reconstruction.mesh = AP::union_of_balls_mesh<Tag>(axis, cell);
  Signal_watch::check();
  reconstruction.error = AP::reconstruction_error<Tag>(axis, source, cell);
  reconstruction.cell = cell;
  return reconstruction;
}

} // namespace

Json to_json(const AP::Spread_of_values& values)
{
  return {{"mean", values.mean},
          {"median", values.median},
          {"quantile_95", values.quantile_95},
          {"largest", values.largest}};
}

Json to_json(const AP::Reconstruction_error& error)
{
  return {{"missing", to_json(error.missing)},
          {"protrusion", error.protrusion ? to_json(*error.protrusion) : Json()},
          {"spacing", error.spacing}};
}

Reconstruction reconstruct(const Medial_result& result, const Surface& surface,
                           const Medial_options& options)
{
  return std::visit([&](const auto* source) { return reconstruct(result, *source, options); },
                    surface.source());
}

void report_reconstruction(const Reconstruction& reconstruction, Console& console)
{
  const AP::Reconstruction_error& error = reconstruction.error;
  console.report["reconstruction"] = {{"faces", reconstruction.mesh.size()},
                                      {"cell", reconstruction.cell},
                                      {"error", to_json(error)}};
  const auto row = [&](const char* name, const char* text, const AP::Spread_of_values& values) {
    const auto percent = [&](double length) {
      return to_text(100 * length / reconstruction.diagonal, 3);
    };
    console.row(name, std::string(text) + " by " + percent(values.mean) +
                          " % of the diagonal in the mean, by more than " +
                          percent(values.quantile_95) + " % in 1 of 20 places, by " +
                          percent(values.largest) + " % at most");
  };
  if(reconstruction.mesh.empty()) {
    console.warn(
        "the mesh of the balls is empty: none of them has a node of a cell inside; lower --cell");
    return;
  }
  row("missing", "the surface is outside of the balls", error.missing);
  if(error.protrusion)
    row("protruding", "the balls stick out", *error.protrusion);
}

} // namespace mapt
