// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_options.h"

#include "errors.h"
#include "map_file.h"
#include "text.h"

#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>
#include <CGAL/Area_projection_transform/salient_points.h>
#include <CGAL/Area_projection_transform/salient_points/paper_salient_points.h>

#include <cmath>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

// What the shapes have at their own radius, whole and at the ratio of 1/2: a threshold that they reach.
const struct
{
  const char* word;
  double value;
} thresholds[] = {{"sphere", 1}, {"hemisphere", 0.5}, {"tube", 0.5}, {"slab", 0.125}};

double threshold_of(const std::string& text)
{
  for(const auto& known : thresholds)
    if(text == known.word)
      return known.value;
  double value = 0;
  if(!CLI::detail::lexical_cast(text, value) || !(value > 0) || !std::isfinite(value))
    throw CLI::ValidationError("--threshold",
                               text + " is neither a positive number nor one of sphere, "
                                      "hemisphere, tube, slab");
  return value;
}

void add_files(CLI::App& app, Salient_options& options)
{
  app.add_option("MESH", options.mesh,
                 "a mesh (.off .obj .ply .stl .vtp), or points with normals (.xyz and these)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options.output,
                 "the table to write (.csv), a row for each point, the strongest first (default: "
                 "standard output)")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--voters", options.voters,
                 "a copy of the mesh (.ply) of which the faces have the colour and the row (from "
                 "0) of the point that they support")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--picture", options.picture,
                 "a picture to write (.png): the points before the surface, along the three axes")
      ->type_name("FILE")
      ->group("Output");
}

void add_selection(CLI::App& app, Salient_options& options)
{
  app.add_option_function<std::string>(
         "--threshold",
         [&options](const std::string& text) { options.threshold = threshold_of(text); },
         "the least intensity of a point: a number, or sphere (1), hemisphere or tube (1/2) or "
         "slab (1/8), which is what such shapes have at least if nothing of them is missing "
         "(default: " +
             to_text(AP::Salient_point_options().threshold) +
             "; paper and joint: " + to_text(AP::Paper_salient_options().threshold) + ")")
      ->type_name("NUMBER|WORD")
      ->group("Selection");
  app.add_option("--radius-min", options.smallest_radius,
                 "the smallest radius (default: as small as the faces allow); in the modes paper "
                 "and joint also the step between radii and the size of a voxel")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Selection");
  app.add_option("--radius-max", options.largest_radius,
                 "the largest radius (default: about half the shortest side of the bounding box)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Selection");
  app.add_option("--type", options.types,
                 "write only these, with commas between them: sphere, tube, cone, other")
      ->type_name("WORD,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(std::vector<std::string>{"sphere", "tube", "cone", "other"}))
      ->group("Selection");
  app.add_option("--tube-spacing", options.tube_spacing,
                 "points along a tube for every so many of its radii (default: one for a tube)")
      ->type_name("NUMBER")
      ->check(positive_number())
      ->group("Selection");
}

void add_computation(CLI::App& app, Salient_options& options)
{
  add_choice(app, "--mode", options.mode, {"fitted", "paper", "joint"},
             "fitted: spheres, tubes and cones fitted to the surface; paper: local maxima of the "
             "maps over space and radii, as published, with raw radii that are too small; joint: "
             "local maxima of the joint map")
      ->capture_default_str()
      ->group("Computation");
  add_choice(app, "--side", options.side, {"inside", "outside", "both"},
             "the side of the surface on which centres are sought: outside for bores and pits")
      ->capture_default_str()
      ->group("Mesh");
  add_reading_options(app, options.common);
  add_thread_option(app, options.common);
}

void check(const Salient_options& options, const Console& console)
{
  if(!options.voters.empty())
    check_extension("--voters", options.voters, {".ply"});
  if(!options.picture.empty())
    check_extension("--picture", options.picture, {".png"});
  if(console.is_json && options.output == "-")
    throw Usage_error("--json and --output - both want standard output: leave one out (the object "
                      "holds the points in any case)");
  if(options.smallest_radius && options.largest_radius &&
     *options.smallest_radius > *options.largest_radius)
    throw Usage_error("--radius-min is " + to_text(*options.smallest_radius, 9) +
                      ": larger than --radius-max, " + to_text(*options.largest_radius, 9));
  if(options.is_fitted())
    return;
  const auto needs_fit = [&](const char* option, bool is_given) {
    if(is_given)
      throw Usage_error(std::string(option) + " needs shapes that are fitted: leave --mode " +
                        options.mode + " out");
  };
  needs_fit("--voters", !options.voters.empty());
  needs_fit("--type", !options.types.empty());
  needs_fit("--tube-spacing", options.tube_spacing.has_value());
}

} // namespace

double Salient_options::used_threshold() const
{
  return threshold.value_or(is_fitted() ? AP::Salient_point_options().threshold
                                        : AP::Paper_salient_options().threshold);
}

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Salient_options& options)
{
  Command_line app(
      "mapt salient",
      "Finds the centres of what is like a sphere or a tube, with the radius that fits to the "
      "surface and an interval for it.\n"
      "A row has the centre, the radius, how strong and how round the map is there (intensity, "
      "sphericity), which part of the shape is there (observed_fraction), and its type.\n"
      "All lengths are in the units of the mesh.");
  add_files(app, options);
  add_selection(app, options);
  add_computation(app, options);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  check(options, console);
  return true;
}

} // namespace mapt
