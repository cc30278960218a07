// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lines_options.h"

#include "errors.h"
#include "map_file.h"
#include "text.h"

#include <algorithm>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

void add_files(CLI::App& app, Lines_options& options)
{
  app.add_option("MESH", options.mesh,
                 "a mesh (.off .obj .ply .stl .vtp), or points with normals (.xyz and these)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options.outputs,
                 "the lines to write: .vtp (ParaView, VMTK), .swc (neurons), .obj (polylines) or "
                 ".json (the graph); may be given several times")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group("Output");
  app.add_option("--segments", options.segments,
                 "a copy of the mesh (.ply) of which the faces have the colour and the number of "
                 "the branch that they surround")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--picture", options.picture,
                 "a picture to write (.png): the lines and their tubes in the surface, along the "
                 "three axes")
      ->type_name("FILE")
      ->group("Output");
}

void add_selection(CLI::App& app, AP::Centerline_options& lines)
{
  app.add_option("--radius-min", lines.smallest_radius,
                 "the smallest radius of a tube (default: 0.003 of twice the largest distance from "
                 "the centroid, or less if all is one thinner tube)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Selection");
  app.add_option("--radius-max", lines.largest_radius,
                 "the largest radius of a tube (default: 0.25 of twice that distance)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Selection");
  app.add_option("--least-length", lines.least_length,
                 "branches with a free end that are shorter than so many of their radii are twigs "
                 "and left out")
      ->type_name("NUMBER")
      ->check(positive_number())
      ->capture_default_str()
      ->group("Selection");
}

void add_computation(CLI::App& app, Lines_options& options)
{
  app.add_flag_callback(
         "--no-join", [&options] { options.lines.do_join = false; },
         "leave each tube a line of its own, rather than to join them where they meet")
      ->group("Computation");
  app.add_flag_callback(
         "--no-extend", [&options] { options.lines.do_extend = false; },
         "end lines where the last piece of tube fits, rather than at the surface")
      ->group("Computation");
  app.add_option("--spacing", options.lines.vertex_spacing,
                 "the distance of the points of a line, in units of its radius")
      ->type_name("NUMBER")
      ->check(positive_number())
      ->capture_default_str()
      ->group("Computation");
  add_choice(app, "--side", options.side, {"inside", "outside"},
             "the side of the surface on which lines are sought: outside for bores")
      ->capture_default_str()
      ->group("Mesh");
  add_reading_options(app, options.common);
  add_thread_option(app, options.common);
}

void check(const Lines_options& options)
{
  for(const std::string& output : options.outputs)
    check_extension("--output", output, {".vtp", ".swc", ".obj", ".json"});
  if(!options.segments.empty())
    check_extension("--segments", options.segments, {".ply"});
  if(!options.picture.empty())
    check_extension("--picture", options.picture, {".png"});
  const AP::Centerline_options& lines = options.lines;
  if(lines.smallest_radius && lines.largest_radius &&
     *lines.smallest_radius > *lines.largest_radius)
    throw Usage_error("--radius-min is " + to_text(*lines.smallest_radius, 9) +
                      ": larger than --radius-max, " + to_text(*lines.largest_radius, 9));
}

} // namespace

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Lines_options& options)
{
  Command_line app(
      "mapt lines",
      "Finds the centrelines of tubes, limbs and vessels, with the radius along them, and joins "
      "them to a graph where the tubes meet.\n"
      "A line keeps to its tube where tubes touch or are fused, and passes holes.\n"
      "All lengths are in the units of the mesh.");
  add_files(app, options);
  add_selection(app, options.lines);
  add_computation(app, options);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  check(options);
  options.lines.side = options.side == "inside" ? AP::Side::INSIDE : AP::Side::OUTSIDE;
  return true;
}

} // namespace mapt
