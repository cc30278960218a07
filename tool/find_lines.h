// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_FIND_LINES_H
#define MAPT_FIND_LINES_H

#include "console.h"
#include "surface.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_options.h>

namespace mapt {

/// finds centrelines; shows the progress.
/// \throw Interruption if a signal came.
AP::Centerline_graph find_lines(const Surface& surface, const AP::Centerline_options& options,
                                const Console& console);

} // namespace mapt

#endif // MAPT_FIND_LINES_H
