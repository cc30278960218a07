// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_RETRIEVE_OPTIONS_H
#define MAPT_RETRIEVE_OPTIONS_H

#include "command_line.h"

#include <CGAL/Area_projection_transform/retrieval/Histogram_distance.h>

#include <optional>
#include <string>
#include <vector>

namespace mapt {

/// what the user asks of `mapt retrieve`. Words stand for themselves: they are checked when read.
struct Retrieve_options
{
  std::string table;
  std::string labels;           // empty: none
  std::string distances;        // to write; empty: not written
  std::string precision_recall; // to write; empty: not written
  std::vector<std::string> queries;
  std::string distance = "jeffrey";
  std::optional<std::size_t> bins;
  std::size_t number_of_neighbours = 10;
  std::size_t smallest_class;
  Common_options common;

  CGAL::Area_projection::Distance_kind distance_kind() const;
  /// whether the distance tells the radii of a row apart.
  bool has_blocks() const;
};

/// reads the arguments; returns whether there is anything left to do after them.
/// \throw Usage_error if they are wrong.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Retrieve_options& options);

} // namespace mapt

#endif // MAPT_RETRIEVE_OPTIONS_H
