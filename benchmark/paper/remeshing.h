// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_REMESHING_H
#define AREA_PROJECTION_PAPER_REMESHING_H

#include "damage.h"

namespace Paper {

/// \brief the same surface with other triangles: about equilateral ones of a given edge length.
/// \throw std::invalid_argument if it is no manifold
Soup remeshed(const Soup& soup, double edge_length);

/// the same surface, turned about an axis that is askew to those of coordinates, or back.
Point_3 turned(const Point_3& p, bool is_back = false);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_REMESHING_H
