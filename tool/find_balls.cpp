// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "find_balls.h"

#include "with_progress.h"

#include <CGAL/Area_projection_transform/medial_balls.h>

namespace mapt {

std::vector<AP::Medial_ball>
find_balls(const Surface& surface, const AP::Medial_ball_options& options, const Console& console)
{
  using Tag = CGAL::Parallel_if_available_tag;
  return with_progress("medial balls", console, [&](const auto& np) {
    return std::visit(
        [&](const auto* source) { return AP::medial_balls<Tag>(*source, options, np); },
        surface.source());
  });
}

} // namespace mapt
