// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SALIENT_POINTS_H
#define MAPT_SALIENT_POINTS_H

#include "console.h"
#include "salient_options.h"
#include "surface.h"

#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <vector>

namespace mapt {

/// salient points, the strongest first, and the side of the surface on which each was found.
struct Salient_points
{
  std::vector<AP::Salient_point> points;
  std::vector<AP::Side> sides;
};

/// finds the points that the user asks for.
/// \throw Usage_error if the options do not suit the surface, Interruption
Salient_points find_points(const Surface& surface, const Salient_options& options,
                           const Console& console);

} // namespace mapt

#endif // MAPT_SALIENT_POINTS_H
