// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_PAPER_CENTERLINES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_PAPER_CENTERLINES_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/centerlines/paper_line_tracer.h>
#include <CGAL/Area_projection_transform/default_scales.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scales.h>
#include <CGAL/Area_projection_transform/vesselness.h>
#include <CGAL/Area_projection_transform/voter_normals.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief where the directions come from along which regions of lines are continued.
enum class Line_directions {
  HESSIAN, ///< of the map, as in the paper
  VOTERS   ///< the normals of the surface that is projected there (see `voter_normals()`)
};

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief the choices of `paper_centerlines()`; lengths are in the units of the surface.
struct Paper_centerline_options
{
  /// the side of the surface on which lines are sought.
  Side side = Side::INSIDE;
  /// the spacing of the lattice. Default: `default_voxel_size()`.
  std::optional<double> voxel_size;
  /// the radii of the joint map, ascending. Default: `default_radii()`.
  std::vector<double> radii;
  /// the ratio `σ/R`, in (0, 1).
  double sigma_ratio = 0.5;
  /// how vesselness is measured; its `scales` and `coverage` count only as the next two say.
  Vesselness_options vesselness;
  /// \brief whether each voxel takes the best of all scales, `vesselness.scale_ratio` times each radius of the map, or
  /// those of `vesselness.scales` if there are any ("multiscale", as in the paper); otherwise it has the one of its own
  /// radius.
  bool scan_scales = true;
  /// whether `vesselness.coverage` is that which the interior sees (`Interior::coverage`).
  bool compensate = true;
  /// where the directions come from in which regions are grown.
  Line_directions directions = Line_directions::HESSIAN;
  /// what becomes of the vesselness.
  Paper_tracing_options tracing;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Source>
inline constexpr bool has_triangles = std::is_same_v<std::decay_t<Source>, Triangle_surface>;

/// the joint map, and how much of the surface the region saw.
struct Covered_joint_map
{
  Joint_map map;
  double coverage;
  bool is_complete;
};

template <class ConcurrencyTag, class Source, class NamedParameters>
Covered_joint_map map_for_lines(const Constant_scale_space<Source>& surface,
                                const Paper_centerline_options& options, const NamedParameters& np)
{
  const Bbox_3 box = surface.bbox();
  const double voxel_size = options.voxel_size.value_or(default_voxel_size(box));
  check_positive(voxel_size, "voxel_size");
  const std::vector<Scale> scales = proportional_scales(
      options.radii.empty() ? default_radii(box, voxel_size, options.sigma_ratio) : options.radii,
      options.sigma_ratio);
  const double margin = options.side == Side::INSIDE ? 0. : scales.back().radius;
  // The session does not outlive the surface.
  Map_session<Constant_scale_space<Source>, ConcurrencyTag> session(
      std::shared_ptr<const Constant_scale_space<Source>>(std::shared_ptr<void>(), &surface),
      voxel_size, margin);
  double coverage = 1;
  if constexpr(has_triangles<Source>)
    if(options.side == Side::INSIDE) {
      Interior inside = interior<ConcurrencyTag>(surface.source(), grid_around(box, voxel_size));
      coverage = inside.coverage;
      session.set_region(Side::INSIDE, std::make_shared<const Row_spans>(std::move(inside.region)));
    }
  Joint_map map = session.joint_map(scales, options.side, np);
  return {std::move(map), coverage, session.summary().is_complete};
}

inline Vesselness_options vesselness_options(const Covered_joint_map& covered,
                                             const Paper_centerline_options& options)
{
  Vesselness_options result = options.vesselness;
  if(options.compensate && covered.coverage > 0)
    result.coverage = covered.coverage;
  if(!options.scan_scales)
    result.scales.clear();
  else if(result.scales.empty()) {
    const double voxel_size = covered.map.grid().spacing();
    for(const Vesselness_level& level : vesselness_levels(covered.map, result))
      result.scales.push_back(level.s * voxel_size);
  }
  return result;
}

/// replaces the directions of voxels that count by those of the normals of the voters.
template <class ConcurrencyTag, class Source>
void take_directions_of_voters(const Source& surface, Side side, const Joint_map& map,
                               double threshold, Vesselness_map& vesselness)
{
  std::vector<Query> queries;
  std::vector<std::size_t> places;
  for_each_line_voxel(vesselness, threshold, [&](const std::array<int, 3>& v, std::size_t place) {
    const std::uint8_t scale = map.scale_indices()[place];
    if(scale == Joint_map::no_scale) // no line goes there
      return;
    queries.push_back({map.grid().point(v[0], v[1], v[2]), map.scales()[scale]});
    places.push_back(place);
  });
  const std::vector<Voter_normals> normals = voter_normals<ConcurrencyTag>(surface, queries, side);
  for(std::size_t q = 0; q < queries.size(); ++q)
    if(normals[q].area() > 0) {
      const Vector_3 axis = normals[q].axis();
      vesselness.directions[places[q]] = {float(axis.x()), float(axis.y()), float(axis.z())};
    }
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief returns the lines that the paper finds in a joint map (section 6.2), given its vesselness.
///
/// - Regions grow from the voxel of the largest vesselness, over neighbours whose vesselness is not below a
///   threshold, and whose directions differ by no more than an angle from that of the voxel before.
/// - In each region a front with the speed 1 starts at the maximum of the map, and from the voxel that it reaches
///   last another one: the voxels that these reach last are the ends. (The paper has "the points with the maximum distance
///   from this point in opposite directions". Directions may turn round on the way; the farthest point from the
///   farthest is at the other end anyway.)
/// - From end to end goes the fastest path with the vesselness as speed.
///
/// The lines are in the order in which their regions were found: that of the largest vesselness of each.
///
/// What is known of it: a region makes one path, so that where the threshold does not part tubes that meet or lie
/// side by side, some are lost: `Paper_tracing_options::repeat` looks for them. A closed tube becomes half a ring, or
/// two. Paths cut corners, since the vesselness hardly falls near the axis, turn to a corner of the region at its
/// ends, and end about a radius before the end of a tube, where the map is that of a ball. Sections of 1 to 2 are no
/// lines.
/// \param map the joint map
/// \param vesselness how much it looks like a line, of the same region
/// \param options what becomes of it
/// \throw std::invalid_argument if an option is out of range, or the two are not of the same region.
///
/// Complexity: `O(n log n)` for `n` voxels above the threshold, and for each region linear in the number of rows of
/// the lattice. One thread.
inline std::vector<Centerline> paper_centerlines(const Joint_map& map,
                                                 const Vesselness_map& vesselness,
                                                 const Paper_tracing_options& options = {})
{
  return internal::Paper_line_tracer(map, vesselness, options).trace();
}

/// \ingroup PkgAreaProjectionTransformCenterlines
/// \brief returns the lines in the middle of the tubes of a surface, as the paper finds them (section 6.2).
///
/// Computes the joint map on a lattice, its multiscale vesselness, and the lines in that. The radius of a line is
/// that of the joint map: raw, so that it is about 85 % of the radius of the tube.
///
/// This is the method as published, for comparison: its lines are off by 1 to 14 % of the radius of a tube. The paper
/// does not say what a scale, a threshold, continuous or negligible is. The defaults are what found the right number
/// of lines in twelve shapes (straight and bent tubes, a helix, a fork, tubes that touch, are merged or fused, and
/// others), whole, and with half of the faces removed and noise. A threshold of 0.2 or 0.35 joins lines that are to
/// stay apart, one of 0.65 ends them earlier; without the compensation, half of the surface leaves lines in pieces.
/// One scale for each voxel is as good as all of them, in half of the time. Directions of voters see edges as lines.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the results have the same bits for any number of threads
/// \tparam Surface `Triangle_surface` or `Surfels`
/// \param surface the surface, facing outward
/// \param options the choices
/// \param np the named parameters of `project_scales()`, `callback` and `visitor`. If the callback stops the
/// computation, no line is returned.
/// \throw std::invalid_argument if the surface is empty or an option is out of range
///
/// Complexity: that of the joint map, of `vesselness()`, and of the search for lines. Memory: 29 bytes for each
/// voxel with storage while the lines are traced.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Surface,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Centerline>
paper_centerlines(const Surface& surface, const Paper_centerline_options& options = {},
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  if(surface.empty())
    throw std::invalid_argument("surface is empty");
  internal::check(options.tracing);
  const Constant_scale_space<Surface> constant(surface);
  const internal::Covered_joint_map covered =
      internal::map_for_lines<ConcurrencyTag>(constant, options, np);
  if(!covered.is_complete)
    return {};
  Vesselness_map found =
      vesselness<ConcurrencyTag>(covered.map, internal::vesselness_options(covered, options));
  if(options.directions == Line_directions::VOTERS)
    internal::take_directions_of_voters<ConcurrencyTag>(surface, options.side, covered.map,
                                                        options.tracing.threshold, found);
  return paper_centerlines(covered.map, found, options.tracing);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_PAPER_CENTERLINES_H
