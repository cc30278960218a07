// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the command line of mapt medial says.

#ifndef MAPT_MEDIAL_OPTIONS_H
#define MAPT_MEDIAL_OPTIONS_H

#include "command_line.h"

#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mapt {

struct Medial_options
{
  std::string mesh;
  std::string output;           // empty: not written
  std::string picture;          // empty: none
  std::string compare;          // empty: no comparison
  std::string reconstruct;      // empty: no mesh of the balls
  std::optional<double> cell;   // of that; default: 0.005 of the diagonal
  bool is_interpolated = false; // whether there are balls between those that are connected, too
  bool do_write_kept_only = false;

  std::string weight = "importance";
  std::optional<double> prune;
  std::optional<std::size_t> balls;
  std::string select = "strongest";
  std::uint64_t seed = 0;
  std::optional<double> tolerance; // default: 0.005 of the diagonal
  std::optional<double> coverage;  // that the axes which are compared keep

  std::string method = "touching";
  std::string side = "inside";
  CGAL::Area_projection::Medial_ball_options computation;
  Common_options common;

  CGAL::Area_projection::Medial_weight used_weight() const;
  bool is_selecting() const { return prune || balls || select != "strongest"; }
};

// Reads the arguments; returns whether there is anything left to do after them.
// \throw Usage_error if they are wrong or contradict each other.
bool read_options(const std::vector<std::string>& arguments, Console& console,
                  Medial_options& options);

} // namespace mapt

#endif // MAPT_MEDIAL_OPTIONS_H
