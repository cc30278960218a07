// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "damage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace Paper {

namespace {

struct Edge
{
  std::uint32_t first, second; // ascending
  std::uint32_t face;

  bool has_ends_of(const Edge& other) const
  {
    return first == other.first && second == other.second;
  }
};

/// the edges of all faces, those with the same ends beside each other.
std::vector<Edge> sorted_edges(const Soup& soup)
{
  std::vector<Edge> edges;
  edges.reserve(3 * soup.triangles.size());
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    for(int i = 0; i < 3; ++i) {
      const auto [a, b] =
          std::minmax(soup.triangles[f][std::size_t(i)], soup.triangles[f][std::size_t(i + 1) % 3]);
      edges.push_back({a, b, std::uint32_t(f)});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.first, a.second, a.face} < std::array{b.first, b.second, b.face};
  });
  return edges;
}

/// for each face, those that share an edge with it.
std::vector<std::vector<std::uint32_t>> neighbours_of_faces(const Soup& soup)
{
  std::vector<std::vector<std::uint32_t>> neighbours(soup.triangles.size());
  const std::vector<Edge> edges = sorted_edges(soup);
  for(std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while(end < edges.size() && edges[end].has_ends_of(edges[begin]))
      ++end;
    for(std::size_t i = begin; i < end; ++i)
      for(std::size_t j = begin; j < end; ++j)
        if(edges[i].face != edges[j].face)
          neighbours[edges[i].face].push_back(edges[j].face);
  }
  return neighbours;
}

std::size_t number_to_remove(const Soup& soup, double fraction)
{
  if(!(fraction >= 0 && fraction <= 1))
    throw std::invalid_argument("fraction is " + std::to_string(fraction) +
                                ": must be between 0 and 1");
  return std::size_t(std::llround(fraction * double(soup.triangles.size())));
}

Soup without(const Soup& soup, const std::vector<bool>& is_removed)
{
  Soup rest;
  rest.points = soup.points;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    if(!is_removed[f])
      rest.triangles.push_back(soup.triangles[f]);
  return rest;
}

/// takes an element out of a vector, in constant time and so that the order of the others changes.
template <class T>
T take(std::vector<T>& elements, std::size_t place)
{
  std::swap(elements[place], elements.back());
  const T element = elements.back();
  elements.pop_back();
  return element;
}

/// removes faces, one after the other.
class Hole_digger
{
public:
  Hole_digger(const Soup& soup, std::size_t holes, std::uint64_t seed)
      : m_neighbours(neighbours_of_faces(soup))
      , m_is_removed(soup.triangles.size(), false)
      , m_rims(holes)
      , m_random(seed)
  {}

  /// \pre a face is left
  void grow(std::size_t hole)
  {
    std::vector<std::uint32_t>& rim = m_rims[hole];
    while(!rim.empty()) {
      const std::uint32_t face = take(rim, m_random.below(rim.size()));
      if(!m_is_removed[face]) {
        remove(face, rim);
        return;
      }
    }
    std::size_t face = m_random.below(m_is_removed.size());
    while(m_is_removed[face])
      face = m_random.below(m_is_removed.size());
    remove(std::uint32_t(face), rim);
  }

  const std::vector<bool>& is_removed() const { return m_is_removed; }

private:
  void remove(std::uint32_t face, std::vector<std::uint32_t>& rim)
  {
    m_is_removed[face] = true;
    for(std::uint32_t neighbour : m_neighbours[face])
      if(!m_is_removed[neighbour])
        rim.push_back(neighbour);
  }

  std::vector<std::vector<std::uint32_t>> m_neighbours;
  std::vector<bool> m_is_removed;
  std::vector<std::vector<std::uint32_t>>
      m_rims; // of each hole; a face may be there more than once
  Random m_random;
};

} // namespace

double area(const Soup& soup)
{
  double sum = 0;
  for(const Soup::Triangle& t : soup.triangles)
    sum += std::sqrt(CGAL::squared_area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
  return sum;
}

double mean_edge_length(const Soup& soup)
{
  const std::vector<Edge> edges = sorted_edges(soup);
  double sum = 0;
  std::size_t number = 0;
  for(std::size_t e = 0; e < edges.size(); ++e)
    if(e == 0 || !edges[e].has_ends_of(edges[e - 1])) {
      sum += std::sqrt(
          CGAL::squared_distance(soup.points[edges[e].first], soup.points[edges[e].second]));
      ++number;
    }
  return number > 0 ? sum / double(number) : 0.;
}

double Random::normal()
{
  if(std::exchange(m_has_spare, false))
    return m_spare;
  double x, y, square;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    square = x * x + y * y;
  } while(square >= 1 || square == 0);
  const double factor = std::sqrt(-2 * std::log(square) / square);
  m_spare = factor * y;
  m_has_spare = true;
  return factor * x;
}

Soup remove_random_faces(const Soup& soup, double fraction, std::uint64_t seed)
{
  const std::size_t number = number_to_remove(soup, fraction);
  std::vector<std::size_t> left(soup.triangles.size());
  std::iota(left.begin(), left.end(), std::size_t(0));
  std::vector<bool> is_removed(soup.triangles.size(), false);
  Random random(seed);
  for(std::size_t i = 0; i < number; ++i)
    is_removed[take(left, random.below(left.size()))] = true;
  return without(soup, is_removed);
}

Soup remove_holes(const Soup& soup, double fraction, std::size_t number, std::uint64_t seed)
{
  if(number == 0)
    throw std::invalid_argument("number of holes is 0: must be at least 1");
  const std::size_t faces = number_to_remove(soup, fraction);
  Hole_digger digger(soup, number, seed);
  for(std::size_t i = 0; i < faces; ++i)
    digger.grow(i % number);
  return without(soup, digger.is_removed());
}

Soup add_noise(const Soup& soup, double ratio, std::uint64_t seed)
{
  const double deviation = ratio * mean_edge_length(soup);
  Soup noisy = soup;
  Random random(seed);
  for(Point_3& p : noisy.points) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    p = p + deviation * Vector_3(x, y, z);
  }
  return noisy;
}

} // namespace Paper
