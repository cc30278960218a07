// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// What the points and vectors of an input need: they are read once, through `CGAL::to_double()`, and
/// everything after that is computed with doubles.
///
/// \cgalHasModel any kernel of \cgal, exact or not
class AreaProjectionTraits_3
{
public:
  /// has `x()`, `y()` and `z()`, of which `CGAL::to_double()` makes doubles.
  typedef unspecified_type Point_3;

  /// has `x()`, `y()` and `z()`, of which `CGAL::to_double()` makes doubles.
  typedef unspecified_type Vector_3;
};
