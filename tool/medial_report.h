// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MEDIAL_REPORT_H
#define MAPT_MEDIAL_REPORT_H

#include "medial_options.h"

#include <CGAL/Area_projection_transform/medial_complex.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace mapt {

// The balls of a surface, those that were selected, how they are connected, and how much of the surface they cover.
struct Medial_result
{
  std::vector<CGAL::Area_projection::Medial_ball> balls;
  double seconds = 0;            // what it took to find them
  std::vector<std::size_t> kept; // positions in `balls`
  double tolerance = 0;
  double covered_by_all = 0, covered_by_kept = 0; // parts of the area
  CGAL::Area_projection::Medial_complex complex;  // of those that were selected
  double growth = 0;                              // of the balls, before they are connected
  std::optional<CGAL::Area_projection::Betti_numbers> shape; // nothing if it is not closed
};

nlohmann::ordered_json to_json(const CGAL::Area_projection::Betti_numbers& topology);

void report_parameters(const Medial_options& options, Console& console);

// Fills "medial" of the report, and shows what was found.
void report_balls(const Medial_result& result, const Medial_options& options, Console& console);

} // namespace mapt

#endif // MAPT_MEDIAL_REPORT_H
