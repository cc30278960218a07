// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MESH_ORIENTATION_H
#define MAPT_MESH_ORIENTATION_H

#include "mesh_topology.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mapt {

/// turns triangles over until neighbours agree, as far as the surface has two sides, and returns
/// how many it turned. Which side of a component becomes the outside is left open.
std::size_t orient_consistently(const std::vector<Point_3>& points,
                                const std::vector<std::uint32_t>& joined,
                                std::vector<Triangle>& triangles);

/// turns all triangles over.
void flip(std::vector<Triangle>& triangles);

/// returns for each component whether it is closed and its faces point inward for certain. Where the
/// whole mesh has a negative volume all of its closed components do; otherwise those of negative
/// volume do, unless they lie inside another one as the wall of a cavity does.
std::vector<bool> find_inward_components(const Mesh_topology& topology);

/// returns how many open components enclose, with their holes closed, a clearly negative volume.
std::size_t count_open_inward_components(const Mesh_topology& topology);

/// turns the triangles of the chosen components over.
void flip_components(const Mesh_topology& topology, const std::vector<bool>& is_chosen,
                     std::vector<Triangle>& triangles);

} // namespace mapt

#endif // MAPT_MESH_ORIENTATION_H
