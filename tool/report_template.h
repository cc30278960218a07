// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_REPORT_TEMPLATE_H
#define MAPT_REPORT_TEMPLATE_H

#include <string_view>

namespace mapt {

/// the page without its data, as `scripts/build-viewer` makes it of `viewer/`.
std::string_view report_template();

} // namespace mapt

#endif // MAPT_REPORT_TEMPLATE_H
