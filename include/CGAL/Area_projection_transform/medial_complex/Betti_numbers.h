// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_BETTI_NUMBERS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_BETTI_NUMBERS_H

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformMedialBalls
/// \brief how a shape is connected: its Betti numbers `b0`, `b1`, `b2`.
///
/// A ball has 1, 0, 0, a solid torus 1, 1, 0, and a ball with a bubble in it 1, 0, 1.
struct Betti_numbers
{
  long components = 0; ///< the pieces
  long loops = 0;    ///< the independent ways around holes that go through: the handles of a solid
  long cavities = 0; ///< the parts of the outside that are enclosed

  /// the alternating sum of the numbers of vertices, edges, triangles and tetrahedra, however the shape is cut into them.
  long euler_number() const { return components - loops + cavities; }

  friend bool operator==(const Betti_numbers& a, const Betti_numbers& b)
  {
    return a.components == b.components && a.loops == b.loops && a.cavities == b.cavities;
  }
  friend bool operator!=(const Betti_numbers& a, const Betti_numbers& b) { return !(a == b); }
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_BETTI_NUMBERS_H
