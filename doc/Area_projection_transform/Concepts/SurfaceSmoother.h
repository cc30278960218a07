// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// Makes of a surface the one that is seen at a radius, for `Smoothing_scale_space`. All functions may be
/// called concurrently.
///
/// \cgalHasModel `CGAL::Area_projection::Averaged_normals`
/// \cgalHasModel `CGAL::Area_projection::Mean_curvature_flow`
class SurfaceSmoother
{
public:
  /// `CGAL::Area_projection::Triangle_surface` or `CGAL::Area_projection::Surfels`
  using Source = unspecified_type;

  /// the surface before smoothing.
  const Source& source() const;

  /// \brief returns the surface as seen at `radius`, a length in the unit of the source: the elements of the
  /// source in their order, with the places, unit normals and areas that they have then.
  ///
  /// The same for the same radius, whatever was asked before. May throw, and be called again. It may work in
  /// parallel with TBB.
  Source operator()(double radius) const;
};
