// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIBE_REPORT_H
#define MAPT_DESCRIBE_REPORT_H

#include "describe_queue.h"

namespace mapt {

/// tells what is computed.
/// \param ranks processes that share the work
void report_parameters(const Describe_options& options, std::size_t ranks, Console& console);

/// tells what became of the files, and lets the command fail if some could not be described.
void report_descriptions(const Describe_queue& queue, const Describe_options& options,
                         Console& console);

} // namespace mapt

#endif // MAPT_DESCRIBE_REPORT_H
