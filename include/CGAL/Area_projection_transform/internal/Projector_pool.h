// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROJECTOR_POOL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROJECTOR_POOL_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/Region_parts.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief keeps the projectors of a region, or of its parts, from one run over some scales to the next.
template <class Projector>
class Projector_pool
{
  struct Kept
  {
    const Row_spans* part;
    std::unique_ptr<Projector> projector;
  };

public:
  /// a projector of the pool, which goes back to it. \cgalModels `GridProjector`
  class Lease
  {
  public:
    Lease(Projector_pool& pool, Kept kept) : m_pool(pool), m_kept(std::move(kept)) {}
    ~Lease() { m_pool.give_back(std::move(m_kept)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    template <class ScaleSpace, class Cancelled>
    double project(const ScaleSpace& surface, const Scale& scale, Side side, Cancelled&& cancelled)
    {
      return m_kept.projector->project(surface, scale, side, cancelled);
    }
    void take_row(std::size_t row, float* out) { m_kept.projector->take_row(row, out); }

  private:
    Projector_pool& m_pool;
    Kept m_kept;
  };

  /// \brief drops what is of no use to a run over so many parts of a region: the projectors of others, and
  /// those of a run that was not finished, whose rows have not all been taken.
  void begin_run(const std::shared_ptr<const Row_spans>& region, std::size_t number_of_parts)
  {
    if(m_is_running || m_region != region || m_wanted_parts != number_of_parts) {
      clear();
      m_region = region;
      m_wanted_parts = number_of_parts;
      m_parts = std::make_unique<Region_parts>(*region, number_of_parts);
    }
    m_is_running = true;
  }

  /// tells that all rows of all scales have been taken.
  void finish_run() { m_is_running = false; }

  const Region_parts& parts() const { return *m_parts; }

  /// a projector for a part, which `make_projector(part)` makes if there is none. May be called
  /// concurrently.
  template <class MakeProjector>
  Lease lease(const Row_spans& part, MakeProjector& make_projector)
  {
    Kept kept = take(part);
    if(!kept.projector)
      kept.projector.reset(new Projector(make_projector(part)));
    return Lease(*this, std::move(kept));
  }

  void clear()
  {
    m_kept.clear();
    m_parts.reset();
    m_region.reset();
    m_is_running = false;
  }

private:
  Kept take(const Row_spans& part)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    for(std::size_t i = 0; i < m_kept.size(); ++i)
      if(m_kept[i].part == &part) {
        std::swap(m_kept[i], m_kept.back());
        Kept kept = std::move(m_kept.back());
        m_kept.pop_back();
        return kept;
      }
    return {&part, nullptr};
  }

  void give_back(Kept kept)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_kept.push_back(std::move(kept));
  }

  std::shared_ptr<const Row_spans> m_region;
  std::size_t m_wanted_parts = 0;
  std::unique_ptr<Region_parts> m_parts;
  std::vector<Kept> m_kept;
  std::mutex m_mutex;
  bool m_is_running = false;
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROJECTOR_POOL_H
