// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TO_TEXT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TO_TEXT_H

#include <charconv>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Area_projection {
namespace internal {

// The shortest text that reads back as exactly the same number, whatever the locale; `std::to_string()` calls 1e-9 0.000000.
template <class Number>
std::string to_text(Number value)
{
  static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>);
  char text[64];
  const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
  return std::string(text, end);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_TO_TEXT_H
