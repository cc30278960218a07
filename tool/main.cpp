// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The command mapt: finds the subcommand, and turns what goes wrong into a message and an exit code.

#include "commands.h"
#include "errors.h"
#include "input.h"
#include "text.h"

#include <CGAL/Area_projection_transform/IO/Output_error.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>

namespace mapt {

namespace {

struct Command
{
  std::string name;
  std::string summary;
  bool (*run)(const std::vector<std::string>& arguments, Console& console);
};

const std::vector<Command>& commands()
{
  static const std::vector<Command> all{
      {"report", "a page for the browser with all that follows", run_report},
      {"transform", "maps of a mesh: the surface that projects to each voxel", run_transform},
      {"evaluate", "the same at given points and radii", run_evaluate},
      {"salient", "the centres of spheres and tubes, with radii", run_salient},
      {"lines", "the centrelines of tubes, with radii, joined to a graph", run_lines},
      {"describe", "a row of numbers for each mesh, by which shapes are compared", run_describe},
      {"retrieve", "how well such rows tell classes of shapes apart; nearest shapes", run_retrieve},
      {"medial", "balls along the medial axis, with what tells which of them matter", run_medial},
      {"info", "what is in a mesh or a map, and what is wrong with it", run_info}};
  return all;
}

void print_help()
{
  std::cout << "mapt: radial symmetry of surfaces by the area projection transform\n\n"
               "usage: mapt COMMAND ... [options]\n\n";
  for(const Command& command : commands())
    std::cout << "  " << command.name << std::string(12 - command.name.size(), ' ')
              << command.summary << '\n';
  std::cout << "\n  mapt COMMAND --help    what a command does, and its options\n"
               "  mapt --version         the version\n\n"
               "Meshes: .off .obj .ply .stl .vtp; points with normals: .xyz and these.\n"
               "Lengths are in the units of the mesh.\n"
               "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 input unusable,\n"
               "4 output not written, 130 interrupted.\n\n"
               "Try: mapt report hand.obj -o hand.html\n";
}

[[noreturn]] void fail_for_command(const std::string& word)
{
  std::vector<std::string> names;
  for(const Command& command : commands())
    names.push_back(command.name);
  const std::string nearest = nearest_word(word, names);
  throw Usage_error("'" + word + "' is not a command: " +
                    (nearest.empty() ? "see mapt --help" : "did you mean " + nearest + "?"));
}

int run(const std::vector<std::string>& arguments, Console& console)
{
  if(arguments.empty()) {
    throw Usage_error("a command is missing: see mapt --help");
  } else if(arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "help") {
    print_help();
  } else if(arguments[0] == "--version") {
    std::cout << "mapt " MAPT_VERSION "\n";
  } else {
    const auto command = std::find_if(commands().begin(), commands().end(),
                                      [&](const Command& c) { return c.name == arguments[0]; });
    if(command == commands().end())
      fail_for_command(arguments[0]);
    console.report["command"] = command->name;
    console.report["version"] = MAPT_VERSION;
    console.report["warnings"] = nlohmann::ordered_json::array();
    if(command->run({arguments.begin() + 1, arguments.end()}, console))
      return console.finish();
  }
  return console.flush(); // of a help or a version
}

// TBB throws a plain std::runtime_error then, which tells by its text only what it is about.
bool is_lack_of_threads(const std::exception& error)
{
  return std::string(error.what()).find("pthread_create") != std::string::npos;
}

int run_guarded(const std::vector<std::string>& arguments)
{
  Console console;
  // Wrong usage is told as JSON, too, though then the arguments are not understood.
  console.is_json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
  try {
    return run(arguments, console);
  } catch(const Usage_error& error) {
    return console.fail(WRONG_USAGE, error.what());
  } catch(const Input_error& error) {
    return console.fail(UNUSABLE_INPUT, error.what());
  } catch(const CGAL::Area_projection::IO::Output_error& error) {
    return console.fail(OUTPUT_NOT_WRITTEN, error.what());
  } catch(const Interruption& interruption) {
    return console.fail(INTERRUPTED, interruption.what());
  } catch(const std::bad_alloc&) {
    return console.fail(
        UNUSABLE_INPUT,
        "the memory is used up: a coarser grid or mesh takes less, and so do fewer --threads");
  } catch(const std::exception& error) {
    if(is_lack_of_threads(error))
      return console.fail(UNUSABLE_INPUT,
                          "no more threads can be started: lower --threads, or allow more memory");
    return console.fail(INTERNAL_ERROR, std::string("internal: ") + error.what());
  }
}

} // namespace

} // namespace mapt

int main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error like a full disk
  return mapt::run_guarded({argv + 1, argv + argc});
}
