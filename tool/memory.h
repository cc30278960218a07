// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MEMORY_H
#define MAPT_MEMORY_H

namespace mapt {

/// the most memory that the program has used so far, in bytes.
double peak_memory();

} // namespace mapt

#endif // MAPT_MEMORY_H
