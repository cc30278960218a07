// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "damage_tables.h"

#include "normals_modes.h"

#include <algorithm>

namespace Paper {

namespace {

using Benchmarks::Parameters;
using Benchmarks::Row;

/// the tables of a figure, row by row.
struct Tables
{
  std::vector<Row> modes, interiors, maps, scales, maxima;
};

std::string stem_of_pictures(const std::string& group, const Subject& subject,
                             const std::string& damage, const std::string& mode)
{
  std::string stem = group + "_" + subject.name() + "_" + damage + "_" + mode;
  std::replace(stem.begin(), stem.end(), ' ', '_');
  return stem;
}

Parameters with_damage(Parameters parameters, const Damage& damage)
{
  parameters.emplace_back("damage", damage.kind);
  parameters.emplace_back("amount", damage.amount);
  return parameters;
}

void add_scales(const std::string& group, const Parameters& parameters, const std::string& mode,
                const Maps& clean, const Maps& other, const std::vector<std::size_t>& shown,
                Tables& tables)
{
  const AP::Row_spans& region = clean.joint.region();
  for(std::size_t k : shown) {
    const Map_difference d = compare(region, clean.scales[k], other.scales[k]);
    Parameters own = parameters;
    own.emplace_back("R in voxels", radius_in_voxels(clean.joint, k));
    tables.scales.push_back(
        row(group, "scales", mode, own,
            {{"correlation", d.correlation}, {"relative RMS error", d.relative_rms}}));
  }
}

/// how far the maps of the modes are from each other before anything happens: a mode that is robust
/// because it shows little of the surface is seen here.
void add_modes(const std::string& group, Subject& subject, Tables& tables)
{
  const Maps& face = subject.maps("face");
  for(const std::string& mode : normals_modes()) {
    const Maps& maps = subject.maps(mode);
    const auto differ = [&](const std::vector<float>& a, const std::vector<float>& b) {
      return compare(*subject.region(), a, b);
    };
    const std::vector<float>& values = maps.joint.values();
    tables.modes.push_back(
        row(group, "clean surface against normals of faces", mode, subject.parameters(),
            {{"joint correlation", differ(face.joint.values(), values).correlation},
             {"largest R correlation", differ(face.scales.back(), maps.scales.back()).correlation},
             {"largest value", *std::max_element(values.begin(), values.end())}}));
  }
}

} // namespace

void compare_damages(const std::string& group, const Options& options, Subject& subject,
                     const std::vector<Damage>& damages, const std::vector<std::size_t>& shown,
                     Benchmarks::Report& report)
{
  Tables tables;
  add_modes(group, subject, tables);
  for(const std::string& mode : normals_modes())
    write_pictures(options, stem_of_pictures(group, subject, "clean", mode), subject.maps(mode),
                   shown, subject.soup());
  for(const Damage& damage : damages) {
    const Damaged damaged = apply(damage, subject, options.seed);
    const Parameters parameters = with_damage(subject.parameters(), damage);
    tables.interiors.push_back(
        row(group, "interior", "all", parameters, measure_interior(damaged)));
    for(const std::string& mode : normals_modes()) {
      const Maps& clean = subject.maps(mode);
      const Maps maps = compute_maps(mode, damaged.soup, subject.region(), subject.scales());
      tables.maps.push_back(
          row(group, "maps", mode, parameters, measure_maps(clean, maps, damaged)));
      tables.maxima.push_back(
          row(group, "maxima", mode, parameters, measure_maxima(clean, maps, damaged)));
      add_scales(group, parameters, mode, clean, maps, shown, tables);
      write_pictures(options, stem_of_pictures(group, subject, damage.kind, mode), maps, shown,
                     damaged.soup);
    }
  }
  for(const auto& rows :
      {tables.modes, tables.interiors, tables.maps, tables.scales, tables.maxima})
    publish(rows, report);
}

} // namespace Paper
