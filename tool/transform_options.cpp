// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "transform_options.h"

#include "errors.h"
#include "map_file.h"

#include <CGAL/Area_projection_transform/projection/Grid_projector.h>

#include <cmath>

namespace mapt {

namespace {

void add_files(CLI::App& app, Transform_options& options)
{
  app.add_option("MESH", options.mesh,
                 "a mesh (.off .obj .ply .stl .vtp), or points with normals (.xyz and these)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options.output, "the map to write: .vti or .nrrd")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--picture", options.picture,
                 "a picture to write (.png): the largest values along the three axes")
      ->type_name("FILE")
      ->group("Output");
  add_choice(app, "--kind", options.kind, {"jmapt", "apt", "mapt"},
             "jmapt: the largest value over the radii, and the radius that attains it; "
             "apt: an area for each radius; mapt: the area over that of a sphere of the radius")
      ->capture_default_str()
      ->group("Output");
  app.add_flag_callback(
         "--no-compress", [&options] { options.is_compressed = false; },
         "write larger files, faster")
      ->group("Output");
}

void add_grid(CLI::App& app, Transform_options& options)
{
  app.add_option("--voxel", options.voxel,
                 "the spacing of the grid (default: 1/128 of the longest side of the bounding box)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Grid");
  add_choice(app, "--region", options.region, {"interior", "band", "all"},
             "the voxels to compute: interior; band, those within the largest radius and its ball "
             "of the surface; or all (default: interior for the inside of a mesh, else all)")
      ->group("Grid");
  app.add_option("--margin", options.margin,
                 "room around the bounding box (default: the largest radius, 0 for the inside)")
      ->type_name("LENGTH")
      ->check(CLI::Validator(
          [](std::string& text) {
            double value = 0;
            const bool is_good =
                CLI::detail::lexical_cast(text, value) && value >= 0 && std::isfinite(value);
            return is_good ? std::string() : text + " is not a length";
          },
          std::string()))
      ->group("Grid");
}

void add_computation(CLI::App& app, Transform_options& options)
{
  add_choice(app, "--side", options.side, {"inside", "outside", "both"},
             "the side of the surface to project to: inside, outside, or both, with a map for each")
      ->capture_default_str()
      ->group("Mesh");
  add_surface_options(app, options.surface);
  add_reading_options(app, options.common);
  add_choice(app, "--method", options.method, {"grid", "exact", "paper"},
             "grid: samples of the surface; exact: whole triangles, slower; paper: rounded to "
             "voxels, for comparison")
      ->capture_default_str()
      ->group("Computation");
  add_choice(
      app, "--kernel", options.kernel, {"ball", "epanechnikov", "gaussian"},
      "how surface counts within the collecting ball: ball (fully), epanechnikov or gaussian "
      "(less towards the rim)")
      ->capture_default_str()
      ->group("Computation");
  app.add_flag("--compensate", options.is_compensated,
               "divide by the part of the surface that is there, as seen from inside, so that "
               "missing faces do not weaken the map")
      ->group("Computation");
  options.sampling_ratio = CGAL::Area_projection::Grid_projector::default_sampling_ratio;
  app.add_option(
         "--sampling-ratio", options.sampling_ratio,
         "the size of the pieces of surface that count as one, as a fraction of the radius of "
         "the collecting ball")
      ->type_name("FRACTION")
      ->capture_default_str()
      ->check(number_from(0.01, 1))
      ->group("Computation");
  add_bytes_option(app, "--max-memory", options.common.max_memory,
                   "refuse what needs more memory, such as 500M or 2G")
      ->group("Computation");
  add_thread_option(app, options.common);
}

void check(const CLI::App& app, const Transform_options& options)
{
  if(!options.output.empty())
    check_extension("--output", options.output, {".vti", ".nrrd"});
  if(!options.picture.empty())
    check_extension("--picture", options.picture, {".png"});
  check(options.surface);
  if(options.method == "exact" && options.surface.normals == "interpolated")
    throw Usage_error("--method exact needs flat faces: leave --normals interpolated out");
  if(options.method == "exact" && app.count("--sampling-ratio") > 0)
    throw Usage_error("--sampling-ratio has no effect on --method exact: leave it out");
}

} // namespace

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Transform_options& options)
{
  Command_line app(
      "mapt transform",
      "Computes how much of a surface, moved by a radius along its normals, lands within "
      "a small ball around each voxel: much at the centres of spheres and on the axes of "
      "tubes of that radius.\n"
      "Values of the joint map: 1/16 plane, 1/8 slab, 1/2 tube, 1 sphere.\n"
      "All lengths are in the units of the mesh.");
  add_files(app, options);
  add_scale_options(app, options.scales);
  add_grid(app, options);
  add_computation(app, options);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  check(app, options);
  return true;
}

} // namespace mapt
