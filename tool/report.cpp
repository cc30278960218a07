// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// mapt report: everything about a shape in one page.

#include "commands.h"
#include "cost.h"
#include "describe_input.h"
#include "map_file.h"
#include "progress.h"
#include "report_summary.h"
#include "threads.h"

namespace mapt {

bool run_report(const std::vector<std::string>& arguments, Console& console)
{
  Report_options options;
  if(!read_options(arguments, console, options))
    return false;
  if(!options.output.empty())
    check_output("--output", options.output, {options.mesh});

  Stopwatch watch;
  const Thread_limit limit(number_of_threads(options.common.threads));
  const Input input = read_described(options.mesh, options.common.reading, console);
  const double reading = watch.seconds();

  const Signal_watch signals;
  const Report_results results = compute_report(input, options, console);
  const double computing = watch.seconds();
  report_parameters(results, options, console);
  Signal_watch::check();
  console.report["outputs"] = nlohmann::ordered_json::array();
  if(!options.output.empty())
    report_page(write_page(input, results, options, console.report), input, options, console);
  else
    console.row("written", "nothing: name a page with -o");
  report_cost({reading, computing, watch.seconds()}, console);
  report_results(results, options, console);
  return true;
}

} // namespace mapt
