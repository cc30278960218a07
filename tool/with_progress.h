// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_WITH_PROGRESS_H
#define MAPT_WITH_PROGRESS_H

#include "console.h"
#include "progress.h"

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <string>

namespace mapt {

/// calls `work(np)` with a callback that shows the progress of a task and stops it on a signal.
/// \throw Interruption if a signal came.
template <class Work>
auto with_progress(const std::string& task, const Console& console, const Work& work)
{
  Progress_line progress(console, task);
  const std::function<bool(double)> callback = [&](double fraction) {
    progress.show(fraction);
    return !Signal_watch::is_interrupted();
  };
  auto result = work(CGAL::parameters::callback(callback));
  Signal_watch::check();
  return result;
}

} // namespace mapt

#endif // MAPT_WITH_PROGRESS_H
