// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_RECENT_VALUES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_RECENT_VALUES_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <cstddef>
#include <exception>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the last few values that were asked for, each computed once, by the first that asks.
///
/// Whoever asks for a value that is being computed waits for it. May be used concurrently. If more values
/// are in use at a time than are kept, some are computed again.
template <class Value>
class Recent_values
{
public:
  using Pointer = std::shared_ptr<const Value>;

  /// \param number how many values are kept, at least 1; those in use live on
  explicit Recent_values(std::size_t number) : m_number(number) {}

  /// \brief returns the value for `key`, which is that of `compute()` if it is not known.
  ///
  /// An exception is passed on to all who wait, and forgotten.
  template <class Compute>
  Pointer get(double key, Compute&& compute)
  {
    std::promise<Pointer> promise;
    std::unique_lock<std::mutex> lock(m_mutex);
    const auto [found, is_new] = m_entries.try_emplace(key);
    found->second.last_use = ++m_uses;
    if(is_new)
      found->second.value = promise.get_future().share();
    const std::shared_future<Pointer> value = found->second.value;
    forget_the_oldest();
    lock.unlock();
    if(is_new)
      try {
        Pointer computed;
        // A loop within must not take up work that asks for this very value, and waits for it.
        run_isolated([&] { computed = std::make_shared<const Value>(compute()); });
        promise.set_value(std::move(computed));
      } catch(...) {
        promise.set_exception(std::current_exception());
        lock.lock();
        m_entries.erase(key);
      }
    return value.get();
  }

private:
  struct Entry
  {
    std::shared_future<Pointer> value;
    std::size_t last_use = 0;
  };

  void forget_the_oldest()
  {
    while(m_entries.size() > m_number) {
      auto oldest = m_entries.begin();
      for(auto entry = m_entries.begin(); entry != m_entries.end(); ++entry)
        if(entry->second.last_use < oldest->second.last_use)
          oldest = entry;
      m_entries.erase(oldest);
    }
  }

  std::size_t m_number, m_uses = 0;
  std::mutex m_mutex;
  std::map<double, Entry> m_entries;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_RECENT_VALUES_H
