// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SALIENT_SCENES_H
#define AREA_PROJECTION_PAPER_SALIENT_SCENES_H

#include "labelled_shapes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Paper {

/// round objects in one soup, and what is known of them.
struct Scene
{
  Soup soup;
  std::vector<Truth> truths;
};

/// \name Scenes
/// of 3 to 10 objects, whose radii are log-uniform in [0.2, 1], in random poses, with gaps between them. The
/// same seed makes the same scene.
/// @{

/// \brief spheres and tubes with flat caps.
///
/// Of the spheres 40 % touch another sphere or the side of a tube; of all objects 30 % are cut in half, by
/// a plane through the centre of spheres, along the axis of tubes. The lengths of tubes are 3 to 7 radii. About
/// 20000 faces in the mean.
Scene easy_scene(std::uint64_t seed);

/// \brief coarse tubes of 12 to 16 sides, a third of them with facets that run from cap to cap; tubes with
/// bends of radius 3 to 8 over 40 to 150 degrees; cones of slopes 0.02 to 0.1; ellipsoids of revolution whose
/// axes are as 1:1.15 to 1:2, long and flat ones; and some objects as in easy scenes, which alone may be
/// cut or touch.
Scene hard_scene(std::uint64_t seed);
/// @}

/// an object without any sphere.
struct Distractor
{
  std::string name;
  Scene scene; ///< without truths
};

/// box, brick and plate, finely divided and with 12 faces each, and a torus, in random poses.
std::vector<Distractor> distractors(std::uint64_t seed);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SALIENT_SCENES_H
