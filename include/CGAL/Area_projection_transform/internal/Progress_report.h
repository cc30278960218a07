// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROGRESS_REPORT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROGRESS_REPORT_H

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief tells a callback how far the work of several threads is, one call at a time, and remembers whether it
/// asked to stop.
class Progress_report
{
public:
  /// \param callback may be empty
  explicit Progress_report(std::function<bool(double)> callback = {})
      : m_callback(std::move(callback))
  {}

  /// adds to the part of the work that is done, of 1 in all.
  void advance(double part)
  {
    if(!m_callback)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_done = std::min(m_done + part, 1.);
    if(!m_is_cancelled && !m_callback(m_done))
      m_is_cancelled = true;
  }

  bool is_cancelled() const { return m_is_cancelled; }

private:
  std::function<bool(double)> m_callback;
  std::mutex m_mutex;
  double m_done = 0;
  std::atomic<bool> m_is_cancelled{false};
};

/// the callback among named parameters.
template <class NamedParameters>
std::function<bool(double)> callback_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, internal_np::callback), std::function<bool(double)>());
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PROGRESS_REPORT_H
