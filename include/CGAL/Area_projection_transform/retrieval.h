// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_H

/// \file
/// Everything that compares shapes by their descriptors, and judges how well that is done:
///
/// - `Descriptor_table` holds the descriptors of many shapes, `Histogram_distance` compares two;
/// - `distance_matrix()` compares all with all, `Metric_index` finds the nearest of many without that;
/// - `Class_labels` tells which shapes belong together;
/// - `evaluate_retrieval()` tells how often what is nearest does, by the measures of the contests, and
///   `precision_recall()` draws the curve.
///
/// Files of labels, descriptors and matrices are read and written by `IO/class_labels.h` and `IO/float_matrix.h`.

#include <CGAL/Area_projection_transform/retrieval/Class_labels.h>
#include <CGAL/Area_projection_transform/retrieval/Descriptor_table.h>
#include <CGAL/Area_projection_transform/retrieval/Distance_matrix.h>
#include <CGAL/Area_projection_transform/retrieval/Histogram_distance.h>
#include <CGAL/Area_projection_transform/retrieval/Metric_index.h>
#include <CGAL/Area_projection_transform/retrieval/evaluation.h>
#include <CGAL/Area_projection_transform/retrieval/precision_recall.h>

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_H
