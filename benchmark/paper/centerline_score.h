// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_CENTERLINE_SCORE_H
#define AREA_PROJECTION_PAPER_CENTERLINE_SCORE_H

#include "centerline_shapes.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>

#include <cstddef>

namespace Paper {

/// how near lines are to the true axes; lengths are in units of the radius there.
struct Centerline_score
{
  double body = 0;     ///< the mean distance of the lines from the axes, where they are beside them
  double all = 0;      ///< the same with the way from the ends of the axes to the surface
  double furthest = 0; ///< of all
  double coverage =
      0; ///< the part of the length of the axes with a line within a fifth of the radius
  double radius =
      0; ///< the mean error of the radius where it was fitted, beside the axes; NaN: not known
  std::size_t leaves = 0, components = 0, cycles = 0;

  /// free ends that are too many.
  std::size_t spurious(const Centerline_shape& shape) const
  {
    return leaves > shape.leaves ? leaves - shape.leaves : 0;
  }
};

Centerline_score score(const Centerline_shape& shape,
                       const CGAL::Area_projection::Centerline_graph& graph);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_CENTERLINE_SCORE_H
