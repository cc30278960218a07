// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SKELETON_PEER_H
#define AREA_PROJECTION_PAPER_SKELETON_PEER_H

#include "damage.h"

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>

#include <optional>

namespace Paper {

/// \brief CGAL's skeleton by mean curvature flow, with its defaults, as centrelines without branches.
///
/// The radius is the mean distance of the vertices of the mesh that went to a point of the skeleton. Nothing if the
/// surface is open or no manifold: then it cannot be asked.
std::optional<CGAL::Area_projection::Centerline_graph> skeleton_lines(const Soup& soup);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SKELETON_PEER_H
