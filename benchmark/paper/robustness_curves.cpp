// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "normals_modes.h"

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

/// what is measured of one mode at one amount, of each mesh the mean over some seeds.
Measures measure(Subject& subject, const std::string& mode, const std::vector<Damaged>& damaged)
{
  std::vector<Measures> all;
  for(const Damaged& d : damaged) {
    const Maps maps = compute_maps(mode, d.soup, subject.region(), subject.scales());
    Measures measures = measure_maps(subject.maps(mode), maps, d);
    for(const Measures& more : {measure_maxima(subject.maps(mode), maps, d), measure_interior(d)})
      measures.insert(measures.end(), more.begin(), more.end());
    all.push_back(std::move(measures));
  }
  return mean(all);
}

double value_of(const Measures& measures, const std::string& name)
{
  for(const auto& [key, value] : measures)
    if(key == name)
      return value;
  throw std::invalid_argument("nothing of the name " + name + " is measured");
}

/// the rows of an amount: of each mesh, their mean, and the mean by the way of compensation.
class Ladder_rows
{
public:
  explicit Ladder_rows(std::string ladder) : m_ladder(std::move(ladder)) {}

  void add(const std::string& mode, double amount, const std::vector<Subject>& subjects,
           const std::vector<Measures>& measures)
  {
    for(std::size_t s = 0; s < subjects.size(); ++s)
      m_each.push_back(row("curves", m_ladder + ", each mesh", mode,
                           {{"mesh", subjects[s].name()}, {"amount", amount}}, measures[s]));
    const Measures means = mean(measures);
    m_means.push_back(row("curves", m_ladder, mode, {{"amount", amount}}, means));
    for(const auto& [compensation, measure] :
        {std::pair("none", "joint error"), std::pair("coverage", "/ coverage error"),
         std::pair("area", "/ area error")})
      m_compensations.push_back(row("curves", m_ladder + ", compensation", mode,
                                    {{"compensation", compensation}, {"amount", amount}},
                                    {{"joint error", value_of(means, measure)}}));
  }

  void publish(Benchmarks::Report& report) const
  {
    for(const auto* rows : {&m_means, &m_compensations, &m_each})
      Paper::publish(*rows, report);
  }

private:
  std::string m_ladder;
  std::vector<Row> m_each, m_means, m_compensations;
};

void run(const Ladder& ladder, const Options& options, std::vector<Subject>& subjects,
         Benchmarks::Report& report)
{
  const std::uint64_t repetitions = options.pick(1, 3);
  Ladder_rows rows(ladder.name);
  for(double amount : ladder.amounts) {
    std::vector<std::vector<Damaged>> damaged;
    for(const Subject& subject : subjects) {
      damaged.emplace_back();
      for(std::uint64_t r = 0; r < repetitions; ++r)
        damaged.back().push_back(apply(ladder.damage(amount), subject, options.seed + r));
    }
    for(const std::string& mode : normals_modes()) {
      std::vector<Measures> measures;
      for(std::size_t s = 0; s < subjects.size(); ++s)
        measures.push_back(measure(subjects[s], mode, damaged[s]));
      rows.add(mode, amount, subjects, measures);
    }
  }
  rows.publish(report);
}

} // namespace

void robustness_curves(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "curves",
      "Faces removed at random and in twelve holes, as fractions of their number, and noise in "
      "units of the mean length of the edges. Means over the meshes and some seeds.");
  std::vector<Subject> subjects;
  for(Mesh& mesh : read_meshes(options, {"hand.obj", "human_woman.obj", "scorpion_low.obj"}))
    subjects.emplace_back(std::move(mesh), options.voxels, descriptor_radii());
  for(const Ladder& ladder : ladders(options))
    run(ladder, options, subjects, report);
}

} // namespace Paper
