// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_options.h"

#include "map_file.h"

#include <algorithm>

namespace mapt {

namespace {

void add_files(CLI::App& app, Report_options& options)
{
  app.add_option("MESH", options.mesh,
                 "a mesh (.off .obj .ply .stl .vtp), or points with normals (.xyz and these)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options.output,
                 "the page to write (.html): one file, which needs no network")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--most-faces", options.most_faces,
                 "a mesh of more faces is drawn coarser in the page; results do not change")
      ->type_name("NUMBER")
      ->check(CLI::Range(std::size_t(100), std::size_t(2000000)))
      ->capture_default_str()
      ->group("Output");
}

void add_computation(CLI::App& app, Report_options& options)
{
  app.add_option("--resolution", options.resolution,
                 "voxels along the longest side of the bounding box")
      ->type_name("NUMBER")
      ->check(CLI::Range(std::size_t(8), std::size_t(512)))
      ->capture_default_str()
      ->group("Grid");
  app.add_option("--leave-out", options.left_out,
                 "what to do without, with commas between: salient, lines, medial, descriptor")
      ->type_name("WORD,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(std::vector<std::string>{"salient", "lines", "medial", "descriptor"}))
      ->group("Computation");
  add_choice(app, "--side", options.side, {"inside", "outside"},
             "the side of the surface to look at: outside for bores and pits")
      ->capture_default_str()
      ->group("Mesh");
  add_reading_options(app, options.common);
  add_bytes_option(app, "--max-memory", options.common.max_memory,
                   "refuse maps that need more memory, such as 500M or 2G")
      ->group("Computation");
  add_thread_option(app, options.common);
}

} // namespace

bool Report_options::has(const std::string& part) const
{
  return std::find(left_out.begin(), left_out.end(), part) == left_out.end();
}

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Report_options& options)
{
  Command_line app(
      "mapt report",
      "Writes a page for the browser that shows a shape and all that this command finds in it: "
      "the maps, salient points, centrelines, medial balls, and the shape descriptor.\n"
      "The page is one file and asks nothing of the network.\n"
      "All lengths are in the units of the mesh.");
  add_files(app, options);
  add_scale_options(app, options.scales);
  add_computation(app, options);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  // Words may come more than once.
  std::sort(options.left_out.begin(), options.left_out.end());
  options.left_out.erase(std::unique(options.left_out.begin(), options.left_out.end()),
                         options.left_out.end());
  if(app.count("--output") > 0) // a name without letters is none, too
    check_extension("--output", options.output, {".html", ".htm"});
  return true;
}

} // namespace mapt
