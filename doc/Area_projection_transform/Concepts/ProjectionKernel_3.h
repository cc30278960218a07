// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// How much a projected surfel adds to a point, by its distance: a positive mixture of nested balls.
/// The weights sum to 1, so that the transform stays 1 at the centre of a sphere.
///
/// \cgalHasModel `CGAL::Area_projection::Ball_kernel_3`
/// \cgalHasModel `CGAL::Area_projection::Epanechnikov_kernel_3`
/// \cgalHasModel `CGAL::Area_projection::Gaussian_kernel_3`
class ProjectionKernel_3
{
public:
  /// the balls; radii are relative to `σ` and in (0, 1].
  std::vector<CGAL::Area_projection::Nested_ball> nested_balls() const;
};
