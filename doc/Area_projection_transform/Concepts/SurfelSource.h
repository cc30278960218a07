// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// A surface that can be represented by surfels.
///
/// \cgalHasModel `CGAL::Area_projection::Triangle_surface`
/// \cgalHasModel `CGAL::Area_projection::Surfels`
class SurfelSource
{
public:
  /// the number of elements: of triangles, or of points.
  std::size_t size() const;

  /// whether there are none.
  bool empty() const;

  /// the bounding box of the elements.
  CGAL::Bbox_3 bbox() const;

  /// hands surfels about `spacing` apart to `sink(const Surfels&)`, batch by batch. Their areas sum to
  /// the area of the surface.
  template <class BatchSink>
  void for_each_batch(double spacing, BatchSink&& sink) const;
};
