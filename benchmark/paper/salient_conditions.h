// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SALIENT_CONDITIONS_H
#define AREA_PROJECTION_PAPER_SALIENT_CONDITIONS_H

#include "scene_damage.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace Paper {

/// scenes, and what happens to them.
struct Condition
{
  std::string name;
  bool is_hard;
  Scene_damage damage;
};

/// those on which detections of round objects are judged: easy scenes first, then hard ones.
std::vector<Condition> salient_conditions();

/// scenes of the seeds from `first_seed` on, damaged.
std::vector<Scene> scenes_of(const Condition& condition, std::uint64_t first_seed,
                             std::size_t number);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SALIENT_CONDITIONS_H
