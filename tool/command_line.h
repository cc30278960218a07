// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_COMMAND_LINE_H
#define MAPT_COMMAND_LINE_H

#include "console.h"
#include "input.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace mapt {

/// what all commands understand.
struct Common_options
{
  std::size_t threads = 0; // 0: all
  double max_memory = 2e9; // in bytes
  Reading_options reading;
};

/// a command line with a help that fits into 80 columns.
class Command_line : public CLI::App
{
public:
  Command_line(const std::string& name, const std::string& description);
};

/// checks of values, for CLI::Option::check().
CLI::Validator positive_number();
CLI::Validator number_between_0_and_1();
/// both included; those of CLI11 let NaN pass.
CLI::Validator number_from(double least, double most);

/// of 64 bits, without a sign.
CLI::Validator whole_number();

/// adds an option for one of some words.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& word,
                        const std::vector<std::string>& words, const std::string& description);
/// adds an option for a number of bytes, such as "500M".
CLI::Option* add_bytes_option(CLI::App& app, const std::string& name, double& bytes,
                              const std::string& description);
/// adds an option for a list of positive numbers with commas between them.
CLI::Option* add_list_option(CLI::App& app, const std::string& name, std::vector<double>& values,
                             const std::string& description);

void add_console_options(CLI::App& app, Console& console);
void add_thread_option(CLI::App& app, Common_options& options);
void add_reading_options(CLI::App& app, Common_options& options);
void add_orientation_options(CLI::App& app, Reading_options& reading);
void add_normals_option(CLI::App& app, Reading_options& reading);

/// reads the arguments; returns whether there is anything left to do after them.
/// \throw Usage_error with one line if they are wrong.
bool parse(CLI::App& app, std::vector<std::string> arguments);

} // namespace mapt

#endif // MAPT_COMMAND_LINE_H
