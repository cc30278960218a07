// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_IMPLICIT_TUBES_H
#define AREA_PROJECTION_PAPER_IMPLICIT_TUBES_H

#include "centerline_shapes.h"

namespace Paper {

/// \brief the surface of the union of tubes around lines, with round ends.
///
/// All vertices lie on it, to rounding, but for those on the creases where tubes meet, which are near.
/// \param spacing about the length of the edges
Soup union_of_tubes(const std::vector<True_line>& lines, double spacing);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_IMPLICIT_TUBES_H
