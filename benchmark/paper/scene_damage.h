// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SCENE_DAMAGE_H
#define AREA_PROJECTION_PAPER_SCENE_DAMAGE_H

#include "salient_scenes.h"

#include <cstdint>

namespace Paper {

// Each keeps the faces of the truths up to date.

/// removes a fraction of the faces of the scene, each with the same probability.
/// \throw std::invalid_argument if `fraction` is not in [0, 1].
Scene remove_random_faces(const Scene& scene, double fraction, std::uint64_t seed);

/// \brief removes a fraction of the faces of each object, as a number of holes.
///
/// Faces that belong to no object stay.
/// \throw std::invalid_argument as `remove_holes()` of a soup.
Scene remove_holes(const Scene& scene, double fraction, std::size_t number, std::uint64_t seed);

/// \brief displaces each vertex by a vector of uniform probability in a ball, whose radius is `ratio`
/// times the mean length of the edges there.
///
/// No edge counts for more than three times the shortest one at the vertex: where facets run from cap to cap the
/// noise would be larger than the tube.
Scene add_uniform_noise(const Scene& scene, double ratio, std::uint64_t seed);

/// turns a fraction of the faces around.
/// \throw std::invalid_argument if `fraction` is not in [0, 1].
Scene flip_random_faces(const Scene& scene, double fraction, std::uint64_t seed);

/// what happens to a scene, one after the other: noise first, which is relative to the edges of the
/// complete surface.
struct Scene_damage
{
  double noise = 0;
  double flipped = 0;
  double holes = 0; ///< three in each object
  double removed = 0;
};

Scene damaged(const Scene& scene, const Scene_damage& damage, std::uint64_t seed);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SCENE_DAMAGE_H
