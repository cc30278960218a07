// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt evaluate: the transform at given points and radii.

#include "commands.h"
#include "command_line.h"
#include "describe_input.h"
#include "errors.h"
#include "map_file.h"
#include "memory.h"
#include "progress.h"
#include "surface.h"
#include "text.h"
#include "threads.h"

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/at_points.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Kd_tree_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace mapt {

namespace {

struct Evaluate_options
{
  std::string mesh;
  std::string queries;
  std::string output; // empty or "-": stdout
  std::string method; // empty: depends on the input
  std::string side = "inside";
  double sigma_ratio = 0.5;
  double sampling_ratio = AP::default_sampling_ratio;
  Surface_options surface;
  Common_options common;

  bool is_to_stdout() const { return output.empty() || output == "-"; }
};

void add_options(CLI::App& app, Evaluate_options& options)
{
  app.add_option("MESH", options.mesh,
                 "a mesh (.off .obj .ply .stl .vtp), or points with normals (.xyz and these)")
      ->required()
      ->type_name("");
  app.add_option("--at", options.queries,
                 "a table (.csv) with the columns x,y,z,radius and, if wanted, sigma")
      ->required()
      ->type_name("FILE");
  app.add_option("-o,--output", options.output,
                 "the table to write: x,y,z,radius,sigma,apt,mapt (default: standard output)")
      ->type_name("FILE");
  app.add_option("-c,--sigma-ratio", options.sigma_ratio,
                 "radius of the collecting ball, as a fraction of the radius, where the table has "
                 "no sigma")
      ->type_name("FRACTION")
      ->capture_default_str()
      ->check(number_between_0_and_1());
  add_choice(app, "--side", options.side, {"inside", "outside"},
             "the side of the surface to project to: inside or outside")
      ->capture_default_str();
  add_choice(app, "--method", options.method, {"exact", "samples", "kd-tree"},
             "exact: whole triangles; samples: samples of the surface; kd-tree: the same, by "
             "CGAL's search, slower (default: exact for meshes, samples for points)");
  app.add_option("--sampling-ratio", options.sampling_ratio,
                 "samples and kd-tree: the spacing of the samples, as a fraction of sigma")
      ->type_name("FRACTION")
      ->capture_default_str()
      ->check(positive_number());
  add_bytes_option(app, "--max-memory", options.common.max_memory,
                   "refuse what needs more memory, such as 500M or 2G")
      ->group("Computation");
  add_surface_options(app, options.surface);
  add_reading_options(app, options.common);
  add_thread_option(app, options.common);
}

std::vector<AP::Query> read_queries(const Evaluate_options& options)
{
  std::vector<AP::Query> queries;
  try {
    for(const AP::IO::Query& row : AP::IO::read_queries(options.queries))
      queries.push_back(
          {row.point,
           {row.radius, std::isnan(row.sigma) ? options.sigma_ratio * row.radius : row.sigma}});
  } catch(const std::runtime_error& error) {
    throw Input_error(error.what());
  }
  return queries;
}

// The queries of one radius share the samples, which suit the smallest ball among them.
std::map<double, double> smallest_sigmas(const std::vector<AP::Query>& queries)
{
  std::map<double, double> smallest;
  for(const AP::Query& query : queries) {
    const auto found = smallest.emplace(query.scale.radius, query.scale.sigma).first;
    found->second = std::min(found->second, query.scale.sigma);
  }
  return smallest;
}

// Points are samples as they are.
void check_memory(const Input& input, const std::map<double, double>& sigmas, double area,
                  const Evaluate_options& options)
{
  constexpr double bytes_of_surfel = 150; // measured, while either tree is built
  for(const auto& [radius, sigma] : sigmas) {
    const double spacing = options.sampling_ratio * sigma;
    const double samples =
        input.is_point_set ? double(input.points.size()) : area / (spacing * spacing);
    const double bytes = bytes_of_surfel * samples;
    if(bytes > options.common.max_memory)
      throw Input_error(options.mesh + ": samples for a sigma of " + to_text(sigma) + " need " +
                        bytes_to_text(bytes) + "; " +
                        (input.is_point_set ? "give fewer points or raise"
                                            : "use --method exact, or raise --sampling-ratio or") +
                        " --max-memory (" + bytes_to_text(options.common.max_memory) + ")");
  }
}

std::vector<double> evaluate(const Input& input, const Surface& surface,
                             const std::vector<AP::Query>& queries, const Evaluate_options& options)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const AP::Side side = options.side == "inside" ? AP::Side::INSIDE : AP::Side::OUTSIDE;
  if(options.method == "exact")
    return AP::evaluate_at_points<Tag>(queries, [&](const AP::Scale& scale) {
      return AP::Exact_evaluator(surface, scale.radius, side);
    });
  const std::map<double, double> sigmas = smallest_sigmas(queries);
  check_memory(input, sigmas, surface.total_area(), options);
  const auto spacing = [&](const AP::Scale& scale) {
    return options.sampling_ratio * sigmas.at(scale.radius);
  };
  if(options.method == "kd-tree")
    return AP::evaluate_at_points<Tag>(queries, [&](const AP::Scale& scale) {
      return AP::Kd_tree_evaluator(surface, scale.radius, side, spacing(scale));
    });
  return AP::evaluate_at_points<Tag>(queries, [&](const AP::Scale& scale) {
    return AP::Sampled_evaluator(surface, scale.radius, side, spacing(scale), Tag());
  });
}

void write_table(std::ostream& stream, const std::vector<AP::Query>& queries,
                 const std::vector<double>& areas)
{
  AP::IO::CSV_writer table(stream);
  table.row("x", "y", "z", "radius", "sigma", "apt", "mapt");
  for(std::size_t q = 0; q < queries.size(); ++q) {
    const AP::Point_3& p = queries[q].point;
    const AP::Scale& scale = queries[q].scale;
    table.row(p.x(), p.y(), p.z(), scale.radius, scale.sigma, areas[q],
              areas[q] * scale.normalization());
  }
}

void write_results(const std::vector<AP::Query>& queries, const std::vector<double>& areas,
                   const Evaluate_options& options, Console& console)
{
  auto& json = console.report["outputs"] = nlohmann::ordered_json::array();
  if(!options.is_to_stdout()) {
    AP::IO::internal::Atomic_file file(options.output);
    write_table(file.stream(), queries, areas);
    Signal_watch::check(); // one that came meanwhile leaves nothing behind
    file.commit();
    json.push_back(options.output);
  } else if(!console.is_json)
    write_table(std::cout, queries, areas);
  else {
    auto& rows = console.report["results"] = nlohmann::ordered_json::array();
    for(std::size_t q = 0; q < queries.size(); ++q) {
      const AP::Point_3& p = queries[q].point;
      const AP::Scale& scale = queries[q].scale;
      rows.push_back({{"x", p.x()},
                      {"y", p.y()},
                      {"z", p.z()},
                      {"radius", scale.radius},
                      {"sigma", scale.sigma},
                      {"apt", areas[q]},
                      {"mapt", areas[q] * scale.normalization()}});
    }
  }
}

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Evaluate_options& options)
{
  Command_line app(
      "mapt evaluate",
      "Computes, for each point and radius of a table, the area of the surface that, "
      "moved by the radius along its normals, lands within sigma of the point (apt), and "
      "the same over the area of a sphere of that radius (mapt).\n"
      "All lengths are in the units of the mesh.");
  add_options(app, options);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  check(options.surface);
  if(options.method == "exact" && options.surface.normals == "interpolated")
    throw Usage_error("--method exact needs flat faces: leave --normals interpolated out");
  if(options.method == "exact" && app.count("--sampling-ratio") > 0)
    throw Usage_error("--sampling-ratio has no effect on --method exact: leave it out");
  if(console.is_json && options.output == "-")
    throw Usage_error("--json and --output - both want standard output: leave one out (without "
                      "--output the object holds the results)");
  return true;
}

void report_parameters(const Evaluate_options& options, const std::vector<AP::Query>& queries,
                       Console& console)
{
  console.report["parameters"] = {{"method", options.method},
                                  {"normals", options.surface.normals},
                                  {"side", options.side},
                                  {"sigma_ratio", options.sigma_ratio},
                                  {"sampling_ratio", options.sampling_ratio},
                                  {"threads", number_of_threads(options.common.threads)}};
  if(const auto ratio = options.surface.used_smoothing_ratio())
    console.report["parameters"]["smoothing_ratio"] = *ratio;
  console.report["queries"] = {{"file", options.queries}, {"points", queries.size()}};
  console.row("points", options.queries + ": " + counted(queries.size(), "row", "rows"));
  console.row("method",
              options.method + ", " + options.side + ", " + options.surface.normals + " normals");
  if(queries.empty())
    console.warn(options.queries + ": nothing to evaluate: the table has no rows");
}

} // namespace

bool run_evaluate(const std::vector<std::string>& arguments, Console& console)
{
  Evaluate_options options;
  if(!read_options(arguments, console, options))
    return false;
  if(options.is_to_stdout())
    console.give_stdout_away();
  else
    check_output("--output", options.output, {options.mesh, options.queries});

  const std::vector<AP::Query> queries = read_queries(options);
  const Thread_limit limit(number_of_threads(options.common.threads));
  const Input input = read_described(options.mesh, options.common.reading, console);
  if(input.is_point_set && options.method == "exact")
    throw Usage_error("--method exact: " + options.mesh +
                      " has points only, and exact areas need faces; use samples");
  const bool has_flat_triangles = !input.is_point_set && options.surface.normals != "interpolated";
  if(options.method.empty())
    options.method = has_flat_triangles ? "exact" : "samples";
  report_parameters(options, queries, console);

  const auto surface = make_surface(input, options.surface, 1);
  const std::vector<double> areas = evaluate(input, *surface, queries, options);
  const Signal_watch signals;
  write_results(queries, areas, options, console);
  console.report["peak_memory_bytes"] = peak_memory();
  if(!options.is_to_stdout())
    console.row("written", options.output);
  return true;
}

} // namespace mapt
