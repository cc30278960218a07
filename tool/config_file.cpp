// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "config_file.h"

#include "errors.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

namespace mapt {

namespace {

void check_line(std::string_view line, std::size_t number)
{
  const auto fail = [number](const char* what) {
    throw CLI::ConfigError("line " + std::to_string(number) + ": " + what);
  };
  const std::size_t begin = line.find_first_not_of(" \t");
  if(begin == std::string_view::npos || line[begin] == '#' || line[begin] == ';')
    return;
  if(line[begin] == '[')
    fail("sections are not known: write lines such as 'threads = 2'");
  if(std::count(line.begin(), line.end(), '"') % 2 != 0)
    fail("a quote is not closed");
}

} // namespace

std::vector<CLI::ConfigItem> Config_reader::from_config(std::istream& input) const
{
  constexpr std::size_t most = 1 << 16;
  std::string text(most + 1, '\0');
  input.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(input.gcount()));
  if(text.size() > most)
    throw CLI::ConfigError("is larger than 64 kB: must hold lines such as 'threads = 2'");
  std::istringstream lines(text);
  std::string line;
  for(std::size_t number = 1; std::getline(lines, line); ++number)
    check_line(line, number);
  std::istringstream copy(text);
  return CLI::ConfigTOML::from_config(copy);
}

std::string config_file_of(const CLI::App& app)
{
  const CLI::Option* const option = app.get_config_ptr();
  return option == nullptr || option->results().empty() ? "" : option->results().front();
}

void check_config_stays(const CLI::App& app)
{
  const std::string config = config_file_of(app);
  if(config.empty())
    return;
  for(const CLI::Option* option : app.get_options())
    for(const std::string& value : option->results()) {
      std::error_code ignored; // of what is no file
      if(option != app.get_config_ptr() && std::filesystem::equivalent(value, config, ignored))
        throw Usage_error(option->get_name() + " " + value +
                          " is the file of --config: choose another name");
    }
}

} // namespace mapt
