// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_LOCAL_MAXIMA_H
#define MAPT_LOCAL_MAXIMA_H

#include <CGAL/Area_projection_transform/Joint_map.h>

#include <vector>

namespace mapt {

struct Local_maximum
{
  CGAL::Area_projection::Point_3 position;
  double radius;
  double value;
};

/// returns the voxels with no larger value among their 26 neighbours, the strongest first, at most
/// `number`.
///
/// Neighbouring voxels of equal value are one maximum, at the one nearest to their mean. Left out is
/// what lies nearer than half its radius to a stronger one.
std::vector<Local_maximum> strongest_local_maxima(const CGAL::Area_projection::Joint_map& map,
                                                  std::size_t number);

} // namespace mapt

#endif // MAPT_LOCAL_MAXIMA_H
