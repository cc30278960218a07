// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_conditions.h"

namespace Paper {

namespace {

struct Named_damage
{
  const char* name;
  Scene_damage damage;
};

Scene_damage noise(double ratio, double removed = 0)
{
  Scene_damage damage;
  damage.noise = ratio;
  damage.removed = removed;
  return damage;
}

Scene_damage removed(double fraction)
{
  return noise(0, fraction);
}

Scene_damage holes(double fraction)
{
  Scene_damage damage;
  damage.holes = fraction;
  return damage;
}

Scene_damage flipped(double fraction)
{
  Scene_damage damage;
  damage.flipped = fraction;
  return damage;
}

} // namespace

std::vector<Condition> salient_conditions()
{
  const std::vector<Named_damage> damages = {
      {"clean", {}},
      {"removed 50 %", removed(0.5)},
      {"noise 20 %", noise(0.2)},
      {"noise 50 %", noise(0.5)},
      {"removed 50 %, noise 20 %", noise(0.2, 0.5)},
      {"removed 50 %, noise 50 %", noise(0.5, 0.5)},
      {"holes 30 %", holes(0.3)},
      {"flipped 20 %", flipped(0.2)},
      {"noise 100 %", noise(1)},
      {"removed 80 %", removed(0.8)},
  };
  std::vector<Condition> conditions;
  for(const Named_damage& d : damages)
    conditions.push_back({std::string("easy, ") + d.name, false, d.damage});
  for(const Named_damage& d : damages)
    conditions.push_back({std::string("hard, ") + d.name, true, d.damage});
  return conditions;
}

std::vector<Scene> scenes_of(const Condition& condition, std::uint64_t first_seed,
                             std::size_t number)
{
  std::vector<Scene> scenes;
  for(std::uint64_t seed = first_seed; seed < first_seed + number; ++seed)
    scenes.push_back(
        damaged(condition.is_hard ? hard_scene(seed) : easy_scene(seed), condition.damage, seed));
  return scenes;
}

} // namespace Paper
