// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_COMMANDS_H
#define MAPT_COMMANDS_H

#include "console.h"

#include <string>
#include <vector>

namespace mapt {

// The commands: each reads its arguments, does its work, writes its files and reports to the
// console. They throw Usage_error, Input_error, CGAL::Area_projection::IO::Output_error and
// Interruption; they return whether there was work, which --help is not.

bool run_report(const std::vector<std::string>& arguments, Console& console);
bool run_transform(const std::vector<std::string>& arguments, Console& console);
bool run_evaluate(const std::vector<std::string>& arguments, Console& console);
bool run_salient(const std::vector<std::string>& arguments, Console& console);
bool run_lines(const std::vector<std::string>& arguments, Console& console);
bool run_describe(const std::vector<std::string>& arguments, Console& console);
bool run_retrieve(const std::vector<std::string>& arguments, Console& console);
bool run_medial(const std::vector<std::string>& arguments, Console& console);
bool run_info(const std::vector<std::string>& arguments, Console& console);

} // namespace mapt

#endif // MAPT_COMMANDS_H
