// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "find_balls.h"

#include "progress.h"

#include <CGAL/Area_projection_transform/medial_balls.h>

#include <functional>

namespace mapt {

std::vector<AP::Medial_ball>
find_balls(const Surface& surface, const AP::Medial_ball_options& options, const Console& console)
{
  using Tag = CGAL::Parallel_if_available_tag;
  Progress_line progress(console, "medial balls");
  const std::function<bool(double)> callback = [&](double fraction) {
    progress.show(fraction);
    return !Signal_watch::is_interrupted();
  };
  const auto np = CGAL::parameters::callback(callback);
  std::vector<AP::Medial_ball> balls =
      std::visit([&](const auto* source) { return AP::medial_balls<Tag>(*source, options, np); },
                 surface.source());
  Signal_watch::check();
  return balls;
}

} // namespace mapt
