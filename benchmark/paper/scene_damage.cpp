// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene_damage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace Paper {

namespace {

constexpr std::uint32_t is_gone = std::numeric_limits<std::uint32_t>::max();

/// for each face, its place among those that are left, which are in the same order.
std::vector<std::uint32_t> places(const std::vector<Soup::Triangle>& faces,
                                  const std::vector<Soup::Triangle>& left)
{
  std::vector<std::uint32_t> places(faces.size(), is_gone);
  std::uint32_t next = 0; // no two faces have the same vertices
  for(std::size_t f = 0; f < faces.size(); ++f)
    if(next < left.size() && left[next] == faces[f])
      places[f] = next++;
  return places;
}

/// the scene with some of its faces, in the same order.
Scene with_fewer_faces(const Scene& scene, Soup rest)
{
  const std::vector<std::uint32_t> new_places = places(scene.soup.triangles, rest.triangles);
  Scene smaller{std::move(rest), scene.truths};
  for(Truth& truth : smaller.truths) {
    std::vector<std::uint32_t> left;
    for(std::uint32_t face : truth.faces)
      if(new_places[face] != is_gone)
        left.push_back(new_places[face]);
    truth.faces = std::move(left);
  }
  return smaller;
}

/// for each point, the lengths of the edges there, each edge once.
std::vector<std::vector<double>> lengths_of_edges(const Soup& soup)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for(const auto& [a, b, c] : soup.triangles)
    for(const auto& edge : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)})
      edges.insert(edge);
  std::vector<std::vector<double>> lengths(soup.points.size());
  for(const auto& [a, b] : edges) {
    const double length = std::sqrt(CGAL::squared_distance(soup.points[a], soup.points[b]));
    lengths[a].push_back(length);
    lengths[b].push_back(length);
  }
  return lengths;
}

/// \pre there is a length
double mean_without_long_ones(const std::vector<double>& lengths)
{
  const double largest = 3 * *std::min_element(lengths.begin(), lengths.end());
  double sum = 0;
  for(double length : lengths)
    sum += std::min(length, largest);
  return sum / double(lengths.size());
}

Vector_3 in_unit_ball(Random& random)
{
  for(;;) {
    const double x = 2 * random.uniform() - 1, y = 2 * random.uniform() - 1,
                 z = 2 * random.uniform() - 1;
    const Vector_3 v(x, y, z);
    if(v.squared_length() <= 1)
      return v;
  }
}

/// seeds that have nothing in common, out of one.
class Seeds
{
public:
  explicit Seeds(std::uint64_t seed) : m_random(seed) {}

  std::uint64_t next() { return std::uint64_t(m_random.uniform() * 0x1p53); }

private:
  Random m_random;
};

/// a soup with some of the faces only.
Soup part_of(const Soup& soup, const std::vector<std::uint32_t>& faces)
{
  Soup part;
  part.points = soup.points;
  for(std::uint32_t face : faces)
    part.triangles.push_back(soup.triangles[face]);
  return part;
}

} // namespace

Scene remove_random_faces(const Scene& scene, double fraction, std::uint64_t seed)
{
  return with_fewer_faces(scene, remove_random_faces(scene.soup, fraction, seed));
}

Scene remove_holes(const Scene& scene, double fraction, std::size_t number, std::uint64_t seed)
{
  std::vector<bool> is_removed(scene.soup.triangles.size(), false);
  Seeds seeds(seed);
  for(const Truth& truth : scene.truths) {
    const Soup object = part_of(scene.soup, truth.faces);
    const Soup left = remove_holes(object, fraction, number, seeds.next());
    const std::vector<std::uint32_t> new_places = places(object.triangles, left.triangles);
    for(std::size_t i = 0; i < truth.faces.size(); ++i)
      is_removed[truth.faces[i]] = new_places[i] == is_gone;
  }
  Soup rest;
  rest.points = scene.soup.points;
  for(std::size_t f = 0; f < is_removed.size(); ++f)
    if(!is_removed[f])
      rest.triangles.push_back(scene.soup.triangles[f]);
  return with_fewer_faces(scene, std::move(rest));
}

Scene add_uniform_noise(const Scene& scene, double ratio, std::uint64_t seed)
{
  const std::vector<std::vector<double>> lengths = lengths_of_edges(scene.soup);
  Scene noisy = scene;
  Random random(seed);
  for(std::size_t i = 0; i < lengths.size(); ++i) {
    const Vector_3 displacement = in_unit_ball(random);
    if(!lengths[i].empty())
      noisy.soup.points[i] =
          noisy.soup.points[i] + ratio * mean_without_long_ones(lengths[i]) * displacement;
  }
  return noisy;
}

Scene flip_random_faces(const Scene& scene, double fraction, std::uint64_t seed)
{
  // those that would be removed, so that the number is exact
  const Soup others = remove_random_faces(scene.soup, fraction, seed);
  const std::vector<std::uint32_t> new_places = places(scene.soup.triangles, others.triangles);
  Scene flipped = scene;
  for(std::size_t f = 0; f < new_places.size(); ++f)
    if(new_places[f] == is_gone)
      std::swap(flipped.soup.triangles[f][1], flipped.soup.triangles[f][2]);
  return flipped;
}

Scene damaged(const Scene& scene, const Scene_damage& damage, std::uint64_t seed)
{
  Seeds seeds(seed);
  Scene result = add_uniform_noise(scene, damage.noise, seeds.next());
  result = flip_random_faces(result, damage.flipped, seeds.next());
  result = remove_holes(result, damage.holes, 3, seeds.next());
  return remove_random_faces(result, damage.removed, seeds.next());
}

} // namespace Paper
