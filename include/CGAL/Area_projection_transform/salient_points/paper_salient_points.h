// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_PAPER_SALIENT_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_PAPER_SALIENT_POINTS_H

#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>
#include <CGAL/Area_projection_transform/salient_points/Scale_maxima.h>
#include <CGAL/Area_projection_transform/salient_points/inertia.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief the choices of `paper_salient_points()`; lengths are in the units of the surface.
struct Paper_salient_options
{
  /// the side of the surface on which points are sought.
  Side side = Side::INSIDE;
  /// the reference length `s`: the smallest radius, the step between radii and the size of a voxel.
  /// Default: `paper_reference_length()` of the area of the surface.
  std::optional<double> reference_length;
  /// no radius is larger. Default: half the shortest side of the box of the surface, since no larger ball
  /// fits into it.
  std::optional<double> largest_radius;
  /// the ratio `σ/R`, in (0, 1).
  double sigma_ratio = 0.5;
  /// the standard deviation of the Gaussian that smooths the maps, in voxels.
  double smoothing = 1;
  /// the smallest value of a point, in the units of the map: a sphere has 1, two parallel walls have 1/8.
  double threshold = 0.2;
  /// whether maxima of the joint map, in three dimensions, are taken instead of those in four.
  bool use_joint_map = false;
};

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief returns the reference length of the paper: the square root of the area, divided by 80π.
///
/// The text of the paper can also be read as the square root of `A / 80π`, which is 16 times as long. Figure 9
/// decides: spheres of the radii 1, 0.5 and 0.25 and a cylinder of the radius 0.4 are all found with
/// `√A / 80π` (0.02), each centre once, and the cylinder by a row of points; with the other (0.32) nothing
/// but one point in the largest sphere is left by the Gaussian, which is then wider than the peaks.
/// (`scripts/paper-figures --figure 9` repeats that.)
/// \param area the area of the surface, in squared units of length
inline double paper_reference_length(double area)
{
  return std::sqrt(area) / (80 * 3.14159265358979323846);
}

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief checks the options and makes the scales: `s`, `2s`, `3s`, …
inline std::vector<Scale> paper_scales(double s, double largest_radius, double sigma_ratio)
{
  check_positive(s, "reference_length");
  check_positive(largest_radius, "largest_radius");
  constexpr double most = 255; // as many as a joint map holds
  const double number = std::floor(largest_radius / s * (1 + 1e-12));
  if(number < 1)
    throw std::invalid_argument("largest_radius is " + internal::to_text(largest_radius) +
                                ": less than the reference length, " + internal::to_text(s));
  if(number > most)
    throw std::invalid_argument(
        "reference_length is " + internal::to_text(s) + ": makes more than 255 radii up to " +
        internal::to_text(largest_radius) + ": must be larger, or largest_radius smaller");
  return proportional_scales(uniform_radii(s, s, std::size_t(number)), sigma_ratio);
}

/// refuses boxes of more voxels than can be dealt with.
inline void check_paper_grid(const Bbox_3& box, double s, double margin)
{
  constexpr double most = 1u << 31; // as many as projectors take
  const double voxels = ((box.x_span() + 2 * margin) / s + 1) *
                        ((box.y_span() + 2 * margin) / s + 1) *
                        ((box.z_span() + 2 * margin) / s + 1);
  if(!(voxels < most))
    throw std::invalid_argument("reference_length is " + internal::to_text(s) +
                                ": cuts the box of the surface into more than 2^31 voxels: must be "
                                "larger");
}

/// makes salient points of maxima in smoothed maps.
class Paper_point_maker
{
public:
  Paper_point_maker(const Row_spans& region, const std::vector<Scale>& scales)
      : m_region(region), m_scales(scales)
  {}

  /// \param map in which the maximum was found
  void add(const Scale_maximum& maximum, std::size_t scale_index, const std::vector<float>& map)
  {
    const Scale& scale = m_scales[scale_index];
    const auto& [i, j, k] = maximum.voxel;
    Salient_point point;
    point.position = m_region.grid().point(i, j, k);
    point.scale = point.radius = scale.radius;
    point.intensity = maximum.value;
    const double radius = inertia_radius(scale.sigma / m_region.grid().spacing());
    point.inertia = inertia_descriptors(map_covariance(m_region, map, maximum.voxel, radius));
    point.sphericity = point.inertia.blobness;
    m_points.push_back(std::move(point));
  }

  /// the points, the strongest first; equal ones as they came.
  std::vector<Salient_point> take()
  {
    std::stable_sort(
        m_points.begin(), m_points.end(),
        [](const Salient_point& a, const Salient_point& b) { return a.intensity > b.intensity; });
    return std::move(m_points);
  }

private:
  const Row_spans& m_region;
  const std::vector<Scale>& m_scales;
  std::vector<Salient_point> m_points;
};

/// tells a callback and a visitor of a run over one scale of many as if it were part of one run over all.
template <class NamedParameters>
class Scale_by_scale
{
public:
  Scale_by_scale(const NamedParameters& np, std::size_t number_of_scales)
      : m_callback(CGAL::parameters::choose_parameter(
            CGAL::parameters::get_parameter(np, internal_np::callback),
            std::function<bool(double)>()))
      , m_visitor(CGAL::parameters::choose_parameter(
            CGAL::parameters::get_parameter(np, internal_np::visitor),
            Multiscale_default_visitor()))
      , m_number(number_of_scales)
  {}

  /// calls `work(np)` with the named parameters for a scale.
  template <class Work>
  void with_parameters(std::size_t scale, Work&& work)
  {
    std::function<bool(double)> callback;
    if(m_callback)
      callback = [this, scale](double fraction) {
        return m_callback((double(scale) + fraction) / double(m_number));
      };
    auto& visitor = unwrap(m_visitor);
    const std::vector<std::size_t> places{scale};
    Renumbering_visitor<std::remove_reference_t<decltype(visitor)>> renumbering{visitor, places};
    work(CGAL::parameters::callback(callback).visitor(std::ref(renumbering)));
  }

private:
  using Visitor = std::decay_t<decltype(CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(std::declval<const NamedParameters&>(), internal_np::visitor),
      Multiscale_default_visitor()))>;

  std::function<bool(double)> m_callback;
  Visitor m_visitor;
  std::size_t m_number;
};

/// the maxima in four dimensions.
template <class ConcurrencyTag, class Session, class NamedParameters>
std::vector<Salient_point> points_of_scales(Session& session, const std::vector<Scale>& scales,
                                            const Paper_salient_options& options,
                                            const NamedParameters& np)
{
  const std::shared_ptr<const Row_spans> region = session.region(options.side);
  Scale_maxima<ConcurrencyTag> maxima(region, options.smoothing, options.threshold);
  Paper_point_maker maker(*region, scales);
  const auto add = [&](const std::vector<Scale_maximum>& found) {
    for(const Scale_maximum& maximum : found)
      maker.add(maximum, maximum.scale, maxima.map_of_maxima());
  };
  Scale_by_scale<NamedParameters> run(np, scales.size());
  for(std::size_t k = 0; k < scales.size(); ++k) {
    const std::vector<float>* map = nullptr;
    run.with_parameters(k, [&](const auto& parameters) {
      map = &session.scale_map(scales[k], options.side, parameters);
    });
    if(!session.summary().is_complete)
      return maker.take();
    add(maxima.push(*map));
  }
  add(maxima.finish());
  return maker.take();
}

/// the maxima of the joint map.
template <class ConcurrencyTag, class Session, class NamedParameters>
std::vector<Salient_point> points_of_joint_map(Session& session, const std::vector<Scale>& scales,
                                               const Paper_salient_options& options,
                                               const NamedParameters& np)
{
  const Joint_map joint = session.joint_map(scales, options.side, np);
  Paper_point_maker maker(joint.region(), scales);
  if(!session.summary().is_complete)
    return maker.take();
  Scale_maxima<ConcurrencyTag> maxima(session.region(options.side), options.smoothing,
                                      options.threshold);
  maxima.push(joint.values());
  for(const Scale_maximum& maximum : maxima.finish()) {
    const auto& [i, j, k] = maximum.voxel;
    const std::uint8_t scale = joint.scale_indices()[joint.region().index(i, j, k)];
    if(scale != Joint_map::no_scale) // or all of the value came from its neighbours
      maker.add(maximum, scale, maxima.map_of_maxima());
  }
  return maker.take();
}

template <class ConcurrencyTag, class ScaleSpace, class NamedParameters>
std::vector<Salient_point> paper_salient_points_of(const ScaleSpace& surface,
                                                   const Paper_salient_options& options,
                                                   const NamedParameters& np)
{
  if(surface.source().empty())
    throw std::invalid_argument("surface is empty");
  const double s =
      options.reference_length.value_or(paper_reference_length(surface.source().total_area()));
  check_positive(s, "reference_length");
  const Bbox_3 box = surface.bbox();
  const double half_side = 0.5 * std::min({box.x_span(), box.y_span(), box.z_span()});
  const std::vector<Scale> scales =
      paper_scales(s, options.largest_radius.value_or(std::max(half_side, s)), options.sigma_ratio);
  const double margin = options.side == Side::INSIDE ? 0. : scales.back().radius;
  check_paper_grid(box, s, margin);
  // The session does not outlive the surface.
  const std::shared_ptr<const ScaleSpace> shared(std::shared_ptr<void>(), &surface);
  Map_session<ScaleSpace, ConcurrencyTag> session(shared, s, margin);
  if(options.use_joint_map)
    return points_of_joint_map<ConcurrencyTag>(session, scales, options, np);
  return points_of_scales<ConcurrencyTag>(session, scales, options, np);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief returns the salient points of the paper (section 6.1), the strongest first: local maxima of the
/// transform over space and radii.
///
/// A reference length `s` is derived from the area of the surface. The transform is computed for the radii
/// `s`, `2s`, `3s`, … and `σ = R/2` on a lattice of the spacing `s`; each map is smoothed by a Gaussian,
/// and a voxel whose value is not below the threshold and above those of its 80 neighbours in space and
/// radius is a point (`Scale_maxima`). Inside, the lattice is that of the interior of the surface, or of
/// its box if it has no triangles; outside it is that of the box and the largest radius around it.
///
/// Of a point there are known:
/// - `position`, a point of the lattice; `scale`, its radius `R`; and `radius`, which is the same: raw, as
///   in the paper, so that it is about two thirds of the radius of a sphere, 85 % of that of a tube;
/// - `intensity`, the value of the *smoothed* map: less than that of the map, most of all for radii of few
///   voxels;
/// - `inertia` and `sphericity`, of the smoothed map of its scale (of the joint map) in a ball of
///   `inertia_radius()`.
///
/// The rest is unknown, the shape `Salient_shape::OTHER`.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the results have the same bits for any number of threads
/// \tparam Surface `Triangle_surface`, `Surfels`, or a model of `SurfelScaleSpace` that has `source()`
/// \param surface the surface, facing outward
/// \param options the choices
/// \param np the named parameters of `project_scales()`, `callback` and `visitor`. If the callback stops
/// the computation, the points found by then are returned.
/// \throw std::invalid_argument if the surface is empty, an option is out of range, or `s` is so small
/// that there are more than 255 radii, or more than 2^31 voxels in the box: that happens by default only
/// to a surface of parts that are small and far apart. Give a larger `reference_length` then, or a smaller
/// `largest_radius`.
///
/// Complexity: for each radius, linear in the number of voxels and in the area of the surface in voxels.
/// Memory: 24 bytes for each voxel with storage; with `use_joint_map` 17, and 4 more for each further
/// thread.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Surface,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Salient_point>
paper_salient_points(const Surface& surface, const Paper_salient_options& options = {},
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(std::is_same_v<Surface, Triangle_surface> || std::is_same_v<Surface, Surfels>)
    return internal::paper_salient_points_of<ConcurrencyTag>(Constant_scale_space(surface), options,
                                                             np);
  else
    return internal::paper_salient_points_of<ConcurrencyTag>(surface, options, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_PAPER_SALIENT_POINTS_H
