// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_TEXT_H
#define MAPT_TEXT_H

#include <string>
#include <vector>

namespace mapt {

/// a number for a reader: up to `digits` significant digits.
std::string to_text(double value, int digits = 4);

/// a coordinate for a reader: with as many digits as tell it from one that is `length / 1000` away, and 5 at least.
std::string coordinate_to_text(double value, double length);

/// "1.2 MB", with units of 1000.
std::string bytes_to_text(double bytes);

/// the number of bytes that `text` means: "800", "500M", "2 GB", "1.5g". Returns whether it means one.
bool bytes_from_text(const std::string& text, double& bytes);

/// "one", "1 face", "3 faces".
std::string counted(std::size_t number, const std::string& one, const std::string& many);

/// "1 2 3", with ` … ` in the middle of long lists.
std::string list_to_text(const std::vector<double>& values);

/// a duration for a reader: "12 s", "3 min 20 s", "2 h 5 min".
std::string time_to_text(double seconds);

/// a text with nothing in it that would end a line: such characters become question marks.
std::string printable(std::string text);

/// the candidate that is most like `word`, or nothing if none is like it.
std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

} // namespace mapt

#endif // MAPT_TEXT_H
