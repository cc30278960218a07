// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_BENCHMARK_MACHINE_H
#define AREA_PROJECTION_BENCHMARK_MACHINE_H

#include <nlohmann/json.hpp>

#include <string>

namespace Benchmarks {

/// today, as YYYY-MM-DD.
std::string date();

/// processor, number of its cores that we may use, memory, system, and how busy it is.
nlohmann::ordered_json machine();

/// compiler, kind of build, versions of what we build on, instruction sets.
nlohmann::ordered_json software();

} // namespace Benchmarks

#endif // AREA_PROJECTION_BENCHMARK_MACHINE_H
