// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt medial --compare: medial axes of a surface beside each other.

#ifndef MAPT_MEDIAL_COMPARISON_H
#define MAPT_MEDIAL_COMPARISON_H

#include "console.h"
#include "medial_options.h"
#include "medial_report.h"
#include "surface.h"

#include <string>
#include <vector>

namespace mapt {

// What is measured of medial axes: all of it, and a table for a reader.
struct Axis_comparison
{
  nlohmann::ordered_json json;
  std::vector<std::string> table;
  std::vector<std::string> left_out; // the axes that could not be made, and why
};

// \param found the balls of the surface, of which the axes are made
Axis_comparison compare_axes(const Surface& surface, const Medial_result& found,
                             const Medial_options& options, const Console& console);

// Writes the measures.
// \throw Output_error if the file cannot be written.
void write_comparison(const std::string& file, const Axis_comparison& comparison);

void show_comparison(const Axis_comparison& comparison, const Medial_options& options,
                     Console& console);

} // namespace mapt

#endif // MAPT_MEDIAL_COMPARISON_H
