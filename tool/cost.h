// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_COST_H
#define MAPT_COST_H

#include "console.h"

#include <chrono>

namespace mapt {

/// the seconds since it was made or asked.
class Stopwatch
{
public:
  double seconds()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - m_start;
    m_start = now;
    return passed.count();
  }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// how long the parts of a command took, in seconds.
struct Times
{
  double reading, computing, writing;
};

/// tells what a command has cost: time, and memory so far.
void report_cost(const Times& times, Console& console);

} // namespace mapt

#endif // MAPT_COST_H
