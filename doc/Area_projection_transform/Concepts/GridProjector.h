// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// Computes the transform over a region of a grid, one scale at a time, in storage that it keeps from
/// scale to scale. Used by one thread at a time.
///
/// A value depends only on what is projected to within `σ` and two voxels of its voxel, and on the order
/// in which that comes: several threads may then share a scale, each with the surfels near its voxels.
///
/// \cgalHasModel `CGAL::Area_projection::Grid_projector`
/// \cgalHasModel `CGAL::Area_projection::Exact_grid_projector`
/// \cgalHasModel `CGAL::Area_projection::Paper_grid_projector`
class GridProjector
{
public:
  /// \brief computes the transform at one scale. Every row of the scale before must have been taken.
  /// \tparam ScaleSpace a model of `SurfelScaleSpace`, or of `TriangleScaleSpace`
  /// \tparam Cancelled a nullary predicate, which is asked now and then; once it returns `true`, the
  /// rest may be left out
  /// \return the area whose projection falls outside of the grid
  template <class ScaleSpace, class Cancelled>
  double project(const ScaleSpace& surface, const CGAL::Area_projection::Scale& scale,
                 CGAL::Area_projection::Side side, Cancelled&& cancelled);

  /// writes the values, which are areas, of the hull of a row of the region to `out`; once per scale.
  void take_row(std::size_t row, float* out);
};
