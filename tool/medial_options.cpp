// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "medial_options.h"

#include "errors.h"
#include "map_file.h"
#include "write_mesh.h"
#include "text.h"

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

using AP::Medial_weight;

const struct
{
  const char* word;
  Medial_weight weight;
} weights[] = {{"importance", Medial_weight::IMPORTANCE},
               {"mapt", Medial_weight::MAPT},
               {"radial-mapt", Medial_weight::RADIAL_MAPT},
               {"lambda", Medial_weight::LAMBDA},
               {"angle", Medial_weight::ANGLE},
               {"scale-axis", Medial_weight::SCALE_AXIS},
               {"radius", Medial_weight::RADIUS}};

void add_files(CLI::App& app, Medial_options& options)
{
  app.add_option("MESH", options.mesh,
                 "a mesh (.off .obj .ply .stl .vtp), or points with normals (.xyz and these)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options.output,
                 "the balls to write (.ply): vertices with radius, mapt, lambda, angle, "
                 "scale_axis, kept and more, and the edges and faces between those that are kept")
      ->type_name("FILE")
      ->group("Output");
  app.add_flag("--kept-only", options.do_write_kept_only,
               "leave out of that file what is not selected")
      ->group("Output");
  app.add_option("--picture", options.picture,
                 "a picture to write (.png): the balls in the surface, along the three axes")
      ->type_name("FILE")
      ->group("Output");
  app.add_option(
         "--compare", options.compare,
         "what is measured of medial axes of this mesh, to write (.json): the one weighted by "
         "the transform, the lambda and the scale axis, balls by chance and those that "
         "cover the most, centrelines, and CGAL's skeleton")
      ->type_name("FILE")
      ->group("Output");
}

void add_reconstruction(CLI::App& app, Medial_options& options)
{
  app.add_option(
         "--reconstruct", options.reconstruct,
         "the boundary of the union of the selected balls, to write as a closed mesh (.off, "
         ".obj, .ply, .stl): the shape that they keep, and how far it is off")
      ->type_name("FILE")
      ->group("Output");
  app.add_option(
         "--cell", options.cell,
         "with --reconstruct: the width of the cells of the lattice, by which the mesh is "
         "off at most; from 0.0005 of the diagonal of the bounding box to all of it (default: "
         "0.005 of it)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Reconstruction");
  app.add_flag("--interpolate", options.is_interpolated,
               "with --reconstruct: put balls between those that are connected, too, with radii "
               "in between: cones along edges, slabs on faces")
      ->group("Reconstruction");
}

void add_selection(CLI::App& app, Medial_options& options)
{
  std::vector<std::string> words;
  for(const auto& known : weights)
    words.push_back(known.word);
  add_choice(app, "--weight", options.weight, words,
             "what matters: importance is how far the surface that agrees with a ball spreads, a "
             "length, and 0 where there is too little of it; mapt has no scale; lambda and radius "
             "are lengths, angle is in degrees")
      ->capture_default_str()
      ->group("Selection");
  app.add_option("--prune", options.prune,
                 "keep balls whose weight is at least that: for importance, lambda and radius a "
                 "length (default: keep all)")
      ->type_name("NUMBER")
      ->check(positive_number())
      ->group("Selection");
  app.add_option("--balls", options.balls, "keep no more than so many balls")
      ->type_name("NUMBER")
      ->check(CLI::Range(std::size_t(1), std::size_t(100000000)))
      ->group("Selection");
  add_choice(app, "--select", options.select, {"strongest", "covering", "connected", "random"},
             "which of them: those of the largest weight that are apart; those that cover the "
             "most of the surface (without --balls, as few as cover it); these and the few "
             "between them that join their pieces; or by chance")
      ->capture_default_str()
      ->group("Selection");
  app.add_option("--seed", options.seed, "of what is selected by chance")
      ->type_name("NUMBER")
      ->check(whole_number())
      ->capture_default_str()
      ->group("Selection");
  app.add_option("--tolerance", options.tolerance,
                 "the surface counts as covered up to this distance from a ball (default: 0.005 "
                 "of the diagonal of the bounding box)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Selection");
}

void add_comparison(CLI::App& app, Medial_options& options)
{
  app.add_option("--coverage", options.coverage,
                 "with --compare: the part of the surface that each selection of balls has to "
                 "cover, unless --balls gives their number (default: 0.9)")
      ->type_name("PART")
      ->check(number_from(0, 1))
      ->group("Comparison");
}

void add_computation(CLI::App& app, Medial_options& options)
{
  add_choice(app, "--method", options.method, {"touching", "polar"},
             "the ball of a sample: the largest that touches there by its normal, or the largest "
             "empty one through it and three others (the inner pole), which needs normals only to "
             "tell the side")
      ->capture_default_str()
      ->group("Computation");
  app.add_option("--spacing", options.computation.spacing,
                 "of the samples that have a ball each (default: one for each face, more for "
                 "large ones)")
      ->type_name("LENGTH")
      ->check(positive_number())
      ->group("Computation");
  app.add_option("--stop-angle", options.computation.stop_angle,
                 "samples that a ball sees within less than so many degrees do not stop it: 20 for "
                 "clean meshes, 45 for noisy ones")
      ->type_name("DEGREES")
      ->check(number_from(1, 170))
      ->capture_default_str()
      ->group("Computation");
  app.add_flag_callback(
         "--no-compensate", [&options] { options.computation.compensate = false; },
         "do not let the surface beside gaps stand for what is missing there")
      ->group("Computation");
  add_choice(app, "--side", options.side, {"inside", "outside"},
             "the side of the surface on which the balls lie")
      ->capture_default_str()
      ->group("Mesh");
  add_reading_options(app, options.common);
  add_bytes_option(app, "--max-memory", options.common.max_memory,
                   "refuse so many balls that they need more memory, such as 500M or 2G")
      ->group("Computation");
  add_thread_option(app, options.common);
}

// What contradicts itself, or would be without effect.
void check(const CLI::App& app, const Medial_options& options)
{
  if(!options.output.empty())
    check_extension("--output", options.output, {".ply"});
  if(!options.picture.empty())
    check_extension("--picture", options.picture, {".png"});
  if(!options.compare.empty())
    check_extension("--compare", options.compare, {".json"});
  if(!options.reconstruct.empty())
    check_extension("--reconstruct", options.reconstruct, mesh_extensions());
  if((options.cell || options.is_interpolated) && options.reconstruct.empty())
    throw Usage_error(std::string(options.cell ? "--cell" : "--interpolate") +
                      " is of the mesh of balls: name a file with --reconstruct");
  if(options.do_write_kept_only && options.output.empty())
    throw Usage_error("--kept-only has nothing to write: name a file with --output");
  if(app.count("--seed") > 0 && options.select != "random" && options.compare.empty())
    throw Usage_error("--seed has no effect: nothing is selected by chance");
  if(options.select == "random" && !options.balls)
    throw Usage_error("--select random needs a number: give --balls");
  if(app.count("--weight") > 0 && !options.prune &&
     !(options.balls && options.select == "strongest"))
    throw Usage_error("--weight selects nothing by itself: give --prune, or --balls for the "
                      "strongest");
  if(options.coverage && options.compare.empty())
    throw Usage_error("--coverage has nothing to select: it is of the axes that --compare writes");
  if(options.coverage && options.balls)
    throw Usage_error("--coverage and --balls both tell how many balls to compare: give one");
  const bool is_comparing_only = !options.compare.empty() && options.output.empty() &&
                                 options.picture.empty() && options.reconstruct.empty();
  if(is_comparing_only && (options.prune || options.select != "strongest"))
    throw Usage_error(
        "--compare selects by all weights, not by " +
        std::string(options.prune ? "--prune" : "--select") +
        ": name a file for what that keeps with --output, --picture or --reconstruct");
}

} // namespace

AP::Medial_weight Medial_options::used_weight() const
{
  for(const auto& known : weights)
    if(weight == known.word)
      return known.weight;
  return Medial_weight::IMPORTANCE;
}

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Medial_options& options)
{
  Command_line app("mapt medial",
                   "Finds the balls that touch a surface and have nothing of it inside: its medial "
                   "axis with radii, and what tells which of them matter.\n"
                   "The surface need not be closed; balls that escape through a hole have a low "
                   "mapt.\n"
                   "All lengths are in the units of the mesh.");
  add_files(app, options);
  add_selection(app, options);
  add_comparison(app, options);
  add_reconstruction(app, options);
  add_computation(app, options);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  check(app, options);
  options.computation.method =
      options.method == "polar" ? AP::Medial_ball_method::POLAR : AP::Medial_ball_method::TOUCHING;
  options.computation.side = options.side == "inside" ? AP::Side::INSIDE : AP::Side::OUTSIDE;
  return true;
}

} // namespace mapt
