// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_TRANSFORM_OUTPUT_H
#define MAPT_TRANSFORM_OUTPUT_H

#include "transform_maps.h"

namespace mapt {

/// writes the maps that were asked for, with the parameters that they were made with.
/// \throw Output_error if they cannot be written.
/// \throw Interruption if a signal came; no file is left.
void write_maps(const std::vector<Side_maps>& maps, const Transform_plan& plan,
                const Transform_options& options);

} // namespace mapt

#endif // MAPT_TRANSFORM_OUTPUT_H
