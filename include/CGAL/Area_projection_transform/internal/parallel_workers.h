// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PARALLEL_WORKERS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PARALLEL_WORKERS_H

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Area_projection {
namespace internal {

template <class ConcurrencyTag>
inline constexpr bool is_parallel = std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>;

/// how many threads there are to work.
template <class ConcurrencyTag>
std::size_t number_of_workers()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>)
    return std::size_t(tbb::this_task_arena::max_concurrency());
#endif
  return 1;
}

/// \brief runs `work(w, workers)` for each worker `w` of as many as there are threads, but at most
/// `largest`.
template <class ConcurrencyTag, class Work>
void run_workers(std::size_t largest, Work&& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>) {
    const std::size_t workers = std::min(number_of_workers<ConcurrencyTag>(), largest);
    if(workers > 1) {
      tbb::parallel_for(
          std::size_t(0), workers, [&](std::size_t w) { work(w, workers); },
          tbb::simple_partitioner());
      return;
    }
  }
#else
  static_assert(!is_parallel<ConcurrencyTag>, "Parallel_tag needs TBB (CGAL_LINKED_WITH_TBB)");
#endif
  if(largest > 0)
    work(std::size_t(0), std::size_t(1));
}

/// runs `work(i)` for the indices 0, …, `number - 1`, in any order.
template <class ConcurrencyTag, class Work>
void for_each_index(std::size_t number, Work&& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>) {
    tbb::parallel_for(std::size_t(0), number, work);
    return;
  }
#else
  static_assert(!is_parallel<ConcurrencyTag>, "Parallel_tag needs TBB (CGAL_LINKED_WITH_TBB)");
#endif
  for(std::size_t i = 0; i < number; ++i)
    work(i);
}

/// \brief runs `work()`, which must not be interrupted by other work that this thread has in hand: one who
/// waits in parallel loops of their own takes up what is there to do.
template <class Work>
void run_isolated(Work&& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::this_task_arena::isolate(work);
#else
  work();
#endif
}

/// runs two pieces of work that have nothing to do with each other.
template <class ConcurrencyTag, class First, class Second>
void run_both(First&& first, Second&& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>) {
    tbb::parallel_invoke(first, second);
    return;
  }
#else
  static_assert(!is_parallel<ConcurrencyTag>, "Parallel_tag needs TBB (CGAL_LINKED_WITH_TBB)");
#endif
  first();
  second();
}

} // namespace internal

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_PARALLEL_WORKERS_H
