// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What mapt lines tells of what it did.

#ifndef MAPT_LINES_REPORT_H
#define MAPT_LINES_REPORT_H

#include "console.h"
#include "lines_options.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>

namespace mapt {

void report_parameters(const Lines_options& options, Console& console);

void report_lines(const CGAL::Area_projection::Centerline_graph& graph,
                  const Lines_options& options, Console& console);

} // namespace mapt

#endif // MAPT_LINES_REPORT_H
