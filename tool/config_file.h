// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// --config: options from a file.

#ifndef MAPT_CONFIG_FILE_H
#define MAPT_CONFIG_FILE_H

#include <CLI/CLI.hpp>

#include <istream>
#include <string>
#include <vector>

namespace mapt {

/// \brief reads lines such as "threads = 2".
///
/// That of CLI11 takes files of any size, sections, of which it copies all levels to all levels, and quotes without an end.
class Config_reader : public CLI::ConfigTOML
{
public:
  /// \throw CLI::ConfigError if it is something else
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;
};

/// the file that --config names, or nothing.
std::string config_file_of(const CLI::App& app);

/// \brief makes sure that no other option names the file of --config, which would be replaced.
/// \throw Usage_error
void check_config_stays(const CLI::App& app);

} // namespace mapt

#endif // MAPT_CONFIG_FILE_H
