// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_PEAK_GROWTH_H
#define AREA_PROJECTION_PAPER_PEAK_GROWTH_H

#include <functional>

namespace Paper {

/// \brief by how many bytes the peak of resident memory grows while work is done, which must be of one thread.
///
/// In a child process, so that work before and after does not count.
/// \throw std::runtime_error if the work fails
double peak_growth(const std::function<void()>& work);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_PEAK_GROWTH_H
