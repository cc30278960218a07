// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The kernel under test as a function of arrays; see test_triangle_disk.cpp.

#include <CGAL/Area_projection_transform/internal/triangle_disk_impl.h>

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

template <class Way, class Lanes, class Triangles>
inline void compute_areas(const Triangles& t, typename Lanes_traits<Lanes>::Number* areas)
{
  for(int n = 0; n < Triangles::size; n += Lanes_traits<Lanes>::size) {
    Edges<Lanes> edges;
    Seen_edges<Lanes> seen;
    for(int i = 0; i < 3; ++i) {
      edges.length[i] = load(t.length[i] + n);
      seen.start[i] = load(t.start[i] + n);
      seen.end[i] = load(t.end[i] + n);
      seen.height[i] = load(t.height[i] + n);
      edges.cosine[i] = load(t.cosine[i] + n);
      edges.sine[i] = load(t.sine[i] + n);
    }
    store(doubled_area_within_disk<Way>(edges, seen, load(t.squared_radius + n)), areas + n);
  }
}

template <class Triangles>
inline void areas_along_the_edges(const Triangles& triangles, float* areas)
{
  compute_areas<Along_the_edges, Floats>(triangles, areas);
}

template <class Triangles>
inline void areas_along_the_edges(const Triangles& triangles, double* areas)
{
  compute_areas<Along_the_edges, Doubles>(triangles, areas);
}

template <class Triangles>
inline void areas_between_the_ends(const Triangles& triangles, float* areas)
{
  compute_areas<Between_the_ends, Floats>(triangles, areas);
}

template <class Triangles>
inline void areas_between_the_ends(const Triangles& triangles, double* areas)
{
  compute_areas<Between_the_ends, Doubles>(triangles, areas);
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
