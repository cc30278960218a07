// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The kernel of exact evaluation as a function of arrays; see exact.cpp.

#include <CGAL/Area_projection_transform/internal/triangle_disk_impl.h>

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// adds up what a triangle has within many disks, given the place of their centres.
template <class Way, class Lanes, class Number>
inline double sum_within_disks(const Flat_triangle& triangle, const Number* x, const Number* y,
                               int size, double radius)
{
  Edges<Lanes> edges;
  for(std::size_t e = 0; e < 3; ++e) {
    edges.length[e] = all_of<Lanes>(triangle.lengths[e]);
    edges.cosine[e] = all_of<Lanes>(triangle.cosines[e]);
    edges.sine[e] = all_of<Lanes>(triangle.sines[e]);
  }
  Lanes sum{};
  for(int i = 0; i < size; i += Lanes_traits<Lanes>::size) {
    Seen_edges<Lanes> seen;
    for(std::size_t e = 0; e < 3; ++e) {
      const Flat_triangle::Seen_edge edge = triangle.seen_edge(e, 0, 0);
      const Lanes along = all_of<Lanes>(triangle.directions[e][0]);
      const Lanes across = all_of<Lanes>(triangle.directions[e][1]);
      seen.start[e] = all_of<Lanes>(edge.start) - (load(x + i) * along + load(y + i) * across);
      seen.end[e] = seen.start[e] + edges.length[e];
      seen.height[e] = all_of<Lanes>(edge.height) - (load(x + i) * across - load(y + i) * along);
    }
    sum += doubled_area_within_disk<Way>(edges, seen, all_of<Lanes>(radius * radius));
  }
  double result = 0;
  for(int i = 0; i < Lanes_traits<Lanes>::size; ++i)
    result += 0.5 * double(sum[i]);
  return result;
}

/// as the grid does it for small triangles, and for large ones.
inline double sum_along(const Flat_triangle& t, const float* x, const float* y, int n,
                        double radius)
{
  return sum_within_disks<Along_the_edges, Floats>(t, x, y, n, radius);
}

inline double sum_between(const Flat_triangle& t, const float* x, const float* y, int n,
                          double radius)
{
  return sum_within_disks<Between_the_ends, Floats>(t, x, y, n, radius);
}

/// as the evaluator does it.
inline double sum_between(const Flat_triangle& t, const double* x, const double* y, int n,
                          double radius)
{
  return sum_within_disks<Between_the_ends, Doubles>(t, x, y, n, radius);
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
