// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_LINE_COMPARISON_H
#define AREA_PROJECTION_PAPER_LINE_COMPARISON_H

#include "damage.h"

#include <vector>

namespace Paper {

/// a line in the middle of a tube, with its radius at each point.
struct Line
{
  std::vector<Point_3> points;
  std::vector<double> radii;
};

double length_of(const Line& line);

/// the mean along the line; 0 if it has no length.
double mean_radius(const Line& line);

/// what is found of lines in other lines.
struct Line_agreement
{
  double found = 0;    ///< the share of their length that has another line near
  double distance = 0; ///< of that, the mean distance, in units of their own radius
  double radius = 0;   ///< of that, the mean of the radius there, in units of their own
};

/// \brief looks for lines among others.
///
/// Lines are cut into pieces of an eighth of their radius; a piece is found if its middle is no farther from another line
/// than `reach` times the radius.
/// \pre radii are positive
Line_agreement compare_lines(const std::vector<Line>& lines, const std::vector<Line>& others,
                             double reach);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_LINE_COMPARISON_H
