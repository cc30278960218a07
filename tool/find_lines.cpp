// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "find_lines.h"

#include "progress.h"

#include <CGAL/Area_projection_transform/centerlines.h>

#include <functional>

namespace mapt {

AP::Centerline_graph find_lines(const Surface& surface, const AP::Centerline_options& options,
                                const Console& console)
{
  using Tag = CGAL::Parallel_if_available_tag;
  Progress_line progress(console, "lines");
  const std::function<bool(double)> callback = [&](double fraction) {
    progress.show(fraction);
    return !Signal_watch::is_interrupted();
  };
  const auto np = CGAL::parameters::callback(callback);
  AP::Centerline_graph graph =
      std::visit([&](const auto* source) { return AP::centerlines<Tag>(*source, options, np); },
                 surface.source());
  Signal_watch::check();
  return graph;
}

} // namespace mapt
