// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "benchmark_suite.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <map>
#include <regex>
#include <stdexcept>

namespace Benchmarks {

namespace {

/// how often and how long: a row is repeated `repetitions` times, or as often as fits into `budget`; what
/// takes less than `shortest` is called more often in each repetition.
struct Plan
{
  int repetitions;
  double budget;   // seconds
  double shortest; // seconds
};

Plan plan(const Options& options)
{
  Plan p = options.effort == Effort::SMOKE   ? Plan{0, 0, 0}
           : options.effort == Effort::QUICK ? Plan{3, 1, 0.005}
                                             : Plan{7, 10, 0.05};
  if(options.repetitions > 0)
    p.repetitions = options.repetitions;
  return p;
}

double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

double peak_resident_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss);
}

struct Group_entry
{
  std::string description;
  Group_function function;
};

std::map<std::string, Group_entry>& groups()
{
  static std::map<std::string, Group_entry> all;
  return all;
}

} // namespace

Comparison::Comparison(const Options& options, Report& report, Row row, Clock clock)
    : m_options(options), m_report(report), m_row(std::move(row)), m_clock(clock)
{
  m_row.is_wall_ratio = clock == Clock::WALL;
}

Row& Comparison::add(const std::string& name, const Parameters& parameters, Work work, Place place)
{
  m_entries.push_back({m_row, std::move(work), place, {}});
  Row& row = m_entries.back().row;
  row.name = name;
  row.is_baseline = m_entries.size() == 1;
  row.parameters.insert(row.parameters.end(), parameters.begin(), parameters.end());
  return row;
}

Comparison::Times Comparison::time(const Work& work, std::size_t calls)
{
  const auto begin = std::chrono::steady_clock::now();
  const double cpu_begin = cpu_seconds();
  for(std::size_t i = 0; i < calls; ++i)
    work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return {wall.count() / double(calls), (cpu_seconds() - cpu_begin) / double(calls), 0};
}

/// The child sends its times and the growth of its peak of memory through a pipe.
Comparison::Times Comparison::time_in_child(const Work& work)
{
  malloc_trim(0); // what was freed but not returned would hide what the child takes
  std::array<int, 2> ends;
  if(pipe(ends.data()) != 0)
    throw std::runtime_error("no pipe to a child process can be made");
  const pid_t child = fork();
  if(child == 0) {
    const double before = peak_resident_bytes();
    Times times;
    try {
      times = time(work, 1);
    } catch(const std::exception& e) {
      std::cerr << e.what() << std::endl;
      _exit(1);
    }
    times.memory = peak_resident_bytes() - before;
    _exit(write(ends[1], &times, sizeof(times)) == sizeof(times) ? 0 : 1);
  }
  close(ends[1]);
  Times times;
  const bool is_read = child > 0 && read(ends[0], &times, sizeof(times)) == sizeof(times);
  close(ends[0]);
  if(child > 0)
    waitpid(child, nullptr, 0);
  if(!is_read)
    throw std::runtime_error("the work of a child process failed");
  return times;
}

void Comparison::repeat(Entry& entry)
{
  entry.times.push_back(entry.place == Place::CHILD ? time_in_child(entry.work)
                                                    : time(entry.work, entry.row.calls));
}

/// fills caches and finds how often to call and to repeat.
void Comparison::warm_up(Entry& entry)
{
  const Plan p = plan(m_options);
  entry.row.calls = 1;
  repeat(entry);
  const double once = std::max(entry.times[0].wall, 1e-9);
  if(entry.place == Place::HERE)
    entry.row.calls = std::max(std::size_t(1), std::size_t(std::ceil(p.shortest / once)));
  const double fitting = p.budget / (once * double(entry.row.calls));
  entry.row.repetitions = std::size_t(std::min(double(p.repetitions), fitting));
  if(entry.row.repetitions > 0 || m_options.repetitions > 0)
    entry.times.clear();
  if(m_options.repetitions > 0)
    entry.row.repetitions = std::size_t(m_options.repetitions);
}

double Comparison::peak_memory(const Entry& entry)
{
  return std::max_element(entry.times.begin(), entry.times.end(),
                          [](const Times& a, const Times& b) { return a.memory < b.memory; })
      ->memory;
}

void Comparison::summarize(Entry& entry)
{
  const std::vector<Times>& baseline = m_entries.front().times;
  std::vector<double> wall, cpu, ratios;
  for(std::size_t i = 0; i < entry.times.size(); ++i) {
    const Times& t = entry.times[i];
    wall.push_back(t.wall);
    cpu.push_back(t.cpu);
    const Times& b = baseline[std::min(i, baseline.size() - 1)];
    ratios.push_back(m_clock == Clock::WALL ? b.wall / t.wall : b.cpu / t.cpu);
  }
  Row& row = entry.row;
  row.wall = spread(wall);
  row.cpu = spread(cpu);
  row.ratio = spread(ratios);
  row.repetitions = entry.times.size();
  if(entry.place == Place::CHILD) {
    row.measures.emplace_back("peak memory", peak_memory(entry));
    row.measures.emplace_back("memory ratio", peak_memory(m_entries.front()) / peak_memory(entry));
  }
}

void Comparison::run()
{
  std::size_t rounds = 0;
  for(Entry& entry : m_entries) {
    warm_up(entry);
    rounds = std::max(rounds, entry.row.repetitions);
  }
  for(std::size_t round = 0; round < rounds; ++round)
    for(Entry& entry : m_entries)
      if(round < entry.row.repetitions)
        repeat(entry);
  std::vector<Row> rows;
  for(Entry& entry : m_entries) {
    summarize(entry);
    rows.push_back(entry.row);
  }
  print_table(rows, std::cout);
  std::cout.flush();
  m_report.add(rows);
}

Comparison Group::comparison(const std::string& name, const Parameters& parameters,
                             Comparison::Clock clock)
{
  Row row{};
  row.group = m_name;
  row.comparison = name;
  row.parameters = parameters;
  return Comparison(m_options, m_report, std::move(row), clock);
}

Registered_group::Registered_group(const std::string& name, const std::string& description,
                                   Group_function function)
{
  groups()[name] = {description, function};
}

std::vector<std::string> names_of_groups()
{
  std::vector<std::string> names;
  for(const auto& [name, group] : groups())
    names.push_back(name);
  return names;
}

bool run_groups(const Options& options, Report& report)
{
  const std::regex filter(options.filter);
  bool is_well = true;
  for(const auto& [name, entry] : groups()) {
    if(!std::regex_search(name, filter))
      continue;
    report.add_group(name, entry.description);
    try {
      Group group(options, report, name);
      entry.function(group);
    } catch(const std::exception& e) {
      std::cerr << "group " << name << ": " << e.what() << std::endl;
      is_well = false;
    }
  }
  return is_well;
}

} // namespace Benchmarks
