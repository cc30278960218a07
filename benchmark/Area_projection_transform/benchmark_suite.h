// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_BENCHMARK_SUITE_H
#define AREA_PROJECTION_BENCHMARK_SUITE_H

// How benchmarks are written. A file of this folder holds a group, a function that is registered:
//
//   void balls(Group& group)
//   {
//     const Cloud cloud = make_cloud(group.pick(1000, 100000, 1000000));
//     Comparison comparison = group.comparison("sums", {{"points", cloud.size()}});
//     comparison.add("Fuzzy_sphere", [&] { keep(sum_by_cgal(cloud)); });     // the baseline
//     Row& row = comparison.add("tree", {{"leaf", 32}}, [&] { keep(sum_by_tree(cloud)); });
//     row.measures.emplace_back("error", difference);
//     comparison.run();
//   }
//   const Registered_group registered("ball_sums", "Sums of areas in balls.", balls);
//
// Nothing else need be touched: the sources of the folder are all compiled, and the page of results has
// a section and a table for each group. A figure for it is one entry in scripts/plot-benchmarks.

#include "benchmark_report.h"

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace Benchmarks {

/// how much is done: seconds to see that all runs, a minute to look, or what is published.
enum class Effort { SMOKE, QUICK, FULL };

struct Options
{
  Effort effort = Effort::FULL;
  int repetitions = 0;             ///< of each row; 0: as the effort has it
  std::string filter;              ///< a regular expression: the groups whose names it matches
  std::vector<std::string> meshes; ///< the files of the groups that read meshes
};

/// has the compiler believe that `value` is used.
template <class T>
void keep(const T& value)
{
  asm volatile("" : : "g"(&value) : "memory");
}

/// \brief several ways to do the same work; the first is the baseline.
///
/// The repetitions are interleaved, so that what slows the machine down for a while slows all rows.
class Comparison
{
public:
  using Work = std::function<void()>;

  enum class Clock { CPU, WALL };
  enum class Place { HERE, CHILD };

  /// \brief adds a row, which may be given more parameters and measures until the end of `run()`.
  ///
  /// With `Place::CHILD` the work is done in a child process and its peak of memory, beyond what is in use
  /// now, is measured. It must not use threads: a child has none of the pool of its parent.
  Row& add(const std::string& name, const Parameters& parameters, Work work,
           Place place = Place::HERE);

  Row& add(const std::string& name, Work work) { return add(name, {}, std::move(work)); }

  /// measures all rows, prints their table and adds them to the report.
  void run();

  /// \param clock whose ratios tell: `WALL` where the number of threads differs. CPU times otherwise, which
  /// other work on the machine disturbs least.
  Comparison(const Options& options, Report& report, Row row, Clock clock);

private:
  struct Times
  {
    double wall = 0, cpu = 0; // seconds
    double memory = 0;        // bytes
  };

  struct Entry
  {
    Row row;
    Work work;
    Place place;
    std::vector<Times> times;
  };

  static Times time(const Work& work, std::size_t calls);
  static Times time_in_child(const Work& work);

  static double peak_memory(const Entry& entry);
  void repeat(Entry& entry);
  void warm_up(Entry& entry);
  void summarize(Entry& entry);

  const Options& m_options;
  Report& m_report;
  Row m_row; // what the rows have in common
  Clock m_clock;
  std::deque<Entry> m_entries; // rows stay where they are
};

/// what the function of a group is given.
class Group
{
public:
  Group(const Options& options, Report& report, std::string name)
      : m_options(options), m_report(report), m_name(std::move(name))
  {}

  Comparison comparison(const std::string& name, const Parameters& parameters,
                        Comparison::Clock clock = Comparison::Clock::CPU);

  const Options& options() const { return m_options; }

  /// the value for the effort of this run.
  template <class T>
  T pick(T smoke, T quick, T full) const
  {
    return m_options.effort == Effort::SMOKE   ? smoke
           : m_options.effort == Effort::QUICK ? quick
                                               : full;
  }

private:
  const Options& m_options;
  Report& m_report;
  std::string m_name;
};

using Group_function = void (*)(Group&);

/// an object of this type at namespace scope makes a group part of the suite.
struct Registered_group
{
  /// \param description a sentence or two of Markdown for the page of results
  Registered_group(const std::string& name, const std::string& description,
                   Group_function function);
};

std::vector<std::string> names_of_groups();

/// \brief runs the groups that the options ask for, in the order of their names.
/// \return whether all ended well; the others say on `std::cerr` what went wrong.
bool run_groups(const Options& options, Report& report);

} // namespace Benchmarks

#endif // AREA_PROJECTION_BENCHMARK_SUITE_H
