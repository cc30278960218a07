// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "retrieval_set.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>

namespace Paper {

namespace {

using Benchmarks::Row;

Measures measures_of(const AP::Retrieval_scores& s)
{
  return {{"NN", s.nearest_neighbor}, {"FT", s.first_tier},       {"ST", s.second_tier},
          {"E", s.e_measure},         {"E at best", s.e_ceiling}, {"DCG", s.discounted_gain}};
}

AP::Retrieval_evaluation evaluate(const AP::Descriptor_table& table, AP::Distance_kind distance,
                                  const AP::Class_labels& labels)
{
  return AP::evaluate_retrieval(ranks(table, distance, labels), labels);
}

/// the descriptors of a set for each method; what methods share is computed once.
class Descriptors
{
public:
  explicit Descriptors(std::vector<Soup> shapes) : m_shapes(std::move(shapes)) {}

  const Described_set& of(const Retrieval_method& method)
  {
    const Key key{method.options.binning, method.options.normals};
    const auto known = m_sets.find(key);
    return known != m_sets.end()
               ? known->second
               : m_sets.emplace(key, describe(m_shapes, method.options)).first->second;
  }

private:
  using Key = std::pair<AP::Binning, AP::Descriptor_normals>;
  std::vector<Soup> m_shapes;
  std::map<Key, Described_set> m_sets;
};

void publish_table(Descriptors& clean, const AP::Class_labels& labels, Benchmarks::Report& report)
{
  std::vector<Row> means, classes;
  for(const Retrieval_method& method : retrieval_methods()) {
    const Described_set& set = clean.of(method);
    const AP::Retrieval_evaluation result = evaluate(set.table, method.distance, labels);
    Measures measures = measures_of(result.micro);
    measures.emplace_back("CPU ms of a shape", 1e3 * set.seconds);
    means.push_back(row("table 1", "scores", method.name,
                        {{"shapes", set.table.size()}, {"classes", result.classes.size()}},
                        measures));
    means.back().measures.emplace_back("FT over classes", result.macro.first_tier);
    if(method.name == "paper")
      for(const AP::Class_scores& c : result.classes)
        if(c.scores.first_tier < 1)
          classes.push_back(row("table 1", "classes with FT below 1, paper", c.name,
                                {{"queries", c.number_of_queries}}, measures_of(c.scores)));
  }
  publish(means, report);
  publish(classes, report);
}

void publish_distances(Descriptors& clean, const AP::Class_labels& labels,
                       Benchmarks::Report& report)
{
  const std::vector<std::pair<std::string, AP::Distance_kind>> kinds{
      {"Jeffrey", AP::Distance_kind::JEFFREY},
      {"root of JS", AP::Distance_kind::JENSEN_SHANNON},
      {"chi squared", AP::Distance_kind::CHI_SQUARED},
      {"L1", AP::Distance_kind::L1},
      {"earth mover", AP::Distance_kind::EARTH_MOVER}};
  std::vector<Row> rows;
  for(const auto& [name, kind] : kinds)
    rows.push_back(
        row("table 1", "distances of the paper's descriptor", name, {},
            measures_of(evaluate(clean.of(retrieval_methods()[0]).table, kind, labels).micro)));
  publish(rows, report);
}

void publish_robustness(Descriptors& clean, const Labelled_set& set, const Options& options,
                        Benchmarks::Report& report)
{
  const std::vector<std::pair<std::string, std::vector<Soup>>> sets{
      {"10 % of faces removed from half", half_without_faces(set.shapes, options.seed)},
      {"noise on half", half_with_noise(set.shapes, options.seed)},
      {"thirds", thirds(set.shapes, options.seed)}};
  for(const auto& [name, shapes] : sets) {
    Descriptors damaged(shapes);
    std::vector<Row> rows;
    for(const Retrieval_method& method : retrieval_methods()) {
      const auto scores = [&](Descriptors& descriptors) {
        return evaluate(descriptors.of(method).table, method.distance, set.labels).micro;
      };
      const AP::Retrieval_scores before = scores(clean), after = scores(damaged);
      Measures measures = measures_of(after);
      measures.emplace_back("NN lost", before.nearest_neighbor - after.nearest_neighbor);
      measures.emplace_back("FT lost", before.first_tier - after.first_tier);
      rows.push_back(row("table 1", name, method.name, {}, measures));
    }
    publish(rows, report);
  }
}

/// how much descriptors differ, as L1: each of them sums to 1.
void publish_invariance(Descriptors& clean, const Labelled_set& set, const Options& options,
                        Benchmarks::Report& report)
{
  Descriptors moved_set(moved(set.shapes, options.seed));
  std::vector<Row> rows;
  for(const Retrieval_method& method : retrieval_methods()) {
    if(method.name == "paper, root of JS")
      continue; // the same descriptor as the one before
    const AP::Descriptor_table &a = clean.of(method).table, &b = moved_set.of(method).table;
    const AP::Histogram_distance l1(AP::Distance_kind::L1, a.dimension(), a.block_size());
    double sum = 0, largest = 0, between = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < a.size(); ++i) {
      sum += l1(a[i], b[i]);
      largest = std::max(largest, l1(a[i], b[i]));
      for(std::size_t j = 0; j < i; ++j)
        between = std::min(between, l1(a[i], a[j]));
    }
    rows.push_back(row("table 1", "turned, moved, scaled", method.name, {},
                       {{"mean L1", sum / double(a.size())},
                        {"largest L1", largest},
                        {"least L1 of two shapes", between}}));
  }
  publish(rows, report);
}

bool has_set(const Options& options, const std::string& name)
{
  if(options.retrieval.empty())
    std::cout << "\n" << name << ": left out, for want of a labelled set of meshes (--retrieval)\n";
  return !options.retrieval.empty();
}

Labelled_set read_set(const Options& options)
{
  return read_labelled_set(options.retrieval,
                           options.pick<std::size_t>(6, std::numeric_limits<std::size_t>::max()));
}

} // namespace

void table_1(const Options& options, Benchmarks::Report& report)
{
  if(!has_set(options, "table 1"))
    return;
  report.add_group("table 1", "Retrieval by descriptors in a labelled set, where the paper has "
                              "SHREC 2011 in full resolution (its NN, FT, ST, E and "
                              "DCG: 1.000, 0.986, 0.993, 0.739 of 0.745 at best, 0.997). Means "
                              "over all queries; means over classes are the same where "
                              "classes have the same size. The first row is the paper's descriptor "
                              "with its Jeffrey divergence; root of JS is the sum "
                              "over the radii of the Jensen-Shannon distance. Robustness, as in "
                              "the paper: 10 % of the triangles removed from every "
                              "second model; every second one with noise of a fifth of the mean "
                              "edge, as the root of the mean squared displacement; "
                              "a third as it is, a third with either. What is lost is relative to "
                              "the same descriptor on the clean set.");
  const Labelled_set set = read_set(options);
  Descriptors clean(set.shapes);
  publish_table(clean, set.labels, report);
  publish_distances(clean, set.labels, report);
  publish_robustness(clean, set, options, report);
  publish_invariance(clean, set, options, report);
}

void figure_15(const Options& options, Benchmarks::Report& report)
{
  if(!has_set(options, "figure 15"))
    return;
  report.add_group("figure 15", "Precision over recall of the paper's descriptor, in the mean over "
                                "all queries, and for the three classes "
                                "that are found worst. The query does not count, but in the curve "
                                "that says so, which is drawn as the tools "
                                "of the Princeton shape benchmark do.");
  const Labelled_set set = read_set(options);
  const Retrieval_method method = retrieval_methods()[0];
  const AP::Relevant_ranks found =
      ranks(describe(set.shapes, method.options).table, method.distance, set.labels);
  std::vector<AP::Class_scores> classes = AP::evaluate_retrieval(found, set.labels).classes;
  std::stable_sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) {
    return a.scores.discounted_gain < b.scores.discounted_gain;
  });
  std::vector<Row> rows;
  const auto add_curve = [&](const std::string& name, auto is_query, AP::Query_counts counts) {
    const AP::Precision_recall curve = AP::precision_recall(found, is_query, counts);
    for(std::size_t s = 0; s < curve.recalls.size(); ++s)
      if(curve.numbers_of_queries[s] > 0)
        rows.push_back(row("figure 15", "precision and recall", name,
                           {{"recall", curve.recalls[s]}},
                           {{"precision", curve.precisions[s]},
                            {"queries", double(curve.numbers_of_queries[s])}}));
  };
  const auto all = [](std::size_t) { return true; };
  add_curve("all", all, AP::Query_counts::NO);
  add_curve("all and the query", all, AP::Query_counts::YES);
  for(std::size_t c = 0; c < std::min<std::size_t>(3, classes.size()); ++c)
    add_curve(
        classes[c].name,
        [&](std::size_t i) { return set.labels.name(set.labels[i]) == classes[c].name; },
        AP::Query_counts::NO);
  publish(rows, report);
}

} // namespace Paper
