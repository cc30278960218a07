// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_FIGURES_H
#define AREA_PROJECTION_PAPER_FIGURES_H

#include "benchmark_report.h"
#include "experiment.h"

namespace Paper {

// Each prints tables and adds their rows to the report.

/// half of the faces removed, and noise: two scales and the joint map.
void figure_1(const Options& options, Benchmarks::Report& report);

/// a sphere with bumps much smaller than its radius, and its value at the centre.
void figure_4(const Options& options, Benchmarks::Report& report);

/// the medial axis of a cylinder with a small bump, pruned by several weights.
void figure_5(const Options& options, Benchmarks::Report& report);

/// a scan with holes: three scales and the joint map.
void figure_7(const Options& options, Benchmarks::Report& report);

/// flat objects at several scales.
void figure_8(const Options& options, Benchmarks::Report& report);

/// salient points of spheres and a cylinder, by how the paper is read.
void figure_9(const Options& options, Benchmarks::Report& report);

/// salient points of animals and people.
void figure_10(const Options& options, Benchmarks::Report& report);

/// salient points of scans with holes.
void figure_11(const Options& options, Benchmarks::Report& report);

/// lines in a hand, and in a body to which an arm is attached.
void figure_12(const Options& options, Benchmarks::Report& report);

/// lines before and after half of the faces are removed.
void figure_13(const Options& options, Benchmarks::Report& report);
/// precision over recall of the descriptor in a labelled set.
void figure_15(const Options& options, Benchmarks::Report& report);

/// retrieval by descriptors in a labelled set, clean and damaged.
void table_1(const Options& options, Benchmarks::Report& report);

/// salient points of the same model in two poses.
void pose_stability(const Options& options, Benchmarks::Report& report);

/// everything against the amount of damage.
void robustness_curves(const Options& options, Benchmarks::Report& report);

/// how far it pays to smooth.
void smoothing_ratios(const Options& options, Benchmarks::Report& report);

/// spheres and tubes found in scenes, beside what Efficient RANSAC finds there.
void salient_comparison(const Options& options, Benchmarks::Report& report);

/// centrelines of tubes whose axes are known, beside CGAL's skeletons.
void centerline_comparison(const Options& options, Benchmarks::Report& report);

/// medial axes, skeletons and centrelines of meshes, and how they move when the surface changes.
void medial_comparison(const Options& options, Benchmarks::Report& report);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_FIGURES_H
