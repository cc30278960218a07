// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "find_lines.h"

#include "with_progress.h"

#include <CGAL/Area_projection_transform/centerlines.h>

namespace mapt {

AP::Centerline_graph find_lines(const Surface& surface, const AP::Centerline_options& options,
                                const Console& console)
{
  using Tag = CGAL::Parallel_if_available_tag;
  return with_progress("lines", console, [&](const auto& np) {
    return std::visit(
        [&](const auto* source) { return AP::centerlines<Tag>(*source, options, np); },
        surface.source());
  });
}

} // namespace mapt
