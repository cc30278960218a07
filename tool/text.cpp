// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace mapt {

namespace {

// The number of letters to insert, remove or replace (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for(std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

} // namespace

std::string to_text(double value, int digits)
{
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

std::string coordinate_to_text(double value, double length)
{
  const double steps = 1000 * std::abs(value / length);
  const bool is_known = steps >= 1 && std::isfinite(steps);
  return to_text(value, is_known ? std::clamp(int(std::log10(steps)) + 2, 5, 17) : 5);
}

std::string bytes_to_text(double bytes)
{
  const char* const units[] = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  int unit = 0;
  for(; bytes >= 999.5 && unit < 6; ++unit)
    bytes /= 1000;
  return to_text(bytes, bytes < 10 && unit > 0 ? 2 : 3) + " " + units[unit];
}

bool bytes_from_text(const std::string& text, double& bytes)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit(end);
  unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
  std::transform(unit.begin(), unit.end(), unit.begin(),
                 [](unsigned char c) { return char(std::toupper(c)); });
  if(end == text.c_str() || !(number > 0) || !std::isfinite(number))
    return false;
  if(!unit.empty() && unit.back() == 'B')
    unit.pop_back();
  const std::string prefixes = "KMGT";
  const std::size_t prefix = prefixes.find(unit);
  if(unit.size() > 1 || prefix == std::string::npos)
    return false;
  bytes = unit.empty() ? number : number * std::pow(1000., double(prefix) + 1);
  return true;
}

std::string counted(std::size_t number, const std::string& one, const std::string& many)
{
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string list_to_text(const std::vector<double>& values)
{
  constexpr std::size_t longest = 12, at_the_ends = 5;
  std::string text;
  for(std::size_t i = 0; i < values.size(); ++i) {
    if(values.size() > longest && i == at_the_ends) {
      text += " …";
      i = values.size() - at_the_ends;
    }
    text += (i > 0 ? " " : "") + to_text(values[i]);
  }
  return text;
}

std::string time_to_text(double seconds)
{
  const auto all = (long long)(std::min(seconds, 1e15) + 0.5);
  const long long days = all / 86400, hours = all / 3600 % 24, minutes = all / 60 % 60;
  if(days > 0)
    return std::to_string(days) + " d " + std::to_string(hours) + " h";
  if(hours > 0)
    return std::to_string(hours) + " h " + std::to_string(minutes) + " min";
  return (minutes > 0 ? std::to_string(minutes) + " min " : "") + std::to_string(all % 60) + " s";
}

std::string printable(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates)
{
  std::string nearest;
  std::size_t smallest = word.size() / 2 + 1;
  for(const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if(distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

} // namespace mapt
