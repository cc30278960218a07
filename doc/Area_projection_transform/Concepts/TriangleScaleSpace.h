// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// A scale space that also shows its triangles, for exact evaluation.
///
/// \cgalRefines `SurfelScaleSpace`
/// \cgalHasModel `CGAL::Area_projection::Constant_scale_space<CGAL::Area_projection::Triangle_surface>`
/// \cgalHasModel `CGAL::Area_projection::Smoothing_scale_space`, if its smoother makes triangles
class TriangleScaleSpace
{
public:
  /// the surface as seen at `radius`, each triangle with one normal.
  std::shared_ptr<const CGAL::Area_projection::Triangle_surface> triangles(double radius) const;
};
