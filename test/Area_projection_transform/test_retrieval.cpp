// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances between histograms, the index, and the measures of retrieval, against what is worked out by hand.

#include <CGAL/Area_projection_transform/IO/class_labels.h>
#include <CGAL/Area_projection_transform/IO/float_matrix.h>
#include <CGAL/Area_projection_transform/IO/shape_descriptors_CSV.h>
#include <CGAL/Area_projection_transform/retrieval.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;
using AP::Distance_kind;
using AP::Histogram_distance;

constexpr std::array<Distance_kind, 5> all_kinds{
    Distance_kind::JEFFREY, Distance_kind::JENSEN_SHANNON, Distance_kind::CHI_SQUARED,
    Distance_kind::L1, Distance_kind::EARTH_MOVER};

using Histogram = std::vector<float>;

double distance(Distance_kind kind, const Histogram& a, const Histogram& b, std::size_t block)
{
  return Histogram_distance(kind, a.size(), block)(a.data(), b.data());
}

/// numbers that are the same with any standard library.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}
  double operator()() { return double(m_engine() >> 11) * 0x1p-53; }

  /// blocks of the same sum, some bins of which are empty.
  Histogram histogram(std::size_t blocks, std::size_t bins)
  {
    Histogram result;
    for(std::size_t b = 0; b < blocks; ++b) {
      std::vector<double> block(bins);
      double sum = 0;
      for(double& value : block)
        sum += value = std::max(0., (*this)() - 0.3);
      block[0] += 0.1;
      for(double value : block)
        result.push_back(float(value / (sum + 0.1) / double(blocks)));
    }
    return result;
  }

  /// near another one, of the same sums.
  Histogram near(const Histogram& center, const Histogram& other, double share)
  {
    Histogram result;
    const double s = share * (*this)();
    for(std::size_t i = 0; i < center.size(); ++i)
      result.push_back(float((1 - s) * center[i] + s * other[i]));
    return result;
  }

private:
  std::mt19937_64 m_engine;
};

TEST(Histogram_distance, values_by_hand)
{
  const Histogram h{0.5f, 0.5f, 0, 0}, k{0.5f, 0, 0, 0.5f}, disjoint{0, 0, 0.25f, 0.75f};
  // The halves that are alike cancel; each of the others is h log(h / (h/2)).
  EXPECT_NEAR(distance(Distance_kind::JEFFREY, h, k, 4), std::log(2.), 1e-15);
  EXPECT_NEAR(distance(Distance_kind::JEFFREY, h, disjoint, 4), 2 * std::log(2.), 1e-15);
  EXPECT_NEAR(distance(Distance_kind::JENSEN_SHANNON, h, k, 4), std::sqrt(std::log(2.) / 2), 1e-15);
  // In blocks of two: the first differs by one half in one bin, and so does the second.
  EXPECT_NEAR(distance(Distance_kind::JENSEN_SHANNON, h, k, 2), 2 * std::sqrt(std::log(2.) / 4),
              1e-15);
  EXPECT_EQ(distance(Distance_kind::CHI_SQUARED, h, k, 4), 1);
  EXPECT_EQ(distance(Distance_kind::L1, h, k, 4), 1);
  EXPECT_EQ(distance(Distance_kind::EARTH_MOVER, h, k, 4), 1);           // half of it, two steps
  EXPECT_EQ(distance(Distance_kind::EARTH_MOVER, h, disjoint, 4), 2.25); // 0.5 + 1 + 0.75
}

TEST(Histogram_distance, equal_histograms_are_nowhere_apart_and_order_does_not_matter)
{
  Random random(1);
  for(int i = 0; i < 50; ++i) {
    const Histogram a = random.histogram(4, 6), b = random.histogram(4, 6);
    for(Distance_kind kind : all_kinds) {
      EXPECT_EQ(distance(kind, a, a, 6), 0);
      EXPECT_EQ(distance(kind, a, b, 6), distance(kind, b, a, 6));
      EXPECT_GT(distance(kind, a, b, 6), 0);
    }
    EXPECT_LE(distance(Distance_kind::JEFFREY, a, b, 6), 2 * std::log(2.) * (1 + 1e-6));
  }
}

TEST(Histogram_distance, jeffrey_is_its_definition)
{
  // In long doubles the definition loses three digits of the 18 at x = 1/30.
  for(int i = 1; i <= 1000; ++i) {
    const long double h = 1 + 0.001L * i, k = 1 - 0.001L * i;
    long double expected = h * std::log(h);
    if(k > 0)
      expected += k * std::log(k);
    const double computed = AP::internal::jeffrey_term(double(h), double(k));
    if(i > 30) {
      EXPECT_NEAR(computed / double(expected), 1, 2e-14) << i;
    }
  }
}

TEST(Histogram_distance, jeffrey_has_all_its_digits_where_histograms_hardly_differ)
{
  // With x = (h - k)/(h + k) the series begins with m (x² + x⁴/6 + x⁶/15), which is all of it here.
  for(double x : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double h = 0.25 * (1 + x), k = 0.25 * (1 - x), u = std::pow((h - k) / (h + k), 2);
    EXPECT_NEAR(AP::internal::jeffrey_term(h, k) / (0.25 * u * (1 + u / 6 + u * u / 15)), 1, 1e-14);
  }
}

TEST(Histogram_distance, metrics_obey_the_triangle_inequality)
{
  Random random(2);
  for(int i = 0; i < 2000; ++i) {
    const Histogram a = random.histogram(3, 5), b = random.histogram(3, 5),
                    c = random.near(a, b, 1); // between them, where the inequality is tight
    for(Distance_kind kind : all_kinds) {
      const Histogram_distance of(kind, 15, 5);
      const auto metric = [&of](const Histogram& x, const Histogram& y) {
        return of.metric(of(x.data(), y.data()));
      };
      EXPECT_LE(metric(a, b), (metric(a, c) + metric(c, b)) * (1 + 1e-6)) << int(kind);
    }
  }
}

TEST(Histogram_distance, a_limit_does_not_change_what_is_within)
{
  Random random(3);
  for(int i = 0; i < 100; ++i) {
    const Histogram a = random.histogram(8, 12), b = random.histogram(8, 12);
    for(Distance_kind kind : all_kinds) {
      const Histogram_distance of(kind, 96, 12);
      const double d = of(a.data(), b.data());
      EXPECT_EQ(of(a.data(), b.data(), d), d);
      EXPECT_GT(of(a.data(), b.data(), 0.3 * d), 0.3 * d);
    }
  }
}

TEST(Histogram_distance, blocks_must_fit)
{
  EXPECT_THROW(Histogram_distance(Distance_kind::L1, 96, 13), std::invalid_argument);
  EXPECT_THROW(Histogram_distance(Distance_kind::L1, 0, 1), std::invalid_argument);
  EXPECT_THROW(Histogram_distance(Distance_kind::L1, 96, 0), std::invalid_argument);
  EXPECT_THROW(AP::Descriptor_table(96, 13), std::invalid_argument);
  AP::Descriptor_table table(2, 2);
  EXPECT_THROW(table.push_back(Histogram{1}), std::invalid_argument);
  EXPECT_THROW(table.push_back(Histogram{1, -1}), std::invalid_argument);
  EXPECT_THROW(table.push_back(Histogram{1, std::nanf("")}), std::invalid_argument);
  EXPECT_EQ(table.size(), 0u);
  EXPECT_THROW(AP::distance_matrix(table, Histogram_distance(Distance_kind::L1, 4, 2)),
               std::invalid_argument);
}

AP::Descriptor_table random_table(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  AP::Descriptor_table table(24, 6);
  for(std::size_t i = 0; i < size; ++i)
    table.push_back(random.histogram(4, 6));
  return table;
}

/// clusters as those of classes, with some shapes that are there twice.
AP::Descriptor_table clustered_table(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  AP::Descriptor_table table(24, 6);
  std::vector<Histogram> centers;
  for(int c = 0; c < 12; ++c)
    centers.push_back(random.histogram(4, 6));
  while(table.size() < size) {
    const Histogram& center = centers[std::size_t(12 * random())];
    table.push_back(random.near(center, random.histogram(4, 6), 0.1));
    if(random() < 0.1)
      table.push_back(center);
  }
  return table;
}

TEST(Distance_matrix, holds_the_distances)
{
  const AP::Descriptor_table table = random_table(40, 4);
  const Histogram_distance of(Distance_kind::JEFFREY, 24, 6);
  const AP::Distance_matrix matrix = AP::distance_matrix(table, of);
  for(std::size_t i = 0; i < table.size(); ++i)
    for(std::size_t j = 0; j < table.size(); ++j)
      EXPECT_EQ(matrix[i][j], float(of(table[i], table[j])));
  const auto parallel = AP::distance_matrix<CGAL::Parallel_if_available_tag>(table, of);
  EXPECT_EQ(parallel.values(), matrix.values());
  EXPECT_THROW(AP::Distance_matrix(2, {0, 1, 1}), std::invalid_argument);
}

void expect_index_finds_what_a_scan_finds(const AP::Descriptor_table& table,
                                          const AP::Descriptor_table& queries, bool is_to_save)
{
  for(Distance_kind kind : all_kinds) {
    const Histogram_distance of(kind, table.dimension(), table.block_size());
    const AP::Metric_index index(CGAL::Parallel_if_available_tag(), table, of);
    ASSERT_EQ(index.size(), table.size());
    std::size_t comparisons = 0;
    for(std::size_t q = 0; q < queries.size(); ++q)
      for(std::size_t number : {std::size_t(1), std::size_t(7), table.size() + 5}) {
        const auto expected = AP::nearest_by_scan(table, of, queries[q], number);
        const auto found = index.nearest(queries[q], number, number == 7 ? &comparisons : nullptr);
        ASSERT_EQ(found.size(), std::min(number, table.size()));
        ASSERT_EQ(found.size(), expected.size());
        for(std::size_t i = 0; i < found.size(); ++i) {
          ASSERT_EQ(found[i].index, expected[i].index) << int(kind) << " " << q << " " << i;
          ASSERT_EQ(found[i].distance, expected[i].distance);
        }
      }
    if(is_to_save) {
      EXPECT_LT(double(comparisons), 0.5 * double(queries.size() * table.size())) << int(kind);
    }
  }
}

TEST(Metric_index, finds_what_a_scan_finds_among_anything)
{
  expect_index_finds_what_a_scan_finds(random_table(600, 5), random_table(10, 6), false);
}

TEST(Metric_index, finds_what_a_scan_finds_in_clusters_with_less_work)
{
  const AP::Descriptor_table table = clustered_table(3000, 7);
  AP::Descriptor_table queries(24, 6); // those of the table, some of which are there twice
  for(std::size_t i = 0; i < table.size(); i += 200)
    queries.push_back(Histogram(table[i], table[i] + 24));
  expect_index_finds_what_a_scan_finds(table, queries, true);
}

// Distances are remembered as floats: without a margin for that a bound on a distance is more than the distance, as often
// as not, if the triangle inequality is tight. That it is for a shape that is there again, of which the first is to be
// found.
TEST(Metric_index, finds_the_first_of_those_that_are_there_twice)
{
  const AP::Descriptor_table once = random_table(300, 9);
  AP::Descriptor_table table(24, 6);
  for(int copy = 0; copy < 2; ++copy)
    for(std::size_t i = 0; i < once.size(); ++i)
      table.push_back(Histogram(once[i], once[i] + 24));
  for(Distance_kind kind : all_kinds) {
    const Histogram_distance of(kind, 24, 6);
    const AP::Metric_index index(table, of);
    for(std::size_t i = 0; i < once.size(); ++i) {
      const auto found = index.nearest(once[i], 1);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].index, i) << int(kind);
      EXPECT_EQ(found[0].distance, 0);
    }
  }
}

TEST(Metric_index, copes_with_few_and_with_equal_shapes)
{
  Random random(8);
  const Histogram one = random.histogram(4, 6);
  AP::Descriptor_table table(24, 6);
  const Histogram_distance of(Distance_kind::JEFFREY, 24, 6);
  EXPECT_TRUE(AP::Metric_index(table, of).nearest(one.data(), 3).empty());
  for(int i = 0; i < 100; ++i)
    table.push_back(one);
  const AP::Metric_index index(table, of);
  EXPECT_TRUE(index.nearest(one.data(), 0).empty());
  const auto found = index.nearest(one.data(), 10);
  ASSERT_EQ(found.size(), 10u);
  for(std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].index, i);
    EXPECT_EQ(found[i].distance, 0);
  }
  EXPECT_THROW(AP::Metric_index(table, Histogram_distance(Distance_kind::L1, 12, 6)),
               std::invalid_argument);
}

// Shapes on a line, and distances along it:
//
//   class  a  a  b        c     a  b  b
//   place  0  1  2        5    10 11 12
//   index  0  1  3        6     2  4  5
const std::vector<double> places{0, 1, 10, 2, 11, 12, 5};

AP::Class_labels labels_on_line()
{
  return AP::Class_labels({"a", "a", "a", "b", "b", "b", "c"});
}

AP::Relevant_ranks ranks_on_line()
{
  AP::Distance_matrix matrix(places.size());
  for(std::size_t i = 0; i < places.size(); ++i)
    for(std::size_t j = 0; j < places.size(); ++j)
      matrix[i][j] = i == j ? 1000.f : float(std::abs(places[i] - places[j])); // not read for i = j
  return AP::relevant_ranks(matrix, labels_on_line());
}

TEST(Evaluation, ranks_by_hand)
{
  using Ranks = std::vector<std::uint32_t>;
  const AP::Relevant_ranks ranks = ranks_on_line();
  EXPECT_EQ(ranks.number_of_shapes, 7u);
  EXPECT_EQ(ranks.of_query[0], (Ranks{1, 4}));
  EXPECT_EQ(ranks.of_query[1], (Ranks{1, 4})); // 0 and 3 are equally near: 0 comes first
  EXPECT_EQ(ranks.of_query[2], (Ranks{5, 6}));
  EXPECT_EQ(ranks.of_query[3], (Ranks{5, 6}));
  EXPECT_EQ(ranks.of_query[4], (Ranks{2, 4})); // 2 and 5 are equally near: 2 comes first
  EXPECT_EQ(ranks.of_query[5], (Ranks{1, 4}));
  EXPECT_TRUE(ranks.of_query[6].empty());
}

TEST(Evaluation, scores_by_hand)
{
  // Of two others among six: the tiers are the first two and the first four, and all six are within 32.
  const AP::Retrieval_scores first = AP::scores_of_query({1, 4}, 7);
  EXPECT_EQ(first.nearest_neighbor, 1);
  EXPECT_EQ(first.first_tier, 0.5);
  EXPECT_EQ(first.second_tier, 1);
  EXPECT_DOUBLE_EQ(first.e_measure, 2 / (6. / 2 + 1)); // precision 2/6, recall 1
  EXPECT_DOUBLE_EQ(first.e_ceiling, first.e_measure);
  EXPECT_DOUBLE_EQ(first.discounted_gain,
                   (1 + 1. / 2) / (1 + 1)); // 1/log₂ 4 where 1/log₂ 2 was possible
  const AP::Retrieval_scores last = AP::scores_of_query({5, 6}, 7);
  EXPECT_EQ(last.nearest_neighbor, 0);
  EXPECT_EQ(last.first_tier, 0);
  EXPECT_EQ(last.second_tier, 0);
  EXPECT_DOUBLE_EQ(last.discounted_gain, (1 / std::log2(5) + 1 / std::log2(6)) / 2);
  // Of nine others among 299, eight are within 32: precision 8/32, recall 8/9.
  const AP::Retrieval_scores many = AP::scores_of_query({1, 2, 3, 4, 5, 6, 7, 32, 33}, 300);
  EXPECT_DOUBLE_EQ(many.e_measure, 2 / (32. / 8 + 9. / 8));
  EXPECT_NEAR(many.e_ceiling, 0.4390, 5e-5);
  EXPECT_DOUBLE_EQ(many.first_tier, 7. / 9);
  // The ceiling of the contest of the paper, with 20 shapes in a class.
  EXPECT_NEAR(AP::scores_of_query(std::vector<std::uint32_t>(19, 600), 600).e_ceiling, 0.7451,
              5e-5);
}

TEST(Evaluation, the_best_order_has_the_best_scores)
{
  const AP::Retrieval_scores best = AP::scores_of_query({1, 2, 3, 4, 5}, 100);
  EXPECT_EQ(best.nearest_neighbor, 1);
  EXPECT_EQ(best.first_tier, 1);
  EXPECT_EQ(best.second_tier, 1);
  EXPECT_EQ(best.e_measure, best.e_ceiling);
  EXPECT_EQ(best.discounted_gain, 1);
}

TEST(Evaluation, means_by_hand)
{
  const AP::Retrieval_evaluation result = AP::evaluate_retrieval(ranks_on_line(), labels_on_line());
  EXPECT_EQ(result.number_of_queries, 6u); // the only one of its class asks nothing
  ASSERT_EQ(result.classes.size(), 2u);
  EXPECT_EQ(result.classes[0].name, "a");
  EXPECT_DOUBLE_EQ(result.classes[0].scores.nearest_neighbor, 2. / 3);
  EXPECT_DOUBLE_EQ(result.classes[1].scores.nearest_neighbor, 1. / 3);
  EXPECT_DOUBLE_EQ(result.micro.nearest_neighbor, 1. / 2);
  EXPECT_DOUBLE_EQ(result.micro.first_tier, (0.5 + 0.5 + 0 + 0 + 0.5 + 0.5) / 6);
}

TEST(Evaluation, classes_of_different_size_count_the_same_in_the_macro_mean)
{
  const AP::Class_labels labels({"a", "a", "a", "b", "b", "b", "b"});
  AP::Relevant_ranks ranks;
  ranks.number_of_shapes = 7;
  ranks.of_query = {{1, 2}, {1, 2}, {1, 2}, {4, 5, 6}, {4, 5, 6}, {4, 5, 6}, {4, 5, 6}};
  const AP::Retrieval_evaluation result = AP::evaluate_retrieval(ranks, labels);
  EXPECT_DOUBLE_EQ(result.micro.nearest_neighbor, 3. / 7);
  EXPECT_DOUBLE_EQ(result.macro.nearest_neighbor, 1. / 2);
}

TEST(Evaluation, shapes_without_a_class_are_in_the_way_and_ask_nothing)
{
  AP::Distance_matrix matrix(4);
  const std::vector<double> line{0, 2, 1, 9};
  for(std::size_t i = 0; i < 4; ++i)
    for(std::size_t j = 0; j < 4; ++j)
      matrix[i][j] = float(std::abs(line[i] - line[j]));
  const AP::Class_labels labels({"a", "a", "", "a"});
  const AP::Relevant_ranks ranks = AP::relevant_ranks(matrix, labels);
  EXPECT_EQ(ranks.of_query[0], (std::vector<std::uint32_t>{2, 3}));
  EXPECT_TRUE(ranks.of_query[2].empty());
  EXPECT_EQ(AP::evaluate_retrieval(ranks, labels).number_of_queries, 3u);
}

TEST(Evaluation, a_table_gives_the_ranks_of_its_matrix)
{
  const AP::Descriptor_table table = clustered_table(60, 9);
  std::vector<std::string> classes;
  for(std::size_t i = 0; i < table.size(); ++i)
    classes.push_back(i % 3 == 0 ? "a" : i % 3 == 1 ? "b" : "");
  const AP::Class_labels labels(classes);
  const Histogram_distance of(Distance_kind::JENSEN_SHANNON, 24, 6);
  EXPECT_EQ(AP::relevant_ranks<CGAL::Parallel_if_available_tag>(table, of, labels).of_query,
            AP::relevant_ranks(AP::distance_matrix(table, of), labels).of_query);
}

TEST(Evaluation, says_what_is_wrong)
{
  AP::Distance_matrix matrix(2);
  EXPECT_THROW(AP::relevant_ranks(matrix, AP::Class_labels({"a"})), std::invalid_argument);
  const AP::Class_labels labels({"a", "a"});
  EXPECT_THROW(AP::evaluate_retrieval(AP::relevant_ranks(matrix, labels), labels),
               std::invalid_argument); // no class of three
  EXPECT_THROW(AP::evaluate_retrieval(AP::relevant_ranks(matrix, labels), labels, 1),
               std::invalid_argument);
  EXPECT_NO_THROW(AP::evaluate_retrieval(AP::relevant_ranks(matrix, labels), labels, 2));
  matrix[1][0] = std::nanf("");
  EXPECT_THROW(AP::relevant_ranks(matrix, labels), std::invalid_argument);
}

TEST(Precision_recall, by_hand_for_both_conventions)
{
  AP::Relevant_ranks ranks;
  ranks.number_of_shapes = 7;
  ranks.of_query = {{1, 4}};
  const auto all = [](std::size_t) { return true; };
  // Recall 1/2 with precision 1, recall 1 with precision 2/4; none at 1/4.
  const auto without = AP::precision_recall(ranks, all, AP::Query_counts::NO, 4);
  EXPECT_EQ(without.recalls, (std::vector<double>{0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(without.numbers_of_queries, (std::vector<std::size_t>{0, 1, 1, 1}));
  EXPECT_DOUBLE_EQ(without.precisions[1], 1);
  EXPECT_NEAR(without.precisions[2], 0.75, 1e-12);
  EXPECT_DOUBLE_EQ(without.precisions[3], 0.5);
  // The query is first: recall 1/3 and 2/3 with precision 1, recall 1 with precision 3/5.
  const auto with = AP::precision_recall(ranks, all, AP::Query_counts::YES, 4);
  EXPECT_EQ(with.numbers_of_queries, (std::vector<std::size_t>{0, 1, 1, 1}));
  EXPECT_DOUBLE_EQ(with.precisions[1], 1);
  EXPECT_NEAR(with.precisions[2], 0.9, 1e-12); // a quarter of the way from 2/3 to 1
  EXPECT_DOUBLE_EQ(with.precisions[3], 0.6);
  EXPECT_THROW(AP::precision_recall(ranks, all, AP::Query_counts::NO, 0), std::invalid_argument);
}

TEST(Precision_recall, chooses_queries)
{
  const AP::Relevant_ranks ranks = ranks_on_line();
  const auto last = [](std::size_t i) { return i == 2 || i == 3; };
  const auto curve = AP::precision_recall(ranks, last, AP::Query_counts::NO, 2);
  EXPECT_EQ(curve.numbers_of_queries, (std::vector<std::size_t>{2, 2}));
  EXPECT_DOUBLE_EQ(curve.precisions[0], 1. / 5);
  EXPECT_DOUBLE_EQ(curve.precisions[1], 2. / 6);
}

/// a file that is there as long as the test.
class File
{
public:
  explicit File(const std::string& name, const std::string& content = "")
      : m_path(std::filesystem::temp_directory_path() / ("area_projection_test_retrieval_" + name))
  {
    std::ofstream(m_path, std::ios_base::binary) << content;
  }
  ~File() { std::filesystem::remove(m_path); }
  std::string name() const { return m_path.string(); }

private:
  std::filesystem::path m_path;
};

const std::vector<std::string> shapes{"set/T5.obj", "set/T12.obj", "T1.obj", "T7.obj"};

void expect_labels(const AP::Class_labels& labels)
{
  ASSERT_EQ(labels.size(), 4u);
  EXPECT_EQ(labels.number_of_classes(), 2u);
  EXPECT_EQ(labels.name(labels[0]), "alien");
  EXPECT_EQ(labels[0], labels[1]);
  EXPECT_EQ(labels.name(labels[2]), "ants");
  EXPECT_EQ(labels[3], AP::Class_labels::none);
  EXPECT_EQ(labels.size_of_class(labels[0]), 2u);
}

TEST(Class_labels, are_read_from_the_classification_of_the_princeton_benchmark)
{
  const File file("ok.cla", "PSB 1\n3 3\n\nanimal 0 0\n\nalien animal 2\n5\n012\n\nants 0 1\n1\n");
  const IO::Label_list list = IO::read_class_labels(file.name());
  EXPECT_EQ(list.classes.size(), 3u);
  const AP::Class_labels labels =
      IO::labels_of({"set/T5.obj", "set/T012.obj", "T1.obj", "T7.obj"}, {list.classes, false});
  EXPECT_EQ(labels.number_of_classes(), 0u); // only numbers are looked up by number
  const File plain("plain.cla", "PSB 1\n2 3\nalien 0 2\n5 12\nants 0 1\n1");
  expect_labels(IO::labels_of(shapes, IO::read_class_labels(plain.name())));
}

TEST(Class_labels, are_read_from_a_table)
{
  const File file("ok.csv", "file,class\nT5.obj,alien\nset/T12.obj,alien\nT1,ants\n");
  expect_labels(IO::labels_of(shapes, IO::read_class_labels(file.name())));
}

TEST(Class_labels, files_that_are_none_are_refused)
{
  for(const char* text :
      {"", "file\nx\n", "file,class\n,a\n", "PSB 2\n", "PSB 1\n1 2\na 0 1\n5\n", "PSB 1\n1 1\na 0",
       "PSB 1\n1 1\na 0 1\n5\n6\n", "PSB 1\n1 1\na 0 x\n5\n", "PSB 1\n1 -1\n"}) {
    const File file("bad", text);
    EXPECT_THROW(IO::read_class_labels(file.name()), std::runtime_error) << text;
  }
  EXPECT_THROW(IO::read_class_labels("/no/such/file"), std::runtime_error);
  EXPECT_THROW(IO::labels_of({"x"}, {{{"x", "a"}, {"x", "b"}}, false}), std::invalid_argument);
}

TEST(Float_matrix, is_written_and_read)
{
  AP::Distance_matrix matrix(3);
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      matrix[i][j] = float(i) + 0.1f * float(j);
  const File file("matrix");
  IO::write_float_matrix(file.name(), matrix);
  EXPECT_EQ(std::filesystem::file_size(file.name()), 36u);
  EXPECT_EQ(IO::read_float_matrix(file.name()).values(), matrix.values());
  std::ostringstream one; // 1 is 0x3f800000, its lowest byte first
  IO::write_float_matrix(one, AP::Distance_matrix(1, {1.f}));
  EXPECT_EQ(one.str(), std::string("\0\0\x80\x3f", 4));
  const File odd("odd", "12345678");
  EXPECT_THROW(IO::read_float_matrix(odd.name()), std::runtime_error);
}

TEST(Shape_descriptors_CSV, is_written_and_read)
{
  std::ostringstream out;
  IO::write_shape_descriptors_CSV_header(out, 4);
  const Histogram a{0.1f, 1.f / 3, 0, 1e-30f}, b{1, 2, 3, 4};
  IO::write_shape_descriptor_CSV_row(out, "a, with a comma", a);
  IO::write_shape_descriptor_CSV_row(out, "b", b);
  EXPECT_EQ(out.str().substr(0, 17), "file,h0,h1,h2,h3\n");
  std::istringstream in(out.str());
  const IO::Named_descriptors read = IO::read_shape_descriptors_CSV(in, "table", 2);
  EXPECT_EQ(read.names, (std::vector<std::string>{"a, with a comma", "b"}));
  ASSERT_EQ(read.table.size(), 2u);
  EXPECT_EQ(Histogram(read.table[0], read.table[0] + 4), a);
  EXPECT_EQ(Histogram(read.table[1], read.table[1] + 4), b);
  for(const char* text : {"", "name,h0\nx,1\n", "file,h0,h1\nx,1\n", "file,h0,h1\nx,1,y\n",
                          "file,h0,h1\nx,1,-1\n", "file,h0,h1\nx,1,nan\n"}) {
    std::istringstream bad(text);
    EXPECT_THROW(IO::read_shape_descriptors_CSV(bad, "table", 1), std::runtime_error) << text;
  }
}

} // namespace
