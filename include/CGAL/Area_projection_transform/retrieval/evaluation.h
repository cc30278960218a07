// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_EVALUATION_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_EVALUATION_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/retrieval/Class_labels.h>
#include <CGAL/Area_projection_transform/retrieval/Descriptor_table.h>
#include <CGAL/Area_projection_transform/retrieval/Distance_matrix.h>
#include <CGAL/Area_projection_transform/retrieval/Histogram_distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief how well a query is answered, by the measures of the Princeton shape benchmark and the contests after it:
/// all between 0 and 1, and 1 is best, but for the E-measure.
///
/// For a query of a class of `C` shapes, among `N` in all, the `N - 1` others are ranked by their distance.
struct Retrieval_scores
{
  double nearest_neighbor = 0; ///< whether the first one is of the class
  double first_tier = 0;       ///< how many of the class are among the first `C - 1`
  double second_tier = 0;      ///< how many are among the first `2 (C - 1)`
  /// the harmonic mean of precision and recall of the first 32.
  double e_measure = 0;
  /// what the E-measure is if all of the class come first: less than 1 unless the class has 33 shapes.
  double e_ceiling = 0;
  /// \brief the discounted cumulative gain: those of the class count one over the logarithm, to the base 2, of their
  /// rank (the first one and the second one count 1), relative to the best order.
  double discounted_gain = 0;

  friend Retrieval_scores operator+(const Retrieval_scores& a, const Retrieval_scores& b)
  {
    return {a.nearest_neighbor + b.nearest_neighbor,
            a.first_tier + b.first_tier,
            a.second_tier + b.second_tier,
            a.e_measure + b.e_measure,
            a.e_ceiling + b.e_ceiling,
            a.discounted_gain + b.discounted_gain};
  }

  friend Retrieval_scores operator/(const Retrieval_scores& a, double number)
  {
    return {a.nearest_neighbor / number, a.first_tier / number, a.second_tier / number,
            a.e_measure / number,        a.e_ceiling / number,  a.discounted_gain / number};
  }
};

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief for each shape as a query, at which ranks (1, 2, …) the others of its class come, ascending. Everything that
/// is said of retrieval follows from these.
struct Relevant_ranks
{
  std::size_t number_of_shapes = 0;                 ///< all, the query included
  std::vector<std::vector<std::uint32_t>> of_query; ///< empty for a shape without a class
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the ranks of those of the class of `query`, by distance and then by index; the query itself is not ranked.
inline std::vector<std::uint32_t> relevant_ranks_of(std::size_t query, const float* distances,
                                                    const Class_labels& labels)
{
  std::vector<std::uint32_t> ranks;
  if(labels[query] == Class_labels::none)
    return ranks;
  std::vector<std::uint32_t> order(labels.size());
  std::iota(order.begin(), order.end(), 0u);
  order.erase(order.begin() + std::ptrdiff_t(query));
  std::stable_sort(order.begin(), order.end(), [distances](std::uint32_t a, std::uint32_t b) {
    return distances[a] < distances[b];
  });
  for(std::size_t r = 0; r < order.size(); ++r)
    if(labels[order[r]] == labels[query])
      ranks.push_back(std::uint32_t(r + 1));
  return ranks;
}

inline void check_number_of_labels(const Class_labels& labels, std::size_t shapes)
{
  if(labels.size() != shapes)
    throw std::invalid_argument("labels has " + std::to_string(labels.size()) +
                                " elements: there are " + std::to_string(shapes) + " shapes");
}

/// the harmonic mean of precision and recall.
inline double e_measure(std::size_t hits, std::size_t listed, std::size_t relevant)
{
  return 2. * double(hits) / double(listed + relevant);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief returns where those of the same class come, from the distances of all shapes.
///
/// Of equal distances the shape of the lower index comes first. Distances from a shape to itself do not matter.
/// \param distances those of all pairs of shapes
/// \param labels the classes of the shapes
/// \throw std::invalid_argument if there are not as many labels as shapes, or a distance is not a number
template <class ConcurrencyTag = CGAL::Sequential_tag>
Relevant_ranks relevant_ranks(const Distance_matrix& distances, const Class_labels& labels)
{
  internal::check_number_of_labels(labels, distances.size());
  for(std::size_t i = 0; i < distances.values().size(); ++i)
    if(std::isnan(distances.values()[i]))
      throw std::invalid_argument("distances[" + std::to_string(i / distances.size()) + "][" +
                                  std::to_string(i % distances.size()) + "] is not a number");
  Relevant_ranks ranks;
  ranks.number_of_shapes = labels.size();
  ranks.of_query.resize(labels.size());
  internal::for_each_index<ConcurrencyTag>(labels.size(), [&](std::size_t i) {
    ranks.of_query[i] = internal::relevant_ranks_of(i, distances[i], labels);
  });
  return ranks;
}

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief the same from descriptors, without the matrix, which takes 4 bytes for each pair.
/// \param table the descriptors of the shapes
/// \param distance compares two of them
/// \param labels the classes of the shapes
/// \throw std::invalid_argument if there are not as many labels as shapes, or the distance is for others
template <class ConcurrencyTag = CGAL::Sequential_tag>
Relevant_ranks relevant_ranks(const Descriptor_table& table, const Histogram_distance& distance,
                              const Class_labels& labels)
{
  internal::check_number_of_labels(labels, table.size());
  if(distance.dimension() != table.dimension())
    throw std::invalid_argument("distance is for descriptors of " +
                                std::to_string(distance.dimension()) + " numbers: the table has " +
                                std::to_string(table.dimension()));
  Relevant_ranks ranks;
  ranks.number_of_shapes = labels.size();
  ranks.of_query.resize(labels.size());
  internal::for_each_index<ConcurrencyTag>(labels.size(), [&](std::size_t i) {
    std::vector<float> row(table.size());
    for(std::size_t j = 0; j < table.size(); ++j)
      row[j] = float(distance(table[i], table[j]));
    ranks.of_query[i] = internal::relevant_ranks_of(i, row.data(), labels);
  });
  return ranks;
}

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief returns the scores of a query.
/// \param ranks of the others of its class, ascending, at least one
/// \param number_of_shapes in all, the query included
inline Retrieval_scores scores_of_query(const std::vector<std::uint32_t>& ranks,
                                        std::size_t number_of_shapes)
{
  const std::size_t relevant = ranks.size(), others = number_of_shapes - 1;
  const auto hits_within = [&ranks](std::size_t length) {
    return std::size_t(std::upper_bound(ranks.begin(), ranks.end(), length) - ranks.begin());
  };
  const auto gain = [](std::size_t rank) { return rank < 2 ? 1. : 1. / std::log2(double(rank)); };
  const std::size_t listed = std::min<std::size_t>(32, others);
  Retrieval_scores scores; ///< their means
  scores.nearest_neighbor = ranks.front() == 1 ? 1 : 0;
  scores.first_tier = double(hits_within(relevant)) / double(relevant);
  scores.second_tier = double(hits_within(2 * relevant)) / double(relevant);
  scores.e_measure = internal::e_measure(hits_within(listed), listed, relevant);
  scores.e_ceiling = internal::e_measure(std::min(relevant, listed), listed, relevant);
  double found = 0, best = 0;
  for(std::size_t i = 0; i < relevant; ++i) {
    found += gain(ranks[i]);
    best += gain(i + 1);
  }
  scores.discounted_gain = found / best;
  return scores;
}

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief the scores of all queries of a class, in the mean.
struct Class_scores
{
  std::string name;                  ///< of the class
  std::size_t number_of_queries = 0; ///< how many of its shapes were asked for
  Retrieval_scores scores;           ///< their means
};

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief the scores of a set of labelled shapes.
struct Retrieval_evaluation
{
  Retrieval_scores micro;            ///< the mean over the queries, as the contests take it
  Retrieval_scores macro;            ///< the mean over the classes of their means
  std::size_t number_of_queries = 0; ///< how many shapes were asked for: those of the `classes`
  std::vector<Class_scores> classes; ///< those with queries, in the order of their numbers
};

/// \ingroup PkgAreaProjectionTransformRetrieval
/// the number of shapes from which on those of a class are queries, as in the Princeton tools: smaller ones are found
/// by others but ask nothing.
inline constexpr std::size_t default_smallest_class = 3;

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief returns the scores of all queries, in the mean and for each class.
/// \param ranks from `relevant_ranks()`
/// \param labels the classes
/// \param smallest_class shapes of classes that have fewer are no queries, nor are those without a class; at least 2
/// \throw std::invalid_argument if `smallest_class` is less than 2, there are not as many labels as ranks, or no query
/// is left
inline Retrieval_evaluation evaluate_retrieval(const Relevant_ranks& ranks,
                                               const Class_labels& labels,
                                               std::size_t smallest_class = default_smallest_class)
{
  internal::check_number_of_labels(labels, ranks.of_query.size());
  if(smallest_class < 2)
    throw std::invalid_argument("smallest_class is " + std::to_string(smallest_class) +
                                ": must be at least 2, since a shape does not find itself");
  std::vector<Class_scores> classes(labels.number_of_classes());
  Retrieval_evaluation result;
  for(std::size_t i = 0; i < labels.size(); ++i) {
    if(labels[i] == Class_labels::none || labels.size_of_class(labels[i]) < smallest_class)
      continue;
    const Retrieval_scores scores = scores_of_query(ranks.of_query[i], ranks.number_of_shapes);
    Class_scores& of_class = classes[labels[i]];
    ++of_class.number_of_queries;
    of_class.scores = of_class.scores + scores;
    ++result.number_of_queries;
    result.micro = result.micro + scores;
  }
  if(result.number_of_queries == 0)
    throw std::invalid_argument("labels has no class of " + std::to_string(smallest_class) +
                                " shapes or more: there is no query");
  result.micro = result.micro / double(result.number_of_queries);
  for(std::size_t c = 0; c < classes.size(); ++c)
    if(classes[c].number_of_queries > 0) {
      classes[c].name = labels.name(c);
      classes[c].scores = classes[c].scores / double(classes[c].number_of_queries);
      result.macro = result.macro + classes[c].scores;
      result.classes.push_back(std::move(classes[c]));
    }
  result.macro = result.macro / double(result.classes.size());
  return result;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_EVALUATION_H
