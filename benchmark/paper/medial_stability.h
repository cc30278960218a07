// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_MEDIAL_STABILITY_H
#define AREA_PROJECTION_PAPER_MEDIAL_STABILITY_H

#include "benchmark_report.h"
#include "experiment.h"

#include <vector>

namespace Paper {

/// tells how far medial axes move when the surface changes: of each mesh, and of all.
void medial_stability(const std::vector<Mesh>& meshes, const Options& options,
                      Benchmarks::Report& report);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_MEDIAL_STABILITY_H
