// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables, labels, matrices, maps and configurations: a line that says which, then the bytes of the file.

#include "fuzz.h"
#include "fuzz_file.h"

#include "command_line.h"
#include "errors.h"

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/IO/NRRD.h>
#include <CGAL/Area_projection_transform/IO/VTI.h>
#include <CGAL/Area_projection_transform/IO/class_labels.h>
#include <CGAL/Area_projection_transform/IO/float_matrix.h>
#include <CGAL/Area_projection_transform/IO/shape_descriptors_CSV.h>
#include <CGAL/Area_projection_transform/retrieval/evaluation.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace IO = CGAL::Area_projection::IO;
using fuzz::require;

/// whatever fields were read, they are read again from what is written.
void try_rows(const std::string& text)
{
  std::istringstream in(text);
  IO::CSV_reader reader(in, "rows");
  std::vector<std::string> fields, again;
  while(reader.read(fields)) {
    std::ostringstream out;
    IO::CSV_writer writer(out);
    for(const std::string& field : fields)
      writer.field(field);
    writer.end_row();
    if(fields == std::vector<std::string>{""})
      continue; // an empty line is no row
    std::istringstream written(out.str());
    IO::CSV_reader second(written, "written");
    require(second.read(again) && again == fields && !second.read(again),
            "a row is read as it was written: " + out.str());
  }
}

void try_queries(const std::string& text)
{
  std::istringstream in(text);
  for(const IO::Query& query : IO::read_queries(in, "queries")) {
    require(std::isfinite(query.point.x() + query.point.y() + query.point.z()) ||
                std::abs(query.point.x()) > 1e300 || std::abs(query.point.y()) > 1e300 ||
                std::abs(query.point.z()) > 1e300,
            "coordinates are finite");
    require(query.radius > 0 && !(query.sigma <= 0), "radius and sigma are positive");
  }
}

void try_labels(const std::string& text)
{
  const IO::Label_list list = IO::read_class_labels(fuzz::file_of(text));
  std::vector<std::string> names;
  for(const auto& entry : list.classes)
    names.push_back(entry.first);
  require(IO::labels_of(names, list).size() == names.size(), "each shape has its class");
}

void try_descriptors(const std::string& text)
{
  std::istringstream in(text);
  const IO::Named_descriptors read = IO::read_shape_descriptors_CSV(in, "descriptors", 2);
  require(read.names.size() == read.table.size(), "each row has a name");
}

/// such as `mapt transform` has, of each kind.
void try_configuration(const std::string& text)
{
  mapt::Console console;
  mapt::Common_options common;
  std::vector<double> radii;
  std::string side;
  mapt::Command_line app("mapt fuzz", "reads a configuration");
  mapt::add_list_option(app, "-R,--radii", radii, "some lengths");
  mapt::add_choice(app, "--side", side, {"inside", "outside"}, "a word");
  mapt::add_bytes_option(app, "--max-memory", common.max_memory, "some bytes");
  mapt::add_thread_option(app, common);
  mapt::add_reading_options(app, common);
  mapt::add_console_options(app, console);
  mapt::parse(app, {"--config", fuzz::file_of(text)});
  for(const double radius : radii)
    require(radius > 0 && std::isfinite(radius), "radii are positive");
  require(side.empty() || side == "inside" || side == "outside",
          "a word is one of those it may be");
  require(common.threads <= 4096, "the number of threads is bounded");
}

void read(std::string_view kind, const std::string& text)
{
  if(kind == "rows")
    try_rows(text);
  else if(kind == "queries")
    try_queries(text);
  else if(kind == "labels")
    try_labels(text);
  else if(kind == "descriptors")
    try_descriptors(text);
  else if(kind == "matrix")
    IO::read_float_matrix(fuzz::file_of(text));
  else if(kind == "vti")
    IO::read_VTI(fuzz::file_of(text));
  else if(kind == "nrrd")
    IO::read_NRRD(fuzz::file_of(text));
  else if(kind == "config")
    try_configuration(text);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string_view kind = fuzz::first_line(text);
  try {
    read(kind, std::string(text));
  } catch(const std::runtime_error& error) { // also Usage_error
    require(*error.what() != 0, "an error has a text");
  } catch(const std::invalid_argument& error) {
    require(*error.what() != 0, "an error has a text");
  }
  return 0;
}
