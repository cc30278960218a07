// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "normals_modes.h"

#include <vector>

namespace Paper {

namespace {

using Benchmarks::Parameters;
using Benchmarks::Row;

/// damages of one kind, from none to much.
struct Ladder
{
  std::string name;
  Damage (*damage)(double);
  std::vector<double> amounts;
};

std::vector<Ladder> ladders(const Options& options)
{
  const auto fractions =
      options.pick<std::vector<double>>({0, 0.5}, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8});
  return {{"faces removed", removed_faces, fractions},
          {"holes", holes, fractions},
          {"noise", noise,
           options.pick<std::vector<double>>({0, 0.2}, {0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5})}};
}

/// the tables of one kind of damage.
class Ladder_tables
{
public:
  explicit Ladder_tables(const std::string& ladder)
      : m_tables{{ladder + ": maps", {}, {}},
                 {ladder + ": maxima", {}, {}},
                 {ladder + ": interior", {}, {}}}
  {}

  /// \param measures of each of the subjects
  void add_maps(const std::string& mode, double amount, const std::vector<Subject>& subjects,
                const std::vector<Measures>& measures)
  {
    add(0, mode, amount, subjects, measures);
  }

  void add_maxima(const std::string& mode, double amount, const std::vector<Subject>& subjects,
                  const std::vector<Measures>& measures)
  {
    add(1, mode, amount, subjects, measures);
  }

  void add_interiors(double amount, const std::vector<Subject>& subjects,
                     const std::vector<Measures>& measures)
  {
    add(2, "all", amount, subjects, measures);
  }

  void publish(Benchmarks::Report& report) const
  {
    for(const Table& table : m_tables)
      Paper::publish(table.means, report);
    for(const Table& table : m_tables)
      Paper::publish(table.each, report);
  }

private:
  struct Table
  {
    std::string name;
    std::vector<Row> means, each;
  };

  void add(std::size_t table, const std::string& name, double amount,
           const std::vector<Subject>& subjects, const std::vector<Measures>& measures)
  {
    Table& t = m_tables[table];
    t.means.push_back(row("curves", t.name, name, {{"amount", amount}}, mean(measures)));
    for(std::size_t s = 0; s < subjects.size(); ++s)
      t.each.push_back(row("curves", t.name + ", each mesh", name,
                           {{"mesh", subjects[s].name()}, {"amount", amount}}, measures[s]));
  }

  std::vector<Table> m_tables;
};

/// of each subject some times the same damage with different seeds.
using Damaged_subjects = std::vector<std::vector<Damaged>>;

Damaged_subjects damage(const Ladder& ladder, double amount, const Options& options,
                        const std::vector<Subject>& subjects)
{
  const std::uint64_t repetitions = options.pick(1, 3);
  Damaged_subjects damaged;
  for(const Subject& subject : subjects) {
    damaged.emplace_back();
    for(std::uint64_t r = 0; r < repetitions; ++r)
      damaged.back().push_back(apply(ladder.damage(amount), subject, options.seed + r));
  }
  return damaged;
}

void add_mode(const std::string& mode, double amount, std::vector<Subject>& subjects,
              const Damaged_subjects& damaged, Ladder_tables& tables)
{
  std::vector<Measures> of_maps, of_maxima;
  for(std::size_t s = 0; s < subjects.size(); ++s) {
    const Maps& clean = subjects[s].maps(mode);
    std::vector<Measures> maps, maxima;
    for(const Damaged& d : damaged[s]) {
      const Maps other = compute_maps(mode, d.soup, subjects[s].region(), subjects[s].scales());
      maps.push_back(measure_maps(clean, other, d));
      maxima.push_back(measure_maxima(clean, other, d));
    }
    of_maps.push_back(mean(maps));
    of_maxima.push_back(mean(maxima));
  }
  tables.add_maps(mode, amount, subjects, of_maps);
  tables.add_maxima(mode, amount, subjects, of_maxima);
}

void add_interiors(double amount, const std::vector<Subject>& subjects,
                   const Damaged_subjects& damaged, Ladder_tables& tables)
{
  std::vector<Measures> means;
  for(const std::vector<Damaged>& of_subject : damaged) {
    std::vector<Measures> measures;
    for(const Damaged& d : of_subject)
      measures.push_back(measure_interior(d));
    means.push_back(mean(measures));
  }
  tables.add_interiors(amount, subjects, means);
}

void run(const Ladder& ladder, const Options& options, std::vector<Subject>& subjects,
         Benchmarks::Report& report)
{
  Ladder_tables tables(ladder.name);
  for(double amount : ladder.amounts) {
    const Damaged_subjects damaged = damage(ladder, amount, options, subjects);
    add_interiors(amount, subjects, damaged, tables);
    for(const std::string& mode : normals_modes())
      add_mode(mode, amount, subjects, damaged, tables);
  }
  tables.publish(report);
}

} // namespace

void robustness_curves(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "curves",
      "Faces removed at random and in thirty holes, as fractions of their number, and noise in "
      "units of the mean length of the edges. Means over the meshes and some seeds.");
  std::vector<Subject> subjects;
  for(Mesh& mesh : read_meshes(options, {"hand.obj", "human_woman.obj", "scorpion_low.obj"}))
    subjects.emplace_back(std::move(mesh), options.voxels, descriptor_radii());
  for(const Ladder& ladder : ladders(options))
    run(ladder, options, subjects, report);
}

} // namespace Paper
