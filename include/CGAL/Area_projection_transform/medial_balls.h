// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_H

#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Progress_report.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/medial_balls/Ball_weigher.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_samples.h>
#include <CGAL/Area_projection_transform/medial_balls/Thinned_samples.h>
#include <CGAL/Area_projection_transform/medial_balls/missing_area.h>
#include <CGAL/Area_projection_transform/medial_balls/polar_balls.h>
#include <CGAL/Area_projection_transform/medial_balls/scale_axis.h>
#include <CGAL/Area_projection_transform/medial_balls/select_balls.h>
#include <CGAL/Area_projection_transform/medial_balls/touching_ball.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

inline Medial_ball medial_ball(const Medial_samples& samples, const Ball_weigher& weigher,
                               std::size_t sample, const Touching_ball& found, double sigma_ratio)
{
  const auto to_point = [](const Eigen::Vector3d& v) { return Point_3(v.x(), v.y(), v.z()); };
  const Eigen::Vector3d &first = samples.positions[sample],
                        &second = samples.positions[found.contact];
  const Ball_weigher::Ball raw{found.center, found.radius}, refitted = weigher.refitted(raw);
  const Ball_weigher::Votes votes = weigher.votes(refitted, sigma_ratio);
  const Ball_weigher::Contacts contacts = weigher.contacts(raw, first, second);
  Medial_ball ball;
  ball.center = to_point(raw.center);
  ball.radius = raw.radius;
  ball.refitted_center = to_point(refitted.center);
  ball.refitted_radius = refitted.radius;
  ball.surface_point = to_point(first);
  ball.contact = to_point(second);
  ball.source = samples.sources[sample];
  ball.contact_source = samples.sources[found.contact];
  ball.mapt = votes.mapt;
  ball.spread = votes.spread;
  ball.lambda = contacts.lambda;
  ball.angle = contacts.angle * 180 / 3.14159265358979323846;
  return ball;
}

template <class ConcurrencyTag>
std::vector<Medial_ball> medial_balls_of(const Medial_samples& samples,
                                         const Medial_ball_options& options,
                                         const std::function<bool(double)>& callback)
{
  constexpr std::size_t block = 256; // samples between two calls
  Progress_report progress(callback);
  const Thinned_samples thinned(samples);
  std::vector<Medial_ball> balls;
  if(thinned.empty())
    return balls;
  const double largest = samples.largest_radius();
  const double least_sine = std::sin(0.5 * options.stop_angle * 3.14159265358979323846 / 180);
  const Ball_weigher weigher(thinned);
  std::optional<Polar_balls> polar;
  if(options.method == Medial_ball_method::POLAR)
    polar.emplace(samples, largest);
  std::vector<std::optional<Medial_ball>> found(samples.size());
  const auto find_one = [&](std::size_t i) {
    const double start = std::sqrt(samples.areas[i]);
    if(!(start > 0))
      return;
    std::optional<Touching_ball> ball;
    if(!polar)
      ball = touching_ball(thinned, samples.positions[i], samples.normals[i], start, largest,
                           least_sine);
    else if((*polar)[i] &&
            is_stopped(thinned, samples.positions[i], samples.normals[i], *(*polar)[i], least_sine))
      ball = (*polar)[i];
    if(ball)
      found[i] = medial_ball(samples, weigher, i, *ball, options.sigma_ratio);
  };
  const std::size_t blocks = (samples.size() + block - 1) / block;
  for_each_index<ConcurrencyTag>(blocks, [&](std::size_t b) {
    for(std::size_t i = b * block; i < std::min((b + 1) * block, samples.size()); ++i)
      if(!progress.is_cancelled())
        find_one(i);
    progress.advance(1. / double(blocks));
  });
  for(const std::optional<Medial_ball>& ball : found)
    if(ball)
      balls.push_back(*ball);
  set_scale_axis<ConcurrencyTag>(balls);
  return balls;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief returns the medial balls of a surface, weighted by the transform and by what else is used to prune a medial
/// axis.
///
/// For each sample of the surface, in their order, the largest ball that touches there and has no other sample inside; none
/// where it is larger than all of the surface (1.2 times the largest distance from its centroid), as it is outside of
/// convex parts. The centres
/// sample the medial axis, including all that small bumps and noise add to it: what is kept of it is up to
/// `select_by_weight()`, `select_strongest()`, `select_covering()`.
///
/// The paper (section 4.2) takes for the medial axis the points to which more than one patch is projected as `σ`
/// goes to 0 (`Projected_patches`). Over all radii these are the centres of all balls that touch twice, also of those with surface inside
/// (the symmetry set); so here the radius is the distance from the surface. That the transform at these balls
/// tells which of them matter is what the paper leaves to investigate.
///
/// Instead of these balls, `Medial_ball_options::method` takes the inner poles: the largest ball through each sample and three
/// others that is empty, and behind all four by their normals.
///
/// The surface need not be closed, connected or manifold. Through a hole larger than the distance between
/// samples balls grow on, to whatever is behind it; such balls have a low `Medial_ball::mapt`. Where less is missing,
/// what is beside it counts for it (`Medial_ball_options::compensate`). Polar balls would have to touch the outer side
/// of what is there, and are not among the result.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`; the
/// result does not depend on it, to the last bit
/// \param surface triangles, facing outward
/// \param options the choices
/// \param np an optional named parameter:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is told the progress, in [0, 1], and answers whether to go on; is called by any of the
///                           threads, but never twice at a time. If it answers `false`, the balls found by then
///                           are returned.}
///     \cgalParamType{an instance of `std::function<bool(double)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw std::invalid_argument if the spacing is not positive, or an angle or `σ/R` not in its range
///
/// What is smaller than a tenth of the radius of a ball, the distance of the samples that it looks at, may stick into it
/// unseen. Sums over voters have an error of some percent, by the same thinning.
///
/// Complexity: some thousand samples are looked at for each ball, whatever the shape. The scale axis compares each ball with
/// the larger ones, at most 20 000 of them. Memory: about 600 bytes for each sample.
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Medial_ball>
medial_balls(const Triangle_surface& surface, const Medial_ball_options& options = {},
             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  internal::Medial_samples samples(surface, options);
  if(options.compensate)
    internal::add_missing_area<ConcurrencyTag>(samples, surface);
  return internal::medial_balls_of<ConcurrencyTag>(samples, options, internal::callback_of(np));
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief the same for points with normals and the areas that they stand for.
/// \param points the points
/// \param options the choices
/// \param np optionally `callback`
/// \throw std::invalid_argument also if a position is not finite, a normal not of length 1, or an area negative
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Medial_ball>
medial_balls(const Surfels& points, const Medial_ball_options& options = {},
             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  return internal::medial_balls_of<ConcurrencyTag>(internal::Medial_samples(points, options),
                                                   options, internal::callback_of(np));
}

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief the same for a mesh.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh, facing outward; in several parts, with holes, as it is
/// \param options the choices
/// \param np the named parameters of `surface_from_mesh()`, and `callback`
/// \throw std::invalid_argument also as `surface_from_mesh()` does
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Medial_ball>
medial_balls(const TriangleMesh& mesh, const Medial_ball_options& options = {},
             const NamedParameters& np = CGAL::parameters::default_values())
{
  return medial_balls<ConcurrencyTag>(surface_from_mesh(mesh, np), options, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_BALLS_H
