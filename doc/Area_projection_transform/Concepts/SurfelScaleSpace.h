// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// A surface as it is seen at each radius `R`: small structures may be smoothed away where `R` is
/// large. All functions may be called concurrently.
///
/// \cgalHasModel `CGAL::Area_projection::Constant_scale_space`
/// \cgalHasModel `CGAL::Area_projection::Smoothing_scale_space`
class SurfelScaleSpace
{
public:
  /// the bounding box of the surface.
  CGAL::Bbox_3 bbox() const;

  /// the total area that votes at `radius`.
  double area(double radius) const;

  /// \brief hands the parallel surface at distance `radius` on `side`, in pieces that spread
  /// no more than a square of side `spacing` does, to `sink(const Projected_surfels&)`, batch by batch.
  ///
  /// The weights are areas and sum to `area(radius)`.
  template <class BatchSink>
  void project(double radius, CGAL::Area_projection::Side side, double spacing,
               BatchSink&& sink) const;
};
