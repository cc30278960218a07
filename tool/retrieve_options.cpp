// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "retrieve_options.h"

#include "errors.h"
#include "map_file.h"

#include <CGAL/Area_projection_transform/retrieval/evaluation.h>

#include <map>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

const std::map<std::string, AP::Distance_kind> kinds{
    {"jeffrey", AP::Distance_kind::JEFFREY},
    {"jensen-shannon", AP::Distance_kind::JENSEN_SHANNON},
    {"chi-squared", AP::Distance_kind::CHI_SQUARED},
    {"l1", AP::Distance_kind::L1},
    {"earth-mover", AP::Distance_kind::EARTH_MOVER}};

void add_files(CLI::App& app, Retrieve_options& options)
{
  app.add_option(
         "TABLE", options.table,
         "a table of mapt describe (.csv), or any with a first column that is named file, and "
         "columns of numbers that are not negative")
      ->required()
      ->type_name("");
  app.add_option(
         "--labels", options.labels,
         "the classes of the shapes: a table (.csv) with a shape and its class in each row, "
         "or a classification of the Princeton shape benchmark (.cla)")
      ->type_name("FILE")
      ->group("Input");
  app.add_option("--distances", options.distances,
                 "the distances of all shapes from all, to write: .csv, or .f32, floats of 32 bits "
                 "and nothing else")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--precision-recall", options.precision_recall,
                 "the curves of precision over recall, of all queries and of each class, to write "
                 "(.csv)")
      ->type_name("FILE")
      ->group("Output");
}

void add_questions(CLI::App& app, Retrieve_options& options)
{
  app.add_option("--query", options.queries,
                 "list the shapes nearest to this one, which is in the table; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->group("Retrieval");
  app.add_option("-k,--neighbours", options.number_of_neighbours, "how many of them")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str()
      ->group("Retrieval");
  add_choice(app, "--distance", options.distance,
             {"jeffrey", "jensen-shannon", "chi-squared", "l1", "earth-mover"},
             "how rows are compared: jeffrey is that of the paper; jensen-shannon and earth-mover "
             "are summed over the radii")
      ->capture_default_str()
      ->group("Retrieval");
  app.add_option("--bins", options.bins,
                 "jensen-shannon and earth-mover: how many numbers of a row belong together, which "
                 "is its block_size (default: 12)")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1 << 24))
      ->group("Retrieval");
  options.smallest_class = AP::default_smallest_class;
  app.add_option("--smallest-class", options.smallest_class,
                 "shapes of smaller classes are found by others, but ask nothing")
      ->type_name("NUMBER")
      ->check(CLI::Range(2, 1000000000))
      ->capture_default_str()
      ->group("Retrieval");
}

void check(const CLI::App& app, const Retrieve_options& options)
{
  if(options.queries.empty() && app.count("--neighbours") > 0)
    throw Usage_error("--neighbours has no effect without --query: leave it out");
  if(options.labels.empty() && app.count("--smallest-class") > 0)
    throw Usage_error("--smallest-class has no effect without --labels: leave it out");
  if(options.labels.empty() && !options.precision_recall.empty())
    throw Usage_error("--precision-recall needs classes: give --labels");
  if(options.labels.empty() && options.queries.empty() && options.distances.empty())
    throw Usage_error("there is nothing to do: give --labels, --query or --distances");
  if(options.bins && !options.has_blocks())
    throw Usage_error("--bins has no effect on --distance " + options.distance + ": leave it out");
  if(!options.distances.empty())
    check_extension("--distances", options.distances, {".csv", ".f32"});
}

} // namespace

AP::Distance_kind Retrieve_options::distance_kind() const
{
  return kinds.at(distance);
}

bool Retrieve_options::has_blocks() const
{
  return distance_kind() == AP::Distance_kind::JENSEN_SHANNON ||
         distance_kind() == AP::Distance_kind::EARTH_MOVER;
}

bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Retrieve_options& options)
{
  Command_line app(
      "mapt retrieve",
      "Tells how well the rows of a table tell classes of shapes apart, if each shape looks for "
      "those of its class: the nearest neighbour (NN), first and second tier (FT, ST), E-measure "
      "(E, and the most that it can be) and discounted cumulative gain (DCG), in the mean over the "
      "queries, over the classes, and for each class; and which shapes are nearest to one.");
  add_files(app, options);
  add_questions(app, options);
  add_bytes_option(app, "--max-memory", options.common.max_memory,
                   "refuse distances that need more memory, such as 500M or 2G")
      ->group("Computation");
  add_thread_option(app, options.common);
  add_console_options(app, console);
  if(!parse(app, arguments))
    return false;
  check(app, options);
  return true;
}

} // namespace mapt
