// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIBE_INPUT_H
#define MAPT_DESCRIBE_INPUT_H

#include "console.h"
#include "input.h"

#include <string>

namespace mapt {

/// the counts and measures of an input, as --json gives them.
nlohmann::ordered_json to_json(const Mesh_report& report);

/// "12 vertices, 20 faces, closed".
std::string summary(const Input& input);

/// warns of all that the user should know.
void warn_of(const Input& input, Console& console);

/// reads an input and tells what it is.
/// \throw Input_error
Input read_described(const std::string& file, const Reading_options& options, Console& console);

} // namespace mapt

#endif // MAPT_DESCRIBE_INPUT_H
