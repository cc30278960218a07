// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SALIENT_REPORT_H
#define MAPT_SALIENT_REPORT_H

#include "console.h"
#include "salient_options.h"
#include "salient_points.h"

namespace mapt {

/// tells what was asked for.
void report_parameters(const Salient_options& options, Console& console);

/// the heading of a table of points, fitted or as the paper finds them.
const char* table_heading(bool is_fitted);

/// the line of a point in such a table.
std::string table_line(const CGAL::Area_projection::Salient_point& point, bool is_fitted);

/// all columns of each point. A number that is unknown becomes null.
nlohmann::ordered_json to_json(const Salient_points& found);

/// tells what was found: all of it in the object of --json, the strongest and their number in the table.
void report_points(const Salient_points& found, const Salient_options& options, Console& console);

} // namespace mapt

#endif // MAPT_SALIENT_REPORT_H
