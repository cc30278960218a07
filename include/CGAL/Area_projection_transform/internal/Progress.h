// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROGRESS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROGRESS_H

#include <CGAL/Area_projection_transform/scales.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief tells the callback and the visitor of progress, one call at a time.
///
/// A scale is computed in one or more parts; it begins with the first and ends with the last of them.
template <class Visitor>
class Progress
{
public:
  Progress(std::size_t scales, std::size_t parts, std::function<bool(double)> callback,
           Visitor& visitor)
      : m_steps(2 * scales * parts)
      , m_parts(parts)
      , m_begun(scales, 0)
      , m_ended(scales, 0)
      , m_callback(std::move(callback))
      , m_visitor(visitor)
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

  void part_begins(std::size_t index, const Scale& scale)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_begun[index]++ == 0)
      m_visitor.scale_begins(index, scale);
  }

  /// \param area_outside is read when the last part ends
  void part_ends(std::size_t index, const Scale& scale, const double& area_outside)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(++m_ended[index] == m_parts)
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
  std::size_t m_parts;
  std::vector<std::size_t> m_begun, m_ended; // parts of each scale
  std::function<bool(double)> m_callback;
  Visitor& m_visitor;
  std::mutex m_mutex;
  std::atomic<bool> m_is_cancelled{false};
};

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROGRESS_H
