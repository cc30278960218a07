// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "benchmark_machine.h"

#include <CGAL/Area_projection_transform/internal/simd/instruction_set.h>
#include <CGAL/version.h>

#include <Eigen/src/Core/util/Macros.h>
#include <boost/version.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/version.h>
#endif

#include <sched.h>
#include <stdlib.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cmath>
#include <ctime>
#include <fstream>

namespace Benchmarks {

namespace {

using Json = nlohmann::ordered_json;

/// what the system says of its processor.
std::string processor()
{
  std::ifstream file("/proc/cpuinfo");
  for(std::string line; std::getline(file, line);)
    if(line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown";
}

int usable_cores()
{
  cpu_set_t set;
  return sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 1;
}

std::string compiler()
{
#ifdef __clang__
  return __VERSION__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

std::string boost_version()
{
  return std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000) +
         "." + std::to_string(BOOST_VERSION % 100);
}

std::string eigen_version()
{
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

std::string tbb_version()
{
#ifdef CGAL_LINKED_WITH_TBB
  return std::to_string(TBB_VERSION_MAJOR) + "." + std::to_string(TBB_VERSION_MINOR);
#else
  return "none";
#endif
}

} // namespace

std::string date()
{
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::localtime(&now));
  return text;
}

Json machine()
{
  utsname system;
  uname(&system);
  const double gigabytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE)) / 1e9;
  double load = 0;
  if(getloadavg(&load, 1) != 1)
    load = 0;
  return {{"processor", processor()},
          {"cores", usable_cores()},
          {"memory_gigabytes", std::round(10 * gigabytes) / 10},
          {"system", std::string(system.sysname) + " " + system.release + " " + system.machine},
          {"load_at_start", load}};
}

Json software()
{
  namespace internal = CGAL::Area_projection::internal;
  Json sets = Json::array();
  for(internal::Instruction_set set : internal::available_instruction_sets())
    sets.push_back(internal::name(set));
  return {{"package", AREA_PROJECTION_TRANSFORM_VERSION},
          {"compiler", compiler()},
          {"build", AREA_PROJECTION_TRANSFORM_BUILD},
          {"CGAL", CGAL_VERSION_STR},
          {"Eigen", eigen_version()},
          {"Boost", boost_version()},
          {"TBB", tbb_version()},
          {"instruction_set", internal::name(internal::instruction_set())},
          {"available_instruction_sets", sets}};
}

} // namespace Benchmarks
