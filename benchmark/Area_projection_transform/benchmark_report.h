// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_BENCHMARK_REPORT_H
#define AREA_PROJECTION_BENCHMARK_REPORT_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace Benchmarks {

/// names and values, in the order in which they are printed; a value is a number or a text.
using Parameters = std::vector<std::pair<std::string, nlohmann::ordered_json>>;

/// the values of the repetitions.
struct Spread
{
  double median = 0, minimum = 0, maximum = 0;
};

/// \pre `values` is not empty
Spread spread(std::vector<double> values);

/// one way to do the work of a comparison, and what was measured.
struct Row
{
  std::string group;
  std::string comparison;
  std::string name;
  bool is_baseline = false;
  Parameters parameters;       ///< first those of the comparison
  bool is_wall_ratio = false;  ///< of which of the two times `ratio` is
  Spread wall, cpu;            ///< seconds
  Spread ratio;                ///< time of the baseline / time of this, both of the same repetition
  std::size_t repetitions = 0; ///< over which the spreads are; 0: no time was taken
  std::size_t calls = 1;       ///< of the work in each repetition
  /// What else was found. `…error` is a fraction, `…memory` a number of bytes, anything else a number.
  std::vector<std::pair<std::string, double>> measures;
};

/// all rows of a run, and where and with what they were measured.
class Report
{
public:
  /// \param effort "full", "quick" or "smoke"
  /// \param page what scripts/plot-benchmarks makes of it: "benchmark" or "paper"
  explicit Report(const std::string& effort, const std::string& page = "benchmark");

  void add_group(const std::string& name, const std::string& description);
  void add(const std::vector<Row>& comparison);

  /// machine, software and the names and sizes of meshes, in a few lines.
  void print_header(std::ostream& out) const;

  const nlohmann::ordered_json& json() const { return m_json; }

private:
  nlohmann::ordered_json m_json;
};

/// prints the rows of one comparison as a table.
void print_table(const std::vector<Row>& comparison, std::ostream& out);

} // namespace Benchmarks

#endif // AREA_PROJECTION_BENCHMARK_REPORT_H
