// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MULTISCALE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MULTISCALE_H

#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/parameters.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <atomic>
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
  void scale_begins(std::size_t /* index */, const Scale&) {}
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

/// Tells the callback and the visitor of progress, one call at a time.
template <class Visitor>
class Progress
{
public:
  Progress(std::size_t steps, std::function<bool(double)> callback, Visitor& visitor)
      : m_steps(steps), m_callback(std::move(callback)), m_visitor(visitor)
  {}

  /// asks the callback, unless another thread is just asking, so that long scales can be stopped.
  bool is_cancelled()
  {
    if(m_callback && !m_is_cancelled) {
      const std::unique_lock<std::mutex> lock(m_mutex, std::try_to_lock);
      if(lock)
        ask();
    }
    return m_is_cancelled;
  }

  void scale_begins(std::size_t index, const Scale& scale)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.scale_begins(index, scale);
  }

  void scale_ends(std::size_t index, const Scale& scale, double area_outside)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.scale_ends(index, scale, area_outside);
  }

  void step()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_done;
    ask();
  }

  void cancel() { m_is_cancelled = true; }

  bool was_cancelled() const { return m_is_cancelled; }

private:
  void ask()
  {
    // Once all is done the answer does not matter.
    if(m_callback && !m_is_cancelled && !m_callback(double(m_done) / double(m_steps)))
      m_is_cancelled = m_done < m_steps;
  }

  std::size_t m_steps;
  std::size_t m_done = 0;
  std::function<bool(double)> m_callback;
  Visitor& m_visitor;
  std::mutex m_mutex;
  std::atomic<bool> m_is_cancelled{false};
};

/// \brief hands the rows of one scale to the sink, layer by layer, beginning with layer `first`.
///
/// A layer is locked while its rows are handed over, so that sinks need no locks of their own.
template <class Projector, class Sink, class Cancelled>
void deliver(Projector& projector, const Row_spans& region, std::size_t index, const Scale& scale,
             std::size_t first, std::vector<std::mutex>& layers, Sink& sink, Cancelled&& cancelled)
{
  const std::size_t rows_of_layer = std::size_t(region.grid().size()[1]);
  const float normalization = float(scale.normalization());
  std::vector<float> values(std::size_t(region.grid().size()[0]));
  for(std::size_t l = 0; l < layers.size() && !cancelled(); ++l) {
    const std::size_t layer = (first + l) % layers.size();
    const std::lock_guard<std::mutex> lock(layers[layer]);
    for(std::size_t row = layer * rows_of_layer; row < (layer + 1) * rows_of_layer; ++row) {
      const Row_spans::Hull& hull = region.hull(row);
      if(hull.first == hull.last)
        continue;
      projector.take_row(row, values.data());
      for(std::int32_t i = 0; i < hull.last - hull.first; ++i)
        values[std::size_t(i)] *= normalization;
      const auto [begin, end] = region.runs(row);
      for(auto run = begin; run != end; ++run) {
        const std::size_t skipped = std::size_t(run->first - hull.first);
        sink.consume(index, scale, hull.offset + skipped, values.data() + skipped,
                     std::size_t(run->last - run->first));
      }
    }
  }
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMultiscale
/// \brief computes the multiscale transform over a region, scale by scale, and hands its values to
/// a sink.
///
/// The sink receives `APT / (4πR²)`: 1 at the centre of a sphere of radius `R`, `σ/R` on the axis of a
/// cylinder (paper, section 4). The scales are computed in parallel, the largest first; each thread
/// holds one map, whatever the number of scales. The values do not depend on the number of threads.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`
/// \tparam ScaleSpace a model of `SurfelScaleSpace` (of `TriangleScaleSpace` for exact projectors)
/// \tparam MakeProjector a nullary function that returns a model of `GridProjector`
/// \tparam Sink a model of `MultiscaleSink`
///
/// \param surface the surface
/// \param region the voxels
/// \param scales the scales, in any order
/// \param side the side on which the parallel surfaces are taken
/// \param make_projector makes a projector for `region`; called once for each thread, and always by
/// the thread that uses it
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
/// \pre the projectors and the sink were made for `region`, and the sink for `scales`
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
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  auto given_visitor =
      choose_parameter(get_parameter(np, internal_np::visitor), Multiscale_default_visitor());
  // A reference wrapper becomes a reference to the visitor of the user.
  auto& visitor = internal::unwrap(given_visitor);
  internal::Progress<std::remove_reference_t<decltype(visitor)>> progress(
      2 * scales.size(),
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
      visitor);

  std::vector<std::size_t> order(scales.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scales[a].radius > scales[b].radius;
  });

  Multiscale_summary summary;
  for(std::size_t k = 0; k < scales.size(); ++k) {
    internal::check_positive(scales[k].radius, "radius of scales[" + std::to_string(k) + "]");
    internal::check_positive(scales[k].sigma, "sigma of scales[" + std::to_string(k) + "]");
  }
  summary.areas_outside.assign(scales.size(), 0.);
  std::vector<std::mutex> layers(std::size_t(region.grid().size()[2]));
  std::atomic<std::size_t> next{0};
  const auto cancelled = [&progress] { return progress.is_cancelled(); };
  internal::run_workers<ConcurrencyTag>(scales.size(), [&](std::size_t worker,
                                                           std::size_t workers) {
    try {
      auto projector = make_projector();
      const std::size_t first_layer = worker * layers.size() / workers;
      for(std::size_t i = next++; i < order.size() && !cancelled(); i = next++) {
        const std::size_t index = order[i];
        progress.scale_begins(index, scales[index]);
        summary.areas_outside[index] = projector.project(surface, scales[index], side, cancelled);
        progress.step();
        internal::deliver(projector, region, index, scales[index], first_layer, layers, sink,
                          cancelled);
        if(!progress.was_cancelled())
          progress.scale_ends(index, scales[index], summary.areas_outside[index]);
        progress.step();
      }
    } catch(...) {
      progress.cancel(); // so that the other threads do not go on in vain
      throw;
    }
  });
  summary.is_complete = !progress.was_cancelled();
  return summary;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MULTISCALE_H
