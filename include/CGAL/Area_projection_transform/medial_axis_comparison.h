// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_H

/// \file
/// Everything that compares medial axes, skeletons and centrelines:
///
/// - `Medial_representation` is what all of them are turned into: balls, and what connects them;
/// - `medial_axes()` makes those of a surface that are worth comparing, \cgal's skeleton among them, where
///   `skeleton_obstacle()` tells of none;
/// - `axis_distances()` and `axis_distance_matrix()` tell how far they are from each other;
/// - `Medial_judge` tells how much of the surface they cover (`covered_part()`), how much of the solid they fill
///   (`ball_volume()`), how far surface and balls are from each other (`reconstruction_error()`), whether they are in the
///   middle and have the right radii;
/// - `union_of_balls_mesh()` is the shape that is left, as a mesh;
/// - `shape_diameter_correlation()` tells whether they are thick where \cgal's shape diameter function says so;
/// - `shape_topology()` tells how many pieces and loops they should have.
///
/// This includes the header of \cgal's skeletons, which takes long to compile; whoever needs no skeleton includes
/// the other headers of the folder one by one.

#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_measures.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Surface_distance.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/axis_distances.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/ball_volume.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/distances_from_balls.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/mean_curvature_skeleton.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/medial_axes.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/reconstruction_error.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_diameter.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/shape_topology.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/union_of_balls_mesh.h>

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_H
