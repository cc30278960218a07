// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "normals_modes.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Paper {

namespace {

/// a box whose sides are whole numbers of voxels, so that voxels lie in the middle.
struct Flat_object
{
  const char* name;
  std::array<int, 3> sides; // in 64ths; the last is the shortest
};

constexpr Flat_object objects[] = {{"plate", {{64, 64, 8}}},
                                   {"beam", {{64, 16, 16}}},
                                   {"box", {{64, 32, 16}}},
                                   {"cube", {{64, 64, 64}}}};

/// \brief of how many walls points have the distance R, at most, where no wall is farther than its opposite.
///
/// A wall adds σ²/4R² where all of the disk that a ball cuts out of it is there: 1/16.
int most_walls(const Flat_object& object, double radius)
{
  int walls = 3;
  for(int side : object.sides)
    walls += std::abs(2 * radius - side) < 1e-9;
  return walls;
}

/// the largest value and how much of the region has at least half of it.
Measures measure(const AP::Row_spans& region, const std::vector<float>& map)
{
  const float largest = *std::max_element(map.begin(), map.end());
  const auto high = std::count_if(map.begin(), map.end(),
                                  [largest](float value) { return value >= 0.5f * largest; });
  return {{"largest value", largest},
          {"in walls", 16 * largest},
          {"half as high", double(high) / double(region.number_of_voxels())}};
}

void add_rows(Subject& subject, const Flat_object* object, std::vector<Benchmarks::Row>& rows)
{
  for(const std::string& mode : normals_modes())
    for(std::size_t k = 0; k < subject.scales().size(); ++k) {
      Benchmarks::Parameters parameters = subject.parameters();
      parameters.emplace_back("R in voxels", radius_in_voxels(subject.maps(mode).joint, k));
      Measures measures = measure(*subject.region(), subject.maps(mode).scales[k]);
      const double in_64ths = 64 * subject.scales()[k].radius;
      if(object && 2 * in_64ths <= object->sides[2] + 1e-9)
        measures.emplace_back("walls", most_walls(*object, in_64ths));
      rows.push_back(row("figure 8", "scales of " + subject.name(), mode, parameters, measures));
    }
}

void show(const Options& options, Subject&& subject, const Flat_object* object,
          Benchmarks::Report& report)
{
  std::vector<Benchmarks::Row> rows;
  add_rows(subject, object, rows);
  publish(rows, report);
  for(const std::string& mode : normals_modes())
    write_pictures(options, "figure_8_" + subject.name() + "_" + mode, subject.maps(mode),
                   {0, 1, 2, 3, 4}, subject.soup());
}

} // namespace

void figure_8(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      "figure 8",
      "Flat objects. Where walls are at the distance R each adds 1/16: one on the parallel of a "
      "wall, two along an edge and between plates, three in a corner, and more where R is half "
      "the distance of opposite walls.");
  const std::vector<double> radii{2, 4, 6, 8, 16};
  if(options.meshes.empty())
    for(const Flat_object& object : objects)
      if(!options.is_quick || &object == objects) // the plate alone
        show(options, Subject({object.name, box(object.sides, 1 / 64.)}, 64, radii), &object,
             report);
  for(Mesh& mesh : read_meshes(options, {}))
    show(options, Subject(std::move(mesh), options.voxels, radii), nullptr, report);
}

} // namespace Paper
