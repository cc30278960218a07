// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt medial --reconstruct: the shape that the selected balls keep.

#ifndef MAPT_MEDIAL_RECONSTRUCTION_H
#define MAPT_MEDIAL_RECONSTRUCTION_H

#include "console.h"
#include "medial_options.h"
#include "medial_report.h"
#include "surface.h"

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/reconstruction_error.h>

namespace mapt {

struct Reconstruction
{
  CGAL::Area_projection::Triangle_surface mesh;
  CGAL::Area_projection::Reconstruction_error error;
  double cell = 0;     // of the lattice
  double diagonal = 0; // of the input
};

nlohmann::ordered_json to_json(const CGAL::Area_projection::Spread_of_values& values);
nlohmann::ordered_json to_json(const CGAL::Area_projection::Reconstruction_error& error);

// \throw Usage_error if the cells that are asked for are too small.
Reconstruction reconstruct(const Medial_result& result, const Surface& surface,
                           const Medial_options& options);

// Fills "reconstruction" of the report, and shows it.
void report_reconstruction(const Reconstruction& reconstruction, Console& console);

} // namespace mapt

#endif // MAPT_MEDIAL_RECONSTRUCTION_H
