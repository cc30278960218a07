// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_THREADS_H
#define MAPT_THREADS_H

#include <cstddef>
#include <memory>

namespace mapt {

/// the number of threads that `wanted` comes to: 0 means all, and without TBB there is one.
std::size_t number_of_threads(std::size_t wanted);

/// keeps to a number of threads as long as it lives.
class Thread_limit
{
public:
  explicit Thread_limit(std::size_t threads);
  ~Thread_limit();

private:
  struct Control;
  std::unique_ptr<Control> m_control;
};

} // namespace mapt

#endif // MAPT_THREADS_H
