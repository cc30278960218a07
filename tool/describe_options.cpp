// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_options.h"

#include "errors.h"
#include "text.h"

#include <filesystem>
#include <map>
#include <stdexcept>

namespace mapt {

namespace {

const std::map<std::string, AP::Binning> binnings{
    {"paper", AP::Binning::HARD}, {"soft", AP::Binning::SOFT}, {"pairs", AP::Binning::PAIRS}};

const std::map<std::string, AP::Descriptor_normals> normals{
    {"face", AP::Descriptor_normals::FACE},
    {"interpolated", AP::Descriptor_normals::INTERPOLATED},
    {"averaged", AP::Descriptor_normals::AVERAGED},
    {"smoothed", AP::Descriptor_normals::SMOOTHED}};

void add_files(CLI::App& app, Describe_options& options)
{
  app.add_option(
         "MESH", options.meshes,
         "meshes (.off .obj .ply .stl .vtp), and folders, of which all meshes are taken, in "
         "the order of their names")
      ->type_name("");
  app.add_option("--list", options.list,
                 "a text file with a mesh or a folder in each line, after those named here; - is "
                 "standard input")
      ->type_name("FILE")
      ->group("Input");
  app.add_option("-o,--output", options.output,
                 "the table to write (.csv): a row for each mesh, with its file and its numbers; "
                 "default: standard output")
      ->type_name("FILE")
      ->group("Output");
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const char* type,
                        const std::string& description)
{
  return app.add_option(name, value, description)
      ->type_name(type)
      ->check(positive_number())
      ->capture_default_str()
      ->group("Descriptor");
}

void add_histograms(CLI::App& app, Describe_options& options)
{
  AP::Shape_descriptor_options& d = options.descriptor;
  add_choice(app, "--kind", options.kind, {"paper", "soft", "pairs"},
             "what histograms count: paper, a value for its bin; soft, for the two bins nearest to "
             "it; pairs, a value at a radius and at another, in a table")
      ->capture_default_str()
      ->group("Descriptor");
  app.add_option_function<std::size_t>(
         "--bins", [&d](std::size_t bins) { d.bins = d.bins_of_pair = bins; },
         "bins at each radius, and for each value of a pair (default: " + std::to_string(d.bins) +
             "; pairs: " + std::to_string(d.bins_of_pair) + ")")
      ->type_name("NUMBER")
      ->check(CLI::Range(2, 4096))
      ->group("Descriptor");
  add_number(app, "--largest-value", d.largest_value, "NUMBER",
             "the value at which the last bin ends; larger ones count for it, too");
  add_number(app, "--scale-divisor", d.scale_divisor, "NUMBER",
             "the unit of radii and voxels is the cube root of the volume, divided by this");
  add_number(app, "--radius-min", d.smallest_radius, "UNITS", "the smallest radius");
  add_number(app, "--radius-max", d.largest_radius, "UNITS", "the largest radius");
  add_number(app, "--radius-step", d.radius_step, "UNITS", "the step between radii");
  add_number(app, "--voxel", d.voxel_size, "UNITS",
             "the spacing of the grid; at least a 200th of --scale-divisor");
  app.add_option("-c,--sigma-ratio", d.sigma_ratio,
                 "the radius of the collecting ball, as a fraction of the radius")
      ->type_name("FRACTION")
      ->check(number_between_0_and_1())
      ->capture_default_str()
      ->group("Descriptor");
  app.add_flag_callback(
         "--no-compensate", [&d] { d.compensate = false; },
         "do not divide by the part of the surface that is there")
      ->group("Descriptor");
  app.add_flag("--subdivide", options.subdivide,
               "for scans, with holes or noise: smooth meshes of large faces by one step of Loop's "
               "scheme, and interpolate between the normals of their vertices")
      ->group("Descriptor");
}

void choose_normals(Describe_options& options)
{
  if(options.subdivide && options.surface.normals != "face")
    throw Usage_error("--subdivide interpolates normals: leave --normals " +
                      options.surface.normals + " out");
  options.descriptor.normals =
      options.subdivide ? AP::Descriptor_normals::SUBDIVIDED : normals.at(options.surface.normals);
  options.descriptor.smoothing_ratio = options.surface.used_smoothing_ratio();
}

// Eight million voxels inside take some seconds for each mesh.
void check_voxels(const AP::Shape_descriptor_options& descriptor)
{
  constexpr double most = 200;
  const double voxels = descriptor.scale_divisor / descriptor.voxel_size;
  if(!(voxels <= most))
    throw Usage_error("--voxel " + to_text(descriptor.voxel_size) + " with --scale-divisor " +
                      to_text(descriptor.scale_divisor) + " makes the cube root of the volume " +
                      to_text(voxels) + " voxels: raise --voxel to " +
                      to_text(descriptor.scale_divisor / most) + " at least");
}

// The library names its own parameters, which are the options by other words.
void check(const AP::Shape_descriptor_options& descriptor)
{
  try {
    AP::internal::check(descriptor);
  } catch(const std::invalid_argument& error) {
    throw Usage_error(std::string(error.what()) +
                      "; see --radius-min, --radius-max, --radius-step and --kind");
  }
}

} // namespace

bool Describe_options::has_journal() const
{
  std::error_code ignored; // of a file that does not exist
  return !is_to_stdout() && (!std::filesystem::exists(output, ignored) ||
                             std::filesystem::is_regular_file(output, ignored));
}

std::size_t Describe_options::dimension() const
{
  const std::size_t radii = AP::internal::relative_radii(descriptor).size();
  return block_size() * (kind == "pairs" ? radii / 2 : radii);
}

std::size_t Describe_options::block_size() const
{
  return kind == "pairs" ? descriptor.bins_of_pair * descriptor.bins_of_pair : descriptor.bins;
}

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Describe_options& options)
{
  Command_line app(
      "mapt describe",
      "Writes a row of numbers for each mesh, which hardly change when the shape moves, bends or "
      "grows: the histograms of its maps at some radii. mapt retrieve compares them.\n"
      "The radii follow from the volume: their unit is its cube root, divided by 30.\n"
      "What is finished is kept beside the output in FILE.partial until all is done: if the "
      "command is stopped, or killed, the same command goes on from there.\n"
      "Meshes that cannot be described are listed and left out; the exit code is then 3.");
  add_files(app, options);
  add_histograms(app, options);
  add_surface_options(app, options.surface);
  add_orientation_options(app, options.common.reading);
  add_thread_option(app, options.common);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  if(options.meshes.empty() && options.list.empty())
    throw Usage_error("MESH is required, or --list: see mapt describe --help");
  if(console.is_json && options.output == "-")
    throw Usage_error("--json and --output - both want standard output: leave one out (the object "
                      "holds the numbers if there is no output)");
  check(options.surface);
  options.descriptor.binning = binnings.at(options.kind);
  choose_normals(options);
  check(options.descriptor);
  check_voxels(options.descriptor);
  return true;
}

nlohmann::ordered_json choices_of(const Describe_options& options)
{
  const AP::Shape_descriptor_options& d = options.descriptor;
  return {
      {"kind", options.kind},
      {"bins", options.kind == "pairs" ? d.bins_of_pair : d.bins},
      {"largest_value", d.largest_value},
      {"scale_divisor", d.scale_divisor},
      {"radius_min", d.smallest_radius},
      {"radius_max", d.largest_radius},
      {"radius_step", d.radius_step},
      {"voxel", d.voxel_size},
      {"sigma_ratio", d.sigma_ratio},
      {"compensate", d.compensate},
      {"normals", options.surface.normals},
      {"subdivide", options.subdivide},
      {"smoothing_ratio", d.smoothing_ratio ? nlohmann::ordered_json(*d.smoothing_ratio) : nullptr},
      {"orient", options.common.reading.orient},
      {"flip", options.common.reading.flip}};
}

} // namespace mapt
