// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the benchmarks, prints a table for each comparison and writes all to a file for
// scripts/plot-benchmarks. One executable: a ratio means something only within one run.

#include "benchmark_suite.h"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iomanip>
#include <iostream>

namespace {

using Benchmarks::Effort;

const char* name(Effort effort)
{
  return effort == Effort::SMOKE ? "smoke" : effort == Effort::QUICK ? "quick" : "full";
}

struct Arguments
{
  Benchmarks::Options options;
  std::string json;
  bool is_quick = false, is_smoke = false, is_list = false;
};

void declare(CLI::App& app, Arguments& arguments)
{
  Benchmarks::Options& options = arguments.options;
  options.meshes = {AREA_PROJECTION_TRANSFORM_DATA "/hand.obj"};
  app.add_flag("--quick", arguments.is_quick, "smaller inputs, fewer repetitions: about a minute");
  app.add_flag("--smoke", arguments.is_smoke, "tiny inputs, once each: times mean nothing");
  app.add_option("--filter", options.filter, "run the groups whose names this expression matches");
  app.add_flag("--list", arguments.is_list, "print the names of the groups and end");
  app.add_option("--repetitions", options.repetitions, "of each row, however long it takes")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", arguments.json, "the file to write");
  app.add_option("meshes", options.meshes, "meshes of triangles, instead of the bundled hand")
      ->check(CLI::ExistingFile);
}

bool write(const nlohmann::ordered_json& json, const std::string& name)
{
  std::ofstream file(name);
  file << std::setw(1) << json << std::endl;
  if(!file)
    std::cerr << name << ": cannot be written\n";
  return bool(file);
}

int run(Arguments& arguments)
{
  arguments.options.effort = arguments.is_smoke   ? Effort::SMOKE
                             : arguments.is_quick ? Effort::QUICK
                                                  : Effort::FULL;
  Benchmarks::Report report(name(arguments.options.effort));
  report.print_header(std::cout);
  bool is_well = Benchmarks::run_groups(arguments.options, report);
  if(!arguments.json.empty())
    is_well = write(report.json(), arguments.json) && is_well;
  return is_well ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Measures the library against what would be used otherwise.");
  Arguments arguments;
  declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  if(arguments.is_list) {
    for(const std::string& group : Benchmarks::names_of_groups())
      std::cout << group << "\n";
    return 0;
  }
  try {
    return run(arguments);
  } catch(const std::exception& e) {
    std::cerr << e.what() << "\n";
    return 1;
  }
}
