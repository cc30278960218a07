// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include <fstream>
#include <limits>
#include <string>

#include <sys/resource.h>

namespace mapt {

namespace {

// What Linux knows of this program alone: getrusage() begins with what the one that started it had. 0 if there is none.
double peak_of_status()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;) {
    double kilobytes = 0;
    if(word == "VmHWM:" && status >> kilobytes)
      return 1024 * kilobytes;
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return 0;
}

} // namespace

double peak_memory()
{
  if(const double peak = peak_of_status(); peak > 0)
    return peak;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return double(usage.ru_maxrss);
#else
  return 1024. * double(usage.ru_maxrss);
#endif
}

} // namespace mapt
