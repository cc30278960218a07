// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MAP_SESSION_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MAP_SESSION_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/internal/Kept_maps.h>
#include <CGAL/Area_projection_transform/internal/Projector_pool.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief makes a `Grid_projector` with the same kernel and sampling for any voxels.
struct Make_grid_projector
{
  /// the kernel, as `ProjectionKernel_3::nested_balls()` tells it.
  std::vector<Nested_ball> kernel = Ball_kernel_3().nested_balls();
  /// the distance of samples of the surface, in units of `σ`; see `Grid_projector`.
  double sampling_ratio = Grid_projector::default_sampling_ratio;

  /// returns a projector for the voxels of `region`.
  Grid_projector operator()(const Row_spans& region) const
  {
    return Grid_projector(region, kernel, sampling_ratio);
  }
};

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief holds all that does not depend on the scales, and answers questions about them: pay once, ask
/// often.
///
/// The surface with its hierarchy of samples, the regions of the two sides and the memory of the
/// projectors are kept. So a change of a radius, of `c` or of the side costs no more than the projection
/// of the scales that are asked for. Whoever changes one radius of many can have the maps of the others
/// kept as well: see `keep_maps()`.
///
/// The inside is the interior of the surface, on a lattice that covers its box; if the surface has no
/// triangles, it is all of the box. The outside is the box with a margin. Both are found when they are
/// needed first, or given by `set_region()`.
///
/// A question is answered by several threads with `Parallel_tag`, even one about a single scale, with the
/// same bits as by one. Questions must not be asked concurrently.
///
/// \tparam ScaleSpace a model of `SurfelScaleSpace` that has `source()`
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \tparam MakeProjector a function of a `const Row_spans&` that returns a model of `GridProjector`
template <class ScaleSpace, class ConcurrencyTag = CGAL::Sequential_tag,
          class MakeProjector = Make_grid_projector>
class Map_session
{
public:
  /// \param surface the surface
  /// \param voxel_size the spacing of the lattices, in the units of the surface
  /// \param margin how far the outside reaches beyond the box of the surface, in the same units: at least
  /// the largest radius of interest, or what lands farther away is lost
  /// \param make_projector makes the projectors
  /// \throw std::invalid_argument if `voxel_size` is not positive or `margin` is negative.
  Map_session(std::shared_ptr<const ScaleSpace> surface, double voxel_size, double margin = 0,
              MakeProjector make_projector = MakeProjector())
      : m_surface(std::move(surface))
      , m_grids{grid_around(m_surface->bbox(), voxel_size),
                grid_around(m_surface->bbox(), voxel_size, margin)}
      , m_make_projector(std::move(make_projector))
  {}

  /// the same, with a surface that the session alone holds.
  Map_session(ScaleSpace surface, double voxel_size, double margin = 0,
              MakeProjector make_projector = MakeProjector())
      : Map_session(std::make_shared<const ScaleSpace>(std::move(surface)), voxel_size, margin,
                    std::move(make_projector))
  {}

  /// the surface.
  const ScaleSpace& surface() const { return *m_surface; }

  /// the voxels of a side.
  const std::shared_ptr<const Row_spans>& region(Side side)
  {
    std::shared_ptr<const Row_spans>& region = m_regions[place(side)];
    if(!region)
      region = std::make_shared<const Row_spans>(find_region(side));
    return region;
  }

  /// replaces the voxels of a side; they may be those of another grid. Drops the maps that were kept.
  void set_region(Side side, std::shared_ptr<const Row_spans> region)
  {
    m_regions[place(side)] = std::move(region);
    m_kept[place(side)].clear();
  }

  /// \brief whether `joint_map()` keeps the map of each scale, so that a question about other scales
  /// recomputes only those that are new: 4 bytes for each voxel with storage, scale and side.
  ///
  /// The maps kept are those of the last joint map of each side. By default none is.
  void keep_maps(bool keep)
  {
    m_keeps_maps = keep;
    if(!keep)
      m_kept = {};
  }

  /// \brief hands the values of the scales to a sink, as `project_scales()` does.
  /// \tparam Sink a model of `MultiscaleSink`, made for `region(side)` and `scales`
  /// \param scales the scales, in any order
  /// \param side the side of the surface
  /// \param sink receives the values
  /// \param np the named parameters of `project_scales()`
  /// \throw std::invalid_argument as `project_scales()` does
  template <class Sink, class NamedParameters = CGAL::parameters::Default_named_parameters>
  const Multiscale_summary& project(const std::vector<Scale>& scales, Side side, Sink& sink,
                                    const NamedParameters& np = CGAL::parameters::default_values());

  /// \brief returns the map of one scale: `APT / (4πR²)` at the places that `region(side)->index()` gives.
  ///
  /// Valid until the next question or change. A map that is kept is not computed again; the visitor is
  /// \param scale the radius and `σ`, in the units of the surface
  /// \param side the side of the surface
  /// told of those that are.
  /// \param np the named parameters of `project_scales()`
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  const std::vector<float>&
  scale_map(const Scale& scale, Side side,
            const NamedParameters& np = CGAL::parameters::default_values());

  /// \brief returns the joint map of some scales.
  ///
  /// The visitor is told of the scales that are computed, not of those that are kept.
  /// \param scales the scales, their radii ascending
  /// \param side the side of the surface
  /// \param np the named parameters of `project_scales()`
  /// \throw std::invalid_argument if the radii do not ascend, and as `project_scales()` does
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Joint_map joint_map(const std::vector<Scale>& scales, Side side,
                      const NamedParameters& np = CGAL::parameters::default_values());

  /// \brief how the last question ended. If its callback stopped it, its answer holds some scales, or
  /// parts of them, and is of no use to most.
  const Multiscale_summary& summary() const { return m_summary; }

private:
  using Projector = std::decay_t<std::invoke_result_t<MakeProjector&, const Row_spans&>>;
  using Maps = std::vector<internal::Kept_map>;

  static std::size_t place(Side side) { return side == Side::INSIDE ? 0 : 1; }

  Row_spans find_region(Side side) const
  {
    const Grid_3& grid = m_grids[place(side)];
    if constexpr(std::is_same_v<std::decay_t<decltype(m_surface->source())>, Triangle_surface>)
      if(side == Side::INSIDE)
        return interior<ConcurrencyTag>(m_surface->source(), grid).region;
    return Row_spans(grid);
  }

  Maps take_kept_maps(const std::vector<Scale>& scales, Side side);

  template <class NamedParameters>
  void compute_new_maps(const std::vector<Scale>& scales, Side side, Maps& maps,
                        const NamedParameters& np);

  std::shared_ptr<const ScaleSpace> m_surface;
  std::array<Grid_3, 2> m_grids; // these arrays: inside and outside
  MakeProjector m_make_projector;
  std::array<std::shared_ptr<const Row_spans>, 2> m_regions;
  internal::Projector_pool<Projector> m_pool;
  bool m_keeps_maps = false;
  std::array<Maps, 2> m_kept;
  std::vector<float> m_map; // of a scale that is not kept
  std::shared_ptr<const Row_spans> m_region_of_map;
  Multiscale_summary m_summary;
};

template <class ScaleSpace, class ConcurrencyTag, class MakeProjector>
template <class Sink, class NamedParameters>
const Multiscale_summary& Map_session<ScaleSpace, ConcurrencyTag, MakeProjector>::project(
    const std::vector<Scale>& scales, Side side, Sink& sink, const NamedParameters& np)
{
  m_pool.begin_run(region(side),
                   internal::number_of_parts<ConcurrencyTag, MakeProjector>(scales.size()));
  m_summary = internal::project_scales<ConcurrencyTag>(
      *m_surface, *region(side), m_pool.parts(), scales, side,
      [this](const Row_spans& part) { return m_pool.lease(part, m_make_projector); }, sink, np);
  if(m_summary.is_complete)
    m_pool.finish_run();
  return m_summary;
}

template <class ScaleSpace, class ConcurrencyTag, class MakeProjector>
template <class NamedParameters>
const std::vector<float>&
Map_session<ScaleSpace, ConcurrencyTag, MakeProjector>::scale_map(const Scale& scale, Side side,
                                                                  const NamedParameters& np)
{
  if(const internal::Kept_map* kept = internal::find_map(m_kept[place(side)], scale)) {
    m_summary = {true, {kept->area_outside}};
    return kept->values;
  }
  // What lies between the runs of a row stays zero from question to question.
  if(m_region_of_map != region(side)) {
    m_region_of_map = region(side);
    m_map.assign(m_region_of_map->storage_size(), 0.f);
  }
  internal::Copying_sink sink({m_map.data()});
  project({scale}, side, sink, np);
  return m_map;
}

template <class ScaleSpace, class ConcurrencyTag, class MakeProjector>
template <class NamedParameters>
Joint_map Map_session<ScaleSpace, ConcurrencyTag, MakeProjector>::joint_map(
    const std::vector<Scale>& scales, Side side, const NamedParameters& np)
{
  Joint_map joint(region(side), scales);
  if(!m_keeps_maps) {
    project(scales, side, joint, np);
    return joint;
  }
  Maps maps = take_kept_maps(scales, side);
  compute_new_maps(scales, side, maps, np);
  internal::fold<ConcurrencyTag>(maps, joint);
  if(!m_summary.is_complete) // what is left of the maps that were kept before
    maps.erase(std::remove_if(maps.begin(), maps.end(),
                              [](const internal::Kept_map& map) { return map.is_new; }),
               maps.end());
  for(internal::Kept_map& map : maps)
    map.is_new = false;
  m_kept[place(side)] = std::move(maps);
  return joint;
}

/// the maps of the scales, those that were not kept empty.
template <class ScaleSpace, class ConcurrencyTag, class MakeProjector>
auto Map_session<ScaleSpace, ConcurrencyTag, MakeProjector>::take_kept_maps(
    const std::vector<Scale>& scales, Side side) -> Maps
{
  Maps kept = std::exchange(m_kept[place(side)], Maps());
  Maps maps;
  for(const Scale& scale : scales)
    if(internal::Kept_map* map = internal::find_map(kept, scale))
      maps.push_back(std::move(*map));
    else
      maps.push_back({scale, std::vector<float>(region(side)->storage_size(), 0.f), 0., true});
  return maps;
}

template <class ScaleSpace, class ConcurrencyTag, class MakeProjector>
template <class NamedParameters>
void Map_session<ScaleSpace, ConcurrencyTag, MakeProjector>::compute_new_maps(
    const std::vector<Scale>& scales, Side side, Maps& maps, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  std::vector<std::size_t> places;
  std::vector<Scale> new_scales;
  std::vector<float*> values;
  for(std::size_t k = 0; k < maps.size(); ++k)
    if(maps[k].is_new) {
      places.push_back(k);
      new_scales.push_back(scales[k]);
      values.push_back(maps[k].values.data());
    }
  m_summary = Multiscale_summary();
  if(!places.empty()) {
    auto given_visitor =
        choose_parameter(get_parameter(np, internal_np::visitor), Multiscale_default_visitor());
    auto& visitor = internal::unwrap(given_visitor);
    internal::Renumbering_visitor<std::remove_reference_t<decltype(visitor)>> renumbering{visitor,
                                                                                          places};
    const auto callback =
        choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());
    internal::Copying_sink sink(std::move(values));
    project(new_scales, side, sink,
            CGAL::parameters::callback(callback).visitor(std::ref(renumbering)));
  }
  for(std::size_t i = 0; i < places.size(); ++i)
    maps[places[i]].area_outside = m_summary.areas_outside[i];
  m_summary.areas_outside.clear();
  for(const internal::Kept_map& map : maps)
    m_summary.areas_outside.push_back(map.area_outside);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MAP_SESSION_H
