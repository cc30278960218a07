// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ADD_PATCHES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ADD_PATCHES_H

#include <CGAL/Area_projection_transform/internal/Patch.h>
#include <CGAL/Area_projection_transform/internal/Row_accumulator.h>

#include <vector>

#define CGAL_AREA_PROJECTION_KERNEL <CGAL/Area_projection_transform/internal/patches_impl.h>
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// adds to each voxel the share of each patch that lies in the ball around it.
inline void add_patches(Row_accumulator& accumulator, const std::vector<Patch>& patches)
{
  CGAL_AREA_PROJECTION_DISPATCHED(add_patches, accumulator.arrays(), patches.data(),
                                  patches.size());
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ADD_PATCHES_H
