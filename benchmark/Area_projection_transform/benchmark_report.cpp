// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "benchmark_report.h"
#include "benchmark_machine.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace Benchmarks {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Spread& s)
{
  return {{"median", s.median}, {"minimum", s.minimum}, {"maximum", s.maximum}};
}

bool is_timed(const Row& row)
{
  return row.repetitions > 0;
}

Json to_json(const Row& row)
{
  Json json{{"group", row.group}, {"comparison", row.comparison}, {"name", row.name}};
  if(is_timed(row))
    json.update({{"is_baseline", row.is_baseline},
                 {"wall_seconds", to_json(row.wall)},
                 {"cpu_seconds", to_json(row.cpu)},
                 {"ratio", to_json(row.ratio)},
                 {"ratio_of", row.is_wall_ratio ? "wall" : "cpu"},
                 {"repetitions", row.repetitions},
                 {"calls", row.calls}});
  json["parameters"] = Json::object();
  json["measures"] = Json::object();
  for(const auto& [name, value] : row.parameters)
    json["parameters"][name] = value;
  for(const auto& [name, value] : row.measures)
    json["measures"][name] = value;
  return json;
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// three significant digits, but whole numbers as they are; without exponents in the usual range.
std::string number_text(double value)
{
  std::ostringstream out;
  const double size = std::abs(value);
  if(size < 1e9 && std::round(value) == value)
    out << std::int64_t(value);
  else if(size >= 1e7 || size < 1e-4)
    out << std::setprecision(3) << value;
  else
    out << std::fixed << std::setprecision(std::max(0, 2 - int(std::floor(std::log10(size)))))
        << value;
  return out.str();
}

std::string time_text(double seconds)
{
  if(seconds >= 1)
    return number_text(seconds) + " s ";
  return seconds >= 1e-3 ? number_text(1e3 * seconds) + " ms" : number_text(1e6 * seconds) + " us";
}

std::string measure_text(const std::string& name, double value)
{
  if(ends_with(name, "error"))
    return number_text(100 * value) + " %";
  return ends_with(name, "memory") ? number_text(value / 1e6) + " MB" : number_text(value);
}

std::string parameter_text(const Json& value)
{
  return value.is_string() ? value.get<std::string>() : number_text(value.get<double>());
}

using Line = std::vector<std::string>;

/// the parameters that all rows share go into the title, the others into columns.
bool is_shared(const std::vector<Row>& rows, const Parameters::value_type& parameter)
{
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    return std::find(row.parameters.begin(), row.parameters.end(), parameter) !=
           row.parameters.end();
  });
}

std::vector<std::string> own_parameters(const std::vector<Row>& rows)
{
  std::vector<std::string> names;
  for(const Row& row : rows)
    for(const auto& parameter : row.parameters)
      if(!is_shared(rows, parameter) &&
         std::find(names.begin(), names.end(), parameter.first) == names.end())
        names.push_back(parameter.first);
  return names;
}

std::vector<std::string> names_of_measures(const std::vector<Row>& rows)
{
  std::vector<std::string> names;
  for(const Row& row : rows)
    for(const auto& measure : row.measures)
      if(std::find(names.begin(), names.end(), measure.first) == names.end())
        names.push_back(measure.first);
  return names;
}

template <class Pairs, class ToText>
std::string cell(const Pairs& pairs, const std::string& name, ToText&& to_text)
{
  for(const auto& pair : pairs)
    if(pair.first == name)
      return to_text(pair.second);
  return "";
}

void append_times(const Row& row, Line& cells)
{
  const Spread& time = row.is_wall_ratio ? row.wall : row.cpu;
  cells.push_back(time_text(row.cpu.median));
  cells.push_back(time_text(row.wall.median));
  cells.push_back(row.repetitions > 1
                      ? number_text(50 * (time.maximum - time.minimum) / time.median) + " %"
                      : "");
  cells.push_back(row.is_baseline ? "1" : number_text(row.ratio.median));
}

Line line(const Row& row, const std::vector<std::string>& parameters,
          const std::vector<std::string>& measures)
{
  Line cells{row.name};
  for(const std::string& name : parameters)
    cells.push_back(cell(row.parameters, name, parameter_text));
  if(is_timed(row))
    append_times(row, cells);
  for(const std::string& name : measures)
    cells.push_back(
        cell(row.measures, name, [&name](double value) { return measure_text(name, value); }));
  return cells;
}

/// The first column is aligned to the left, the others to the right.
void print_aligned(const std::vector<Line>& lines, std::ostream& out)
{
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for(const Line& cells : lines)
    for(std::size_t c = 0; c < cells.size(); ++c)
      widths[c] = std::max(widths[c], cells[c].size());
  for(const Line& cells : lines) {
    for(std::size_t c = 0; c < cells.size(); ++c)
      out << "  " << (c == 0 ? std::left : std::right) << std::setw(int(widths[c])) << cells[c];
    out << "\n";
  }
}

} // namespace

Spread spread(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values.front(), values.back()};
}

Report::Report(const std::string& effort, const std::string& page)
    : m_json{{"format", 1},
             {"page", page},
             {"effort", effort},
             {"date", date()},
             {"machine", machine()},
             {"software", software()},
             {"groups", Json::array()},
             {"rows", Json::array()}}
{}

void Report::add_group(const std::string& name, const std::string& description)
{
  m_json["groups"].push_back({{"name", name}, {"description", description}});
}

void Report::add(const std::vector<Row>& comparison)
{
  for(const Row& row : comparison)
    m_json["rows"].push_back(to_json(row));
}

void Report::print_header(std::ostream& out) const
{
  for(const char* part : {"machine", "software"})
    for(const auto& [name, value] : m_json[part].items())
      out << name << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
}

void print_table(const std::vector<Row>& comparison, std::ostream& out)
{
  const Row& first = comparison.front();
  out << "\n" << first.group << ", " << first.comparison;
  for(const auto& parameter : first.parameters)
    if(is_shared(comparison, parameter))
      out << ", " << parameter.first << " " << parameter_text(parameter.second);
  out << "\n";

  const std::vector<std::string> parameters = own_parameters(comparison);
  const std::vector<std::string> measures = names_of_measures(comparison);
  Line head{""};
  head.insert(head.end(), parameters.begin(), parameters.end());
  if(is_timed(first))
    head.insert(head.end(),
                {"cpu", "wall", "+-", first.is_wall_ratio ? "wall ratio" : "cpu ratio"});
  head.insert(head.end(), measures.begin(), measures.end());
  std::vector<Line> lines{head};
  for(const Row& row : comparison)
    lines.push_back(line(row, parameters, measures));
  print_aligned(lines, out);
}

} // namespace Benchmarks
