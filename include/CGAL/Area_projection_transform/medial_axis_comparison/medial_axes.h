// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_AXES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_AXES_H

#include <CGAL/Area_projection_transform/centerlines.h>
#include <CGAL/Area_projection_transform/internal/Progress_report.h>
#include <CGAL/Area_projection_transform/internal/diagonal_of.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/mean_curvature_skeleton.h>
#include <CGAL/Area_projection_transform/medial_balls.h>
#include <CGAL/Area_projection_transform/medial_complex.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief which medial axes are compared, and how they are made comparable.
struct Medial_axes_options
{
  Medial_ball_options balls; ///< of all axes that are selections of balls
  Centerline_options lines;  ///< of the centrelines
  /// \brief each selection of balls has so many as are needed to cover that part of the surface, in [0, 1]: pruned by a
  /// threshold, without gaps …
  double coverage = 0.9;
  /// \brief … or that many, if there is a number: the strongest that are apart by 0.6 radii.
  std::optional<std::size_t> number;
  /// up to which the surface counts as covered, in its units. Default: 0.005 of the diagonal of the bounding box.
  std::optional<double> tolerance;
  std::uint64_t seed = 0;  ///< of what is selected by chance
  bool do_skeleton = true; ///< whether \cgal's skeleton is among them, which takes most of the time
};

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief medial axes of one surface.
struct Medial_axes
{
  /// \brief some of: `unpruned`, all balls; `mapt`, the axis weighted by the transform, and `mapt_refitted`, the same balls
  /// fitted to the surface around them; `lambda`, `scale_axis`; the baselines `random` and `covering` (greedy set cover); `centerlines`; `skeleton`, that of \cgal.
  std::vector<Medial_representation> axes;
  /// the names of those that could not be made, and why.
  std::vector<std::pair<std::string, std::string>> left_out;
  double tolerance = 0; ///< that was used
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// makes medial axes of a surface, one after the other.
template <class ConcurrencyTag, class Source>
class Axes_maker
{
public:
  Axes_maker(const Source& surface, const std::vector<Medial_ball>& balls, double seconds_of_balls,
             const Medial_axes_options& options, const std::function<bool(double)>& callback)
      : m_surface(surface)
      , m_options(options)
      , m_balls(balls)
      , m_seconds_of_balls(seconds_of_balls)
      , m_progress(callback)
  {
    m_result.tolerance = options.tolerance.value_or(0.005 * diagonal_of(surface.bbox()));
  }

  Medial_axes make()
  {
    m_growth = crack_width(m_surface.total_area(), m_balls.size());
    std::vector<std::size_t> all(m_balls.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::vector<std::size_t> weighted;
    const std::vector<std::function<void()>> steps{
        [&] { add("unpruned", all); },
        [&] {
          weighted =
              selected(m_options.number ? Medial_weight::RADIAL_MAPT : Medial_weight::IMPORTANCE);
          add("mapt", weighted);
        },
        [&] { add("mapt_refitted", weighted, true); },
        [&] { add("lambda", selected(Medial_weight::LAMBDA)); },
        [&] { add("scale_axis", selected(Medial_weight::SCALE_AXIS)); },
        [&] { add("random", first_of(select_random(m_balls, m_balls.size(), m_options.seed))); },
        [&] { add("covering", first_of(select_covering(m_balls, m_surface, m_result.tolerance))); },
        [&] { add_centerlines(); },
        [&] { add_skeleton(); }};
    for(const auto& step : steps) {
      if(m_progress.is_cancelled())
        break;
      step();
      m_progress.advance(1. / double(steps.size()));
    }
    return std::move(m_result);
  }

private:
  /// since it was asked last.
  double seconds()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - m_start;
    m_start = now;
    return passed.count();
  }

  std::vector<std::size_t> first_of(std::vector<std::size_t> order) const
  {
    if(!m_options.number)
      return select_until_covered(m_balls, order, m_surface, m_result.tolerance,
                                  m_options.coverage);
    order.resize(std::min(order.size(), *m_options.number));
    return order;
  }

  std::vector<std::size_t> selected(Medial_weight weight) const
  {
    const double sigma_ratio = m_options.balls.sigma_ratio;
    if(m_options.number)
      return select_strongest(m_balls, weight, *m_options.number, 0.6, sigma_ratio);
    std::vector<double> weights;
    std::vector<std::size_t> order;
    for(std::size_t i = 0; i < m_balls.size(); ++i) {
      weights.push_back(weight_of(m_balls[i], weight, sigma_ratio));
      if(weights[i] > 0) // what importance gates is never kept
        order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return weights[i] > weights[j]; });
    return first_of(std::move(order));
  }

  void add(const std::string& name, const std::vector<std::size_t>& balls,
           bool use_refitted = false)
  {
    Medial_representation axis =
        medial_representation(name, m_balls, balls, m_growth, use_refitted);
    axis.seconds = m_seconds_of_balls + seconds();
    m_result.axes.push_back(std::move(axis));
  }

  void add_centerlines()
  {
    const std::function<bool(double)> go_on = [&](double) {
      m_progress.advance(0); // asks whether to stop
      return !m_progress.is_cancelled();
    };
    Medial_representation axis = medial_representation(
        "centerlines",
        centerlines<ConcurrencyTag>(m_surface, m_options.lines, CGAL::parameters::callback(go_on)));
    axis.seconds = seconds();
    if(m_progress.is_cancelled())
      return;
    if(axis.centers.empty())
      m_result.left_out.emplace_back("centerlines", "no tube was found");
    else
      m_result.axes.push_back(std::move(axis));
  }

  void add_skeleton()
  {
    if(!m_options.do_skeleton)
      return;
    std::string obstacle = skeleton_obstacle(m_surface);
    try {
      if(obstacle.empty())
        m_result.axes.push_back(mean_curvature_skeleton(m_surface));
    } catch(const std::runtime_error& error) {
      obstacle = error.what();
    }
    if(!obstacle.empty())
      m_result.left_out.emplace_back("skeleton", obstacle);
  }

  const Source& m_surface;
  const Medial_axes_options& m_options;
  const std::vector<Medial_ball>& m_balls;
  double m_seconds_of_balls, m_growth = 0;
  Progress_report m_progress;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  Medial_axes m_result;
};

inline void check(const Medial_axes_options& options)
{
  check(options.balls);
  check(options.lines);
  if(!(options.coverage >= 0 && options.coverage <= 1))
    throw std::invalid_argument("coverage is " + internal::to_text(options.coverage) +
                                ": must be from 0 to 1");
  if(options.tolerance)
    check_positive(*options.tolerance, "tolerance");
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief makes the medial axes of a surface that are worth comparing, of balls that there are.
///
/// Balls are connected after they grew by `crack_width()`. A surface without extent has no axes.
/// \tparam Source `Triangle_surface` or `Surfels`
/// \param surface what the balls are of
/// \param balls all of them, as `medial_balls()` finds them with `options.balls`
/// \param seconds what it took to find them, which the times of the axes include
/// \param options the choices
/// \param np an optional named parameter:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is told the progress, in [0, 1], after each axis and while centrelines are sought, and answers
///                           whether to go on; is called by any of the threads, but never twice at a time. If it
///                           answers `false`, the axes made by then are returned.}
///     \cgalParamType{an instance of `std::function<bool(double)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw std::invalid_argument if an option is out of its range
template <class ConcurrencyTag = CGAL::Sequential_tag, class Source,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Medial_axes medial_axes(const Source& surface, const std::vector<Medial_ball>& balls,
                        double seconds, const Medial_axes_options& options = {},
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  if(surface.empty() || !(internal::diagonal_of(surface.bbox()) > 0))
    return {};
  return internal::Axes_maker<ConcurrencyTag, Source>(surface, balls, seconds, options,
                                                      internal::callback_of(np))
      .make();
}

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief finds the balls, too, without asking the callback.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Source,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Medial_axes medial_axes(const Source& surface, const Medial_axes_options& options = {},
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Medial_ball> balls = medial_balls<ConcurrencyTag>(surface, options.balls);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return medial_axes<ConcurrencyTag>(surface, balls, passed.count(), options, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_MEDIAL_AXES_H
