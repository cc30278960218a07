// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The experiments of the paper: what remains of the maps of damaged surfaces, its salient points and lines, which round
// objects are found in scenes whose truth is known, and retrieval by shape descriptors.
// scripts/paper-figures runs them and draws the curves.

#include "figures.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace {

struct Figure
{
  const char* name;
  void (*function)(const Paper::Options&, Benchmarks::Report&);
};

constexpr Figure figures[] = {{"1", Paper::figure_1},
                              {"4", Paper::figure_4},
                              {"5", Paper::figure_5},
                              {"7", Paper::figure_7},
                              {"8", Paper::figure_8},
                              {"9", Paper::figure_9},
                              {"10", Paper::figure_10},
                              {"11", Paper::figure_11},
                              {"12", Paper::figure_12},
                              {"13", Paper::figure_13},
                              {"15", Paper::figure_15},
                              {"table1", Paper::table_1},
                              {"poses", Paper::pose_stability},
                              {"curves", Paper::robustness_curves},
                              {"ratios", Paper::smoothing_ratios},
                              {"salient", Paper::salient_comparison},
                              {"lines", Paper::centerline_comparison},
                              {"medial", Paper::medial_comparison}};

struct Arguments
{
  Paper::Options options;
  std::vector<std::string> figures;
  std::string json;
};

void declare(CLI::App& app, Arguments& arguments)
{
  std::vector<std::string> names;
  for(const Figure& figure : figures)
    names.push_back(figure.name);
  Paper::Options& options = arguments.options;
  app.add_option("--figure", arguments.figures, "the figures to make, instead of all")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names));
  app.add_option("--seed", options.seed, "of everything random")->capture_default_str();
  app.add_option("--voxels", options.voxels, "along the longest side of a mesh")
      ->capture_default_str()
      ->check(CLI::Range(8, 1024));
  app.add_option("--scenes", options.scenes, "of round objects, for each damage")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  app.add_option("--json", arguments.json, "the file to write the numbers to");
  app.add_option("--pictures", options.pictures, "the folder to write pictures of maps to");
  app.add_option("--retrieval", options.retrieval,
                 "the folder of a labelled set of meshes (labels.csv or .cla, meshes/), for "
                 "retrieval and pairs of poses")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--quick", options.is_quick, "few amounts of damage, coarse: to see that all runs");
  app.add_option("meshes", options.meshes, "meshes instead of the bundled ones")
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

bool run(Arguments& arguments)
{
  Benchmarks::Report report(arguments.options.is_quick ? "quick" : "full", "paper");
  report.print_header(std::cout);
  for(const Figure& figure : figures)
    if(arguments.figures.empty() ||
       std::count(arguments.figures.begin(), arguments.figures.end(), figure.name))
      figure.function(arguments.options, report);
  return arguments.json.empty() || write(report.json(), arguments.json);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app(
      "Measures what remains of the maps of damaged surfaces, finds salient points and lines, and "
      "retrieves shapes.");
  Arguments arguments;
  declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    return run(arguments) ? 0 : 1;
  } catch(const std::exception& e) {
    std::cerr << e.what() << "\n";
    return 1;
  }
}
