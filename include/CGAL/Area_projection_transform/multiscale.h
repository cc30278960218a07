// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MULTISCALE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MULTISCALE_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/Progress.h>
#include <CGAL/Area_projection_transform/internal/Region_parts.h>
#include <CGAL/Area_projection_transform/internal/Scale_space_near_part.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/parameters.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief how a run over the scales ended.
struct Multiscale_summary
{
  /// whether all scales were computed: `false` if the callback asked to stop. The sink then holds
  /// the scales that were finished, and parts of others.
  bool is_complete = true;
  /// per scale, the area whose projection falls outside of the grid.
  std::vector<double> areas_outside;
};

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief the visitor that does nothing; derive from it and override what is of interest.
///
/// Calls are never concurrent. With several threads the scales come in no fixed order.
struct Multiscale_default_visitor
{
  /// called before a scale is projected, with its position in the list of scales.
  void scale_begins(std::size_t /* index */, const Scale&) {}
  /// called when the sink has all of a scale, with the area whose projection falls outside of the grid.
  void scale_ends(std::size_t /* index */, const Scale&, double /* area_outside */) {}
};

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class T>
T& unwrap(T& value)
{
  return value;
}

template <class T>
T& unwrap(std::reference_wrapper<T>& wrapper)
{
  return wrapper.get();
}

/// a projector for some voxels, if `make_projector` asks which, and for all otherwise.
template <class MakeProjector>
decltype(auto) make_projector_for(MakeProjector& make_projector, const Row_spans& region)
{
  if constexpr(std::is_invocable_v<MakeProjector&, const Row_spans&>)
    return make_projector(region);
  else
    return make_projector();
}

/// \brief into how many parts a region is cut, so that no thread has to be idle where there are fewer
/// scales than threads.
template <class ConcurrencyTag, class MakeProjector>
std::size_t number_of_parts(std::size_t scales)
{
  if constexpr(std::is_invocable_v<MakeProjector&, const Row_spans&>)
    if(scales > 0)
      return (number_of_workers<ConcurrencyTag>() + scales - 1) / scales;
  return 1;
}

/// \brief hands the rows of a part of one scale to the sink, layer by layer, beginning with the `start`-th
/// of the part.
///
/// A layer is locked while its rows are handed over, and a scale of several parts while a row is, so that sinks
/// need no locks of their own.
/// \param lock_of_scale null if no other thread has a part of the scale
template <class Projector, class Sink, class Cancelled>
void deliver(Projector& projector, const Row_spans& region, const Region_part& part,
             std::size_t index, const Scale& scale, std::size_t start,
             std::vector<std::mutex>& layers, std::mutex* lock_of_scale, Sink& sink,
             Cancelled&& cancelled)
{
  const std::size_t rows_of_layer = std::size_t(region.grid().size()[1]);
  const std::size_t layers_of_part = std::size_t(part.last_layer - part.first_layer);
  const float normalization = float(scale.normalization());
  std::vector<float> values(std::size_t(region.grid().size()[0]));
  for(std::size_t l = 0; l < layers_of_part && !cancelled(); ++l) {
    const std::size_t layer = std::size_t(part.first_layer) + (start + l) % layers_of_part;
    const std::lock_guard<std::mutex> lock(layers[layer]);
    for(std::size_t row = layer * rows_of_layer; row < (layer + 1) * rows_of_layer; ++row) {
      const Row_spans::Hull& hull = region.hull(row);
      if(hull.first == hull.last)
        continue;
      projector.take_row(row, values.data());
      for(std::int32_t i = 0; i < hull.last - hull.first; ++i)
        values[std::size_t(i)] *= normalization;
      std::unique_lock<std::mutex> scale_lock;
      if(lock_of_scale)
        scale_lock = std::unique_lock<std::mutex>(*lock_of_scale);
      const auto [begin, end] = region.runs(row);
      for(auto run = begin; run != end; ++run) {
        const std::size_t skipped = std::size_t(run->first - hull.first);
        sink.consume(index, scale, hull.offset + skipped, values.data() + skipped,
                     std::size_t(run->last - run->first));
      }
    }
  }
}

/// projects the surface onto a part of a region, or onto the whole if there is one part only.
template <class Projector, class ScaleSpace, class Cancelled>
double project_part(Projector& projector, const ScaleSpace& surface, const Region_part& part,
                    bool is_whole, const Scale& scale, Side side, Cancelled& cancelled)
{
  if(is_whole)
    return projector.project(surface, scale, side, cancelled);
  return projector.project(Scale_space_near_part<ScaleSpace>(surface, part, scale), scale, side,
                           cancelled);
}

inline void check_scales(const std::vector<Scale>& scales)
{
  for(std::size_t k = 0; k < scales.size(); ++k) {
    check_positive(scales[k].radius, "radius of scales[" + std::to_string(k) + "]");
    check_positive(scales[k].sigma, "sigma of scales[" + std::to_string(k) + "]");
  }
}

/// the indices of the scales, the largest radius first: what takes longest is begun first.
inline std::vector<std::size_t> order_of_work(const std::vector<Scale>& scales)
{
  std::vector<std::size_t> order(scales.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scales[a].radius > scales[b].radius;
  });
  return order;
}

/// \brief computes the scales over the parts of a region, by any number of workers.
///
/// A worker stays with a part, and takes the next scale that nobody has begun there.
template <class ScaleSpace, class MakeProjector, class Sink, class Visitor>
class Multiscale_work
{
public:
  Multiscale_work(const ScaleSpace& surface, const Row_spans& region, const Region_parts& parts,
                  const std::vector<Scale>& scales, Side side, MakeProjector& make_projector,
                  Sink& sink, const std::function<bool(double)>& callback, Visitor& visitor)
      : m_surface(surface)
      , m_region(region)
      , m_parts(parts)
      , m_scales(scales)
      , m_side(side)
      , m_make_projector(make_projector)
      , m_sink(sink)
      , m_progress(scales.size(), parts.size(), callback, visitor)
      , m_order(order_of_work(scales))
      , m_next(parts.size())
      , m_layers(std::size_t(region.grid().size()[2]))
      , m_locks_of_scales(parts.size() > 1 ? scales.size() : 0)
  {
    m_summary.areas_outside.assign(scales.size(), 0.);
  }

  template <class ConcurrencyTag>
  Multiscale_summary run()
  {
    run_workers<ConcurrencyTag>(m_scales.size() * m_parts.size(),
                                [this](std::size_t worker, std::size_t workers) {
                                  try {
                                    work(worker, workers);
                                  } catch(...) {
                                    m_progress.cancel(); // the other threads would go on in vain
                                    throw;
                                  }
                                });
    m_summary.is_complete = !m_progress.was_cancelled();
    return m_summary;
  }

private:
  void work(std::size_t worker, std::size_t workers)
  {
    for(std::size_t p = worker % m_parts.size(); p < m_parts.size(); p += workers) {
      const Region_part& part = m_parts[p];
      auto&& projector = make_projector_for(m_make_projector, *part.region);
      // Workers begin at different layers, so that they seldom wait for each other.
      const std::size_t start = worker * std::size_t(part.last_layer - part.first_layer) / workers;
      for(std::size_t i = m_next[p]++; i < m_order.size() && !m_progress.is_cancelled();
          i = m_next[p]++)
        compute(projector, part, m_order[i], start);
    }
  }

  template <class Projector>
  void compute(Projector& projector, const Region_part& part, std::size_t index, std::size_t start)
  {
    const auto cancelled = [this] { return m_progress.is_cancelled(); };
    const Scale& scale = m_scales[index];
    m_progress.part_begins(index, scale);
    const double area_outside =
        project_part(projector, m_surface, part, m_parts.size() == 1, scale, m_side, cancelled);
    if(part.is_first)
      m_summary.areas_outside[index] = area_outside;
    m_progress.step();
    deliver(projector, m_region, part, index, scale, start, m_layers,
            m_locks_of_scales.empty() ? nullptr : &m_locks_of_scales[index], m_sink, cancelled);
    if(!m_progress.was_cancelled())
      m_progress.part_ends(index, scale, m_summary.areas_outside[index]);
    m_progress.step();
  }

  const ScaleSpace& m_surface;
  const Row_spans& m_region;
  const Region_parts& m_parts;
  const std::vector<Scale>& m_scales;
  Side m_side;
  MakeProjector& m_make_projector;
  Sink& m_sink;
  Progress<Visitor> m_progress;
  std::vector<std::size_t> m_order;
  std::vector<std::atomic<std::size_t>> m_next; ///< in the order of work, of each part
  std::vector<std::mutex> m_layers, m_locks_of_scales;
  Multiscale_summary m_summary;
};

/// computes the scales over the parts of a region.
template <class ConcurrencyTag, class ScaleSpace, class MakeProjector, class Sink,
          class NamedParameters>
Multiscale_summary project_scales(const ScaleSpace& surface, const Row_spans& region,
                                  const Region_parts& parts, const std::vector<Scale>& scales,
                                  Side side, MakeProjector&& make_projector, Sink& sink,
                                  const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  check_scales(scales);
  auto given_visitor =
      choose_parameter(get_parameter(np, internal_np::visitor), Multiscale_default_visitor());
  // A reference wrapper becomes a reference to the visitor of the user.
  Multiscale_work work(
      surface, region, parts, scales, side, make_projector, sink,
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
      unwrap(given_visitor));
  return work.template run<ConcurrencyTag>();
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief computes the multiscale transform over a region, scale by scale, and hands its values to
/// a sink.
///
/// The sink receives `APT / (4πR²)`: 1 at the centre of a sphere of radius `R`, `σ/R` on the axis of a
/// cylinder (paper, section 4). The scales are computed in parallel, the largest first; each thread
/// holds one map, whatever the number of scales. With fewer scales than threads the region is cut into
/// parts, and each thread holds one. The values do not depend on the number of threads.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \tparam ScaleSpace a model of `SurfelScaleSpace` (of `TriangleScaleSpace` for exact projectors)
/// \tparam MakeProjector a function of a `const Row_spans&`, which will live as long as the projector, or
/// of nothing; it returns a model of `GridProjector`
/// \tparam Sink a model of `MultiscaleSink`
///
/// \param surface the surface
/// \param region the voxels
/// \param scales the scales, in any order
/// \param side the side on which the parallel surfaces are taken
/// \param make_projector makes a projector for the voxels that it is given, a part of `region`, or for
/// `region` if it is a function of nothing, in which case a scale is never shared by threads; called once
/// for each thread, and always by the thread that uses it
/// \param sink is called with no two calls at a time for the same scale or the same layer of voxels
/// \param np optional named parameters among:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is told the progress, in [0, 1], and answers whether to go on; is called
///                           often (for every batch of some
///                           thousand surfels and every layer of voxels) by any of the threads, but never twice
///                           at a time}
///     \cgalParamType{an instance of `std::function<bool(double)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told when a scale begins and ends}
///     \cgalParamType{a reference wrapper (`std::ref`) of a class derived from
///                    `Multiscale_default_visitor`}
///     \cgalParamDefault{`Multiscale_default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre the projectors were made for what they were asked for, and the sink for `region` and `scales`
/// \return whether all scales were computed, and the area that each lost
/// \throw std::invalid_argument if a radius or a `σ` is not positive. An exception of a thread stops
/// the others and is passed on.
template <class ConcurrencyTag = CGAL::Sequential_tag, class ScaleSpace, class MakeProjector,
          class Sink, class NamedParameters = CGAL::parameters::Default_named_parameters>
Multiscale_summary project_scales(const ScaleSpace& surface, const Row_spans& region,
                                  const std::vector<Scale>& scales, Side side,
                                  MakeProjector&& make_projector, Sink& sink,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  const std::size_t parts = internal::number_of_parts<ConcurrencyTag, MakeProjector>(scales.size());
  return internal::project_scales<ConcurrencyTag>(surface, region,
                                                  internal::Region_parts(region, parts), scales,
                                                  side, make_projector, sink, np);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MULTISCALE_H
