// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peak_growth.h"

#include <array>
#include <exception>
#include <stdexcept>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Paper {

namespace {

double peak_resident_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss);
}

[[noreturn]] void work_in_child(const std::function<void()>& work, int end)
{
  const double before = peak_resident_bytes();
  try {
    work();
  } catch(const std::exception&) {
    _exit(1);
  }
  const double growth = peak_resident_bytes() - before;
  _exit(write(end, &growth, sizeof growth) == sizeof growth ? 0 : 1);
}

} // namespace

double peak_growth(const std::function<void()>& work)
{
  malloc_trim(0); // what was freed but not returned would hide what the child takes
  std::array<int, 2> ends;
  if(pipe(ends.data()) != 0)
    throw std::runtime_error("no pipe to a child process can be made");
  const pid_t child = fork();
  if(child == 0)
    work_in_child(work, ends[1]);
  close(ends[1]);
  double growth = 0;
  const bool is_read = child > 0 && read(ends[0], &growth, sizeof growth) == sizeof growth;
  close(ends[0]);
  if(child > 0)
    waitpid(child, nullptr, 0);
  if(!is_read)
    throw std::runtime_error("the work of a child process failed");
  return growth;
}

} // namespace Paper
