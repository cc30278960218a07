// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include <sys/resource.h>

namespace mapt {

double peak_memory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return double(usage.ru_maxrss);
#else
  return 1024. * double(usage.ru_maxrss);
#endif
}

} // namespace mapt
