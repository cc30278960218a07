// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_DAMAGE_TABLES_H
#define AREA_PROJECTION_PAPER_DAMAGE_TABLES_H

#include "experiment.h"

#include <string>
#include <vector>

namespace Paper {

/// \brief compares a surface with itself after each of some damages, for all modes, and prints tables of
/// interiors, maps, some of the scales, and maxima.
///
/// Writes pictures of the surface before and after, if they are wanted.
/// \param shown the scales that are shown each
void compare_damages(const std::string& group, const Options& options, Subject& subject,
                     const std::vector<Damage>& damages, const std::vector<std::size_t>& shown,
                     Benchmarks::Report& report);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_DAMAGE_TABLES_H
