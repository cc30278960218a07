// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_DAMAGE_H
#define AREA_PROJECTION_PAPER_DAMAGE_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace Paper {

using CGAL::Area_projection::Point_3;
using CGAL::Area_projection::Vector_3;

/// triangles that name their points, facing outward.
struct Soup
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
};

double area(const Soup& soup);

/// the mean over the edges, each counted once.
double mean_edge_length(const Soup& soup);

/// numbers that are the same with any standard library, unlike those of its distributions.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  /// in [0, 1).
  double uniform() { return double(m_engine() >> 11) * 0x1p-53; }

  /// one of 0, …, `number - 1`.
  std::size_t below(std::size_t number) { return std::size_t(uniform() * double(number)); }

  /// of mean 0 and standard deviation 1 (Marsaglia's polar method).
  double normal();

private:
  std::mt19937_64 m_engine;
  double m_spare = 0;
  bool m_has_spare = false;
};

/// \name What happens to surfaces
/// The same seed has the same effect everywhere. Points keep their places, whether faces use them or not.
/// @{

/// removes a fraction of the faces, rounded to a whole number of them, each with the same probability.
/// \throw std::invalid_argument if `fraction` is not in [0, 1].
Soup remove_random_faces(const Soup& soup, double fraction, std::uint64_t seed);

/// \brief removes a fraction of the faces, rounded to a whole number of them, as `number` holes.
///
/// Holes begin at random faces and grow in turn, each by a random one of the faces that share an edge
/// with it. They may meet. One that has eaten its part of the surface begins anew elsewhere.
/// \throw std::invalid_argument if `fraction` is not in [0, 1] or `number` is zero.
Soup remove_holes(const Soup& soup, double fraction, std::size_t number, std::uint64_t seed);

/// adds normally distributed noise to each coordinate, of a standard deviation in units of the mean length
/// of the edges.
Soup add_noise(const Soup& soup, double ratio, std::uint64_t seed);
/// @}

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_DAMAGE_H
