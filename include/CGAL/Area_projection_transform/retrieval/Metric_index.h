// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_METRIC_INDEX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_METRIC_INDEX_H

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/retrieval/Descriptor_table.h>
#include <CGAL/Area_projection_transform/retrieval/Histogram_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief a shape that was found.
struct Neighbor
{
  std::uint32_t index; ///< in the table
  double distance;     ///< from what was asked for

  friend bool operator<(const Neighbor& a, const Neighbor& b)
  {
    return a.distance < b.distance || (a.distance == b.distance && a.index < b.index);
  }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the nearest of those that were offered, no more than some number.
class Nearest_list
{
public:
  explicit Nearest_list(std::size_t number) : m_number(number) { m_heap.reserve(number + 1); }

  /// no shape at a larger distance is of interest.
  double limit() const
  {
    return m_heap.size() < m_number ? std::numeric_limits<double>::infinity()
                                    : m_heap.front().distance;
  }

  void offer(const Neighbor& neighbor)
  {
    if(m_heap.size() == m_number && !(neighbor < m_heap.front()))
      return;
    m_heap.push_back(neighbor);
    std::push_heap(m_heap.begin(), m_heap.end());
    if(m_heap.size() > m_number) {
      std::pop_heap(m_heap.begin(), m_heap.end());
      m_heap.pop_back();
    }
  }

  std::vector<Neighbor> take()
  {
    std::sort_heap(m_heap.begin(), m_heap.end());
    return std::move(m_heap);
  }

private:
  std::size_t m_number;
  std::vector<Neighbor> m_heap; // the farthest on top
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief returns the `number` shapes of a table that are nearest to a descriptor, the nearest first, by comparing it with
/// all. Of equal distances the lower index comes first.
/// \param table the descriptors of the shapes
/// \param distance compares two of them
/// \param query as many numbers as a row of the table has
/// \param number how many are wanted
/// \pre `query` has as many numbers as the rows of the table
inline std::vector<Neighbor> nearest_by_scan(const Descriptor_table& table,
                                             const Histogram_distance& distance, const float* query,
                                             std::size_t number)
{
  internal::Nearest_list nearest(std::min(number, table.size()));
  if(number > 0)
    for(std::size_t i = 0; i < table.size(); ++i)
      nearest.offer({std::uint32_t(i), distance(query, table[i], nearest.limit())});
  return nearest.take();
}

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief finds the nearest shapes of a large table without comparing with all: a vantage-point tree.
///
/// Each node has a vantage point, one of its shapes; of the others, the half that is nearer to it and the half that is
/// farther become its children. By the triangle inequality a child is left out if the query is too far from the ring in
/// which its shapes lie around any of the vantage points above; and so is a single shape, since it remembers its distances
/// from some of these. What is found is exactly what `nearest_by_scan()` finds, to the last bit.
class Metric_index
{
public:
  /// \param table the shapes; copied, in another order
  /// \param distance which distance; if it is not a metric, its root is what obeys the triangle inequality
  /// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  /// `CGAL::Parallel_if_available_tag`; the index does not depend on it
  /// \throw std::invalid_argument if the distance is for descriptors of another length, or there are 2^32 shapes or more
  ///
  /// Complexity: `n log n` distances for `n` shapes.
  template <class ConcurrencyTag>
  Metric_index(ConcurrencyTag, const Descriptor_table& table, const Histogram_distance& distance)
      : m_distance(distance), m_rows(table.dimension(), table.block_size())
  {
    if(distance.dimension() != table.dimension())
      throw std::invalid_argument("distance is for descriptors of " +
                                  std::to_string(distance.dimension()) +
                                  " numbers: the table has " + std::to_string(table.dimension()));
    if(table.size() >= std::numeric_limits<std::uint32_t>::max())
      throw std::invalid_argument("table has " + std::to_string(table.size()) +
                                  " shapes: must have less than 2^32");
    std::vector<Item> items(table.size());
    for(std::size_t i = 0; i < items.size(); ++i)
      items[i].index = std::uint32_t(i);
    if(!items.empty())
      build<ConcurrencyTag>(table, items, 0, items.size(), 0);
    m_rows.reserve(items.size());
    for(const Item& item : items)
      m_rows.push_back(row_of(table, item.index));
    m_items = std::move(items);
  }

  /// the same, built by one thread.
  Metric_index(const Descriptor_table& table, const Histogram_distance& distance)
      : Metric_index(CGAL::Sequential_tag(), table, distance)
  {}

  /// how many shapes it finds.
  std::size_t size() const { return m_items.size(); }

  /// \brief returns the `number` shapes that are nearest to a descriptor, the nearest first. May be called concurrently.
  /// \param query as many numbers as a row of the table has
  /// \param number how many are wanted
  /// \param comparisons is increased by the number of distances that were computed, if it is not null
  std::vector<Neighbor> nearest(const float* query, std::size_t number,
                                std::size_t* comparisons = nullptr) const
  {
    Search search{query, internal::Nearest_list(std::min(number, size())), {}, 0};
    if(number > 0 && size() > 0)
      visit(search, 0, 0);
    if(comparisons)
      *comparisons += search.comparisons;
    return search.nearest.take();
  }

private:
  /// \cond SKIP_IN_MANUAL
  static constexpr std::size_t size_of_leaf = 24;
  static constexpr std::size_t remembered = 8; ///< vantage points, from the lowest upwards

  /// a shape, and how far it is from vantage points: that of depth `d` at place `d % remembered`.
  struct Item
  {
    std::uint32_t index = 0;
    std::array<float, remembered> distances{};
  };

  /// the shapes from `first` to `last`; the first one is the vantage point, unless it is a leaf.
  struct Node
  {
    std::size_t first, last;
    std::array<std::uint32_t, 2> children{{0, 0}};                ///< both zero: a leaf
    std::array<std::array<double, 2>, 2> rings{{{0, 0}, {0, 0}}}; ///< least and largest distances
    bool is_leaf() const { return children[0] == 0; }
  };

  struct Search
  {
    const float* query;
    internal::Nearest_list nearest;
    std::vector<double> from_vantage_points; ///< of the nodes above
    std::size_t comparisons;
  };

  static std::vector<float> row_of(const Descriptor_table& table, std::size_t row)
  {
    return std::vector<float>(table[row], table[row] + table.dimension());
  }

  /// \brief makes the vantage point that which is farthest from the one above: seen from the rim, distances differ
  /// most.
  static void choose_vantage_point(std::vector<Item>& items, std::size_t first, std::size_t last,
                                   std::size_t depth)
  {
    if(depth == 0)
      return;
    const std::size_t above = (depth - 1) % remembered;
    const auto best = std::max_element(
        items.begin() + std::ptrdiff_t(first), items.begin() + std::ptrdiff_t(last),
        [above](const Item& a, const Item& b) { return a.distances[above] < b.distances[above]; });
    std::swap(items[first], *best);
  }

  template <class ConcurrencyTag>
  std::uint32_t build(const Descriptor_table& table, std::vector<Item>& items, std::size_t first,
                      std::size_t last, std::size_t depth)
  {
    const std::uint32_t number = std::uint32_t(m_nodes.size());
    m_nodes.push_back({first, last});
    if(last - first <= size_of_leaf)
      return number;
    choose_vantage_point(items, first, last, depth);
    const float* const vantage = table[items[first].index];
    const std::size_t place = depth % remembered;
    internal::for_each_index<ConcurrencyTag>(last - first - 1, [&](std::size_t i) {
      Item& item = items[first + 1 + i];
      item.distances[place] = float(m_distance.metric(m_distance(vantage, table[item.index])));
    });
    const std::size_t middle = first + 1 + (last - first) / 2;
    std::nth_element(
        items.begin() + std::ptrdiff_t(first + 1), items.begin() + std::ptrdiff_t(middle),
        items.begin() + std::ptrdiff_t(last), [place](const Item& a, const Item& b) {
          return std::pair(a.distances[place], a.index) < std::pair(b.distances[place], b.index);
        });
    const std::array<std::size_t, 3> ends{first + 1, middle, last};
    for(std::size_t c = 0; c < 2; ++c) {
      double least = std::numeric_limits<double>::infinity(), largest = 0;
      for(std::size_t i = ends[c]; i < ends[c + 1]; ++i) {
        least = std::min(least, double(items[i].distances[place]));
        largest = std::max(largest, double(items[i].distances[place]));
      }
      const std::uint32_t child =
          build<ConcurrencyTag>(table, items, ends[c], ends[c + 1], depth + 1);
      m_nodes[number].children[c] = child;
      m_nodes[number].rings[c] = {least, largest};
    }
    return number;
  }

  /// \brief what a bound has to be above the limit, for rounding: distances are remembered as floats, and sums in
  /// distances have errors.
  static double slack(double a, double b) { return 1e-6 * (a + b); }

  /// offers a shape; returns its distance as a metric, which is a bound if it exceeds the limit.
  double offer(Search& search, std::size_t item, double limit) const
  {
    const double distance = m_distance(search.query, m_rows[item], limit);
    ++search.comparisons;
    search.nearest.offer({m_items[item].index, distance});
    return m_distance.metric(distance);
  }

  void visit(Search& search, std::uint32_t number, std::size_t depth) const
  {
    const Node& node = m_nodes[number];
    if(node.is_leaf()) {
      visit_leaf(search, node, depth);
      return;
    }
    const double d = offer(search, node.first, std::numeric_limits<double>::infinity());
    search.from_vantage_points.push_back(d);
    const std::size_t nearer = d > 0.5 * (node.rings[0][1] + node.rings[1][0]) ? 1 : 0;
    for(std::size_t c : {nearer, 1 - nearer}) {
      const auto& [least, largest] = node.rings[c];
      const double bound = std::max(least - d, d - largest) - slack(d, largest);
      if(bound <= m_distance.metric(search.nearest.limit()))
        visit(search, node.children[c], depth + 1);
    }
    search.from_vantage_points.pop_back();
  }

  void visit_leaf(Search& search, const Node& node, std::size_t depth) const
  {
    const std::size_t known = std::min(depth, remembered);
    for(std::size_t i = node.first; i < node.last; ++i) {
      const double limit = search.nearest.limit(), limit_as_metric = m_distance.metric(limit);
      const auto is_too_far = [&](std::size_t up) {
        const std::size_t above = depth - 1 - up;
        const double a = search.from_vantage_points[above],
                     b = double(m_items[i].distances[above % remembered]);
        return std::abs(a - b) - slack(a, b) > limit_as_metric;
      };
      bool is_candidate = true;
      for(std::size_t up = 0; up < known && is_candidate; ++up)
        is_candidate = !is_too_far(up);
      if(is_candidate)
        offer(search, i, limit);
    }
  }

  Histogram_distance m_distance;
  Descriptor_table m_rows; ///< in the order of the items
  std::vector<Item> m_items;
  std::vector<Node> m_nodes;
  /// \endcond
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_METRIC_INDEX_H
