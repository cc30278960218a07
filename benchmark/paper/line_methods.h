// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_LINE_METHODS_H
#define AREA_PROJECTION_PAPER_LINE_METHODS_H

#include "experiment.h"
#include "line_comparison.h"

#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <functional>
#include <string>
#include <vector>

namespace Paper {

/// a way to find the lines in the middle of the tubes of a surface.
struct Line_method
{
  std::string name;
  std::function<std::vector<Line>(const AP::Triangle_surface&)> find;
};

/// the procedure of the paper, once for each region and repeated.
std::vector<Line_method> line_methods(const Options& options);

struct Line_run
{
  std::vector<Line> lines;
  double seconds; ///< on the wall
};

Line_run find_lines(const Line_method& method, const Soup& soup);

/// number, length and radius of lines, lengths in units of the longest side of the box of the surface.
Measures summarise(const Line_run& run, const Soup& soup);

/// \brief writes a picture of lines before a surface, along `z` and along `x`, if pictures are wanted.
///
/// Lines shine through the surface.
/// \param name of the file, without the folder; blanks become underlines
/// \throw Output_error if it cannot be written.
void write_picture_of_lines(const Options& options, const std::string& name, const Soup& soup,
                            const std::vector<Line>& lines);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_LINE_METHODS_H
