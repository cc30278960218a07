// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// The transform at arbitrary points, for the radius and the side with which the evaluator was made.
/// Queries may run concurrently.
///
/// \cgalHasModel `CGAL::Area_projection::Exact_evaluator`
/// \cgalHasModel `CGAL::Area_projection::Sampled_evaluator`
/// \cgalHasModel `CGAL::Area_projection::Kd_tree_evaluator`
class ProjectionEvaluator
{
public:
  /// \brief returns the area that is projected into the ball of radius `sigma` around `x`.
  /// \tparam Point a model of `AreaProjectionTraits_3::Point_3`
  template <class Point>
  double operator()(const Point& x, double sigma) const;

  /// the same for a kernel given by its nested balls.
  template <class Point>
  double operator()(const Point& x, double sigma,
                    const std::vector<CGAL::Area_projection::Nested_ball>& kernel) const;
};
