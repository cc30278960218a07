// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "threads.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

namespace mapt {

#ifdef CGAL_LINKED_WITH_TBB

struct Thread_limit::Control
{
  tbb::global_control control;
};

std::size_t number_of_threads(std::size_t wanted)
{
  return wanted > 0 ? wanted : std::size_t(tbb::info::default_concurrency());
}

Thread_limit::Thread_limit(std::size_t threads)
    : m_control(new Control{{tbb::global_control::max_allowed_parallelism, threads}})
{}

#else

struct Thread_limit::Control
{};

std::size_t number_of_threads(std::size_t)
{
  return 1;
}

Thread_limit::Thread_limit(std::size_t) {}

#endif

Thread_limit::~Thread_limit() = default;

} // namespace mapt
