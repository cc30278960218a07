// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_REPORT_PAGE_H
#define MAPT_REPORT_PAGE_H

#include "report_results.h"

#include <cstddef>

namespace mapt {

/// what a page holds, for those who want to know.
struct Page_summary
{
  std::size_t bytes = 0;
  std::size_t faces = 0; // drawn
};

/// writes the page of a report, whole or not at all.
/// \param report what `--json` tells so far: input, parameters, grid, seconds
/// \throw Output_error if it cannot be written
Page_summary write_page(const Input& input, const Report_results& results,
                        const Report_options& options, const nlohmann::ordered_json& report);

} // namespace mapt

#endif // MAPT_REPORT_PAGE_H
