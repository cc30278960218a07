// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_KD_TREE_EVALUATOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_KD_TREE_EVALUATOR_H

#include <CGAL/Area_projection_transform/Projection_kernel_3.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformProjection
/// \brief the transform of sampled surfels at arbitrary points, for one radius, by \cgal's spatial
/// searching.
///
/// The surfels, moved by `R`, are the points of a `CGAL::Kd_tree`; the areas of those within a
/// `CGAL::Fuzzy_sphere` are summed as the search finds them (paper, section 5). Works for point sets,
/// too. The rim belongs to the ball. Queries are `const` and may run concurrently.
///
/// `Sampled_evaluator` finds the same much faster; this is what it is compared with.
///
/// \cgalModels `ProjectionEvaluator`
class Kd_tree_evaluator
{
  using Point_map = typename Pointer_property_map<Point_3>::const_type;
  using Area_map = typename Pointer_property_map<double>::const_type;
  using Traits = Search_traits_adapter<std::size_t, Point_map, Search_traits_3<Kernel>>;
  using Tree = CGAL::Kd_tree<Traits>;
  using Ball = CGAL::Fuzzy_sphere<Traits>;

public:
  /// \tparam ScaleSpace a model of `SurfelScaleSpace`
  /// \param surface is read by the constructor only
  /// \param radius the distance of projection, positive, in the units of the surface
  /// \param side the side on which the surface is projected
  /// \param spacing the spacing of the surfels; see `default_sampling_ratio`
  /// \throw std::invalid_argument if `radius` or `spacing` is not positive.
  ///
  /// Complexity: `O(n log n)` for `n` surfels.
  template <class ScaleSpace>
  Kd_tree_evaluator(const ScaleSpace& surface, double radius, Side side, double spacing)
  {
    internal::check_positive(radius, "radius");
    internal::check_positive(spacing, "spacing");
    surface.project(radius, side, spacing, [this](const Projected_surfels& batch) {
      m_projected.insert(m_projected.end(), batch.positions.begin(), batch.positions.end());
      m_areas.insert(m_areas.end(), batch.areas.begin(), batch.areas.end());
    });
    if(m_projected.empty())
      return; // a tree of no points cannot be built
    m_traits = Traits(make_property_map(std::as_const(m_projected)));
    m_tree = std::make_unique<Tree>(boost::counting_iterator<std::size_t>(0),
                                    boost::counting_iterator<std::size_t>(m_projected.size()),
                                    typename Tree::Splitter(), m_traits);
    m_tree->build(); // now, because a lazy build would serialise concurrent queries
  }

  // The tree refers to the points by address.
  Kd_tree_evaluator(const Kd_tree_evaluator&) = delete;
  Kd_tree_evaluator& operator=(const Kd_tree_evaluator&) = delete;

  /// \brief returns the area that is projected into the ball of radius `sigma` around `x`.
  template <class Point>
  double operator()(const Point& x, double sigma) const
  {
    double sum = 0;
    if(!m_tree)
      return sum;
    // The traits go along: the point map lives in them.
    m_tree->search(boost::make_function_output_iterator(Add{make_property_map(m_areas), &sum}),
                   Ball(internal::to_point(x), sigma, 0, m_traits));
    return sum;
  }

  /// the same for another kernel.
  template <class Point>
  double operator()(const Point& x, double sigma, const std::vector<Nested_ball>& kernel) const
  {
    return internal::sum_over_balls(*this, x, sigma, kernel);
  }

  /// how many samples of the surface are searched.
  std::size_t number_of_surfels() const { return m_projected.size(); }

private:
  /// \cond SKIP_IN_MANUAL
  /// sums the areas of the surfels found. A named type, since the tree assigns its iterator.
  struct Add
  {
    Area_map areas;
    double* sum;
    void operator()(std::size_t surfel) const { *sum += get(areas, surfel); }
  };

  std::vector<Point_3> m_projected;
  std::vector<double> m_areas;
  Traits m_traits;
  std::unique_ptr<Tree> m_tree;
  /// \endcond
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_PROJECTION_KD_TREE_EVALUATOR_H
