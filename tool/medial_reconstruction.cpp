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
#include <stdexcept>
#include <utility>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

using Json = nlohmann::ordered_json;
using Tag = CGAL::Parallel_if_available_tag;

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
  const double extent = AP::internal::Ball_lattice::extent(axis); // of what is kept
  const double cell =
      options.cell.value_or(std::min(0.005 * reconstruction.diagonal, 0.1 * extent));
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
  try {
    return std::visit([&](const auto* source) { return reconstruct(result, *source, options); },
                      surface.source());
  } catch(const std::invalid_argument& error) {
    throw Usage_error(std::string("--") + error.what());
  }
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
  if(reconstruction.mesh.empty())
    return;
  row("missing", "the surface is outside of the balls", error.missing);
  if(error.protrusion)
    row("protruding", "the balls stick out", *error.protrusion);
}

} // namespace mapt
