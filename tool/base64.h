// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_BASE64_H
#define MAPT_BASE64_H

#include <string>
#include <string_view>

namespace mapt {

/// bytes as letters, digits, '+', '/' and '=' (RFC 4648), 4 for every 3 bytes, in one line.
std::string to_base64(std::string_view bytes);

} // namespace mapt

#endif // MAPT_BASE64_H
