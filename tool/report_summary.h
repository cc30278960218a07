// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What mapt report tells on the terminal.

#ifndef MAPT_REPORT_SUMMARY_H
#define MAPT_REPORT_SUMMARY_H

#include "report_page.h"

namespace mapt {

/// what was computed with which choices: "parameters", "grid" and "steps" of the object of --json.
void report_parameters(const Report_results& results, const Report_options& options,
                       Console& console);

/// what was found, in short.
void report_results(const Report_results& results, const Report_options& options, Console& console);

/// what the page is.
void report_page(const Page_summary& page, const Input& input, const Report_options& options,
                 Console& console);

} // namespace mapt

#endif // MAPT_REPORT_SUMMARY_H
