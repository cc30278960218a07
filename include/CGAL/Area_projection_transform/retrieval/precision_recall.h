// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_PRECISION_RECALL_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_PRECISION_RECALL_H

#include <CGAL/Area_projection_transform/retrieval/evaluation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief the two ways to draw curves of precision over recall, of a query of a class of `C` shapes.
enum class Query_counts {
  NO, ///< the query is not in the list: the `j`-th that is found has the recall `j/(C-1)` and the precision `j/rank`
  /// \brief the query is the first of the list: the `j`-th has the recall `j/C`. So do the tools of the Princeton shape
  /// benchmark; the precision at the recall `1/C` is then always 1.
  YES
};

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief a curve of precision over recall, at equal steps of the recall.
struct Precision_recall
{
  std::vector<double> recalls;                 ///< ascending, in (0, 1]
  std::vector<double> precisions;              ///< 0 where no query has that little recall
  std::vector<std::size_t> numbers_of_queries; ///< that count at each recall
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief the precision of a query at a recall, between that of its neighbours; negative if the recall is less than
/// that of the first shape.
inline double precision_at(const std::vector<std::uint32_t>& ranks, double recall,
                           Query_counts query_counts)
{
  const std::size_t shift = query_counts == Query_counts::YES ? 1 : 0;
  const std::size_t found = ranks.size() + shift; // in the end
  const auto precision = [&](std::size_t j) {     // of the first j
    return j <= shift ? 1. : double(j) / double(ranks[j - 1 - shift] + shift);
  };
  const double place = recall * double(found) + 1e-9; // a recall that is met is met
  const std::size_t j = std::min(std::size_t(place), found);
  if(j == 0)
    return -1;
  const double part = std::max(0., place - 1e-9 - double(j));
  return j == found ? precision(j) : (1 - part) * precision(j) + part * precision(j + 1);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief returns the precision in the mean over some queries at the recalls `1/samples`, `2/samples`, …, 1, with
/// straight lines between what a query has. Queries whose class is too small to have so little recall do not count there.
/// \param ranks from `relevant_ranks()`
/// \param is_query `is_query(i)` tells whether shape `i`, which has a class, counts: all of a class, for its curve
/// \param query_counts which convention
/// \param samples the number of recalls, positive
/// \throw std::invalid_argument if `samples` is zero
template <class IsQuery>
Precision_recall precision_recall(const Relevant_ranks& ranks, IsQuery&& is_query,
                                  Query_counts query_counts, std::size_t samples = 20)
{
  if(samples == 0)
    throw std::invalid_argument("samples is 0: must be positive");
  Precision_recall curve;
  for(std::size_t s = 1; s <= samples; ++s) {
    const double recall = double(s) / double(samples);
    double sum = 0;
    std::size_t number = 0;
    for(std::size_t i = 0; i < ranks.of_query.size(); ++i) {
      if(ranks.of_query[i].empty() || !is_query(i))
        continue;
      const double precision = internal::precision_at(ranks.of_query[i], recall, query_counts);
      if(precision >= 0) {
        sum += precision;
        ++number;
      }
    }
    curve.recalls.push_back(recall);
    curve.precisions.push_back(number > 0 ? sum / double(number) : 0);
    curve.numbers_of_queries.push_back(number);
  }
  return curve;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_PRECISION_RECALL_H
