// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_FIND_BALLS_H
#define MAPT_FIND_BALLS_H

#include "console.h"
#include "surface.h"

#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>

#include <vector>

namespace mapt {

/// finds medial balls; shows the progress.
/// \throw Interruption if a signal came.
std::vector<AP::Medial_ball>
find_balls(const Surface& surface, const AP::Medial_ball_options& options, const Console& console);

} // namespace mapt

#endif // MAPT_FIND_BALLS_H
