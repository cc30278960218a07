// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>
#include <CGAL/Area_projection_transform/salient_points/Shape_detector.h>
#include <CGAL/Area_projection_transform/salient_points/assign_voters.h>
#include <CGAL/Area_projection_transform/salient_points/best_scale.h>
#include <CGAL/Area_projection_transform/salient_points/refine_shape.h>
#include <CGAL/Area_projection_transform/scales.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief the choices of `salient_points()`.
struct Salient_point_options
{
  /// the side of the surface on which centres are sought: the outside for bores and pits.
  Side side = Side::INSIDE;
  /// the range of the radii of spheres and tubes, in the units of the surface.
  /// Default: from about the length of an edge, or less where faces are long and thin, to half of the middle
  /// one of the sides of the bounding box.
  std::optional<double> smallest_radius;
  std::optional<double> largest_radius; ///< \copydoc smallest_radius
  /// the least intensity of what is returned: a number, or one of `salient_thresholds`. By default what a shape
  /// fits to is returned, however little of it there is.
  double threshold = 0;
  /// the least gap between the ends of tubes that follow each other along a line, in units of their radius: of those
  /// that are nearer, the longer one is returned. Pieces of one straight tube are one tube anyway.
  std::optional<double> tube_spacing;
};

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief what the transform has at the centre of ideal shapes, each at its own radius and `σ/R = 1/2`: names for
/// thresholds of the intensity.
///
/// The intensity of a salient point is the largest over all radii, so that ideal shapes exceed these values: a sphere
/// has 2.25, a hemisphere half of that, a tube 0.55. What is left over is for what is missing.
struct salient_thresholds
{
  static constexpr double sphere = 1;       ///< a whole sphere
  static constexpr double hemisphere = 0.5; ///< half of a sphere
  static constexpr double tube = 0.5;       ///< a whole tube, far from its ends
  static constexpr double slab = 0.125;     ///< more than two parallel walls
  static constexpr double paper = 0.2;      ///< that of the paper, section 6.1
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check(const Salient_point_options& options)
{
  if(options.smallest_radius)
    check_positive(*options.smallest_radius, "smallest_radius");
  if(options.largest_radius)
    check_positive(*options.largest_radius, "largest_radius");
  if(options.smallest_radius && options.largest_radius &&
     *options.smallest_radius > *options.largest_radius)
    throw std::invalid_argument(
        "smallest_radius is " + internal::to_text(*options.smallest_radius) +
        ": larger than largest_radius, " + internal::to_text(*options.largest_radius));
  if(options.tube_spacing)
    check_positive(*options.tube_spacing, "tube_spacing");
  if(!(options.threshold >= 0))
    throw std::invalid_argument("threshold is " + internal::to_text(options.threshold) +
                                ": must not be negative");
}

/// \brief the smallest radius for which a surface is cut into no more than some number of patches, and for which its
/// clusters can be numbered.
inline double least_radius(const Feature_surface& surface, double most_patches)
{
  constexpr double most_cells = 1 << 18; // along an axis
  const double finest = surface.extent().maxCoeff() / (Vote_level::cluster_size * most_cells);
  double radius =
      std::max(std::sqrt(surface.area() / most_patches) / Vote_level::patch_spacing, finest);
  // Needles take more pieces than their area tells.
  while(std::isnormal(radius) &&
        surface.number_of_patches(Vote_level::patch_spacing * radius) > most_patches)
    radius *= 1.3;
  return radius;
}

/// the smallest radius, that of the user if there is one.
inline double smallest_salient_radius(const Feature_surface& surface,
                                      const Salient_point_options& options)
{
  // So many patches are enough to see what the faces show, however long some of them are.
  const double number = double(surface.patches().size());
  if(!options.smallest_radius)
    return std::max(surface.resolution(), least_radius(surface, 2 * number + 2e4));
  constexpr double most_patches = 4e6;
  const double least = least_radius(surface, std::max(most_patches, 2 * number));
  if(*options.smallest_radius < least)
    throw std::invalid_argument("smallest_radius is " +
                                internal::to_text(*options.smallest_radius) +
                                ": the surface would be cut into too many pieces; must be at "
                                "least " +
                                internal::to_text(least));
  return *options.smallest_radius;
}

/// of the three sides of the bounding box the one in the middle: halves of balls and tubes are two radii wide in two
/// directions.
inline double middle_extent(const Feature_surface& surface)
{
  Eigen::Vector3d sides = surface.extent();
  std::sort(sides.data(), sides.data() + 3);
  return sides[1];
}

/// the radii of the levels: from the smallest of which something can be seen to one that is too large.
inline std::vector<double> salient_radii(const Feature_surface& surface,
                                         const Salient_point_options& options)
{
  constexpr double ratio = 1.3;
  std::vector<double> radii;
  if(surface.patches().empty())
    return radii;
  const double smallest = smallest_salient_radius(surface, options);
  const double beyond = std::max(2 * surface.extent().norm(), smallest);
  const double largest = std::min(
      options.largest_radius.value_or(std::max(0.55 * middle_extent(surface), smallest)), beyond);
  if(std::isnormal(smallest) && std::isfinite(largest))
    for(double r = smallest; r < ratio * largest; r *= ratio)
      radii.push_back(r);
  return radii;
}

/// whether there is still a shape after it was fitted to all points, near the one that was found.
inline bool is_valid(const Shape& shape, const Radius_estimate& radius, double radius_before)
{
  constexpr double most_change = 1.3, widest = 0.25;
  const double r = radius.radius;
  if(!(r > radius_before / most_change) || !(r < radius_before * most_change))
    return false;
  if(shape.is_sphere() || shape.is_tube())
    return radius.high - radius.low < 2 * widest * r;
  const Eigen::Vector3d axes = shape.ellipsoid().axes().lengths;
  return axes[0] > 0 && axes[2] < 4 * axes[0];
}

/// whether a point is what the user asked for.
inline bool is_wanted(const Salient_point& point, const Salient_point_options& options)
{
  constexpr double tolerance = 0.01;
  return !point.voters.empty() && point.intensity >= options.threshold &&
         point.radius >= (1 - tolerance) * options.smallest_radius.value_or(0) &&
         !(options.largest_radius && point.radius > (1 + tolerance) * *options.largest_radius);
}

inline std::optional<Salient_point> salient_point(const Feature_surface& surface,
                                                  const Cell_list& cells, Found_shape& found)
{
  Shape& shape = found.shape;
  const Shape before = shape;
  Radius_estimate radius = refine_shape(surface.points(), cells, shape);
  if(!is_valid(shape, radius, before.radius())) {
    if(before.is_sphere() || before.is_tube())
      return std::nullopt;
    // Ellipsoids bend to what is beside them, too, such as a neck; no interval is lost with the refinement.
    shape = before;
    radius.radius = before.radius();
  }
  Salient_point point;
  const Eigen::Vector3d x = shape.center();
  point.position = Point_3(x.x(), x.y(), x.z());
  point.radius = radius.radius;
  point.radius_low = radius.low;
  point.radius_high = radius.high;
  point.residual = shape.deviation;
  point.observed_fraction = observed_fraction(shape, found.support);
  point.is_seen_from_one_side = found.support.far_area < 0.02 * found.support.area;
  const Best_scale best = best_scale(surface, x, 0.5, 0.4 * radius.radius, 1.6 * radius.radius);
  point.scale = best.radius;
  point.intensity = best.intensity;
  point.inertia = inertia_at(surface, x, {best.radius, 0.5 * best.radius});
  point.sphericity = point.inertia.blobness;
  if(shape.is_sphere()) {
    point.shape = Salient_shape::SPHERE;
    return point;
  }
  if(!shape.is_tube()) {
    const Eigen::Vector3d longest = shape.ellipsoid().axes().directions.col(2);
    point.axis = Vector_3(longest.x(), longest.y(), longest.z());
    return point;
  }
  const Tube& tube = shape.tube();
  point.shape = tube.slope != 0 ? Salient_shape::CONE : Salient_shape::TUBE;
  point.axis = Vector_3(tube.axis.x(), tube.axis.y(), tube.axis.z());
  point.slope = tube.slope;
  point.curvature = Vector_3(tube.curvature.x(), tube.curvature.y(), tube.curvature.z());
  point.length = shape.length();
  return point;
}

/// drops tubes that begin near the end of a longer one, along its axis.
inline void thin_tubes(std::vector<Found_shape>& shapes, double spacing)
{
  std::vector<Found_shape> kept;
  std::stable_sort(shapes.begin(), shapes.end(), [](const Found_shape& a, const Found_shape& b) {
    return a.support.area > b.support.area;
  });
  for(const Found_shape& found : shapes) {
    const auto is_near = [&](const Found_shape& other) {
      return other.shape.is_tube() &&
             follows(other.shape, found.shape, spacing * other.shape.radius());
    };
    if(!found.shape.is_tube() || std::none_of(kept.begin(), kept.end(), is_near))
      kept.push_back(found);
  }
  shapes = std::move(kept);
}

template <class ConcurrencyTag>
std::vector<Salient_point>
salient_points_of(const Feature_surface& surface, const std::vector<std::uint32_t>& sources,
                  const Salient_point_options& options, const std::function<bool(double)>& callback)
{
  Progress_report progress(callback);
  std::vector<Found_shape> found =
      Shape_detector<ConcurrencyTag>(surface, salient_radii(surface, options), progress).find();
  if(options.tube_spacing)
    thin_tubes(found, *options.tube_spacing);
  const Cell_list cells(surface.points().positions, 3 * surface.resolution());
  std::vector<std::optional<Salient_point>> refined(found.size());
  for_each_index<ConcurrencyTag>(
      found.size(), [&](std::size_t i) { refined[i] = salient_point(surface, cells, found[i]); });
  std::vector<Salient_point> points;
  std::vector<Found_shape> shapes;
  for(std::size_t i = 0; i < found.size(); ++i)
    if(refined[i]) {
      points.push_back(*refined[i]);
      shapes.push_back(found[i]);
    }
  assign_voters(surface, sources, shapes, points);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Salient_point& p) { return !is_wanted(p, options); }),
               points.end());
  std::stable_sort(
      points.begin(), points.end(),
      [](const Salient_point& a, const Salient_point& b) { return a.intensity > b.intensity; });
  return points;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief returns the centres of spheres, tubes, cones and ellipsoids that a surface is made of, or parts of them,
/// the strongest first.
///
/// Each place at which the surface meets, moved along its normals by one of many radii, is a candidate, the
/// best first (the maxima of the map, paper, section 6.1). What counts is whether a shape fits to the vertices
/// around: then its radius, its axis and an interval for the radius come from the fit, since the radius of the
/// map is a third too small for spheres; and its surface is taken out of what is left for the others. Tubes are
/// followed along their axis, as cylinders, cones or bent tubes.
///
/// Half of the faces may be missing, at random or as holes, faces may be turned over, and vertices displaced.
/// What was measured, and what defeats it, is told in the user manual. Triangles without area are ignored; the
/// surface need not be closed, connected or manifold.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result does not depend on it, to the last bit
/// \param surface triangles, facing outward; their vertices lie on what the mesh stands for
/// \param options the choices
/// \param np an optional named parameter:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is told the progress, in [0, 1], and answers whether to go on; is called some
///                           times a second by any of the threads, but never twice at a time. If it
///                           answers `false`, the points found by then are returned.}
///     \cgalParamType{an instance of `std::function<bool(double)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw std::invalid_argument if a radius or the spacing of tubes is not positive, the radii do not ascend, or the
/// threshold is negative or not a number
///
/// Complexity: linear in the number of faces for each radius whose clusters are not much larger than the faces, and
/// in the number of candidates, of which there are some hundreds to thousands. Memory: about 300 bytes for each face.
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Salient_point>
salient_points(const Triangle_surface& surface, const Salient_point_options& options = {},
               const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  return internal::salient_points_of<ConcurrencyTag>(
      internal::Feature_surface(surface, options.side), surface.sources, options,
      internal::callback_of(np));
}

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief the same for points with normals, which lie on the surface, and the areas that they stand for.
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Salient_point>
salient_points(const Surfels& points, const Salient_point_options& options = {},
               const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check(options);
  return internal::salient_points_of<ConcurrencyTag>(
      internal::Feature_surface(points, options.side), points.sources, options,
      internal::callback_of(np));
}

/// \ingroup PkgAreaProjectionTransformSalientPoints
/// \brief the same for a mesh.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh, facing outward; open, holed, in several parts, as it is
/// \param options the choices
/// \param np the named parameters of `surface_from_mesh()`, and `callback`
/// \throw std::invalid_argument also as `surface_from_mesh()` does
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Salient_point>
salient_points(const TriangleMesh& mesh, const Salient_point_options& options = {},
               const NamedParameters& np = CGAL::parameters::default_values())
{
  return salient_points<ConcurrencyTag>(surface_from_mesh(mesh, np), options, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SALIENT_POINTS_H
